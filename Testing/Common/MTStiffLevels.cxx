// SPDX-License-Identifier: BSD-3-Clause
#include "MTStiffLevels.h"

#include "vtkMTAssembler.h"
#include "vtkMTCut.h"
#include "vtkMTPatchStore.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
// For the rounding of coordinates in double precision, of the frame's size; nothing else is allowed for.
constexpr double Rounding = 1e-12;

bool IsFinite(const MTWorstPlace::Place& x)
{
  return std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]);
}

// What was found over what is allowed, where that is more than the rounding of coordinates.
double GetShare(double found, double allowed)
{
  return found <= Rounding ? 0.0 : found / (allowed + Rounding);
}
}

//------------------------------------------------------------------------------
MTStiffLevels::MTStiffLevels(vtkPolyData* input, const vtkMTPatchStore& store, std::size_t climbs, bool isSearched)
  : Store(store)
  , Climbs(climbs)
  , IsSearched(isSearched)
{
  this->ReadInput(input);
  if (isSearched && !store.GetGraph().IsEmpty())
  {
    this->InputSearch = std::make_unique<MTWorstPlace>(this->Input);
    this->Read(0, this->Finest);
    this->FinestSearch = std::make_unique<MTWorstPlace>(this->Finest.Surface);
  }
}

//------------------------------------------------------------------------------
// Triangles that are no surface are left out: a corner that is not finite, is not there, or is at the place of another.
void MTStiffLevels::ReadInput(vtkPolyData* input)
{
  std::vector<MTWorstPlace::Place> places(static_cast<std::size_t>(input->GetNumberOfPoints()));
  constexpr double infinity = std::numeric_limits<double>::infinity();
  MTWorstPlace::Place low{ infinity, infinity, infinity };
  MTWorstPlace::Place high{ -infinity, -infinity, -infinity };
  for (std::size_t p = 0; p < places.size(); ++p)
  {
    input->GetPoint(static_cast<vtkIdType>(p), places[p].data());
    for (int i = 0; i < 3 && IsFinite(places[p]); ++i)
    {
      low[i] = std::min(low[i], places[p][i]);
      high[i] = std::max(high[i], places[p][i]);
    }
  }
  vtkNew<vtkIdList> corners;
  for (vtkIdType t = 0; t < input->GetNumberOfPolys(); ++t)
  {
    input->GetPolys()->GetCellAtId(t, corners);
    bool isGood = corners->GetNumberOfIds() == 3;
    std::array<std::uint32_t, 3> triangle{ 0, 0, 0 };
    for (int c = 0; c < 3 && isGood; ++c)
    {
      const vtkIdType p = corners->GetId(c);
      isGood = p >= 0 && p < input->GetNumberOfPoints() && IsFinite(places[static_cast<std::size_t>(p)]);
      triangle[c] = static_cast<std::uint32_t>(isGood ? p : 0);
    }
    const auto isSame = [&](int a, int b) { return places[triangle[a]] == places[triangle[b]]; };
    if (isGood && !isSame(0, 1) && !isSame(1, 2) && !isSame(2, 0))
    {
      this->Input.Triangles.push_back(triangle);
    }
  }
  if (!(low[0] <= high[0]))
  {
    return;
  }
  double size = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    this->Center[i] = low[i] + 0.5 * (high[i] - low[i]);
    size = std::max(size, high[i] - low[i]);
  }
  this->Exponent = size > 0.0 ? -std::ilogb(size) - 1 : 0;
  this->Diagonal = std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
  for (const MTWorstPlace::Place& x : places)
  {
    this->Input.Points.push_back(IsFinite(x) ? this->ToLocal(x) : MTWorstPlace::Place{ 0.0, 0.0, 0.0 });
  }
}

//------------------------------------------------------------------------------
MTWorstPlace::Place MTStiffLevels::ToLocal(const MTWorstPlace::Place& x) const
{
  return { this->ToLocal(x[0] - this->Center[0]), this->ToLocal(x[1] - this->Center[1]),
    this->ToLocal(x[2] - this->Center[2]) };
}

//------------------------------------------------------------------------------
double MTStiffLevels::ToLocal(double distance) const
{
  return std::ldexp(distance, this->Exponent);
}

//------------------------------------------------------------------------------
bool MTStiffLevels::Read(std::uint32_t level, Cut& cut) const
{
  const vtkMTGraph& graph = this->Store.GetGraph();
  vtkMTCut arcs(graph);
  for (std::uint32_t n = 1; n < graph.Nodes.size(); ++n)
  {
    if (graph.Nodes[n].Level > level)
    {
      arcs.RefineWithDependencies(n);
    }
  }
  cut.Error = arcs.GetError();
  cut.FromInput = arcs.GetDistanceFromInput();
  cut.OwnDistance = std::max(cut.FromInput, arcs.GetDistanceToInput());
  vtkMTAssembler assembler(graph.Arrays);
  for (const std::uint32_t arc : arcs.GetArcs())
  {
    vtkMTPatch patch;
    std::string error;
    if (!this->Store.ReadPatch(arc, nullptr, patch, error) || !assembler.Add(patch))
    {
      return false;
    }
    cut.ToInput.resize(cut.ToInput.size() + patch.Triangles.size(), graph.GetDistanceToInput(arc));
  }
  const vtkMTPatch& mesh = assembler.GetMesh();
  for (const vtkMTPoint& k : mesh.Points)
  {
    cut.Lattice.Points.push_back({ k[0], k[1], k[2] });
    cut.Surface.Points.push_back(this->ToLocal(graph.Lattice.ToWorld(k)));
  }
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    const vtkMTTriangle corners = mesh.GetPointsOfTriangle(t);
    cut.Lattice.Triangles.push_back({ corners[0], corners[1], corners[2] });
  }
  cut.Surface.Triangles = cut.Lattice.Triangles;
  return true;
}

//------------------------------------------------------------------------------
MTWorstPlace::Surface MTStiffLevels::GetSurface(std::uint32_t level) const
{
  Cut cut;
  this->Read(level, cut);
  return cut.Surface;
}

//------------------------------------------------------------------------------
void MTStiffLevels::Search(const Cut& cut, MTStiffStudy::Level& found) const
{
  std::vector<double> allowed;
  for (const double certified : cut.ToInput)
  {
    allowed.push_back(this->ToLocal(certified));
  }
  double largest = 0.0;
  const std::vector<double> toInput = this->InputSearch->Search(cut.Surface, this->Climbs, allowed);
  for (std::size_t t = 0; t < toInput.size(); ++t)
  {
    largest = std::max(largest, toInput[t]);
    found.ViolatedPatch = std::max(found.ViolatedPatch, GetShare(toInput[t], allowed[t]));
  }
  for (const double distance : MTWorstPlace(cut.Surface).Search(this->Input, this->Climbs))
  {
    largest = std::max(largest, distance);
    found.ViolatedCut = std::max(found.ViolatedCut, GetShare(distance, this->ToLocal(cut.FromInput)));
  }
  found.Found = std::ldexp(largest, -this->Exponent);
}

//------------------------------------------------------------------------------
std::int64_t MTStiffLevels::CountFlipped(const Cut& cut) const
{
  std::int64_t flipped = 0;
  const double step = this->ToLocal(this->Store.GetGraph().Lattice.Step);
  for (std::size_t t = 0; t < cut.Surface.Triangles.size(); ++t)
  {
    MTWorstPlace::Place center{ 0.0, 0.0, 0.0 };
    for (int i = 0; i < 3; ++i)
    {
      for (const std::uint32_t p : cut.Surface.Triangles[t])
      {
        center[i] += cut.Surface.Points[p][i] / 3.0;
      }
    }
    const MTExactPredicates::Triangle triangle = cut.Lattice.GetTriangle(t);
    const auto near = this->FinestSearch->FindTriangles(center, this->FinestSearch->GetDistance(center) + step);
    const bool isRight = MTExactPredicates::IsDegenerate(triangle) ||
      std::any_of(near.begin(), near.end(),
        [&](std::uint32_t s)
        { return MTExactPredicates::GetNormalProductSign(triangle, this->Finest.Lattice.GetTriangle(s)) >= 0; });
    flipped += isRight ? 0 : 1;
  }
  return flipped;
}

//------------------------------------------------------------------------------
MTStiffStudy::Level MTStiffLevels::Measure(std::uint32_t level, std::size_t pairs) const
{
  MTStiffStudy::Level found;
  Cut cut;
  this->Read(level, cut);
  found.Triangles = cut.ToInput.size();
  found.Certified = cut.Error;
  found.OwnDistance = cut.OwnDistance;
  if (this->IsSearched)
  {
    this->Search(cut, found);
    found.Flipped = this->CountFlipped(cut);
    found.Topology = MTStiffTopology::Count(cut.Lattice);
    found.Topology.Intersections = MTStiffTopology::CountIntersections(cut.Lattice, pairs);
  }
  return found;
}
