// SPDX-License-Identifier: BSD-3-Clause
// vtkMTCutFollower: what a frame gives, and which patches it wants.
#include "vtkMTCutFollowerWorker.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace
{
// Prefetching ends below this share of the threshold: by a step that leaves half as many triangles the error falls to
// about so much.
constexpr double NextSteps = 0.5;
constexpr double Needed = std::numeric_limits<double>::infinity();
}

void vtkMTCutFollower::Worker::Finish()
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
void vtkMTCutFollower::Worker::UploadEarly()
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
std::vector<vtkMTCutFollower::Worker::Operation> vtkMTCutFollower::Worker::GetPending()
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

void vtkMTCutFollower::Worker::Want(std::uint32_t arc, double priority, bool load)
{
  if (this->IsCoarsest(arc))
  {
    return; // always wanted, see AddWants
  }
  this->Out.Wants.push_back({ arc, priority, load });
}

void vtkMTCutFollower::Worker::AddWants()
{
  if (!this->In.GetState)
  {
    return;
  }
  // Where frames do not wait, the coarsest patches must be resident at any time.
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

void vtkMTCutFollower::Worker::WantRefinements()
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
void vtkMTCutFollower::Worker::WantSurroundings()
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

void vtkMTCutFollower::Worker::WantFiner(std::uint32_t node)
{
  const double error = this->Views.GetWanted(node);
  if (error > NextSteps * this->Views.GetThreshold() && this->Cut.CanRefine(node))
  {
    this->ForLeaving(node, [&](std::uint32_t arc) { this->WantAround(arc, -2.0 - 1.0 / (1.0 + error)); });
  }
}

void vtkMTCutFollower::Worker::WantAround(std::uint32_t arc, double priority)
{
  if (this->IsDrawn(arc) && this->GetState(arc) != Uploaded)
  {
    this->Want(arc, priority, true);
  }
}
