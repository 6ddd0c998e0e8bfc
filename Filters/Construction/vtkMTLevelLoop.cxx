// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTLevelLoop.h"

#include "vtkMTArcRecord.h"
#include "vtkMTInputMesh.h"
#include "vtkMTPartitionStrategy.h"
#include "vtkMTPatchSink.h"
#include "vtkMTPatchSplitter.h"
#include "vtkMTRegionStep.h"
#include "vtkMTSimplifier.h"
#include "vtkMTSliverMerge.h"
#include "vtkMTSpool.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>

#include <omp.h>

namespace
{
constexpr std::uint32_t None = ~std::uint32_t(0);
using Barycentre = std::array<double, 3>;

std::vector<Barycentre> GetBarycentres(const vtkMTPatch& mesh)
{
  std::vector<Barycentre> result(mesh.Triangles.size());
  for (std::size_t t = 0; t < result.size(); ++t)
  {
    const vtkMTTriangle p = mesh.GetPointsOfTriangle(t);
    for (int i = 0; i < 3; ++i)
    {
      // A sum of three integers is exact, so the barycentre does not depend on the order of the corners.
      const std::int64_t sum = std::int64_t(mesh.Points[p[0]][i]) + mesh.Points[p[1]][i] + mesh.Points[p[2]][i];
      result[t][i] = static_cast<double>(sum) / 3.0;
    }
  }
  return result;
}

// The barycentres of a level's mesh, fragment by fragment.
class FragmentScan : public vtkMTBarycentreScan
{
public:
  std::vector<std::vector<Barycentre>> Fragments;

  std::size_t GetNumberOfTriangles() const override
  {
    std::size_t sum = 0;
    for (const auto& fragment : this->Fragments)
    {
      sum += fragment.size();
    }
    return sum;
  }
  bool Scan(const Block& block) override
  {
    for (const auto& fragment : this->Fragments)
    {
      if (!fragment.empty())
      {
        block(fragment.data(), fragment.size());
      }
    }
    return true;
  }
};

struct NodeRecord
{
  std::uint32_t Level;
  std::uint32_t Region;
  double Error;
  double EdgeLength;
};

struct ArcRecord
{
  vtkMTArc Arc;
  std::uint32_t FromNode; // index of a node record, None for the source
  std::uint32_t ToNode;   // the same, None for the sink
};
}

class vtkMTLevelLoop::Internals
{
public:
  Internals(const Settings& settings, vtkMTPatchSink& sink, vtkMTSpool& fragments, vtkMTSpool& patches)
    : Options(settings)
    , Threads(settings.NumberOfThreads > 0 ? settings.NumberOfThreads : omp_get_max_threads())
    , Sink(sink)
    , FragmentSpool(fragments)
    , PatchSpool(patches)
  {
  }

  bool Run(vtkMTInputMesh&& input)
  {
    this->Lattice = input.Lattice;
    this->Graph.Lattice = input.Lattice;
    this->Graph.Arrays = input.Arrays;
    this->CarriedArrays = input.Arrays;
    this->CarriedArrays.push_back(vtkMTRegionStep::GetReachInfo());
    vtkMTRegionStep::AppendReachOfInput(input.Mesh);
    this->Graph.InputTriangles = input.InputTriangles;
    this->Graph.InputReport = input.Report;
    this->InputTriangles = input.Mesh.Triangles.size();
    if (!this->Sink.Begin(input.Arrays))
    {
      return this->Fail(this->Sink.GetError());
    }
    if (!this->MakeFirstFragments(input.Mesh))
    {
      return false;
    }
    input = vtkMTInputMesh();
    std::uint32_t level = 0;
    for (; !this->IsFinished(level); ++level)
    {
      if (!this->SplitFragments(level) || !this->SimplifyRegions(level + 1))
      {
        return false;
      }
    }
    return this->WriteRoots() && this->FinishGraph();
  }

  std::string Error;
  bool Aborted = false;

private:
  bool Fail(const std::string& error)
  {
    this->Error = error;
    return false;
  }

  std::unique_ptr<vtkMTPartition> MakePartition(vtkMTBarycentreScan& scan, double target, int level)
  {
    std::unique_ptr<vtkMTPartition> partition = this->Options.Partition->Build(scan, target, level);
    if (!partition)
    {
      this->Error = "the partition of level " + std::to_string(level) + " could not be made";
    }
    else if (partition->GetNumberOfRegions() > vtkMTPatchSplitter::MaximumRegions)
    {
      this->Error = "the partition of level " + std::to_string(level) + " has more regions than identities allow";
      partition.reset();
    }
    return partition;
  }

  double GetRegionTarget() const { return PatchesPerRegion * static_cast<double>(this->Options.PatchTriangles); }

  // M_0, one fragment for each region of Psi_0.
  bool MakeFirstFragments(const vtkMTPatch& mesh)
  {
    std::vector<std::uint32_t> region;
    std::uint32_t regions = 0;
    {
      FragmentScan scan;
      scan.Fragments.push_back(GetBarycentres(mesh));
      const auto partition = this->MakePartition(scan, this->GetRegionTarget(), 0);
      if (!partition)
      {
        return false;
      }
      regions = partition->GetNumberOfRegions();
      region = this->LocateAll(*partition, scan.Fragments[0]);
    }
    // Points that triangles of several regions use are shared from the start.
    std::vector<std::uint32_t> user(mesh.Points.size(), None);
    std::vector<unsigned char> isShared(mesh.Points.size(), 0);
    std::vector<std::vector<std::uint32_t>> triangles(regions);
    for (std::uint32_t t = 0; t < region.size(); ++t)
    {
      triangles[region[t]].push_back(t);
      for (std::uint32_t p : mesh.GetPointsOfTriangle(t))
      {
        isShared[p] = isShared[p] || (user[p] != None && user[p] != region[t]) ? 1 : 0;
        user[p] = region[t];
      }
    }
    std::vector<std::uint64_t> ids(mesh.Points.size());
    for (std::size_t p = 0; p < ids.size(); ++p)
    {
      ids[p] = vtkMTPatchSplitter::MakeInputId(p);
    }
    return this->PutFirstFragments(mesh, triangles, isShared, ids);
  }

  bool PutFirstFragments(const vtkMTPatch& mesh, const std::vector<std::vector<std::uint32_t>>& triangles,
    const std::vector<unsigned char>& isShared, const std::vector<std::uint64_t>& ids)
  {
    std::vector<std::size_t> pointTupleSizes;
    std::vector<std::size_t> cellTupleSizes;
    for (const vtkMTArrayInfo& info : this->CarriedArrays)
    {
      (info.Association == vtkMTArrayInfo::Point ? pointTupleSizes : cellTupleSizes).push_back(info.GetTupleSize());
    }
    std::vector<std::uint32_t> scratch(mesh.GetNumberOfWedges() + mesh.Points.size(), None);
    if (!this->FragmentSpool.Reset(triangles.size()))
    {
      return this->Fail(this->FragmentSpool.GetError());
    }
    this->LevelScan.Fragments.resize(triangles.size());
    for (std::size_t r = 0; r < triangles.size(); ++r)
    {
      vtkMTPatch fragment =
        vtkMTPatchSplitter::Extract(mesh, triangles[r], isShared, ids, pointTupleSizes, cellTupleSizes, scratch);
      this->LevelScan.Fragments[r] = GetBarycentres(fragment);
      if (!this->FragmentSpool.Put(r, std::move(fragment)))
      {
        return this->Fail(this->FragmentSpool.GetError());
      }
    }
    this->NodeOfFragment.assign(triangles.size(), None); // the sink
    this->LevelTriangles.push_back(this->InputTriangles);
    return true;
  }

  std::vector<std::uint32_t> LocateAll(
    const vtkMTPartition& partition, const std::vector<Barycentre>& barycentres) const
  {
    std::vector<std::uint32_t> region(barycentres.size());
    const std::ptrdiff_t count = static_cast<std::ptrdiff_t>(region.size());
#pragma omp parallel for num_threads(this->Threads) schedule(static)
    for (std::ptrdiff_t t = 0; t < count; ++t)
    {
      region[t] = partition.Locate(barycentres[t]);
    }
    return region;
  }

  bool IsFinished(std::uint32_t level) const
  {
    const auto& counts = this->LevelTriangles;
    if (this->LevelScan.Fragments.size() <= 1 && counts.back() <= this->Options.PatchTriangles)
    {
      return true;
    }
    const auto isStuck = [&counts](std::size_t i) { return counts[i] > 0.9 * static_cast<double>(counts[i - 1]); };
    return (level >= 2 && isStuck(level) && isStuck(level - 1)) || level >= MaximumLevels;
  }

  // Calls work(i) for a batch of indices at a time, in parallel, then finish(i) in order; both give false on failure.
  template <class Work, class Finish>
  bool ForAll(std::size_t count, Work&& work, Finish&& finish)
  {
    const std::size_t batch = 4 * static_cast<std::size_t>(this->Threads);
    std::vector<std::string> errors(batch);
    for (std::size_t begin = 0; begin < count; begin += batch)
    {
      const std::size_t size = std::min(batch, count - begin);
#pragma omp parallel for num_threads(this->Threads) schedule(dynamic, 1)
      for (std::size_t i = 0; i < size; ++i)
      {
        errors[i].clear();
        try
        {
          work(begin + i, i, errors[i]);
        }
        catch (const std::exception& e)
        {
          errors[i] = std::string("out of memory or an internal fault: ") + e.what();
        }
      }
      for (std::size_t i = 0; i < size; ++i)
      {
        if (!errors[i].empty())
        {
          return this->Fail(errors[i]);
        }
        if (!finish(begin + i, i))
        {
          return false;
        }
      }
      if (this->Options.Progress && !this->Options.Progress(this->GetProgress()))
      {
        this->Aborted = true;
        return this->Fail("aborted");
      }
    }
    return true;
  }

  // Every level halves, so all levels together have about twice the input's triangles.
  double GetProgress() const
  {
    return std::min(
      1.0, static_cast<double>(this->SimplifiedTriangles) / (2.0 * static_cast<double>(this->InputTriangles)));
  }

  bool SplitFragments(std::uint32_t level)
  {
    const auto partition =
      this->MakePartition(this->LevelScan, 2.0 * this->GetRegionTarget(), static_cast<int>(level) + 1);
    if (!partition)
    {
      return false;
    }
    if (!this->PatchSpool.Reset(partition->GetNumberOfRegions()))
    {
      return this->Fail(this->PatchSpool.GetError());
    }
    this->LockedIds.clear();
    std::vector<std::pair<std::uint64_t, std::uint32_t>> uses;
    std::vector<vtkMTPatchSplitter> splits(4 * static_cast<std::size_t>(this->Threads));
    // Nodes of the next level are numbered when their region is simplified: until then arcs hold the region.
    this->FirstArcOfLevel = this->Arcs.size();
    return this->ForAll(
             this->LevelScan.Fragments.size(),
             [&](std::size_t fragment, std::size_t slot, std::string& error)
             { this->SplitFragment(*partition, level, fragment, splits[slot], error); },
             [&](std::size_t fragment, std::size_t slot)
             { return this->PutPieces(this->NodeOfFragment[fragment], splits[slot], uses); }) &&
      this->FindLockedIds(uses);
  }

  void SplitFragment(const vtkMTPartition& partition, std::uint32_t level, std::size_t fragment,
    vtkMTPatchSplitter& split, std::string& error)
  {
    split = vtkMTPatchSplitter();
    std::vector<vtkMTPatch> meshes;
    if (!this->FragmentSpool.Take(fragment, meshes))
    {
      error = this->FragmentSpool.GetError();
      return;
    }
    if (meshes.empty() || meshes[0].Triangles.empty())
    {
      return;
    }
    const std::vector<Barycentre>& barycentres = this->LevelScan.Fragments[fragment];
    std::vector<std::uint32_t> regions(barycentres.size());
    for (std::size_t t = 0; t < regions.size(); ++t)
    {
      regions[t] = partition.Locate(barycentres[t]);
    }
    const double sliver = std::ceil(SliverShare * static_cast<double>(this->Options.PatchTriangles));
    vtkMTSliverMerge::MergeSlivers(partition, barycentres, static_cast<std::size_t>(sliver), regions);
    split = vtkMTPatchSplitter::Split(meshes[0], regions, level, static_cast<std::uint32_t>(fragment));
  }

  bool PutPieces(
    std::uint32_t toNode, vtkMTPatchSplitter& split, std::vector<std::pair<std::uint64_t, std::uint32_t>>& uses)
  {
    uses.insert(uses.end(), split.Uses.begin(), split.Uses.end());
    this->LockedIds.insert(this->LockedIds.end(), split.LockedIds.begin(), split.LockedIds.end());
    for (vtkMTPatchSplitter::Piece& piece : split.Pieces)
    {
      if (!this->WritePatch(vtkMTPatch(piece.Patch), piece.Region, toNode))
      {
        return false;
      }
      if (!this->PatchSpool.Put(piece.Region, std::move(piece.Patch)))
      {
        return this->Fail(this->PatchSpool.GetError());
      }
    }
    return true;
  }

  bool WritePatch(vtkMTPatch&& patch, std::uint32_t fromNode, std::uint32_t toNode)
  {
    vtkMTRegionStep::RemoveReach(patch);
    this->Arcs.push_back({ vtkMTMakeArcRecord(patch, this->Lattice.Step), fromNode, toNode });
    return this->Sink.WritePatch(std::move(patch)) || this->Fail(this->Sink.GetError());
  }

  // Points that triangles of more than one next region use must stay as they are in the next step.
  bool FindLockedIds(std::vector<std::pair<std::uint64_t, std::uint32_t>>& uses)
  {
    std::sort(uses.begin(), uses.end());
    for (std::size_t i = 0; i < uses.size();)
    {
      std::size_t end = i;
      bool isLocked = false;
      for (; end < uses.size() && uses[end].first == uses[i].first; ++end)
      {
        isLocked = isLocked || uses[end].second != uses[i].second;
      }
      if (isLocked)
      {
        this->LockedIds.push_back(uses[i].first);
      }
      i = end;
    }
    std::sort(this->LockedIds.begin(), this->LockedIds.end());
    this->NextRegions = 0;
    for (std::size_t a = this->FirstArcOfLevel; a < this->Arcs.size(); ++a)
    {
      this->NextRegions = std::max(this->NextRegions, this->Arcs[a].FromNode + 1);
    }
    return true;
  }

  bool SimplifyRegions(std::uint32_t level)
  {
    const vtkMTRegionStep::Context context{ this->Options.Simplifier, &this->CarriedArrays, &this->LockedIds,
      level - 1 };
    std::vector<vtkMTRegionStep> steps(4 * static_cast<std::size_t>(this->Threads));
    this->LevelScan.Fragments.assign(this->NextRegions, {});
    this->NodeOfFragment.assign(this->NextRegions, None);
    this->LevelTriangles.push_back(0);
    if (!this->FragmentSpool.Reset(this->NextRegions))
    {
      return this->Fail(this->FragmentSpool.GetError());
    }
    const bool done = this->ForAll(
      this->NextRegions,
      [&](std::size_t region, std::size_t slot, std::string& error)
      {
        steps[slot] = vtkMTRegionStep();
        std::vector<vtkMTPatch> patches;
        if (!this->PatchSpool.Take(region, patches))
        {
          error = this->PatchSpool.GetError();
        }
        else if (!patches.empty() && steps[slot].Run(patches, context, error))
        {
          this->LevelScan.Fragments[region] = GetBarycentres(steps[slot].Fragment);
        }
      },
      [&](std::size_t region, std::size_t slot) { return this->PutFragment(level, region, steps[slot]); });
    for (std::size_t a = this->FirstArcOfLevel; done && a < this->Arcs.size(); ++a)
    {
      this->Arcs[a].FromNode = this->NodeOfFragment[this->Arcs[a].FromNode];
    }
    return done;
  }

  bool PutFragment(std::uint32_t level, std::size_t region, vtkMTRegionStep& step)
  {
    if (step.FloorTriangles == 0)
    {
      return true; // a region that lost all its triangles to its neighbours
    }
    this->SimplifiedTriangles += step.FloorTriangles;
    this->LevelTriangles.back() += step.Fragment.Triangles.size();
    this->NodeOfFragment[region] = static_cast<std::uint32_t>(this->Nodes.size());
    this->Nodes.push_back({ level, static_cast<std::uint32_t>(region), step.Error, step.EdgeLength });
    this->Graph.FullySharedBorders += step.HasFullySharedBorder ? 1 : 0;
    for (const auto& [cause, edges] : step.Blocked)
    {
      this->Graph.Blocked[cause] += edges;
    }
    return this->FragmentSpool.Put(region, std::move(step.Fragment)) || this->Fail(this->FragmentSpool.GetError());
  }

  // The last fragments are the coarsest patches.
  bool WriteRoots()
  {
    for (std::size_t f = 0; f < this->LevelScan.Fragments.size(); ++f)
    {
      std::vector<vtkMTPatch> meshes;
      if (!this->FragmentSpool.Take(f, meshes))
      {
        return this->Fail(this->FragmentSpool.GetError());
      }
      for (vtkMTPatch& mesh : meshes)
      {
        if (!this->WritePatch(std::move(mesh), None, this->NodeOfFragment[f]))
        {
          return false;
        }
      }
    }
    return true;
  }

  // Nodes from coarse to fine between source and sink, then everything that follows from them.
  bool FinishGraph()
  {
    std::vector<std::uint32_t> order(this->Nodes.size());
    for (std::uint32_t i = 0; i < order.size(); ++i)
    {
      order[i] = i;
    }
    std::stable_sort(order.begin(), order.end(),
      [this](std::uint32_t a, std::uint32_t b) { return this->Nodes[a].Level > this->Nodes[b].Level; });
    std::vector<std::uint32_t> place(order.size());
    this->Graph.Nodes.assign(order.size() + 2, vtkMTNode());
    const std::uint32_t levels = this->Nodes.empty() ? 0 : this->Nodes[order[0]].Level;
    this->Graph.Nodes[0].Level = levels + 1;
    for (std::uint32_t i = 0; i < order.size(); ++i)
    {
      const NodeRecord& record = this->Nodes[order[i]];
      vtkMTNode& node = this->Graph.Nodes[i + 1];
      node.Level = record.Level;
      node.Region = record.Region;
      node.OwnError = record.Error > 0.0
        ? std::nextafter(record.Error * this->Lattice.Step, std::numeric_limits<double>::infinity())
        : 0.0;
      node.EdgeLength = record.EdgeLength * this->Lattice.Step;
      place[order[i]] = i + 1;
    }
    const std::uint32_t sink = this->Graph.GetSink();
    for (const ArcRecord& record : this->Arcs)
    {
      vtkMTArc arc = record.Arc;
      arc.From = record.FromNode == None ? 0 : place[record.FromNode];
      arc.To = record.ToNode == None ? sink : place[record.ToNode];
      this->Graph.Arcs.push_back(arc);
    }
    const std::vector<std::uint32_t> patchOfArc = this->Graph.Index();
    this->Graph.Saturate(this->Lattice.MaximumShift);
    this->Graph.Settings["partition"] = this->Options.Partition->GetSettings();
    this->Graph.Settings["simplifier"] = this->Options.Simplifier->GetSettings();
    this->Graph.Settings["patch_triangles"] = std::to_string(this->Options.PatchTriangles);
    this->Graph.Settings["floor_triangles"] = std::to_string(std::llround(2.0 * this->GetRegionTarget()));
    return this->Sink.Finish(this->Graph, patchOfArc) || this->Fail(this->Sink.GetError());
  }

  static constexpr std::uint32_t MaximumLevels = 60; // identities have room for 61

  const Settings Options;
  const int Threads;
  vtkMTPatchSink& Sink;
  vtkMTSpool& FragmentSpool; // by region of the present partition
  vtkMTSpool& PatchSpool;    // by region of the next one
  vtkMTLattice Lattice;
  vtkMTGraph Graph;
  std::vector<vtkMTArrayInfo> CarriedArrays; // the input's and, last, the reach
  std::vector<NodeRecord> Nodes;
  std::vector<ArcRecord> Arcs; // in the order in which their patches were written
  std::size_t FirstArcOfLevel = 0;
  std::uint32_t NextRegions = 0;
  FragmentScan LevelScan;
  std::vector<std::uint32_t> NodeOfFragment;
  std::vector<std::uint64_t> LockedIds;
  std::vector<std::size_t> LevelTriangles;
  std::size_t InputTriangles = 0;
  std::size_t SimplifiedTriangles = 0;
};

vtkMTLevelLoop::vtkMTLevelLoop(
  const Settings& settings, vtkMTPatchSink& sink, vtkMTSpool& fragments, vtkMTSpool& patches)
  : Implementation(std::make_unique<Internals>(settings, sink, fragments, patches))
{
}

vtkMTLevelLoop::~vtkMTLevelLoop() = default;

bool vtkMTLevelLoop::Run(vtkMTInputMesh&& input)
{
  return this->Implementation->Run(std::move(input));
}

const std::string& vtkMTLevelLoop::GetError() const
{
  return this->Implementation->Error;
}

bool vtkMTLevelLoop::WasAborted() const
{
  return this->Implementation->Aborted;
}
