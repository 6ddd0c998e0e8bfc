// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTCutFollower.h"

#include "vtkMTCutFollowerWorker.h"

#include <algorithm>
#include <utility>

vtkMTCutFollower::Result vtkMTCutFollower::Worker::Run()
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

void vtkMTCutFollower::Worker::TakeTarget()
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
void vtkMTCutFollower::Worker::Measure()
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

// There was no time to find the target: to what has been found comes what of the cut is needed, and the next steps
// from there.
void vtkMTCutFollower::Worker::AddNextSteps()
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
  this->States.resize(input.Graph->Arcs.size(), Worker::Unknown);
  return Worker(*this, input, settings).Run();
}

vtkMTTargetCut::Result vtkMTCutFollower::View(const Input& input, const Settings& settings)
{
  return this->Extraction.View(
    this->Cut && this->Graph == input.Graph ? *this->Cut : vtkMTCut(*input.Graph), input, settings);
}
