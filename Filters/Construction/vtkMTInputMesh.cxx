// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTInputMesh.h"

#include "vtkMTBuildState.h"
#include "vtkMTExactPoints.h"
#include "vtkMTFarOutliers.h"
#include "vtkMTInputFragment.h"
#include "vtkMTInputRegions.h"
#include "vtkMTInputSpool.h"
#include "vtkMTOrderedWork.h"
#include "vtkMTPartitionStrategy.h"
#include "vtkMTPatchRecord.h"
#include "vtkMTPatchSplitter.h"
#include "vtkMTPointNormals.h"
#include "vtkMTRegionStep.h"
#include "vtkMTSharedIds.h"
#include "vtkMTStitch.h"
#include "vtkMTTriangleStream.h"

#include "vtkDataSetAttributes.h"
#include "vtkType.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
using Barycentre = vtkMTBarycentreSpool::Barycentre;
using Bytes = std::vector<unsigned char>;

void Count(std::map<std::string, std::int64_t>& report, const char* reason, std::uint64_t count)
{
  if (count > 0)
  {
    report[reason] += static_cast<std::int64_t>(count);
  }
}

vtkMTArrayInfo MakeCellIdInfo()
{
  vtkMTArrayInfo info;
  info.Name = "vtkMTInputCellIds";
  info.Type = VTK_ID_TYPE;
  info.Association = vtkMTArrayInfo::Cell;
  info.Resampling = vtkMTArrayInfo::Nearest;
  info.Role = vtkMTArrayInfo::InputCellIds;
  return info;
}

vtkMTArrayInfo MakeNormalInfo(const std::vector<vtkMTArrayInfo>& others)
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
  return info;
}

bool HasNormals(const std::vector<vtkMTArrayInfo>& arrays)
{
  return std::any_of(arrays.begin(), arrays.end(),
    [](const vtkMTArrayInfo& info)
    { return info.Association == vtkMTArrayInfo::Point && info.Attribute == vtkDataSetAttributes::NORMALS; });
}

// Which of the cell arrays says of what part a triangle is; -1: none.
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

  bool Read(vtkMTTriangleStream& stream, vtkMTBuildState& state)
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
    state.LevelTriangles.assign(1, input.GetNumberOfTriangles());
    if (!this->CheckTriangles(input) || !this->FindOutliers(input, outliers))
    {
      return false;
    }
    this->SetUpArrays(stream, input.IsSingle());
    state.Graph.InputTriangles = input.GetInputTriangles();
    state.Graph.InputReport = input.GetReport();
    state.Graph.Lattice = vtkMTLattice::FromBounds(outliers.GetBounds().data(), this->Settings.LatticeBits);
    state.LevelTriangles.assign(1, input.GetNumberOfTriangles());
    vtkMTStitch stitch(*this->Settings.Store, this->Settings.SortMemory / 4);
    this->Regions = std::make_unique<vtkMTInputRegions>(
      this->Settings, input, this->Settings.ExactPoints ? &this->Exact : nullptr, this->Settings.SortMemory / 4 * 3);
    if (!this->SortIntoRegions(input, stitch) || !this->MakeFragments(input))
    {
      return false;
    }
    this->Report(stream, input, stitch);
    return this->FinishFragments();
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
    this->Aborted = !this->Settings.Report({ 0.0, step, 0, done, this->State->LevelTriangles[0] });
    return !this->Aborted || this->Fail("aborted");
  }

  bool CheckTriangles(const vtkMTInputSpool& input)
  {
    if (input.GetNumberOfTriangles() > 0)
    {
      return true;
    }
    return this->Fail(input.GetInputTriangles() == 0
        ? "the input has no triangles"
        : "none of the input's " + std::to_string(input.GetInputTriangles()) +
          " triangles is usable (all are degenerate, not finite, or refer to points that do not exist)");
  }

  bool FindOutliers(vtkMTInputSpool& input, vtkMTFarOutliers& outliers)
  {
    bool good = outliers.FinishStep();
    vtkMTInputBlock block;
    while (good && !outliers.IsFinished() && !this->Settings.KeepFarOutliers)
    {
      for (std::size_t i = 0; good && i < input.GetNumberOfBlocks(); ++i)
      {
        good = (input.ReadBlock(i, block) || this->Fail(input.GetError())) && outliers.Add(block) &&
          this->Continue("looking for far outliers", i * vtkMTInputBlock::Size);
      }
      good = good && outliers.FinishStep();
    }
    if (!good || outliers.IsRefused())
    {
      return this->Error.empty() ? this->Fail(outliers.GetError() + outliers.GetMessage()) : false;
    }
    this->Warning = outliers.GetMessage();
    input.LeaveOut([&outliers](const vtkMTInputBlock& of, const vtkMTInputBlock::Triangle& t)
      { return outliers.IsFar(of, t); },
      "dropped_far_outlier", outliers.GetNumberOfOutliers());
    return true;
  }

  void SetUpArrays(const vtkMTTriangleStream& stream, bool isSingle)
  {
    std::vector<vtkMTArrayInfo>& arrays = this->State->Graph.Arrays;
    arrays = stream.GetArrays();
    this->MakesNormals = this->Settings.MakeNormals && !HasNormals(arrays);
    if (this->Settings.ExactPoints)
    {
      this->Exact = vtkMTExactPoints::MakeInfo(isSingle, arrays);
      arrays.push_back(this->Exact);
    }
    arrays.push_back(MakeCellIdInfo());
    if (this->MakesNormals)
    {
      arrays.push_back(MakeNormalInfo(arrays));
    }
  }

  void Report(const vtkMTTriangleStream& stream, const vtkMTInputSpool& input, const vtkMTStitch& stitch)
  {
    std::map<std::string, std::int64_t>& report = this->State->Graph.InputReport;
    for (const auto& [reason, count] : stream.GetReport())
    {
      Count(report, reason.c_str(), static_cast<std::uint64_t>(count));
    }
    Count(report, "stitched_edges", static_cast<std::uint64_t>(stitch.GetStitchedEdges()));
    Count(report, "stitched_points", static_cast<std::uint64_t>(stitch.GetStitchedPoints()));
    Count(report, "seam_wedges", this->Regions->GetSeamWedges());
    Count(report, "isolated_points", input.GetNumberOfPoints() - this->Regions->GetUsedPoints());
  }

  //----------------------------------------------------------------------------
  // Psi_0
  bool SortIntoRegions(vtkMTInputSpool& input, vtkMTStitch& stitch)
  {
    vtkMTBarycentreSpool scan;
    if (!scan.Begin(*this->Settings.Store, "input-barycentres", this->Error) ||
      !this->PutBarycentres(input, stitch, scan) || !scan.Seal(this->Error))
    {
      return false;
    }
    scan.SetContinue([this] { return this->Continue("placing regions", 0); });
    const auto partition = this->Settings.Partition->Build(scan, this->Settings.GetRegionTarget(), 0);
    if (!partition)
    {
      return this->Aborted ? false : this->Fail("the partition of level 0 could not be made: " + scan.GetError());
    }
    scan.Remove();
    this->NumberOfRegions = partition->GetNumberOfRegions();
    if (this->NumberOfRegions > vtkMTPatchSplitter::MaximumRegions)
    {
      return this->Fail("the partition of level 0 has more regions than identities allow");
    }
    vtkMTInputBlock block;
    std::vector<std::uint32_t> regions;
    std::uint64_t done = 0;
    for (std::size_t i = 0; i < input.GetNumberOfBlocks(); ++i)
    {
      if (!input.ReadBlock(i, block))
      {
        return this->Fail(input.GetError());
      }
      this->Locate(*partition, this->GetBarycentres(block), regions);
      done += regions.size();
      if (!this->Regions->Add(block, regions) || !this->Continue("sorting into regions", done))
      {
        return this->Error.empty() ? this->Fail(this->Regions->GetError()) : false;
      }
    }
    input.ForgetBlocks();
    const bool found = this->Regions->FindPoints(stitch, this->State->Graph.Lattice);
    input.ForgetPoints();
    this->Aborted = this->Regions->WasAborted();
    return found || this->Fail(this->Regions->GetError());
  }

  // In the same pass: stitching, and the largest shift to the lattice.
  bool PutBarycentres(vtkMTInputSpool& input, vtkMTStitch& stitch, vtkMTBarycentreSpool& scan)
  {
    const int partColumn = FindPartColumn(this->State->Graph.Arrays);
    vtkMTLattice& lattice = this->State->Graph.Lattice;
    double largest = 0.0; // in steps, so that the square neither underflows nor overflows at extreme scales
    vtkMTInputBlock block;
    for (std::size_t i = 0; i < input.GetNumberOfBlocks(); ++i)
    {
      if (!input.ReadBlock(i, block))
      {
        return this->Fail(input.GetError());
      }
      if (!stitch.Add(block, partColumn))
      {
        return this->Fail(stitch.GetError());
      }
      const std::vector<unsigned char> used = block.GetUsed();
      for (std::size_t p = 0; p < used.size(); ++p)
      {
        largest = used[p] ? std::max(largest, GetShift2(lattice, block.Places[p])) : largest;
      }
      if (!scan.Put(this->GetBarycentres(block), this->Error) ||
        !this->Continue("finding barycentres", i * vtkMTInputBlock::Size))
      {
        return false;
      }
    }
    // Four roundings at most: 2^-50 covers them.
    lattice.MaximumShift = std::sqrt(largest) * (1.0 + std::ldexp(1.0, -50)) * lattice.Step;
    if (largest > 0.0 && lattice.MaximumShift < std::numeric_limits<double>::min())
    {
      // Denormal numbers are rounded more coarsely than that.
      lattice.MaximumShift = std::nextafter(lattice.MaximumShift, std::numeric_limits<double>::infinity());
    }
    return stitch.Finish() || this->Fail(stitch.GetError());
  }

  static double GetShift2(const vtkMTLattice& lattice, const vtkMTInputBlock::Place& place)
  {
    const std::array<double, 3> snapped = lattice.ToWorld(lattice.Snap(place.data()));
    double shift2 = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      const double shift = (snapped[i] - place[i]) / lattice.Step;
      shift2 += shift * shift;
    }
    return shift2;
  }

  std::vector<Barycentre> GetBarycentres(const vtkMTInputBlock& block) const
  {
    vtkMTPatch mesh;
    mesh.Triangles = block.Triangles;
    for (const vtkMTInputBlock::Place& place : block.Places)
    {
      mesh.Points.push_back(this->State->Graph.Lattice.Snap(place.data()));
    }
    return vtkMTBarycentreSpool::GetBarycentres(mesh);
  }

  void Locate(const vtkMTPartition& partition, const std::vector<Barycentre>& barycentres,
    std::vector<std::uint32_t>& regions) const
  {
    regions.resize(barycentres.size());
    const std::ptrdiff_t count = static_cast<std::ptrdiff_t>(regions.size());
#pragma omp parallel for num_threads(this->Settings.Threads) schedule(static)
    for (std::ptrdiff_t t = 0; t < count; ++t)
    {
      regions[t] = partition.Locate(barycentres[t]);
    }
  }

  //----------------------------------------------------------------------------
  // Fragments, but for what depends on other fragments
  struct Making
  {
    vtkMTInputRegions::Region Records;
    vtkMTInputFragment Fragment;
    std::vector<Barycentre> Barycentres;
  };

  bool MakeFragments(const vtkMTInputSpool& input)
  {
    vtkMTBuildState& state = *this->State;
    vtkMTInputFragment::Layout layout{ this->Regions->GetTriangleSize(), this->Regions->GetPointSize(),
      input.GetPointTupleSizes(), input.GetCellTupleSizes(), this->MakesNormals };
    if (this->Settings.ExactPoints)
    {
      layout.PointTupleSizes.push_back(this->Exact.GetTupleSize());
    }
    vtkMTSpoolStore& store = *this->Settings.Store;
    const std::size_t memory = this->Settings.SortMemory / 8;
    this->Orientation = std::make_unique<vtkMTOrientation>(store, memory);
    this->Normals = std::make_unique<vtkMTSharedNormals>(store, memory / 2);
    this->SharedIds = std::make_unique<vtkMTSharedIds>(store, memory / 2);
    if (!this->Fragments.Begin(store, "input-fragments", this->NumberOfRegions, this->Error) ||
      !state.Barycentres.Begin(store, vtkMTBuildState::GetBarycentresName(0), this->Error))
    {
      return false;
    }
    std::vector<Making> slots(vtkMTOrderedWork::GetNumberOfSlots(this->Settings.Threads));
    std::uint64_t done = 0;
    const bool made = this->ForAllRegions(
      [&](std::size_t region, std::size_t slot, std::string& error)
      {
        slots[slot] = Making();
        const bool taken = this->Regions->Take(static_cast<std::uint32_t>(region), slots[slot].Records);
        error = taken ? error : this->Regions->GetError();
        return taken;
      },
      [&](std::size_t region, std::size_t slot, std::string&)
      {
        Making& making = slots[slot];
        making.Fragment.Make(static_cast<std::uint32_t>(region), std::move(making.Records), layout);
        making.Barycentres = vtkMTBarycentreSpool::GetBarycentres(making.Fragment.Mesh);
        return true;
      },
      [&](std::size_t region, std::size_t slot, std::string& error)
      {
        done += slots[slot].Barycentres.size();
        return this->PutMade(region, slots[slot], error) && this->Continue("making fragments", done);
      });
    return made && this->Fragments.Seal(this->Error) && state.Barycentres.Seal(this->Error);
  }

  bool PutMade(std::size_t region, Making& making, std::string& error)
  {
    if (making.Fragment.Mesh.Triangles.empty())
    {
      return true;
    }
    if (!this->Orientation->Add(making.Fragment.Orientation, making.Fragment.Pieces))
    {
      error = this->Orientation->GetError();
      return false;
    }
    if (!this->Normals->Add(making.Fragment.Terms, making.Fragment.Pieces))
    {
      error = this->Normals->GetError();
      return false;
    }
    if (!this->SharedIds->Add(
          static_cast<std::uint32_t>(region), making.Fragment.Mesh.Ids, making.Fragment.SharedPlaces))
    {
      error = this->SharedIds->GetError();
      return false;
    }
    Bytes mesh;
    Bytes orientation;
    making.Fragment.Encode(mesh, orientation);
    return this->Fragments.Put(region, mesh.data(), mesh.size(), error) &&
      this->Fragments.Put(region, orientation.data(), orientation.size(), error) &&
      this->State->Barycentres.Put(making.Barycentres, error);
  }

  //----------------------------------------------------------------------------
  // And that
  struct Finishing
  {
    vtkMTInputFragment Fragment;
    std::vector<std::array<float, 3>> SharedNormals;
    Bytes Record;
  };

  bool FinishFragments()
  {
    vtkMTBuildState& state = *this->State;
    this->Regions.reset();
    if (!this->Orientation->Solve() || !this->Normals->Solve(*this->Orientation) || !this->SharedIds->Solve())
    {
      return this->Fail(this->Orientation->GetError() + this->Normals->GetError() + this->SharedIds->GetError());
    }
    Count(state.Graph.InputReport, "reoriented_triangles", this->Orientation->GetReversedTriangles());
    Count(state.Graph.InputReport, "not_orientable_triangles", this->Orientation->GetNonOrientableTriangles());
    if (!state.Fragments.Begin(
          *this->Settings.Store, vtkMTBuildState::GetFragmentsName(0), this->NumberOfRegions, this->Error))
    {
      return false;
    }
    std::vector<Finishing> slots(vtkMTOrderedWork::GetNumberOfSlots(this->Settings.Threads));
    std::uint64_t done = 0;
    const bool finished = this->ForAllRegions([&](std::size_t region, std::size_t slot, std::string& error)
      { return this->Fetch(static_cast<std::uint32_t>(region), slots[slot], error); },
      [&](std::size_t, std::size_t slot, std::string&)
      {
        this->Finish(slots[slot]);
        return true;
      },
      [&](std::size_t region, std::size_t slot, std::string& error)
      {
        done += slots[slot].Fragment.Mesh.Triangles.size();
        const Bytes& record = slots[slot].Record;
        return (record.empty() || state.Fragments.Put(region, record.data(), record.size(), error)) &&
          this->Continue("finishing fragments", done);
      });
    this->Fragments.Remove();
    state.NodeOfFragment.assign(this->NumberOfRegions, vtkMTBuildState::None);
    return finished && state.Fragments.Seal(this->Error);
  }

  bool Fetch(std::uint32_t region, Finishing& finishing, std::string& error)
  {
    finishing = Finishing();
    std::vector<Bytes> records;
    if (!this->Fragments.Take(region, records, error))
    {
      return false;
    }
    if (records.size() == 2 && !finishing.Fragment.Decode(records[0], records[1], error))
    {
      return false;
    }
    finishing.SharedNormals.resize(finishing.Fragment.Mesh.Ids.size());
    const bool taken =
      !this->MakesNormals || this->Normals->Take(region, finishing.Fragment.Mesh, finishing.SharedNormals);
    // Normals are asked for by the input's numbers, so these are replaced after that.
    const bool numbered = taken && this->SharedIds->Take(region, finishing.Fragment.Mesh.Ids);
    error = taken ? this->SharedIds->GetError() : this->Normals->GetError();
    return numbered;
  }

  void Finish(Finishing& finishing) const
  {
    vtkMTInputFragment& fragment = finishing.Fragment;
    if (fragment.Mesh.Triangles.empty())
    {
      return;
    }
    fragment.TurnRound(*this->Orientation);
    if (this->MakesNormals)
    {
      std::vector<std::array<float, 3>> normals = vtkMTPointNormals::Compute(fragment.Mesh);
      std::copy(finishing.SharedNormals.begin(), finishing.SharedNormals.end(), normals.begin());
      fragment.AddNormals(normals);
    }
    vtkMTRegionStep::AppendReachOfInput(fragment.Mesh);
    vtkMTPatchRecord::Encode(fragment.Mesh, finishing.Record);
  }

  bool ForAllRegions(
    const vtkMTOrderedWork::Work& fetch, const vtkMTOrderedWork::Work& work, const vtkMTOrderedWork::Work& take)
  {
    std::string error;
    const bool done = vtkMTOrderedWork::Run(this->NumberOfRegions, this->Settings.Threads, fetch, work, take, error);
    this->Error = error.empty() ? this->Error : error;
    return done;
  }

  const vtkMTBuildSettings& Settings;
  vtkMTBuildState* State = nullptr;
  bool MakesNormals = false;
  vtkMTArrayInfo Exact; // of use when exact points are asked for
  std::uint32_t NumberOfRegions = 0;
  std::unique_ptr<vtkMTInputRegions> Regions;
  std::unique_ptr<vtkMTOrientation> Orientation;
  std::unique_ptr<vtkMTSharedNormals> Normals;
  std::unique_ptr<vtkMTSharedIds> SharedIds;
  vtkMTRecordSpool Fragments; // by region, with their orientation
};

vtkMTInputMesh::vtkMTInputMesh(const vtkMTBuildSettings& settings)
  : Implementation(std::make_unique<Internals>(settings))
{
}

vtkMTInputMesh::~vtkMTInputMesh() = default;

bool vtkMTInputMesh::Read(vtkMTTriangleStream& stream, vtkMTBuildState& state)
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
