// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTTargetCut.h"

#include "vtkMTArcViews.h"
#include "vtkMTFrameTimer.h"
#include "vtkMTGraph.h"
#include "vtkMTView.h"

#include <algorithm>
#include <queue>

namespace
{
constexpr double NotWanted = vtkMTArcViews::NotWanted;

// All levels above a cut have about as many triangles as the cut; what has several times more will not fit.
constexpr std::uint64_t HopelessOvershoot = 4;
}

// Kept between calls so that a frame costs as much as its cut, not as much as its graph.
struct vtkMTTargetCut::Scratch
{
  vtkMTArcViews Views;
  std::vector<unsigned char> Marks; // nodes of the closure in question; all zero between uses
  std::vector<double> Wanted;       // per node, the error with which it was last put into the heap
  std::vector<std::uint32_t> TouchedNodes;

  void Begin(const Input& input, const Settings& settings)
  {
    for (const std::uint32_t node : this->TouchedNodes)
    {
      this->Wanted[node] = NotWanted;
    }
    this->TouchedNodes.clear();
    this->Marks.resize(input.Graph->Nodes.size(), 0);
    this->Wanted.resize(input.Graph->Nodes.size(), NotWanted);
    this->Views.Begin(*input.Graph, input.Views, settings);
  }
};

class vtkMTTargetCut::Worker
{
public:
  Worker(const Input& input, const Settings& settings, Scratch& memory)
    : Graph(*input.Graph)
    , Resident(input.Resident)
    , Timer(settings)
    , Memory(memory)
    , Out(*input.Graph)
  {
    this->Memory.Begin(input, settings);
  }

  Result Run()
  {
    if (!this->Graph.IsEmpty())
    {
      if (!this->TakeAllWanted())
      {
        this->Out = Result(this->Graph);
        this->Out.RefinedNodes.push_back(this->Graph.GetSource());
        this->EnterLeaving(this->Graph.GetSource());
        this->Refine();
        this->Finish();
      }
    }
    return std::move(this->Out);
  }

  Result Show(const vtkMTCut& cut)
  {
    this->Out.Cut = cut;
    for (std::uint32_t node = 0; node < this->Graph.GetSink(); ++node)
    {
      if (cut.IsRefined(node))
      {
        this->Out.RefinedNodes.push_back(node);
      }
    }
    if (!this->Graph.IsEmpty())
    {
      this->Finish();
    }
    return std::move(this->Out);
  }

private:
  struct Candidate
  {
    double Error;
    std::uint32_t Node;
    bool operator<(const Candidate& other) const
    {
      return this->Error != other.Error ? this->Error < other.Error : this->Node > other.Node;
    }
  };

  bool IsDrawn(std::uint32_t arc) { return this->Memory.Views.Look(arc).IsDrawn(); }

  bool IsResident(std::uint32_t arc) const { return !this->Resident || (*this->Resident)[arc] != 0; }

  /// The result, where all that is wanted is within the budgets. False where that is not so, or would take half of the
  /// time.
  bool TakeAllWanted()
  {
    if (this->Resident)
    {
      return false;
    }
    const bool found = this->MarkAllWanted();
    std::vector<std::uint32_t>& nodes = this->Out.RefinedNodes;
    for (const std::uint32_t node : nodes)
    {
      this->Memory.Marks[node] = 0;
    }
    if (!found)
    {
      return false;
    }
    std::sort(nodes.begin(), nodes.end()); // an order in which they can be refined
    for (const std::uint32_t node : nodes)
    {
      this->Out.Cut.Refine(node);
    }
    this->Memory.Views.Report(this->Out);
    return this->Out.WithinLimits;
  }

  bool MarkAllWanted()
  {
    constexpr std::size_t looksAtTheClock = 8; // nodes from one to the next
    std::uint64_t triangles = 0;
    std::uint64_t bytes = 0;
    std::vector<std::uint32_t>& nodes = this->Out.RefinedNodes;
    this->Mark(this->Graph.GetSource());
    for (std::size_t i = 0; i < nodes.size(); ++i)
    {
      if ((i % looksAtTheClock == 0 && this->Timer.IsOver(0.5)) ||
        !this->Memory.Views.Fits(triangles / HopelessOvershoot, bytes / HopelessOvershoot))
      {
        return false;
      }
      const vtkMTNode& record = this->Graph.Nodes[nodes[i]];
      for (const std::uint32_t arc : this->Graph.GetEntering(nodes[i]))
      {
        this->Mark(this->Graph.Arcs[arc].From);
      }
      for (std::uint32_t index = record.FirstOut; index < record.FirstOut + record.OutCount; ++index)
      {
        const vtkMTArc& arc = this->Graph.Arcs[index];
        const vtkMTArcViews::ArcView& view = this->Memory.Views.Look(index);
        triangles += view.IsDrawn() ? arc.Triangles : 0;
        bytes += view.IsDrawn() ? this->Memory.Views.GetBytes(arc) : 0;
        if (view.Wanted > this->Memory.Views.GetThreshold() && this->Graph.IsRefinable(arc.To))
        {
          this->Mark(arc.To);
        }
      }
    }
    return true;
  }

  void Mark(std::uint32_t node)
  {
    if (!this->Memory.Marks[node])
    {
      this->Memory.Marks[node] = 1;
      this->Out.RefinedNodes.push_back(node);
    }
  }

  void EnterLeaving(std::uint32_t node)
  {
    const vtkMTNode& record = this->Graph.Nodes[node];
    for (std::uint32_t arc = record.FirstOut; arc < record.FirstOut + record.OutCount; ++arc)
    {
      this->Enter(arc);
    }
  }

  void Enter(std::uint32_t arc)
  {
    const vtkMTArc& record = this->Graph.Arcs[arc];
    if (this->IsDrawn(arc))
    {
      this->Triangles += record.Triangles;
      this->Bytes += this->Memory.Views.GetBytes(record);
    }
    if (!this->Graph.IsRefinable(record.To))
    {
      return;
    }
    const double error = this->Memory.Views.Look(arc).Wanted;
    double& wanted = this->Memory.Wanted[record.To];
    if (error > this->Memory.Views.GetThreshold() && error > wanted)
    {
      if (wanted == NotWanted)
      {
        this->Memory.TouchedNodes.push_back(record.To);
      }
      wanted = error;
      this->Heap.push({ error, record.To });
    }
  }

  /// The node and all unrefined ones that it depends on; ascending, which is an order in which they can be refined.
  const std::vector<std::uint32_t>& GetClosure(std::uint32_t node)
  {
    this->Closure.assign(1, node);
    this->Memory.Marks[node] = 1;
    for (std::size_t i = 0; i < this->Closure.size(); ++i)
    {
      for (const std::uint32_t arc : this->Graph.GetEntering(this->Closure[i]))
      {
        const std::uint32_t from = this->Graph.Arcs[arc].From;
        if (!this->Memory.Marks[from] && !this->Out.Cut.IsRefined(from))
        {
          this->Memory.Marks[from] = 1;
          this->Closure.push_back(from);
        }
      }
    }
    std::sort(this->Closure.begin(), this->Closure.end());
    return this->Closure;
  }

  void Unmark()
  {
    for (const std::uint32_t node : this->Closure)
    {
      this->Memory.Marks[node] = 0;
    }
  }

  /// Whether this closure may be refined: enough budget, and all that it would draw is resident.
  bool IsFeasible(double error)
  {
    std::uint64_t triangles = this->Triangles;
    std::uint64_t bytes = this->Bytes;
    this->Missing.clear();
    for (const std::uint32_t node : this->Closure)
    {
      const vtkMTNode& record = this->Graph.Nodes[node];
      for (std::uint32_t arc = record.FirstOut; arc < record.FirstOut + record.OutCount; ++arc)
      {
        const bool stays = this->Graph.Refinement == vtkMTGraph::Add || !this->Memory.Marks[this->Graph.Arcs[arc].To];
        if (stays && this->IsDrawn(arc))
        {
          triangles += this->Graph.Arcs[arc].Triangles;
          bytes += this->Memory.Views.GetBytes(this->Graph.Arcs[arc]);
          if (!this->IsResident(arc))
          {
            this->Missing.push_back({ arc, error });
          }
        }
      }
      for (const std::uint32_t arc : this->Graph.GetReplaced(node))
      {
        if (!this->Memory.Marks[this->Graph.Arcs[arc].From] && this->IsDrawn(arc))
        {
          triangles -= this->Graph.Arcs[arc].Triangles;
          bytes -= this->Memory.Views.GetBytes(this->Graph.Arcs[arc]);
        }
      }
    }
    // What does not grow is never refused: where the coarsest cut is above a budget, only that brings it below.
    if (!this->Memory.Views.Fits(triangles > this->Triangles ? triangles : 0, bytes > this->Bytes ? bytes : 0))
    {
      return false;
    }
    this->Out.Requests.insert(this->Out.Requests.end(), this->Missing.begin(), this->Missing.end());
    return this->Missing.empty();
  }

  /// Refines the node with everything that it depends on, or does nothing.
  bool TryRefine(std::uint32_t node, double error)
  {
    ++this->Out.Operations;
    this->GetClosure(node);
    const bool feasible = this->IsFeasible(error);
    this->Unmark();
    if (!feasible)
    {
      return false;
    }
    const std::vector<std::uint32_t> nodes = this->Closure;
    for (const std::uint32_t each : nodes)
    {
      this->RefineOne(each);
    }
    return true;
  }

  void RefineOne(std::uint32_t node)
  {
    for (const std::uint32_t arc : this->Graph.GetReplaced(node))
    {
      if (this->IsDrawn(arc))
      {
        this->Triangles -= this->Graph.Arcs[arc].Triangles;
        this->Bytes -= this->Memory.Views.GetBytes(this->Graph.Arcs[arc]);
      }
    }
    this->Out.Cut.Refine(node);
    this->Out.RefinedNodes.push_back(node);
    this->EnterLeaving(node);
  }

  /// Refines by the heap until nothing more can be done.
  void Refine()
  {
    std::size_t refinedAtLastRetry = 0;
    while (true)
    {
      while (!this->Heap.empty())
      {
        if (this->Timer.IsOver())
        {
          this->Out.Complete = false;
          this->ForgetRefined();
          return;
        }
        const Candidate candidate = this->Heap.top();
        this->Heap.pop();
        const bool outdated =
          this->Out.Cut.IsRefined(candidate.Node) || candidate.Error < this->Memory.Wanted[candidate.Node];
        if (!outdated && !this->TryRefine(candidate.Node, candidate.Error))
        {
          this->Postponed.push_back(candidate);
        }
      }
      // Another closure may have refined what a postponed one was waiting for.
      if (this->Out.RefinedNodes.size() == refinedAtLastRetry || this->Postponed.empty())
      {
        this->ForgetRefined();
        return;
      }
      refinedAtLastRetry = this->Out.RefinedNodes.size();
      for (const Candidate& candidate : this->Postponed)
      {
        this->Heap.push(candidate);
      }
      this->Postponed.clear();
    }
  }

  void ForgetRefined()
  {
    const auto done = [this](const Candidate& candidate)
    { return this->Out.Cut.IsRefined(candidate.Node) || candidate.Error < this->Memory.Wanted[candidate.Node]; };
    this->Postponed.erase(std::remove_if(this->Postponed.begin(), this->Postponed.end(), done), this->Postponed.end());
  }

  void Finish()
  {
    std::sort(this->Out.RefinedNodes.begin(), this->Out.RefinedNodes.end());
    this->Memory.Views.Report(this->Out);
    this->Out.Postponed = this->Postponed.size();
    this->SortRequests();
  }

  void SortRequests()
  {
    std::vector<Request>& requests = this->Out.Requests;
    std::sort(requests.begin(), requests.end(),
      [](const Request& a, const Request& b) { return a.Arc != b.Arc ? a.Arc < b.Arc : a.Error > b.Error; });
    requests.erase(
      std::unique(requests.begin(), requests.end(), [](const Request& a, const Request& b) { return a.Arc == b.Arc; }),
      requests.end());
    std::stable_sort(
      requests.begin(), requests.end(), [](const Request& a, const Request& b) { return a.Error > b.Error; });
  }

  const vtkMTGraph& Graph;
  const std::vector<unsigned char>* Resident;
  vtkMTFrameTimer Timer;
  Scratch& Memory;
  std::uint64_t Triangles = 0; // of what is drawn of the cut as it is
  std::uint64_t Bytes = 0;
  Result Out;
  std::priority_queue<Candidate> Heap;
  std::vector<Candidate> Postponed; // the largest error first
  std::vector<std::uint32_t> Closure;
  std::vector<Request> Missing;
};

vtkMTTargetCut::vtkMTTargetCut()
  : Memory(std::make_unique<Scratch>())
{
}

vtkMTTargetCut::~vtkMTTargetCut() = default;

vtkMTArcViews& vtkMTTargetCut::GetViews()
{
  return this->Memory->Views;
}

vtkMTTargetCut::Result vtkMTTargetCut::Extract(const Input& input, const Settings& settings)
{
  return Worker(input, settings, *this->Memory).Run();
}

vtkMTTargetCut::Result vtkMTTargetCut::View(const vtkMTCut& cut, const Input& input, const Settings& settings)
{
  return Worker(input, settings, *this->Memory).Show(cut);
}
