// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTJointSampling.h"

#include "vtkMTCut.h"
#include "vtkMTGraph.h"
#include "vtkMTPatchSource.h"
#include "vtkMTSurfaceSampler.h"

#include "vtkSetGet.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <sstream>

namespace
{
template <class Value>
void CopyTuple(const vtkMTColumn& column, std::size_t tuple, int components, double* values)
{
  for (int i = 0; i < components; ++i)
  {
    Value value;
    std::memcpy(&value, column.data() + (tuple * components + i) * sizeof(value), sizeof(value));
    values[i] = static_cast<double>(value);
  }
}
}

vtkMTJointSampling::Corners vtkMTJointSampling::Side::GetCorners(std::uint32_t triangle) const
{
  const vtkMTTriangle& t = this->Surface.Triangles[triangle];
  return { this->Surface.Points[t[0]], this->Surface.Points[t[1]], this->Surface.Points[t[2]] };
}

vtkMTRealPoint vtkMTJointSampling::Blend(const Corners& corners, double u, double v)
{
  vtkMTRealPoint x;
  for (int i = 0; i < 3; ++i)
  {
    x[i] = corners[0][i] * (1.0 - u - v) + corners[1][i] * u + corners[2][i] * v;
  }
  return x;
}

vtkMTJointSampling::vtkMTJointSampling(
  const vtkMTPatchSource& source, std::size_t samples, std::uint64_t seed, const std::string& noun)
  : Source(source)
  , Samples(samples)
  , Seed(seed)
  , Noun(noun)
  , Arrays(source.GetGraph().Arrays.size(), 0)
  , Check("certified_" + noun)
{
  double bounds[6];
  source.GetGraph().GetBounds(bounds);
  vtkMTRealBounds box;
  box.Add({ bounds[0], bounds[2], bounds[4] });
  box.Add({ bounds[1], bounds[3], bounds[5] });
  this->Frame = vtkMTMeasuringFrame::FromBounds(box);
}

vtkMTJointSampling::~vtkMTJointSampling() = default;

vtkMTJointSampling::Column vtkMTJointSampling::AddColumn(std::size_t array)
{
  const std::vector<vtkMTArrayInfo>& arrays = this->Source.GetGraph().Arrays;
  Column column;
  column.Array = static_cast<int>(array);
  for (std::size_t i = 0; i < array; ++i)
  {
    column.Index += arrays[i].Association == arrays[array].Association ? 1 : 0;
  }
  this->Arrays[array] = 1;
  return column;
}

void vtkMTJointSampling::GetTuple(
  const Column& column, const vtkMTPatch& patch, std::size_t triangle, std::size_t corner, double* values) const
{
  const vtkMTArrayInfo& array = this->Source.GetGraph().Arrays[column.Array];
  const bool ofPoints = array.Association == vtkMTArrayInfo::Point;
  const vtkMTColumn& bytes = ofPoints ? patch.PointColumns[column.Index] : patch.CellColumns[column.Index];
  const std::size_t tuple = ofPoints ? patch.Triangles[triangle][corner] : triangle;
  if (bytes.empty()) // an array of the finest level alone
  {
    std::fill_n(values, array.Components, std::numeric_limits<double>::quiet_NaN());
    return;
  }
  switch (array.Type)
  {
    vtkTemplateMacro(CopyTuple<VTK_TT>(bytes, tuple, array.Components, values));
  }
}

bool vtkMTJointSampling::Begin(const vtkMTVerificationProgress& progress, std::string& error)
{
  const vtkMTGraph& graph = this->Source.GetGraph();
  std::vector<std::uint32_t> arcs;
  for (std::uint32_t arc = 0; arc < graph.Arcs.size(); ++arc)
  {
    if (graph.IsFinest(arc))
    {
      arcs.push_back(arc);
    }
  }
  return this->Read(arcs, progress, this->Finest, error);
}

bool vtkMTJointSampling::Read(
  const std::vector<std::uint32_t>& arcs, const vtkMTVerificationProgress& progress, Side& side, std::string& error)
{
  const vtkMTGraph& graph = this->Source.GetGraph();
  side.Width = this->Width;
  vtkMTPatch patch;
  for (const std::uint32_t arc : arcs)
  {
    if (!progress("reading patches", 0.0) || !this->Source.ReadPatch(arc, &this->Arrays, patch, error))
    {
      return false;
    }
    side.Surface.Append(patch, graph.Lattice, this->Frame);
    for (std::size_t i = 0; i < patch.Triangles.size(); ++i)
    {
      this->AddData(patch, i, side);
    }
    side.Nodes.resize(side.Surface.Triangles.size(), graph.Arcs[arc].To);
  }
  return true;
}

// In local units.
double vtkMTJointSampling::GetReach(std::uint32_t node) const
{
  return this->Source.GetGraph().Nodes[node].Error / this->Frame.ToModel(1.0) + vtkMTMeasuringFrame::Tolerance;
}

// node: whose error and measure count; none: those of each triangle. reach: the largest of them.
bool vtkMTJointSampling::Find(const vtkMTClosestPoint& search, const Side& to, std::uint32_t nearest,
  const Wanted& wanted, const std::uint32_t* node, double reach) const
{
  const auto isFound = [&](std::uint32_t triangle)
  {
    const std::uint32_t by = node ? *node : to.Nodes[triangle];
    return this->HasPoint(to, triangle, wanted, by, this->GetReach(by));
  };
  bool found = isFound(nearest);
  if (!found)
  {
    search.VisitWithin(wanted.X, node ? this->GetReach(*node) : reach,
      [&](std::uint32_t triangle)
      {
        found = isFound(triangle);
        return !found;
      });
  }
  return found;
}

// ofFrom: whether error and measure are those of the surface that samples are taken of.
bool vtkMTJointSampling::Test(const Side& from, const Side& to, bool ofFrom, const std::string& name,
  std::uint64_t seed, const vtkMTVerificationProgress& progress)
{
  const vtkMTSurfaceSampler::Samples samples =
    vtkMTSurfaceSampler(from.Surface, this->Samples, seed).Take(0, this->Samples);
  const vtkMTClosestPoint search(to.Surface);
  double reach = 0.0;
  for (const std::uint32_t node : to.Nodes)
  {
    reach = std::max(reach, this->GetReach(node));
  }
  std::uint32_t hint = vtkMTClosestPoint::NoTriangle;
  for (std::size_t i = 0; i < samples.Triangles.size(); ++i)
  {
    if (i % 1024 == 0 && !progress(name, double(i) / double(samples.Triangles.size())))
    {
      return false;
    }
    Place place{ samples.Triangles[i], samples.Weights[i] };
    const auto& [u, v] = samples.Weights[i];
    if (i % 4 == 0)
    {
      place.Weights = { u > v && u > 1.0 - u - v ? 1.0 : 0.0, v >= u && v > 1.0 - u - v ? 1.0 : 0.0 };
    }
    Wanted wanted;
    wanted.X = Blend(from.GetCorners(place.Triangle), place.Weights[0], place.Weights[1]);
    hint = search.Find(wanted.X, hint).Triangle;
    const std::uint32_t* node = ofFrom ? &from.Nodes[place.Triangle] : nullptr;
    for (wanted.Part = 0; wanted.Part < this->GetNumberOfParts(); ++wanted.Part)
    {
      if (!this->Take(from, place, wanted))
      {
        ++this->Skipped;
        continue;
      }
      ++this->Check.Tested;
      if (!this->Find(search, to, hint, wanted, node, reach))
      {
        std::ostringstream text;
        text.precision(9);
        const vtkMTRealPoint at = this->Frame.ToModelPoint(wanted.X);
        text << name << ", near (" << at[0] << ", " << at[1] << ", " << at[2] << "): no point within the error has "
             << this->Describe(wanted, node ? *node : to.Nodes[hint]);
        this->Check.Fail(text.str());
      }
    }
  }
  return true;
}

bool vtkMTJointSampling::TestCut(
  const vtkMTCut& cut, const std::string& name, const vtkMTVerificationProgress& progress, std::string& error)
{
  Side side;
  return this->Read(cut.GetArcs(), progress, side, error) &&
    this->Test(side, this->Finest, true, name + " to the finest level's " + this->Noun, this->Seed, progress) &&
    this->Test(this->Finest, side, false, "the finest level's " + this->Noun + " to " + name, this->Seed + 1, progress);
}
