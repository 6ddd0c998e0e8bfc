// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTSimplifyStep.h"

#include "vtkMTDihedralAngles.h"

#include <algorithm>

bool vtkMTSimplifyStep::Run()
{
  vtkMTSequenceState& state = this->State;
  const std::uint32_t next = state.Level + 1;
  std::vector<Result> results(this->GetNumberOfSlots());
  state.NodeOfFragment.assign(state.NextRegions, vtkMTSequenceState::None);
  this->CertifiedArrays = this->Options.FindCertifiedArrays(state.Graph.Arrays);
  std::uint64_t left = 0;
  std::uint64_t triangles = 0;
  if (!state.Fragments.Begin(
        *this->Options.Store, vtkMTSequenceState::GetFragmentsName(next), state.NextRegions, this->Error))
  {
    return false;
  }
  // Workers look nodes of finer levels up while this thread adds new ones, so these must stay where they are.
  state.Nodes.reserve(state.Nodes.size() + state.NextRegions);
  const bool done = this->ForAll(
    state.Patches.GetRecords(), state.NextRegions, { this->Options.WorkMemory, this->Options.MemoryPerByteSimplified },
    [&](std::size_t region, std::size_t slot, std::string& error)
    {
      const vtkMTStageTimes::Scope assemble(this->Options.Times, vtkMTStageTimes::Assemble);
      return this->SimplifyRegion(region, results[slot], error);
    },
    [&](std::size_t region, std::size_t slot, std::string& error)
    {
      const vtkMTStageTimes::Scope write(this->Options.Times, vtkMTStageTimes::Write);
      left += results[slot].Step.Fragment.Mesh.Triangles.size();
      triangles += results[slot].Step.FloorTriangles;
      state.Patches.Forget(region);
      return this->PutFragment(next, region, results[slot], error) && this->Continue("simplifying", triangles);
    });
  if (!done || !state.Fragments.Seal(this->Error))
  {
    return false;
  }
  for (std::size_t a = static_cast<std::size_t>(state.FirstArcOfLevel); a < state.Arcs.size(); ++a)
  {
    state.Arcs[a].FromNode = state.NodeOfFragment[state.Arcs[a].FromNode];
  }
  state.LevelElements.push_back(left);
  state.Patches.Remove();
  state.Finer.Keep(static_cast<std::size_t>(std::max(0, this->Options.DirectLevels - 1)));
  state.Level = next;
  state.Stage = vtkMTSequenceState::HasFragments;
  return true;
}

bool vtkMTSimplifyStep::SimplifyRegion(std::size_t region, Result& result, std::string& error) const
{
  result = Result();
  vtkMTRegionRecords records;
  if (!this->State.Patches.Take(region, records, error))
  {
    return false;
  }
  if (records.Patches.empty())
  {
    return true; // a region that lost all its triangles to its neighbours
  }
  vtkMTRegionStep::Context context{ this->Options.Simplifier, &this->State.Graph.Arrays, &records.Locks,
    this->State.Level, this->Options.Reduction, this->Options.CertifyNormals,
    !(this->State.FeatureAngle < vtkMTDihedralAngles::Smooth), &this->CertifiedArrays };
  if (this->Options.KeepsFinerLevels())
  {
    context.LevelsBelow = std::min(this->State.Level + 1, static_cast<std::uint32_t>(this->Options.DirectLevels));
    context.CollectFiner = [this, region](const vtkMTDirectDeviation::Neighbourhood& near, std::size_t levelsBelow,
                             const vtkMTPoint& origin, vtkMTDirectDeviation::FinerPart& part, std::string& why)
    {
      return this->State.Finer.Collect(
        this->State, { static_cast<std::uint32_t>(region), levelsBelow }, near, origin, part, why);
    };
  }
  if (!result.Step.Run(records.Patches, context, error))
  {
    return false;
  }
  const vtkMTStageTimes::Scope encode(vtkMTStageTimes::Encode);
  result.Step.Fragment.Encode(result.Record);
  return true;
}

bool vtkMTSimplifyStep::PutFragment(std::uint32_t level, std::size_t region, const Result& result, std::string& error)
{
  vtkMTSequenceState& state = this->State;
  const vtkMTRegionStep& step = result.Step;
  if (step.FloorTriangles == 0)
  {
    return true;
  }
  state.SimplifiedTriangles += step.FloorTriangles;
  state.NodeOfFragment[region] = static_cast<std::uint32_t>(state.Nodes.size());
  vtkMTBuildState::NodeRecord node{ level, static_cast<std::uint32_t>(region), step.Error, step.EdgeLength };
  if (step.NormalDeviation)
  {
    node.NormalDeviation = step.NormalDeviation->Largest;
    node.MeanNormalDeviation = step.NormalDeviation->Mean;
  }
  state.Nodes.push_back(node);
  state.NodeValueDeviations.insert(
    state.NodeValueDeviations.end(), step.ValueDeviations.begin(), step.ValueDeviations.end());
  state.Graph.FullySharedBorders += step.HasFullySharedBorder ? 1 : 0;
  for (const auto& [cause, edges] : step.Blocked)
  {
    state.Graph.Blocked[cause] += edges;
  }
  return state.Fragments.Put(region, result.Record.data(), result.Record.size(), error);
}
