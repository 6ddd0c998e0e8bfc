// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTCutFollower.h"

#include "vtkMTArcViews.h"
#include "vtkMTFrameTimer.h"
#include "vtkMTGraph.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <unordered_set>
#include <utility>

namespace
{
constexpr unsigned char Unknown = 255;
// Prefetching ends below this share of the threshold: by a step that leaves half as many triangles the error falls to
// about so much.
constexpr double NextSteps = 0.5;
constexpr double Needed = std::numeric_limits<double>::infinity();

struct Operation
{
  double Error;
  std::uint32_t Node;
};

// On top: the largest error, then the smallest index.
struct LargestFirst
{
  bool operator()(const Operation& a, const Operation& b) const
  {
    return a.Error != b.Error ? a.Error < b.Error : a.Node > b.Node;
  }
};

// On top: the smallest error, then the largest index.
struct SmallestFirst
{
  bool operator()(const Operation& a, const Operation& b) const
  {
    return a.Error != b.Error ? a.Error > b.Error : a.Node < b.Node;
  }
};

using RefinementHeap = std::priority_queue<Operation, std::vector<Operation>, LargestFirst>;
using CoarseningHeap = std::priority_queue<Operation, std::vector<Operation>, SmallestFirst>;

// Of what is drawn.
struct Totals
{
  std::uint64_t Triangles = 0;
  std::uint64_t Bytes = 0;
  std::uint64_t Upload = 0;
};
}

// One frame.
class vtkMTCutFollower::Worker
{
public:
  Worker(vtkMTCutFollower& owner, const Input& input, const Settings& settings)
    : Owner(owner)
    , In(input)
    , Options(settings)
    , Timer(settings)
    , Graph(*input.Graph)
    , Views(owner.Extraction.GetViews())
    , Cut(*owner.Cut)
    , Target(*input.Graph)
    , Out(*input.Graph)
  {
  }

  ~Worker()
  {
    for (const std::uint32_t arc : this->Owner.Asked)
    {
      this->Owner.States[arc] = Unknown;
    }
    this->Owner.Asked.clear();
  }

  Result Run()
  {
    vtkMTTargetCut::Settings half = this->Options;
    half.TimeLimit *= 0.5;
    vtkMTTargetCut::Result target = this->Owner.Extraction.Extract(this->In, half);
    if (target.Complete && (this->Options.Wait || this->IsDrawable(target)))
    {
      this->Out = Result(std::move(target));
      this->Out.Requests.clear();
      this->TakeTarget();
    }
    else
    {
      this->Target = std::move(target.Cut);
      this->HasTarget = target.Complete;
      if (!this->HasTarget)
      {
        this->AddNextSteps();
      }
      this->Measure();
      this->Repair();
      this->CoarsenToTarget();
      this->FitBudgets();
      this->RefineToTarget();
      this->Finish();
    }
    this->Out.UploadBytes = this->GetUploadBytes(this->Out.Arcs);
    this->Owner.RefinedNodes = this->Out.RefinedNodes;
    this->UploadEarly();
    this->AddWants();
    return std::move(this->Out);
  }

private:
  //----------------------------------------------------------------------------
  // States and sums

  bool IsCoarsest(std::uint32_t arc) const { return this->Graph.Arcs[arc].From == this->Graph.GetSource(); }

  StateType GetState(std::uint32_t arc)
  {
    if (!this->In.GetState)
    {
      return Uploaded;
    }
    unsigned char& known = this->Owner.States[arc];
    if (known == Unknown)
    {
      this->Owner.Asked.push_back(arc);
      known = this->In.GetState(arc);
    }
    return static_cast<StateType>(known);
  }

  bool IsDrawn(std::uint32_t arc) { return this->Views.Look(arc).IsDrawn(); }
  bool IsMissing(std::uint32_t arc)
  {
    return this->IsDrawn(arc) && !this->IsCoarsest(arc) && this->GetState(arc) == Absent;
  }
  std::uint64_t GetUpload(std::uint32_t arc)
  {
    return !this->IsCoarsest(arc) && this->GetState(arc) == Loaded ? this->Views.GetBytes(this->Graph.Arcs[arc]) : 0;
  }
  std::uint64_t GetUploadBytes(const std::vector<std::uint32_t>& arcs)
  {
    std::uint64_t bytes = 0;
    for (const std::uint32_t arc : arcs)
    {
      bytes += this->GetUpload(arc);
    }
    return bytes;
  }

  bool FitsUpload(std::uint64_t bytes) const
  {
    return this->Options.UploadBudget == 0 || bytes <= this->Options.UploadBudget;
  }
  bool Fits(const Totals& totals) const
  {
    return this->Views.Fits(totals.Triangles, totals.Bytes) && this->FitsUpload(totals.Upload);
  }
  // Whether an operation is within the budgets, or at least makes nothing worse.
  bool Allows(const Totals& after) const
  {
    return this->Views.Fits(after.Triangles > this->Sum.Triangles ? after.Triangles : 0,
             after.Bytes > this->Sum.Bytes ? after.Bytes : 0) &&
      this->FitsUpload(after.Upload > this->Sum.Upload ? after.Upload : 0);
  }

  void Add(std::uint32_t arc, Totals& totals)
  {
    if (this->IsDrawn(arc))
    {
      totals.Triangles += this->Graph.Arcs[arc].Triangles;
      totals.Bytes += this->Views.GetBytes(this->Graph.Arcs[arc]);
      totals.Upload += this->GetUpload(arc);
    }
  }
  void Subtract(std::uint32_t arc, Totals& totals)
  {
    if (this->IsDrawn(arc))
    {
      totals.Triangles -= this->Graph.Arcs[arc].Triangles;
      totals.Bytes -= this->Views.GetBytes(this->Graph.Arcs[arc]);
      totals.Upload -= this->GetUpload(arc);
    }
  }

  template <typename Function>
  void ForLeaving(std::uint32_t node, Function&& function) const
  {
    const vtkMTNode& record = this->Graph.Nodes[node];
    for (std::uint32_t arc = record.FirstOut; arc < record.FirstOut + record.OutCount; ++arc)
    {
      function(arc);
    }
  }
  template <typename Function>
  void ForEntering(std::uint32_t node, Function&& function) const
  {
    for (const std::uint32_t arc : this->Graph.GetEntering(node))
    {
      function(arc);
    }
  }
  // Those of them that refining the node takes away.
  template <typename Function>
  void ForReplaced(std::uint32_t node, Function&& function) const
  {
    for (const std::uint32_t arc : this->Graph.GetReplaced(node))
    {
      function(arc);
    }
  }

  bool IsDrawable(const vtkMTTargetCut::Result& target)
  {
    return std::none_of(
             target.Arcs.begin(), target.Arcs.end(), [this](std::uint32_t arc) { return this->IsMissing(arc); }) &&
      this->FitsUpload(this->GetUploadBytes(target.Arcs));
  }

  void TakeTarget()
  {
    for (const std::uint32_t node : this->Out.RefinedNodes)
    {
      this->Out.Refined += this->Cut.IsRefined(node) ? 0 : 1;
    }
    for (const std::uint32_t node : this->Owner.RefinedNodes)
    {
      this->Out.Coarsened += this->Out.Cut.IsRefined(node) ? 0 : 1;
    }
    this->Cut = this->Out.Cut;
  }

  // The cut as it is, seen from the new view.
  void Measure()
  {
    this->Sum = Totals();
    this->Missing.clear();
    for (const std::uint32_t node : this->Owner.RefinedNodes)
    {
      this->ForLeaving(node,
        [this](std::uint32_t arc)
        {
          if (this->Cut.Contains(arc))
          {
            this->Enter(arc);
          }
        });
    }
  }

  void Enter(std::uint32_t arc)
  {
    this->Add(arc, this->Sum);
    if (this->IsMissing(arc))
    {
      this->Missing.push_back(arc);
    }
  }

  // There was no time to find the target: to what has been found comes what of the cut is needed, and the next steps
  // from there.
  void AddNextSteps()
  {
    const double threshold = this->Views.GetThreshold();
    for (const std::uint32_t node : this->Owner.RefinedNodes)
    {
      if (this->Views.GetWanted(node) > threshold)
      {
        this->Target.RefineWithDependencies(node);
      }
      this->ForLeaving(node,
        [&](std::uint32_t arc)
        {
          const std::uint32_t to = this->Graph.Arcs[arc].To;
          if (this->Cut.Contains(arc) && this->Views.Look(arc).Wanted > threshold && this->IsReadable(to))
          {
            this->Target.RefineWithDependencies(to);
          }
        });
    }
  }

  bool IsReadable(std::uint32_t node) const
  {
    bool readable = true;
    this->ForLeaving(
      node, [&](std::uint32_t arc) { readable = readable && (!this->In.Resident || (*this->In.Resident)[arc] != 0); });
    return readable;
  }

  //----------------------------------------------------------------------------
  // Coarsening

  void CoarsenOne(std::uint32_t node)
  {
    this->ForLeaving(node, [this](std::uint32_t arc) { this->Subtract(arc, this->Sum); });
    this->Cut.Coarsen(node);
    this->ForReplaced(node, [this](std::uint32_t arc) { this->Enter(arc); });
  }

  // Coarsens the node, and before it all refined ones that depend on it.
  void ForceCoarsening(std::uint32_t node)
  {
    std::vector<std::uint32_t> nodes{ node };
    std::unordered_set<std::uint32_t> seen{ node };
    for (std::size_t i = 0; i < nodes.size(); ++i)
    {
      this->ForLeaving(nodes[i],
        [&](std::uint32_t arc)
        {
          const std::uint32_t to = this->Graph.Arcs[arc].To;
          if (this->Cut.IsRefined(to) && seen.insert(to).second)
          {
            nodes.push_back(to);
          }
        });
    }
    std::sort(nodes.begin(), nodes.end());
    for (std::size_t i = nodes.size(); i-- > 0;)
    {
      this->CoarsenOne(nodes[i]);
      ++this->Out.Forced;
    }
  }

  // Until everything drawn is there. The coarsest patches are never missing, so this ends.
  void Repair()
  {
    while (!this->Missing.empty())
    {
      const std::uint32_t arc = this->Missing.back();
      this->Missing.pop_back();
      if (this->Cut.Contains(arc))
      {
        this->ForceCoarsening(this->Graph.Arcs[arc].From);
      }
    }
  }

  void PushCoarsening(std::uint32_t node, CoarseningHeap& heap, bool towardsTarget)
  {
    if (this->Cut.CanCoarsen(node) && !(towardsTarget && this->Target.IsRefined(node)))
    {
      heap.push({ this->Views.GetWanted(node), node });
    }
  }

  template <typename Function>
  void ForCoarseningHeap(bool towardsTarget, Function&& use)
  {
    CoarseningHeap heap;
    for (std::uint32_t node = 1; node < this->Graph.GetSink(); ++node)
    {
      this->PushCoarsening(node, heap, towardsTarget);
    }
    while (!heap.empty())
    {
      const std::uint32_t node = heap.top().Node;
      heap.pop();
      if (!this->Cut.CanCoarsen(node))
      {
        continue;
      }
      if (!use(node))
      {
        return;
      }
      if (!this->Cut.IsRefined(node))
      {
        this->ForEntering(
          node, [&](std::uint32_t arc) { this->PushCoarsening(this->Graph.Arcs[arc].From, heap, towardsTarget); });
      }
    }
  }

  // What the target does not refine, as far as the coarser patches are there.
  void CoarsenToTarget()
  {
    this->ForCoarseningHeap(true,
      [this](std::uint32_t node)
      {
        if (this->Timer.IsOver())
        {
          return false;
        }
        Totals after = this->Sum;
        bool there = true;
        this->ForReplaced(node,
          [&](std::uint32_t arc)
          {
            this->Add(arc, after);
            there = there && !this->IsMissing(arc);
          });
        this->ForLeaving(node, [&](std::uint32_t arc) { this->Subtract(arc, after); });
        if (there && this->Allows(after))
        {
          this->CoarsenOne(node);
          ++this->Out.Coarsened;
        }
        else
        {
          this->Blocked.push_back(node);
        }
        return true;
      });
  }

  // The smallest errors go first; what has to be uploaded goes only while there is too much of that. Coarsening may
  // bring more triangles into view, or patches that are to be uploaded, so it is done until nothing is left to coarsen.
  void FitBudgets()
  {
    for (std::size_t before = ~std::size_t(0); !this->Fits(this->Sum) && before != this->Out.Forced;)
    {
      before = this->Out.Forced;
      if (!this->FitsUpload(this->Sum.Upload))
      {
        this->CoarsenUploads();
      }
      this->ForCoarseningHeap(false,
        [this](std::uint32_t node)
        {
          if (this->Fits(this->Sum))
          {
            return false;
          }
          this->ForceCoarsening(node);
          this->Repair();
          return true;
        });
    }
  }

  void CoarsenUploads()
  {
    CoarseningHeap heap;
    for (std::uint32_t node = 1; node < this->Graph.GetSink(); ++node)
    {
      bool uploads = false;
      if (this->Cut.IsRefined(node))
      {
        this->ForLeaving(node,
          [&](std::uint32_t arc)
          { uploads = uploads || (this->Cut.Contains(arc) && this->IsDrawn(arc) && this->GetUpload(arc) > 0); });
      }
      if (uploads)
      {
        heap.push({ this->Views.GetWanted(node), node });
      }
    }
    for (; !heap.empty() && !this->FitsUpload(this->Sum.Upload); heap.pop())
    {
      if (this->Cut.IsRefined(heap.top().Node))
      {
        this->ForceCoarsening(heap.top().Node);
        this->Repair();
      }
    }
  }

  //----------------------------------------------------------------------------
  // Refinement

  void PushRefinement(std::uint32_t node, RefinementHeap& heap)
  {
    if (this->Target.IsRefined(node) && this->Cut.CanRefine(node))
    {
      heap.push({ this->Views.GetWanted(node), node });
    }
  }

  bool TryRefine(std::uint32_t node)
  {
    Totals after = this->Sum;
    bool there = true;
    this->ForLeaving(node,
      [&](std::uint32_t arc)
      {
        this->Add(arc, after);
        there = there && !this->IsMissing(arc);
      });
    this->ForReplaced(node, [&](std::uint32_t arc) { this->Subtract(arc, after); });
    if (!there || !this->Allows(after))
    {
      return false;
    }
    this->Cut.Refine(node);
    this->Sum = after;
    ++this->Out.Refined;
    return true;
  }

  void RefineToTarget()
  {
    RefinementHeap heap;
    for (std::uint32_t node = 1; node < this->Graph.GetSink(); ++node)
    {
      this->PushRefinement(node, heap);
    }
    std::vector<Operation> postponed;
    for (std::size_t before = ~std::size_t(0); before != this->Out.Refined;)
    {
      before = this->Out.Refined;
      for (const Operation& operation : postponed)
      {
        heap.push(operation);
      }
      postponed.clear();
      for (; !heap.empty();)
      {
        if (this->Timer.IsOver())
        {
          this->Interrupted = true;
          return;
        }
        const Operation operation = heap.top();
        heap.pop();
        if (!this->Cut.CanRefine(operation.Node))
        {
          continue;
        }
        if (this->TryRefine(operation.Node))
        {
          this->ForLeaving(
            operation.Node, [&](std::uint32_t arc) { this->PushRefinement(this->Graph.Arcs[arc].To, heap); });
        }
        else
        {
          postponed.push_back(operation);
        }
      }
    }
  }

  //----------------------------------------------------------------------------
  // Result

  void Finish()
  {
    const Result counts = std::move(this->Out);
    this->Out = Result(this->Graph);
    this->Out.Refined = counts.Refined;
    this->Out.Coarsened = counts.Coarsened;
    this->Out.Forced = counts.Forced;
    this->Out.Complete = this->HasTarget && !this->Interrupted;
    this->Out.Cut = this->Cut;
    bool same = true;
    for (std::uint32_t node = 0; node < this->Graph.GetSink(); ++node)
    {
      same = same && this->Cut.IsRefined(node) == this->Target.IsRefined(node);
      if (this->Cut.IsRefined(node))
      {
        this->Out.RefinedNodes.push_back(node);
      }
    }
    this->Views.Report(this->Out);
    this->Out.OnTarget = this->HasTarget && same;
  }

  // An operation whose patches together are more than one frame's upload is prepared in several frames.
  void UploadEarly()
  {
    std::uint64_t upload = this->Out.UploadBytes;
    std::uint64_t bytes = this->Out.Bytes;
    if (this->Out.OnTarget || !this->In.GetState || this->Options.UploadBudget == 0)
    {
      return;
    }
    for (const Operation& operation : this->GetPending())
    {
      this->ForLeaving(operation.Node,
        [&](std::uint32_t arc)
        {
          const std::uint64_t size = this->Views.GetBytes(this->Graph.Arcs[arc]);
          if (!this->IsDrawn(arc) || this->GetState(arc) == Absent || !this->Views.Fits(0, bytes + size) ||
            !this->FitsUpload(upload + this->GetUpload(arc)))
          {
            return;
          }
          upload += this->GetUpload(arc);
          bytes += size;
          this->Out.Early.push_back(arc);
        });
    }
    this->Out.UploadBytes = upload;
  }

  // The refinements that lie between the cut and the target, the largest errors first.
  std::vector<Operation> GetPending()
  {
    std::vector<Operation> pending;
    for (std::uint32_t node = 1; node < this->Graph.GetSink(); ++node)
    {
      if (!this->Cut.IsRefined(node) && this->Target.IsRefined(node))
      {
        pending.push_back({ this->Views.GetWanted(node), node });
      }
    }
    std::sort(
      pending.begin(), pending.end(), [](const Operation& a, const Operation& b) { return LargestFirst()(b, a); });
    return pending;
  }

  void Want(std::uint32_t arc, double priority, bool load)
  {
    if (this->IsCoarsest(arc))
    {
      return; // always wanted, see AddWants
    }
    this->Out.Wants.push_back({ arc, priority, load });
  }

  void AddWants()
  {
    if (!this->In.GetState)
    {
      return;
    }
    // Where nobody waits, the coarsest patches must be at hand at any time.
    const bool atHand = !this->Options.Wait || this->Options.Prefetch;
    this->ForLeaving(this->Graph.GetSource(),
      [&](std::uint32_t arc) {
        this->Out.Wants.push_back({ arc, Needed, atHand });
      });
    for (const std::uint32_t arc : this->Out.Arcs)
    {
      this->Want(arc, this->GetState(arc) != Uploaded ? Needed : 0.0, this->Options.Wait);
    }
    if (!this->Out.OnTarget)
    {
      this->WantRefinements();
      for (const std::uint32_t node : this->Blocked)
      {
        this->ForEntering(node,
          [this](std::uint32_t arc)
          {
            if (this->IsMissing(arc))
            {
              this->Want(arc, std::numeric_limits<double>::min(), true);
            }
          });
      }
    }
    if (this->Options.Prefetch && this->Out.Complete && !this->Timer.IsOver())
    {
      this->WantSurroundings();
    }
  }

  void WantRefinements()
  {
    for (const Operation& operation : this->GetPending())
    {
      const double error = std::max(operation.Error, std::numeric_limits<double>::min());
      this->ForLeaving(operation.Node,
        [&](std::uint32_t arc)
        {
          if (this->IsDrawn(arc) && this->GetState(arc) != Uploaded)
          {
            this->Want(arc, error, true);
            if (this->GetState(arc) == Absent)
            {
              this->Out.Requests.push_back({ arc, error });
            }
          }
        });
    }
  }

  // What all operations in the two heaps would bring, now and after others, and what a small turn of the camera would.
  // First the way back: where a budget shrinks, the cut is coarsened at once, and with nothing else there that would be
  // down to the coarsest one.
  void WantSurroundings()
  {
    for (const std::uint32_t node : this->Out.RefinedNodes)
    {
      this->ForLeaving(node,
        [this](std::uint32_t arc)
        {
          const std::uint32_t to = this->Graph.Arcs[arc].To;
          if (this->Cut.IsRefined(to))
          {
            const double level = this->Graph.Nodes[to].Level;
            this->WantAround(arc, -1.0 + 0.5 * level / (1.0 + level));
            return;
          }
          if (this->Views.Look(arc).Outside && this->Views.IsNearby(arc))
          {
            this->Want(arc, -1.0, true);
          }
          // Of the arcs that enter a node the first one asks for what refining it would bring.
          if (this->Graph.IsRefinable(to) && arc == *this->Graph.GetEntering(to).begin())
          {
            this->WantFiner(to);
          }
        });
    }
  }

  void WantFiner(std::uint32_t node)
  {
    const double error = this->Views.GetWanted(node);
    if (error > NextSteps * this->Views.GetThreshold() && this->Cut.CanRefine(node))
    {
      this->ForLeaving(node, [&](std::uint32_t arc) { this->WantAround(arc, -2.0 - 1.0 / (1.0 + error)); });
    }
  }

  void WantAround(std::uint32_t arc, double priority)
  {
    if (this->IsDrawn(arc) && this->GetState(arc) != Uploaded)
    {
      this->Want(arc, priority, true);
    }
  }

  vtkMTCutFollower& Owner;
  const Input& In;
  const Settings& Options;
  vtkMTFrameTimer Timer;
  const vtkMTGraph& Graph;
  vtkMTArcViews& Views;
  vtkMTCut& Cut;
  vtkMTCut Target;
  Result Out;
  Totals Sum;
  std::vector<std::uint32_t> Missing; // drawn arcs of the cut that are not there; some may have left it again
  std::vector<std::uint32_t> Blocked; // nodes that the target does not refine, whose coarser patches are not there
  bool HasTarget = true;              // otherwise Target is what there was time for
  bool Interrupted = false;
};

vtkMTCutFollower::vtkMTCutFollower() = default;
vtkMTCutFollower::~vtkMTCutFollower() = default;

void vtkMTCutFollower::Reset()
{
  this->Cut.reset();
  this->RefinedNodes.clear();
  this->Graph = nullptr;
}

vtkMTCutFollower::Result vtkMTCutFollower::Update(const Input& input, const Settings& settings)
{
  if (input.Graph->IsEmpty())
  {
    return Result(*input.Graph);
  }
  if (!this->Cut || this->Graph != input.Graph)
  {
    this->Graph = input.Graph;
    this->Cut = std::make_unique<vtkMTCut>(*input.Graph);
    this->RefinedNodes.assign(1, input.Graph->GetSource());
  }
  this->States.resize(input.Graph->Arcs.size(), Unknown);
  return Worker(*this, input, settings).Run();
}

vtkMTTargetCut::Result vtkMTCutFollower::View(const Input& input, const Settings& settings)
{
  return this->Extraction.View(
    this->Cut && this->Graph == input.Graph ? *this->Cut : vtkMTCut(*input.Graph), input, settings);
}
