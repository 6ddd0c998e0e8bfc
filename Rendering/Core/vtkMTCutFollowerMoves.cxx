// SPDX-License-Identifier: BSD-3-Clause
// vtkMTCutFollower: operations, in the order of their errors.
#include "vtkMTCutFollowerWorker.h"

#include <algorithm>
#include <unordered_set>

void vtkMTCutFollower::Worker::CoarsenOne(std::uint32_t node)
{
  this->ForLeaving(node, [this](std::uint32_t arc) { this->Subtract(arc, this->Sum); });
  this->Cut.Coarsen(node);
  this->ForReplaced(node, [this](std::uint32_t arc) { this->Enter(arc); });
}

// Coarsens the node, and before it all refined ones that depend on it.
void vtkMTCutFollower::Worker::ForceCoarsening(std::uint32_t node)
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
void vtkMTCutFollower::Worker::Repair()
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

void vtkMTCutFollower::Worker::PushCoarsening(std::uint32_t node, CoarseningHeap& heap, bool towardsTarget)
{
  if (this->Cut.CanCoarsen(node) && !(towardsTarget && this->Target.IsRefined(node)))
  {
    heap.push({ this->Views.GetWanted(node), node });
  }
}

// What the target does not refine, as far as the coarser patches are there.
void vtkMTCutFollower::Worker::CoarsenToTarget()
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
void vtkMTCutFollower::Worker::FitBudgets()
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

void vtkMTCutFollower::Worker::CoarsenUploads()
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

void vtkMTCutFollower::Worker::PushRefinement(std::uint32_t node, RefinementHeap& heap)
{
  if (this->Target.IsRefined(node) && this->Cut.CanRefine(node))
  {
    heap.push({ this->Views.GetWanted(node), node });
  }
}

bool vtkMTCutFollower::Worker::TryRefine(std::uint32_t node)
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

void vtkMTCutFollower::Worker::RefineToTarget()
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
