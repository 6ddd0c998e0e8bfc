// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTInputMesh.h"

#include "vtkMTExactPoints.h"
#include "vtkMTFarOutliers.h"
#include "vtkMTInputFragmentStep.h"
#include "vtkMTInputRegions.h"
#include "vtkMTInputSpool.h"
#include "vtkMTMadeNormals.h"
#include "vtkMTOrderedWork.h"
#include "vtkMTPartitionStrategy.h"
#include "vtkMTPatchSplitter.h"
#include "vtkMTPointWelding.h"
#include "vtkMTSequenceState.h"
#include "vtkMTStageTimes.h"
#include "vtkMTTriangleStream.h"
#include "vtkMTTrimHeap.h"

#include "vtkDataSetAttributes.h"
#include "vtkType.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace
{
using Barycentre = vtkMTBarycentreSpool::Barycentre;

// A block of the input with what is made of it, over its bytes as it is stored.
constexpr std::uint64_t MemoryPerByteOfBlock = 5;

void Count(std::map<std::string, std::int64_t>& report, const char* reason, std::uint64_t count)
{
  if (count > 0)
  {
    report[reason] += static_cast<std::int64_t>(count);
  }
}

vtkMTArrayInfo MakeNormalInfo(const std::vector<vtkMTArrayInfo>& others, int bits)
{
  vtkMTArrayInfo info;
  info.Name = "Normals";
  const auto isTaken = [&info](const vtkMTArrayInfo& other)
  { return other.Association == vtkMTArrayInfo::Point && other.Name == info.Name; };
  while (std::any_of(others.begin(), others.end(), isTaken))
  {
    info.Name = "Made" + info.Name;
  }
  info.Type = VTK_FLOAT;
  info.Components = 3;
  info.Resampling = vtkMTArrayInfo::Direction;
  info.Role = vtkMTArrayInfo::MadeNormals;
  info.Attribute = vtkDataSetAttributes::NORMALS;
  vtkMTMadeNormals::SetBits(bits, info);
  return info;
}

bool HasNormals(const std::vector<vtkMTArrayInfo>& arrays)
{
  return std::any_of(arrays.begin(), arrays.end(),
    [](const vtkMTArrayInfo& info)
    { return info.Association == vtkMTArrayInfo::Point && info.Attribute == vtkDataSetAttributes::NORMALS; });
}

// Which of the cell arrays holds the part that a triangle is of; -1: none.
int FindPartColumn(const std::vector<vtkMTArrayInfo>& arrays)
{
  int column = -1;
  for (const vtkMTArrayInfo& info : arrays)
  {
    column += info.Association == vtkMTArrayInfo::Cell ? 1 : 0;
    if (info.Association == vtkMTArrayInfo::Cell && info.Name == "PartId" && info.Type == VTK_INT &&
      info.Components == 1)
    {
      return column;
    }
  }
  return -1;
}
}

class vtkMTInputMesh::Internals
{
public:
  explicit Internals(const vtkMTBuildSettings& settings)
    : Settings(settings)
  {
  }

  bool Read(vtkMTTriangleStream& stream, vtkMTSequenceState& state)
  {
    this->State = &state;
    vtkMTInputSpool input(this->Settings);
    vtkMTFarOutliers outliers(this->Settings.LatticeBits, *this->Settings.Store, this->Settings.SortMemory / 2);
    const auto visit = [&](const vtkMTInputBlock& block)
    { return outliers.Add(block) || this->Fail(outliers.GetError()); };
    if (!input.Load(stream, visit))
    {
      this->Aborted = input.WasAborted();
      return this->Error.empty() ? this->Fail(input.GetError()) : false;
    }
    state.LevelElements.assign(1, input.GetNumberOfTriangles());
    if (!this->CheckTriangles(input) || !this->FindOutliers(input, outliers) ||
      !this->SetUpArrays(stream, input.GetPoints().IsSingle()))
    {
      return false;
    }
    state.Graph.InputCounts.Triangles = input.GetNumberOfInputTriangles();
    state.Graph.InputReport = input.GetReport();
    state.Graph.Lattice = vtkMTLattice::FromBounds(outliers.GetBounds().data(), this->Settings.LatticeBits);
    state.LevelElements.assign(1, input.GetNumberOfTriangles());
    vtkMTPointWelding stitch(*this->Settings.Store, this->Settings.SortMemory / 4);
    this->Regions = std::make_unique<vtkMTInputRegions>(
      this->Settings, input, this->Settings.ExactPoints ? &this->Exact : nullptr, this->Settings.SortMemory / 4 * 3);
    if (!this->SortIntoRegions(input, stitch))
    {
      return false;
    }
    vtkMTInputFragmentStep fragments(this->Settings, state, this->NumberOfRegions, this->MakesNormals);
    bool done = fragments.Make(*this->Regions, input);
    this->Report(stream, input, stitch);
    this->Regions.reset();
    input.ForgetBlocks();
    input.ForgetPoints();
    done = done && fragments.Finish();
    this->Aborted = fragments.WasAborted();
    return done || this->Fail(fragments.GetError());
  }

  std::string Error;
  std::string Warning;
  bool Aborted = false;

private:
  bool Fail(const std::string& error)
  {
    this->Error = error;
    return false;
  }

  bool Continue(const char* step, std::uint64_t done)
  {
    this->Aborted = !this->Settings.Report({ 0.0, step, 0, done, this->State->LevelElements[0] });
    return !this->Aborted || this->Fail("aborted");
  }

  bool CheckTriangles(const vtkMTInputSpool& input)
  {
    if (input.GetNumberOfTriangles() > 0)
    {
      return true;
    }
    return this->Fail(input.GetNumberOfInputTriangles() == 0
        ? "the input has no triangles"
        : "none of the input's " + std::to_string(input.GetNumberOfInputTriangles()) +
          " triangles is usable (all are degenerate, not finite, or refer to points that do not exist)");
  }

  bool FindOutliers(vtkMTInputSpool& input, vtkMTFarOutliers& outliers)
  {
    const vtkMTStageTimes::Scope sort(this->Settings.Times, vtkMTStageTimes::Sort);
    bool good = outliers.FinishStep();
    vtkMTInputBlock block;
    while (good && !outliers.IsFinished() && !this->Settings.KeepFarOutliers)
    {
      for (std::size_t i = 0; good && i < input.GetNumberOfBlocks(); ++i)
      {
        good = input.ReadBlock(i, block, this->Error) && outliers.Add(block) &&
          this->Continue("looking for far outliers", i * vtkMTInputBlock::Size);
      }
      good = good && outliers.FinishStep();
    }
    if (!good || outliers.IsRefused())
    {
      return this->Error.empty() ? this->Fail(outliers.GetError() + outliers.GetMessage()) : false;
    }
    this->Warning = outliers.GetMessage();
    return input.LeaveOut([&outliers](const vtkMTInputBlock& of, const vtkMTInputBlock::Triangle& t)
             { return outliers.IsFar(of, t); },
             "dropped_far_outlier", outliers.GetNumberOfOutliers()) ||
      this->Fail(input.GetError());
  }

  bool SetUpArrays(const vtkMTTriangleStream& stream, bool isSingle)
  {
    std::vector<vtkMTArrayInfo>& arrays = this->State->Graph.Arrays;
    arrays = stream.GetArrays();
    const std::string missing =
      vtkMTArrayInfo::ChooseMeanings(this->Settings.LabelArrays, this->Settings.ValueArrays, arrays);
    if (!missing.empty())
    {
      return this->Fail("the input has no array \"" + missing + "\"");
    }
    this->State->CertifiedArrays = this->Settings.CertifiedArrays;
    const std::string uncertifiable = vtkMTArrayInfo::FindUncertifiable(this->Settings.CertifiedArrays, arrays);
    if (!uncertifiable.empty())
    {
      return this->Fail(uncertifiable);
    }
    this->MakesNormals = this->Settings.MakeNormals && !HasNormals(arrays);
    if (this->Settings.ExactPoints)
    {
      this->Exact = vtkMTExactPoints::MakeInfo(isSingle, arrays);
      arrays.push_back(this->Exact);
    }
    this->Settings.AddIdArrays(arrays);
    if (this->MakesNormals)
    {
      arrays.push_back(MakeNormalInfo(arrays, this->Settings.NormalBits));
    }
    return true;
  }

  void Report(const vtkMTTriangleStream& stream, const vtkMTInputSpool& input, const vtkMTPointWelding& stitch)
  {
    std::map<std::string, std::int64_t>& report = this->State->Graph.InputReport;
    for (const auto& [reason, count] : stream.GetReport())
    {
      Count(report, reason.c_str(), static_cast<std::uint64_t>(count));
    }
    Count(report, "stitched_edges", static_cast<std::uint64_t>(stitch.GetNumberOfStitchedEdges()));
    Count(report, "stitched_points", static_cast<std::uint64_t>(stitch.GetNumberOfWeldedPoints()));
    Count(report, "seam_wedges", this->Regions->GetNumberOfSeamWedges());
    Count(report, "isolated_points", input.GetPoints().GetNumberOfPoints() - this->Regions->GetNumberOfUsedPoints());
  }

  //----------------------------------------------------------------------------
  // Psi_0
  bool SortIntoRegions(vtkMTInputSpool& input, vtkMTPointWelding& stitch)
  {
    vtkMTBarycentreSpool scan;
    if (!scan.Begin(*this->Settings.Store, "input-barycentres", this->Error) ||
      !this->PutBarycentres(input, stitch, scan) || !scan.Seal(this->Error))
    {
      return false;
    }
    const auto partition = this->MakePartition(scan);
    scan.Remove();
    if (!partition || !this->PutTriangles(input, *partition))
    {
      return false;
    }
    const vtkMTStageTimes::Scope sort(this->Settings.Times, vtkMTStageTimes::Sort);
    if (!input.IsInMemory()) // there regions are taken from what is kept
    {
      input.ForgetBlocks();
    }
    const bool found = this->Regions->FindPoints(stitch, this->State->Graph.Lattice);
    if (!input.IsInMemory())
    {
      input.ForgetPoints();
    }
    this->Aborted = this->Regions->WasAborted();
    return found || this->Fail(this->Regions->GetError());
  }

  // A block of the input that is worked on.
  struct BlockWork
  {
    vtkMTInputBlock Block;
    vtkMTPatch Mesh; // points and triangles on the lattice
    std::vector<Barycentre> Barycentres;
    vtkMTPointWelding::BlockEdges Edges;
    double LargestShift2 = 0.0;
    vtkMTInputRegions::BlockRecords Records;
  };

  // work by several threads with every block, take in order with what came of it.
  bool ForAllBlocks(const vtkMTInputSpool& input, const std::function<void(BlockWork&)>& work,
    const std::function<bool(std::size_t, BlockWork&)>& take)
  {
    const vtkMTTrimHeap trim(this->Settings.MemoryLimit);
    std::vector<BlockWork> slots(vtkMTOrderedWork::GetNumberOfSlots(input.GetNumberOfThreads()));
    const vtkMTOrderedWork::Budget budget{ this->Settings.BlockMemory,
      [&input](std::size_t index) { return MemoryPerByteOfBlock * input.GetBlockSize(index); } };
    std::string error;
    const bool done = vtkMTOrderedWork::Run(
      input.GetNumberOfBlocks(), input.GetNumberOfThreads(), budget,
      [&](std::size_t index, std::size_t slot, std::string& message)
      {
        const vtkMTStageTimes::Scope seed(this->Settings.Times, vtkMTStageTimes::Seed);
        if (!input.ReadBlock(index, slots[slot].Block, message))
        {
          return false;
        }
        this->FindBarycentres(slots[slot]);
        work(slots[slot]);
        return true;
      },
      [&](std::size_t index, std::size_t slot, std::string&)
      {
        const vtkMTStageTimes::Scope sort(this->Settings.Times, vtkMTStageTimes::Sort);
        const bool taken = take(index, slots[slot]);
        slots[slot] = BlockWork();
        return taken;
      },
      error);
    this->Error = error.empty() ? this->Error : error;
    return done;
  }

  std::unique_ptr<vtkMTPartition> MakePartition(vtkMTBarycentreSpool& scan)
  {
    const vtkMTStageTimes::Scope seed(this->Settings.Times, vtkMTStageTimes::Seed, true);
    scan.SetContinue([this] { return this->Continue("placing regions", 0); });
    auto partition = this->Settings.Partition->Build(scan, this->Settings.GetRegionTarget(), 0);
    if (!partition)
    {
      this->Error = this->Aborted ? this->Error : "the partition of level 0 could not be made: " + scan.GetError();
      return nullptr;
    }
    this->NumberOfRegions = partition->GetNumberOfRegions();
    if (this->NumberOfRegions > vtkMTPatchSplitter::MaximumRegions)
    {
      this->Error = "the partition of level 0 has more regions than identities allow";
      return nullptr;
    }
    return partition;
  }

  bool PutTriangles(const vtkMTInputSpool& input, const vtkMTPartition& partition)
  {
    std::uint64_t done = 0;
    return this->ForAllBlocks(
      input,
      [&](BlockWork& work)
      {
        std::vector<std::uint32_t> regions(work.Barycentres.size());
        partition.LocateAll(work.Barycentres.data(), regions.size(), regions.data());
        const vtkMTStageTimes::Scope sort(vtkMTStageTimes::Sort);
        work.Records = this->Regions->MakeRecords(work.Block, regions);
      },
      [&](std::size_t, BlockWork& work)
      {
        done += work.Barycentres.size();
        return (this->Regions->Add(work.Block, std::move(work.Records)) || this->Fail(this->Regions->GetError())) &&
          this->Continue("sorting into regions", done);
      });
  }

  // In the same pass: stitching, and the largest shift to the lattice.
  bool PutBarycentres(const vtkMTInputSpool& input, vtkMTPointWelding& stitch, vtkMTBarycentreSpool& scan)
  {
    const int partColumn = FindPartColumn(this->State->Graph.Arrays);
    vtkMTLattice& lattice = this->State->Graph.Lattice;
    double largest = 0.0; // in steps, so that the square neither underflows nor overflows at extreme scales
    const bool put = this->ForAllBlocks(
      input,
      [&](BlockWork& work)
      {
        work.LargestShift2 = GetLargestShift2(lattice, work);
        const vtkMTStageTimes::Scope sort(vtkMTStageTimes::Sort);
        work.Edges = vtkMTPointWelding::FindEdges(work.Block);
      },
      [&](std::size_t index, BlockWork& work)
      {
        largest = std::max(largest, work.LargestShift2);
        return (stitch.Add(work.Block, work.Edges, partColumn) || this->Fail(stitch.GetError())) &&
          scan.Put(work.Barycentres, this->Error) &&
          this->Continue("finding barycentres", index * vtkMTInputBlock::Size);
      });
    // Four roundings at most: 2^-50 covers them.
    lattice.MaximumShift = std::sqrt(largest) * (1.0 + std::ldexp(1.0, -50)) * lattice.Step;
    if (largest > 0.0 && lattice.MaximumShift < std::numeric_limits<double>::min())
    {
      // Denormal numbers are rounded more coarsely than that.
      lattice.MaximumShift = std::nextafter(lattice.MaximumShift, std::numeric_limits<double>::infinity());
    }
    const vtkMTStageTimes::Scope sort(this->Settings.Times, vtkMTStageTimes::Sort);
    return put && (stitch.Finish() || this->Fail(stitch.GetError()));
  }

  static double GetLargestShift2(const vtkMTLattice& lattice, const BlockWork& work)
  {
    const std::vector<unsigned char> used = work.Block.GetUsed();
    double largest = 0.0;
    for (std::size_t p = 0; p < used.size(); ++p)
    {
      largest = used[p] ? std::max(largest, GetShift2(lattice, work.Block.Places[p], work.Mesh.Points[p])) : largest;
    }
    return largest;
  }

  static double GetShift2(const vtkMTLattice& lattice, const vtkMTInputBlock::Place& place, const vtkMTPoint& point)
  {
    const std::array<double, 3> snapped = lattice.ToWorld(point);
    double shift2 = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      const double shift = (snapped[i] - place[i]) / lattice.Step;
      shift2 += shift * shift;
    }
    return shift2;
  }

  void FindBarycentres(BlockWork& work) const
  {
    const vtkMTLattice lattice = this->State->Graph.Lattice;
    work.Mesh.Triangles = work.Block.Triangles;
    work.Mesh.Points.reserve(work.Block.Places.size());
    for (const vtkMTInputBlock::Place& place : work.Block.Places)
    {
      work.Mesh.Points.push_back(lattice.Snap(place.data()));
    }
    work.Barycentres = vtkMTBarycentreSpool::GetBarycentres(work.Mesh);
  }

  const vtkMTBuildSettings& Settings;
  vtkMTSequenceState* State = nullptr;
  bool MakesNormals = false;
  vtkMTArrayInfo Exact; // of use when exact points are asked for
  std::uint32_t NumberOfRegions = 0;
  std::unique_ptr<vtkMTInputRegions> Regions;
};

vtkMTInputMesh::vtkMTInputMesh(const vtkMTBuildSettings& settings)
  : Implementation(std::make_unique<Internals>(settings))
{
}

vtkMTInputMesh::~vtkMTInputMesh() = default;

bool vtkMTInputMesh::Read(vtkMTTriangleStream& stream, vtkMTSequenceState& state)
{
  return this->Implementation->Read(stream, state);
}

const std::string& vtkMTInputMesh::GetError() const
{
  return this->Implementation->Error;
}

const std::string& vtkMTInputMesh::GetWarning() const
{
  return this->Implementation->Warning;
}

bool vtkMTInputMesh::WasAborted() const
{
  return this->Implementation->Aborted;
}
