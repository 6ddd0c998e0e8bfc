// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTLevelLoop.h"

#include "vtkMTArcRecord.h"
#include "vtkMTBuildState.h"
#include "vtkMTBytes.h"
#include "vtkMTLocks.h"
#include "vtkMTOrderedWork.h"
#include "vtkMTPartitionStrategy.h"
#include "vtkMTPatchRecord.h"
#include "vtkMTPatchSink.h"
#include "vtkMTPatchSplitter.h"
#include "vtkMTRegionStep.h"
#include "vtkMTSimplifier.h"
#include "vtkMTSliverMerge.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
constexpr std::uint32_t None = vtkMTBuildState::None;
constexpr std::uint32_t MaximumLevels = 60; // identities have room for 61

using Barycentre = vtkMTBarycentreSpool::Barycentre;
using Bytes = std::vector<unsigned char>;
}

class vtkMTLevelLoop::Internals
{
public:
  Internals(const vtkMTBuildSettings& settings, vtkMTPatchSink& sink, const std::string& identity)
    : Options(settings)
    , Sink(sink)
    , Identity(identity)
  {
  }

  bool Run(vtkMTBuildState& state)
  {
    this->State = &state;
    this->CarriedArrays = state.Graph.Arrays;
    this->CarriedArrays.push_back(vtkMTRegionStep::GetReachInfo());
    if (state.Level == 0 && state.Stage == vtkMTBuildState::HasFragments && !this->Commit())
    {
      return false;
    }
    while (state.Stage == vtkMTBuildState::HasPatches || !this->IsFinished())
    {
      const bool done = state.Stage == vtkMTBuildState::HasFragments ? this->SplitFragments() : this->SimplifyRegions();
      if (!done || !this->Commit())
      {
        return false;
      }
    }
    return this->WriteRoots() && this->FinishGraph();
  }

  std::string Error;
  bool Aborted = false;
  bool HasCommitted = false;

private:
  bool Fail(const std::string& error)
  {
    this->Error = error;
    return false;
  }

  bool Commit()
  {
    Bytes sink;
    if (!this->Options.Store->IsLasting() || !this->Sink.Save(sink))
    {
      return this->Sink.GetError().empty() || this->Fail(this->Sink.GetError());
    }
    Bytes state;
    this->State->Save(state);
    Bytes bytes;
    vtkMTBytes::Writer writer(bytes);
    writer.PutText(this->Identity);
    writer.PutList(state);
    writer.PutList(sink);
    this->HasCommitted = this->Options.Store->Commit(bytes, this->Error) || this->HasCommitted;
    return this->Error.empty();
  }

  bool IsFinished() const
  {
    const auto& counts = this->State->LevelTriangles;
    const std::uint32_t level = this->State->Level;
    if (this->State->NodeOfFragment.size() <= 1 && counts.back() <= this->Options.PatchTriangles)
    {
      return true;
    }
    const auto isStuck = [&counts](std::size_t i)
    { return static_cast<double>(counts[i]) > 0.9 * static_cast<double>(counts[i - 1]); };
    return (level >= 2 && isStuck(level) && isStuck(level - 1)) || level >= MaximumLevels;
  }

  // Every level halves, so all levels together have about twice the input's triangles.
  double GetFraction() const
  {
    return std::min(1.0,
      static_cast<double>(this->State->SimplifiedTriangles) /
        (2.0 * static_cast<double>(this->State->LevelTriangles[0])));
  }

  bool Continue(const char* step, std::uint64_t triangles)
  {
    const bool goOn = this->Options.Report({ this->GetFraction(), step, this->State->Level + 1, triangles,
      this->State->LevelTriangles[this->State->Level] });
    this->Aborted = !goOn;
    return goOn || this->Fail("aborted");
  }

  bool ForAll(std::size_t count, const vtkMTOrderedWork::Work& work, const vtkMTOrderedWork::Work& take)
  {
    std::string error;
    if (vtkMTOrderedWork::Run(count, this->Options.Threads, work, take, error))
    {
      return true;
    }
    this->Error = error.empty() ? this->Error : error;
    return false;
  }

  std::size_t GetNumberOfSlots() const { return vtkMTOrderedWork::GetNumberOfSlots(this->Options.Threads); }

  std::unique_ptr<vtkMTPartition> MakePartition()
  {
    vtkMTBarycentreSpool& scan = this->State->Barycentres;
    const int level = static_cast<int>(this->State->Level) + 1;
    scan.SetContinue([this] { return this->Continue("placing regions", 0); });
    auto partition = this->Options.Partition->Build(scan, 2.0 * this->Options.GetRegionTarget(), level);
    if (!partition)
    {
      this->Error = this->Aborted
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

  //----------------------------------------------------------------------------
  // A patch on its way to the sink.
  struct PatchToWrite
  {
    vtkMTArc Arc;
    std::unique_ptr<vtkMTPatchSink::PreparedPatch> Patch;
  };

  // A fragment's pieces on their way to sink and spool.
  struct SplitResult
  {
    std::size_t Triangles = 0;
    std::vector<std::pair<std::uint64_t, std::uint32_t>> Uses;
    std::vector<std::uint32_t> Regions; // of the pieces
    std::vector<PatchToWrite> Patches;
    std::vector<Bytes> Records;
  };

  bool SplitFragments()
  {
    vtkMTBuildState& state = *this->State;
    const auto partition = this->MakePartition();
    if (!partition)
    {
      return false;
    }
    if (!state.Patches.Begin(*this->Options.Store, vtkMTBuildState::GetPatchesName(state.Level),
          partition->GetNumberOfRegions(), this->Error))
    {
      return false;
    }
    // Nodes of the next level are numbered when their region is simplified: until then arcs hold the region.
    state.FirstArcOfLevel = state.Arcs.size();
    std::uint64_t triangles = 0;
    std::vector<SplitResult> splits(this->GetNumberOfSlots());
    vtkMTLocks locks(*this->Options.Store, this->Options.SortMemory);
    const bool done = this->ForAll(
      state.NodeOfFragment.size(),
      [&](std::size_t fragment, std::size_t slot, std::string& error)
      { return this->SplitFragment(*partition, fragment, splits[slot], error); },
      [&](std::size_t fragment, std::size_t slot, std::string& error)
      {
        triangles += splits[slot].Triangles;
        return this->PutPieces(state.NodeOfFragment[fragment], splits[slot], error) &&
          locks.Add(splits[slot].Uses, error) && this->Continue("cutting patches", triangles);
      });
    if (!done || !locks.Finish(state.Patches, this->Error) || !state.Patches.Seal(this->Error))
    {
      return false;
    }
    state.NextRegions = 0;
    for (std::size_t a = static_cast<std::size_t>(state.FirstArcOfLevel); a < state.Arcs.size(); ++a)
    {
      state.NextRegions = std::max(state.NextRegions, state.Arcs[a].FromNode + 1);
    }
    state.Fragments.Remove();
    state.Barycentres.Remove();
    state.Stage = vtkMTBuildState::HasPatches;
    return true;
  }

  bool TakeFragment(std::size_t fragment, vtkMTPatch& mesh, bool& isEmpty, std::string& error) const
  {
    std::vector<Bytes> records;
    if (!this->State->Fragments.Take(fragment, records, error))
    {
      return false;
    }
    isEmpty = records.empty();
    return isEmpty || vtkMTPatchRecord::Decode(records[0], mesh, error);
  }

  bool SplitFragment(
    const vtkMTPartition& partition, std::size_t fragment, SplitResult& result, std::string& error) const
  {
    result = SplitResult();
    vtkMTPatch mesh;
    bool isEmpty = false;
    if (!this->TakeFragment(fragment, mesh, isEmpty, error))
    {
      return false;
    }
    if (isEmpty || mesh.Triangles.empty())
    {
      return true;
    }
    const std::vector<Barycentre> barycentres = vtkMTBarycentreSpool::GetBarycentres(mesh);
    std::vector<std::uint32_t> regions(barycentres.size());
    partition.LocateAll(barycentres.data(), barycentres.size(), regions.data());
    const double sliver = std::ceil(SliverShare * static_cast<double>(this->Options.PatchTriangles));
    vtkMTSliverMerge::MergeSlivers(partition, barycentres, static_cast<std::size_t>(sliver), regions);
    result.Triangles = mesh.Triangles.size();
    vtkMTPatchSplitter split =
      vtkMTPatchSplitter::Split(mesh, regions, this->State->Level, static_cast<std::uint32_t>(fragment));
    result.Uses = std::move(split.Uses);
    for (vtkMTPatchSplitter::Piece& piece : split.Pieces)
    {
      result.Regions.push_back(piece.Region);
      result.Records.emplace_back();
      vtkMTPatchRecord::Encode(piece.Patch, result.Records.back());
      result.Patches.emplace_back();
      if (!this->PreparePatch(std::move(piece.Patch), result.Patches.back(), error))
      {
        return false;
      }
    }
    return true;
  }

  bool PutPieces(std::uint32_t toNode, SplitResult& result, std::string& error)
  {
    for (std::size_t i = 0; i < result.Regions.size(); ++i)
    {
      const std::uint32_t region = result.Regions[i];
      if (!this->WritePatch(std::move(result.Patches[i]), region, toNode, error) ||
        !this->State->Patches.Put(region, result.Records[i].data(), result.Records[i].size(), error))
      {
        return false;
      }
    }
    return true;
  }

  bool PreparePatch(vtkMTPatch&& patch, PatchToWrite& result, std::string& error) const
  {
    vtkMTRegionStep::RemoveReach(patch);
    result.Arc = vtkMTMakeArcRecord(patch, this->State->Graph.Lattice.Step);
    result.Patch = this->Sink.Prepare(std::move(patch), error);
    return result.Patch != nullptr;
  }

  bool WritePatch(PatchToWrite&& patch, std::uint32_t fromNode, std::uint32_t toNode, std::string& error)
  {
    this->State->Arcs.push_back({ patch.Arc, fromNode, toNode });
    const bool written = this->Sink.WritePrepared(std::move(patch.Patch));
    error = written ? error : this->Sink.GetError();
    return written;
  }

  //----------------------------------------------------------------------------
  struct RegionResult
  {
    vtkMTRegionStep Step;
    Bytes Record;
    std::vector<Barycentre> Barycentres;
  };

  bool SimplifyRegions()
  {
    vtkMTBuildState& state = *this->State;
    const std::uint32_t next = state.Level + 1;
    std::vector<RegionResult> results(this->GetNumberOfSlots());
    state.NodeOfFragment.assign(state.NextRegions, None);
    std::uint64_t left = 0;
    std::uint64_t triangles = 0;
    if (!state.Fragments.Begin(
          *this->Options.Store, vtkMTBuildState::GetFragmentsName(next), state.NextRegions, this->Error) ||
      !state.Barycentres.Begin(*this->Options.Store, vtkMTBuildState::GetBarycentresName(next), this->Error))
    {
      return false;
    }
    const bool done = this->ForAll(
      state.NextRegions,
      [&](std::size_t region, std::size_t slot, std::string& error)
      { return this->SimplifyRegion(region, results[slot], error); },
      [&](std::size_t region, std::size_t slot, std::string& error)
      {
        left += results[slot].Step.Fragment.Triangles.size();
        triangles += results[slot].Step.FloorTriangles;
        return this->PutFragment(next, region, results[slot], error) && this->Continue("simplifying", triangles);
      });
    if (!done || !state.Fragments.Seal(this->Error) || !state.Barycentres.Seal(this->Error))
    {
      return false;
    }
    for (std::size_t a = static_cast<std::size_t>(state.FirstArcOfLevel); a < state.Arcs.size(); ++a)
    {
      state.Arcs[a].FromNode = state.NodeOfFragment[state.Arcs[a].FromNode];
    }
    state.LevelTriangles.push_back(left);
    state.Patches.Remove();
    state.Level = next;
    state.Stage = vtkMTBuildState::HasFragments;
    return true;
  }

  bool SimplifyRegion(std::size_t region, RegionResult& result, std::string& error) const
  {
    result = RegionResult();
    std::vector<Bytes> records;
    if (!this->State->Patches.Take(region, records, error))
    {
      return false;
    }
    if (records.size() < 2)
    {
      return true; // a region that lost all its triangles to its neighbours
    }
    std::vector<vtkMTPatch> patches(records.size() - 1);
    for (std::size_t i = 0; i < patches.size(); ++i)
    {
      if (!vtkMTPatchRecord::Decode(records[i], patches[i], error))
      {
        return false;
      }
      records[i] = Bytes();
    }
    std::vector<std::uint64_t> locks(records.back().size() / sizeof(std::uint64_t));
    std::copy_n(records.back().data(), locks.size() * sizeof(locks[0]), reinterpret_cast<unsigned char*>(locks.data()));
    const vtkMTRegionStep::Context context{ this->Options.Simplifier, &this->CarriedArrays, &locks,
      this->State->Level };
    if (!result.Step.Run(patches, context, error))
    {
      return false;
    }
    result.Barycentres = vtkMTBarycentreSpool::GetBarycentres(result.Step.Fragment);
    vtkMTPatchRecord::Encode(result.Step.Fragment, result.Record);
    return true;
  }

  bool PutFragment(std::uint32_t level, std::size_t region, const RegionResult& result, std::string& error)
  {
    vtkMTBuildState& state = *this->State;
    const vtkMTRegionStep& step = result.Step;
    if (step.FloorTriangles == 0)
    {
      return true;
    }
    state.SimplifiedTriangles += step.FloorTriangles;
    state.NodeOfFragment[region] = static_cast<std::uint32_t>(state.Nodes.size());
    state.Nodes.push_back({ level, static_cast<std::uint32_t>(region), step.Error, step.EdgeLength });
    state.Graph.FullySharedBorders += step.HasFullySharedBorder ? 1 : 0;
    for (const auto& [cause, edges] : step.Blocked)
    {
      state.Graph.Blocked[cause] += edges;
    }
    return state.Fragments.Put(region, result.Record.data(), result.Record.size(), error) &&
      state.Barycentres.Put(result.Barycentres, error);
  }

  //----------------------------------------------------------------------------
  // The last fragments are the coarsest patches.
  bool WriteRoots()
  {
    for (std::size_t f = 0; f < this->State->NodeOfFragment.size(); ++f)
    {
      vtkMTPatch mesh;
      PatchToWrite patch;
      bool isEmpty = false;
      if (!this->TakeFragment(f, mesh, isEmpty, this->Error))
      {
        return false;
      }
      if (!isEmpty &&
        (!this->PreparePatch(std::move(mesh), patch, this->Error) ||
          !this->WritePatch(std::move(patch), None, this->State->NodeOfFragment[f], this->Error)))
      {
        return false;
      }
    }
    return true;
  }

  // Nodes from coarse to fine between source and sink, then everything that follows from them.
  bool FinishGraph()
  {
    vtkMTGraph& graph = this->State->Graph;
    std::vector<std::uint32_t> order(this->State->Nodes.size());
    for (std::uint32_t i = 0; i < order.size(); ++i)
    {
      order[i] = i;
    }
    const auto& nodes = this->State->Nodes;
    std::stable_sort(order.begin(), order.end(),
      [&nodes](std::uint32_t a, std::uint32_t b) { return nodes[a].Level > nodes[b].Level; });
    std::vector<std::uint32_t> place(order.size());
    graph.Nodes.assign(order.size() + 2, vtkMTNode());
    graph.Nodes[0].Level = (nodes.empty() ? 0 : nodes[order[0]].Level) + 1;
    const double step = graph.Lattice.Step;
    for (std::uint32_t i = 0; i < order.size(); ++i)
    {
      const vtkMTBuildState::NodeRecord& record = nodes[order[i]];
      vtkMTNode& node = graph.Nodes[i + 1];
      node.Level = record.Level;
      node.Region = record.Region;
      node.OwnError =
        record.Error > 0.0 ? std::nextafter(record.Error * step, std::numeric_limits<double>::infinity()) : 0.0;
      node.EdgeLength = record.EdgeLength * step;
      place[order[i]] = i + 1;
    }
    graph.Arcs.reserve(this->State->Arcs.size());
    for (const vtkMTBuildState::ArcRecord& record : this->State->Arcs)
    {
      vtkMTArc arc = record.Arc;
      arc.From = record.FromNode == None ? 0 : place[record.FromNode];
      arc.To = record.ToNode == None ? graph.GetSink() : place[record.ToNode];
      graph.Arcs.push_back(arc);
    }
    this->State->Arcs = {};
    const std::vector<std::uint32_t> patchOfArc = graph.Index();
    graph.Saturate(graph.Lattice.MaximumShift);
    graph.Settings["partition"] = this->Options.Partition->GetSettings();
    graph.Settings["simplifier"] = this->Options.Simplifier->GetSettings();
    graph.Settings["patch_triangles"] = std::to_string(this->Options.PatchTriangles);
    graph.Settings["floor_triangles"] = std::to_string(std::llround(2.0 * this->Options.GetRegionTarget()));
    return this->Sink.Finish(graph, patchOfArc) || this->Fail(this->Sink.GetError());
  }

  const vtkMTBuildSettings Options;
  vtkMTPatchSink& Sink;
  const std::string Identity;
  vtkMTBuildState* State = nullptr;
  std::vector<vtkMTArrayInfo> CarriedArrays; // the input's and, last, the reach
};

vtkMTLevelLoop::vtkMTLevelLoop(const vtkMTBuildSettings& settings, vtkMTPatchSink& sink, const std::string& identity)
  : Implementation(std::make_unique<Internals>(settings, sink, identity))
{
}

vtkMTLevelLoop::~vtkMTLevelLoop() = default;

bool vtkMTLevelLoop::Run(vtkMTBuildState& state)
{
  return this->Implementation->Run(state);
}

bool vtkMTLevelLoop::ReadCheckpoint(vtkMTSpoolStore& store, Checkpoint& checkpoint, std::string& error)
{
  checkpoint = Checkpoint();
  Bytes bytes;
  if (!store.Restore(bytes, error))
  {
    return false;
  }
  if (bytes.empty())
  {
    return true;
  }
  vtkMTBytes::Reader reader(bytes);
  checkpoint.Identity = reader.TakeText();
  reader.TakeList(checkpoint.State);
  reader.TakeList(checkpoint.Sink);
  error = reader.IsSound() && reader.IsAtEnd() ? error : "the checkpoint does not hold what was kept";
  return reader.IsSound() && reader.IsAtEnd();
}

const std::string& vtkMTLevelLoop::GetError() const
{
  return this->Implementation->Error;
}

bool vtkMTLevelLoop::WasAborted() const
{
  return this->Implementation->Aborted;
}

bool vtkMTLevelLoop::HasCheckpoint() const
{
  return this->Implementation->HasCommitted;
}
