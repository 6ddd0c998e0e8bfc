// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTInputFragmentStep.h"

#include "vtkMTCertifiedMesh.h"
#include "vtkMTInputSpool.h"
#include "vtkMTPointNormals.h"
#include "vtkMTStageTimes.h"

#include <algorithm>

namespace
{
void Count(std::map<std::string, std::int64_t>& report, const char* reason, std::uint64_t count)
{
  if (count > 0)
  {
    report[reason] += static_cast<std::int64_t>(count);
  }
}
}

vtkMTInputFragmentStep::vtkMTInputFragmentStep(
  const vtkMTBuildSettings& settings, vtkMTSequenceState& state, std::uint32_t regions, bool makesNormals)
  : Settings(settings)
  , State(state)
  , NumberOfRegions(regions)
  , MakesNormals(makesNormals)
{
}

vtkMTInputFragmentStep::~vtkMTInputFragmentStep() = default;

bool vtkMTInputFragmentStep::Fail(const std::string& error)
{
  this->Error = error;
  return false;
}

bool vtkMTInputFragmentStep::Continue(const char* step, std::uint64_t done)
{
  this->Aborted = !this->Settings.Report({ 0.0, step, 0, done, this->State.LevelElements[0] });
  return !this->Aborted || this->Fail("aborted");
}

bool vtkMTInputFragmentStep::Make(vtkMTInputRegions& regions, const vtkMTInputSpool& input)
{
  vtkMTSequenceState& state = this->State;
  vtkMTInputFragment::Layout layout{ input.GetPoints().GetTupleSizes(), input.GetCellTupleSizes(),
    this->Settings.InputIds != vtkMTBuildSettings::Ids::None, this->Settings.InputPointIds, this->MakesNormals };
  for (const vtkMTArrayInfo& array : state.Graph.Arrays)
  {
    if (array.Role == vtkMTArrayInfo::ExactPoints)
    {
      layout.PointTupleSizes.push_back(array.GetTupleSize());
    }
  }
  vtkMTSpoolStore& store = *this->Settings.Store;
  const std::size_t memory = this->Settings.SortMemory / 8;
  this->Orientation = std::make_unique<vtkMTOrientation>(store, memory);
  this->Normals = std::make_unique<vtkMTSharedNormals>(store, memory / 2);
  this->SharedIds = std::make_unique<vtkMTSharedIds>(store, memory / 2);
  if (!this->Fragments.Begin(store, "input-fragments", this->NumberOfRegions, this->Error))
  {
    return false;
  }
  std::vector<Making> slots(vtkMTOrderedWork::GetNumberOfSlots(this->Settings.Threads));
  std::uint64_t done = 0;
  const bool made = this->ForAllRegions(
    [&](std::size_t region, std::size_t slot, std::string& error)
    {
      const vtkMTStageTimes::Scope sort(this->Settings.Times, vtkMTStageTimes::Sort);
      slots[slot] = Making();
      const bool taken = regions.Take(static_cast<std::uint32_t>(region), slots[slot].Records);
      error = taken ? error : regions.GetError();
      return taken;
    },
    [&](std::size_t region, std::size_t slot, std::string&)
    {
      const vtkMTStageTimes::Scope assemble(this->Settings.Times, vtkMTStageTimes::Assemble);
      Making& making = slots[slot];
      making.Fragment.Make(static_cast<std::uint32_t>(region), std::move(making.Records), layout);
      return true;
    },
    [&](std::size_t region, std::size_t slot, std::string& error)
    {
      const vtkMTStageTimes::Scope write(this->Settings.Times, vtkMTStageTimes::Write);
      done += slots[slot].Fragment.Mesh.Triangles.size();
      return this->PutMade(region, slots[slot], error) && this->Continue("making fragments", done);
    });
  return made && this->Fragments.Seal(this->Error);
}

bool vtkMTInputFragmentStep::PutMade(std::size_t region, Making& making, std::string& error)
{
  if (making.Fragment.Mesh.Triangles.empty())
  {
    return true;
  }
  {
    const vtkMTStageTimes::Scope sort(vtkMTStageTimes::Sort);
    if (!this->Orientation->Add(making.Fragment.Orientation, making.Fragment.Components))
    {
      error = this->Orientation->GetError();
      return false;
    }
    if (!this->Normals->Add(making.Fragment.Terms, making.Fragment.Components))
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
  }
  this->Angles.Add(making.Fragment.Angles);
  Bytes bytes;
  making.Fragment.Encode(bytes);
  return this->Fragments.Put(region, bytes.data(), bytes.size(), error);
}

//------------------------------------------------------------------------------
bool vtkMTInputFragmentStep::Finish()
{
  vtkMTSequenceState& state = this->State;
  {
    const vtkMTStageTimes::Scope sort(this->Settings.Times, vtkMTStageTimes::Sort);
    if (this->MakesNormals)
    {
      const double automatic = this->Angles.ChooseFeatureAngle();
      state.FeatureAngle = this->Settings.FeatureAngle < 0.0 ? automatic : this->Settings.FeatureAngle;
      state.AutomaticFeatureAngle = automatic;
      state.DihedralAngles = this->Angles.Describe();
    }
    if (!this->Orientation->Solve() ||
      !this->Normals->Solve(*this->Orientation, { state.FeatureAngle, this->Settings.NormalBits }) ||
      !this->SharedIds->Solve())
    {
      return this->Fail(this->Orientation->GetError() + this->Normals->GetError() + this->SharedIds->GetError());
    }
  }
  Count(state.Graph.InputReport, "reoriented_triangles", this->Orientation->GetNumberOfReversedTriangles());
  Count(state.Graph.InputReport, "not_orientable_triangles", this->Orientation->GetNumberOfNonOrientableTriangles());
  if (!state.Fragments.Begin(
        *this->Settings.Store, vtkMTSequenceState::GetFragmentsName(0), this->NumberOfRegions, this->Error))
  {
    return false;
  }
  std::vector<Finishing> slots(vtkMTOrderedWork::GetNumberOfSlots(this->Settings.Threads));
  std::uint64_t done = 0;
  const bool finished = this->ForAllRegions(
    [&](std::size_t region, std::size_t slot, std::string& error)
    {
      const vtkMTStageTimes::Scope assemble(this->Settings.Times, vtkMTStageTimes::Assemble);
      return this->Fetch(static_cast<std::uint32_t>(region), slots[slot], error);
    },
    [&](std::size_t, std::size_t slot, std::string&)
    {
      const vtkMTStageTimes::Scope assemble(this->Settings.Times, vtkMTStageTimes::Assemble);
      this->FinishOne(slots[slot]);
      return true;
    },
    [&](std::size_t region, std::size_t slot, std::string& error)
    {
      const vtkMTStageTimes::Scope write(this->Settings.Times, vtkMTStageTimes::Write);
      done += slots[slot].Triangles;
      const Bytes& record = slots[slot].Record;
      this->Fragments.Forget(region);
      return (record.empty() || state.Fragments.Put(region, record.data(), record.size(), error)) &&
        this->Continue("finishing fragments", done);
    });
  this->Fragments.Remove();
  state.NodeOfFragment.assign(this->NumberOfRegions, vtkMTSequenceState::None);
  return finished && state.Fragments.Seal(this->Error);
}

bool vtkMTInputFragmentStep::Fetch(std::uint32_t region, Finishing& finishing, std::string& error)
{
  finishing = Finishing();
  std::vector<vtkMTBytes::Record> records;
  if (!this->Fragments.Take(region, records, error))
  {
    return false;
  }
  if (!records.empty() && !finishing.Fragment.Decode(records[0], error))
  {
    return false;
  }
  const bool taken =
    !this->MakesNormals || this->Normals->Take(region, finishing.Fragment.Mesh, finishing.SharedNormals);
  // Normals are asked for by the input's numbers, so these are replaced after that.
  const bool numbered = taken && this->SharedIds->Take(region, finishing.Fragment.Mesh.Ids);
  error = taken ? this->SharedIds->GetError() : this->Normals->GetError();
  return numbered;
}

void vtkMTInputFragmentStep::FinishOne(Finishing& finishing) const
{
  vtkMTInputFragment& fragment = finishing.Fragment;
  finishing.Triangles = fragment.Mesh.Triangles.size();
  if (fragment.Mesh.Triangles.empty())
  {
    return;
  }
  fragment.TurnRound(*this->Orientation);
  if (this->MakesNormals)
  {
    this->AddNormals(finishing);
  }
  vtkMTCertifiedMesh certified; // it is the input itself: all deviations are zero
  certified.Mesh = std::move(fragment.Mesh);
  certified.Deviations.resize(certified.Mesh.Triangles.size());
  certified.Encode(finishing.Record);
}

void vtkMTInputFragmentStep::AddNormals(Finishing& finishing) const
{
  vtkMTPatch& mesh = finishing.Fragment.Mesh;
  std::vector<std::array<float, 3>> shared(mesh.Ids.size()); // of all triangles
  for (const vtkMTSharedNormals::Normal& normal : finishing.SharedNormals)
  {
    shared[normal.Point] = normal.Triangle == vtkMTSharedNormals::AllTriangles ? normal.Value : shared[normal.Point];
  }
  if (!(this->State.FeatureAngle < vtkMTDihedralAngles::Smooth))
  {
    std::vector<std::array<float, 3>> normals = vtkMTPointNormals::Compute(mesh, this->Settings.NormalBits);
    std::copy(shared.begin(), shared.end(), normals.begin());
    finishing.Fragment.AddNormals(normals);
    return;
  }
  std::vector<std::array<float, 3>> normals =
    vtkMTPointNormals::ComputeByCorner(mesh, this->State.FeatureAngle, this->Settings.NormalBits);
  const auto getPoint = [&mesh](std::size_t h) { return mesh.GetPointOfWedge(mesh.Triangles[h / 3][h % 3]); };
  for (std::size_t h = 0; h < normals.size(); ++h)
  {
    normals[h] = getPoint(h) < shared.size() ? shared[getPoint(h)] : normals[h];
  }
  for (const vtkMTSharedNormals::Normal& normal : finishing.SharedNormals)
  {
    for (std::size_t c = 0; c < 3 && normal.Triangle != vtkMTSharedNormals::AllTriangles; ++c)
    {
      const std::size_t h = 3 * std::size_t(normal.Triangle) + c;
      normals[h] = getPoint(h) == normal.Point ? normal.Value : normals[h];
    }
  }
  finishing.Fragment.AddNormalsByCorner(normals);
}

bool vtkMTInputFragmentStep::ForAllRegions(
  const vtkMTOrderedWork::Work& fetch, const vtkMTOrderedWork::Work& work, const vtkMTOrderedWork::Work& take)
{
  std::string error;
  const bool done = vtkMTOrderedWork::Run(this->NumberOfRegions, this->Settings.Threads, fetch, work, take, error);
  this->Error = error.empty() ? this->Error : error;
  return done;
}
