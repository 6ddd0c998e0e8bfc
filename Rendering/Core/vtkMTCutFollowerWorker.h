// SPDX-License-Identifier: BSD-3-Clause
// vtkMTCutFollower's work of one frame; for its own sources.
#ifndef vtkMTCutFollowerWorker_h
#define vtkMTCutFollowerWorker_h

#include "vtkMTArcViews.h"
#include "vtkMTCutFollower.h"
#include "vtkMTFrameTimer.h"
#include "vtkMTGraph.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <queue>
#include <vector>

class vtkMTCutFollower::Worker
{
public:
  static constexpr unsigned char Unknown = 255;

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

  Result Run();

private:
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

  void TakeTarget();
  void Measure();

  void Enter(std::uint32_t arc)
  {
    this->Add(arc, this->Sum);
    if (this->IsMissing(arc))
    {
      this->Missing.push_back(arc);
    }
  }

  void AddNextSteps();

  bool IsReadable(std::uint32_t node) const
  {
    bool readable = true;
    this->ForLeaving(
      node, [&](std::uint32_t arc) { readable = readable && (!this->In.Resident || (*this->In.Resident)[arc] != 0); });
    return readable;
  }

  //----------------------------------------------------------------------------
  // Coarsening

  void CoarsenOne(std::uint32_t node);
  void ForceCoarsening(std::uint32_t node);
  void Repair();
  void PushCoarsening(std::uint32_t node, CoarseningHeap& heap, bool towardsTarget);

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

  void CoarsenToTarget();
  void FitBudgets();
  void CoarsenUploads();

  //----------------------------------------------------------------------------
  // Refinement

  void PushRefinement(std::uint32_t node, RefinementHeap& heap);
  bool TryRefine(std::uint32_t node);
  void RefineToTarget();

  //----------------------------------------------------------------------------
  // Result

  void Finish();
  void UploadEarly();
  std::vector<Operation> GetPending();
  void Want(std::uint32_t arc, double priority, bool load);
  void AddWants();
  void WantRefinements();
  void WantSurroundings();
  void WantFiner(std::uint32_t node);
  void WantAround(std::uint32_t arc, double priority);

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

#endif
