// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTSplitStep.h"

#include "vtkMTLocks.h"
#include "vtkMTPartitionStrategy.h"
#include "vtkMTPatchRecord.h"
#include "vtkMTPatchSplitter.h"
#include "vtkMTSliverMerge.h"

#include <algorithm>
#include <cmath>
#include <numeric>

using Barycentre = vtkMTBarycentreSpool::Barycentre;

namespace
{
// The barycentres of a level's fragments, one after the other, made when they are asked for.
class FragmentScan : public vtkMTBarycentreScan
{
public:
  FragmentScan(const vtkMTSequenceState& state, double reduction, std::function<bool()> proceed)
    : State(state)
    , Reduction(reduction)
    , Proceed(std::move(proceed))
  {
  }

  std::size_t GetNumberOfTriangles() const override
  {
    return static_cast<std::size_t>(this->State.LevelElements.back());
  }

  double GetNominalTriangles() const override
  {
    return static_cast<double>(this->State.LevelElements[0]) / std::pow(this->Reduction, this->State.Level);
  }

  bool Scan(const Block& block) override
  {
    std::size_t count = 0; // of those that wait
    for (std::size_t fragment = 0; fragment < this->State.Fragments.GetNumberOfKeys(); ++fragment)
    {
      if (!this->AddBarycentres(fragment, count))
      {
        return false;
      }
      if (count >= Many)
      {
        block(this->Barycentres.data(), count);
        count = 0;
        if (!this->Proceed())
        {
          return false;
        }
      }
    }
    block(this->Barycentres.data(), count);
    return true;
  }

  const std::string& GetError() const { return this->Error; }

private:
  bool AddBarycentres(std::size_t fragment, std::size_t& count)
  {
    std::vector<vtkMTBytes::Record> records;
    if (!this->State.Fragments.Take(fragment, records, this->Error))
    {
      return false;
    }
    if (records.empty())
    {
      return true;
    }
    vtkMTBytes::Reader reader(records[0]);
    const vtkMTPatchRecord::Shape shape = vtkMTPatchRecord::TakeShape(reader);
    if (!reader.IsSound())
    {
      this->Error = "temporary data does not hold the mesh that was written";
      return false;
    }
    this->Barycentres.resize(std::max(this->Barycentres.size(), count + shape.Triangles.size()));
    vtkMTBarycentreSpool::PutBarycentres(shape, this->Barycentres.data() + count);
    count += shape.Triangles.size();
    return true;
  }

  static constexpr std::size_t Many = 16384;
  const vtkMTSequenceState& State;
  const double Reduction;
  const std::function<bool()> Proceed;
  std::vector<Barycentre> Barycentres;
  std::string Error;
};
}

std::unique_ptr<vtkMTPartition> vtkMTSplitStep::MakePartition()
{
  FragmentScan scan(this->State, this->Options.Reduction, [this] { return this->Continue("placing regions", 0); });
  const int level = static_cast<int>(this->State.Level) + 1;
  const vtkMTStageTimes::Scope seed(this->Options.Times, vtkMTStageTimes::Seed, true);
  auto partition = this->Options.Partition->Build(scan, this->Options.GetFloorTarget(), level);
  if (!partition)
  {
    this->Error = this->WasAborted()
      ? "aborted"
      : "the partition of level " + std::to_string(level) + " could not be made: " + scan.GetError();
  }
  else if (partition->GetNumberOfRegions() > vtkMTPatchSplitter::MaximumRegions)
  {
    this->Error = "the partition of level " + std::to_string(level) + " has more regions than identities allow";
    partition.reset();
  }
  return partition;
}

//------------------------------------------------------------------------------
bool vtkMTSplitStep::Run()
{
  vtkMTSequenceState& state = this->State;
  const auto partition = this->MakePartition();
  if (!partition)
  {
    return false;
  }
  if (!state.Patches.Begin(*this->Options.Store, vtkMTSequenceState::GetPatchesName(state.Level),
        partition->GetNumberOfRegions(), this->Error))
  {
    return false;
  }
  if (this->Options.KeepsFinerLevels() &&
    !state.Finer.Begin(*this->Options.Store, state.Level, partition->GetNumberOfRegions(), this->Error))
  {
    return false;
  }
  // Nodes of the next level are numbered when their region is simplified: until then arcs hold the region.
  state.FirstArcOfLevel = state.Arcs.size();
  std::uint64_t triangles = 0;
  std::vector<Result> splits(this->GetNumberOfSlots());
  const std::size_t sortMemory = this->Options.SortMemory / 4;
  vtkMTLocks locks(*this->Options.Store, sortMemory);
  const Room room{ this->Options.WorkMemory > 0 ? this->Options.WorkMemory - sortMemory : 0,
    this->Options.MemoryPerByteSplit };
  const bool done = this->ForAll(
    state.Fragments, state.NodeOfFragment.size(), room,
    [&](std::size_t fragment, std::size_t slot, std::string& error)
    {
      const vtkMTStageTimes::Scope assemble(this->Options.Times, vtkMTStageTimes::Assemble);
      return this->SplitFragment(*partition, fragment, splits[slot], error);
    },
    [&](std::size_t fragment, std::size_t slot, std::string& error)
    {
      const vtkMTStageTimes::Scope write(this->Options.Times, vtkMTStageTimes::Write);
      triangles += splits[slot].Triangles;
      state.Fragments.Forget(fragment);
      return this->PutPatches(state.NodeOfFragment[fragment], splits[slot], error) &&
        locks.Add(splits[slot].Uses, error) && this->Continue("splitting fragments", triangles);
    });
  const vtkMTStageTimes::Scope sort(this->Options.Times, vtkMTStageTimes::Sort);
  if (!done || !locks.Finish(state.Patches, this->Error) || !state.Patches.Seal(this->Error))
  {
    return false;
  }
  if (this->Options.KeepsFinerLevels() && !state.Finer.Seal(state, state.FirstArcOfLevel, this->Error))
  {
    return false;
  }
  state.NextRegions = 0;
  for (std::size_t a = static_cast<std::size_t>(state.FirstArcOfLevel); a < state.Arcs.size(); ++a)
  {
    state.NextRegions = std::max(state.NextRegions, state.Arcs[a].FromNode + 1);
  }
  state.Fragments.Remove();
  state.Stage = vtkMTSequenceState::HasPatches;
  return true;
}

bool vtkMTSplitStep::SplitFragment(
  const vtkMTPartition& partition, std::size_t fragment, Result& result, std::string& error) const
{
  result = Result();
  vtkMTCertifiedMesh whole;
  bool isEmpty = false;
  if (!this->TakeFragment(fragment, whole, isEmpty, error))
  {
    return false;
  }
  const vtkMTPatch& mesh = whole.Mesh;
  if (isEmpty || mesh.Triangles.empty())
  {
    return true;
  }
  const std::vector<Barycentre> barycentres = vtkMTBarycentreSpool::GetBarycentres(mesh);
  std::vector<std::uint32_t> regions(barycentres.size());
  {
    const vtkMTStageTimes::Scope seed(vtkMTStageTimes::Seed);
    partition.LocateAll(barycentres.data(), barycentres.size(), regions.data());
  }
  const double sliver = std::ceil(SliverShare * static_cast<double>(this->Options.PatchTriangles));
  vtkMTSliverMerge::MergeSlivers(partition, barycentres, static_cast<std::size_t>(sliver), regions);
  result.Triangles = mesh.Triangles.size();
  this->FindRanges(mesh, result);
  vtkMTPatchSplitter split =
    vtkMTPatchSplitter::Split(mesh, regions, this->State.Level, static_cast<std::uint32_t>(fragment));
  result.Uses = std::move(split.Uses);
  for (vtkMTPatchSplitter::Part& part : split.Parts)
  {
    vtkMTCertifiedMesh patch{ std::move(part.Patch), {}, {} };
    patch.TakeDeviations(whole, part.Triangles);
    result.Regions.push_back(part.Region);
    result.Records.emplace_back();
    {
      const vtkMTStageTimes::Scope encode(vtkMTStageTimes::Encode);
      vtkMTRegionSpool::EncodePatch(patch, result.Records.back());
      result.Finer.emplace_back();
      if (this->Options.KeepsFinerLevels())
      {
        vtkMTFinerLevels::Encode(patch, result.Finer.back());
      }
    }
    result.Patches.emplace_back();
    if (!this->PreparePatch(std::move(patch), result.Patches.back(), error))
    {
      return false;
    }
  }
  return true;
}

void vtkMTSplitStep::FindRanges(const vtkMTPatch& mesh, Result& result) const
{
  if (this->State.Level > 0 || this->Options.CertifiedArrays.empty())
  {
    return;
  }
  const std::vector<vtkMTArrayInfo>& arrays = this->State.Graph.Arrays;
  const std::vector<vtkMTRange> ranges = mesh.GetRanges(arrays);
  for (const std::size_t array : this->Options.FindCertifiedArrays(arrays))
  {
    const std::size_t column = std::accumulate(arrays.begin(), arrays.begin() + static_cast<std::ptrdiff_t>(array),
      std::size_t(0), [](std::size_t sum, const vtkMTArrayInfo& info) { return sum + info.Components; });
    result.Ranges.push_back(ranges[column]);
  }
}

bool vtkMTSplitStep::PutPatches(std::uint32_t toNode, Result& result, std::string& error)
{
  this->State.CertifiedRanges.resize(this->State.CertifiedArrays.size());
  for (std::size_t a = 0; a < result.Ranges.size(); ++a)
  {
    this->State.CertifiedRanges[a].Add(result.Ranges[a]);
  }
  for (std::size_t i = 0; i < result.Regions.size(); ++i)
  {
    const std::uint32_t region = result.Regions[i];
    if (!this->WritePatch(std::move(result.Patches[i]), region, toNode, error) ||
      !this->State.Patches.PutPatch(region, result.Records[i], error) ||
      (this->Options.KeepsFinerLevels() && !this->State.Finer.Put(region, result.Finer[i], error)))
    {
      return false;
    }
  }
  return true;
}
