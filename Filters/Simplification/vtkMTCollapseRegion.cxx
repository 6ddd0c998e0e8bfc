// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTCollapseRegion.h"

#include "vtkMTSimplifier.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

vtkMTCollapseRegion::vtkMTCollapseRegion(const vtkMTPatch& floor, const vtkMTFanMesh& fans)
  : Mesh(fans)
  , Seams(fans.Seams)
  , Faces(fans.GetNumberOfTriangles())
  , Floor(floor)
  , Parents(floor.Points.size())
  , Marks(fans.GetNumberOfVertices(), 0)
{
  std::iota(this->Parents.begin(), this->Parents.end(), 0u);
  this->PlaceVertices(fans);
  this->FillStates(fans);
  this->FillNormals();
}

void vtkMTCollapseRegion::FindBox(const vtkMTFanMesh& fans)
{
  constexpr std::int32_t most = std::numeric_limits<std::int32_t>::max();
  constexpr std::int32_t least = std::numeric_limits<std::int32_t>::min();
  vtkMTPoint low{ most, most, most };
  vtkMTPoint high{ least, least, least };
  for (const std::uint32_t point : fans.Point)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      low[i] = std::min(low[i], this->Floor.Points[point][i]);
      high[i] = std::max(high[i], this->Floor.Points[point][i]);
    }
  }
  this->Box = { low[0], high[0], low[1], high[1], low[2], high[2] };
}

void vtkMTCollapseRegion::PlaceVertices(const vtkMTFanMesh& fans)
{
  this->FindBox(fans);
  double half = 1.0;
  for (int i = 0; i < 3; ++i)
  {
    const std::int64_t low = this->Box[2 * i];
    const std::int64_t high = this->Box[2 * i + 1];
    if (low > high)
    {
      continue;
    }
    const std::int64_t sum = low + high;
    this->Origin[i] = (sum - (sum & 1)) / 2;
    half = std::max(half, static_cast<double>(high - this->Origin[i]));
  }
  int exponent = 0;
  std::frexp(half, &exponent);
  this->Scale = std::ldexp(1.0, exponent);
  this->Magic = std::ldexp(1.5, 52 - exponent);
  const double inverse = 1.0 / this->Scale;
  for (std::size_t v = 0; v < this->Mesh.Places.size(); ++v)
  {
    const vtkMTPoint& k = this->Floor.Points[fans.Point[v]];
    for (int i = 0; i < 3; ++i)
    {
      this->Mesh.Places[v].At[i] = static_cast<double>(k[i] - this->Origin[i]) * inverse;
    }
  }
}

void vtkMTCollapseRegion::FillStates(const vtkMTFanMesh& fans)
{
  this->States.resize(fans.GetNumberOfVertices());
  for (std::uint32_t v = 0; v < this->States.size(); ++v)
  {
    this->States[v].Point = fans.Point[v];
    this->States[v].Wedge = fans.WedgeOf[v];
    this->States[v].Lock = fans.Lock[v];
    this->States[v].Rank = fans.Lock[v] ? Kept : Plain;
    this->Split = this->Split || (fans.Lock[v] & vtkMTFanMesh::NonManifold);
  }
  for (std::uint32_t c = 0; c < fans.Vertex.size(); ++c)
  {
    if (fans.Opposite[c] == vtkMTFanMesh::None)
    {
      VertexState& state = this->States[fans.Vertex[c]];
      state.Rank = std::max<unsigned char>(state.Rank, Border);
    }
  }
  for (std::uint32_t v = 0; this->Seams && v < this->States.size(); ++v)
  {
    this->States[v].Rank = this->ComputeRank(v);
  }
}

// What is true of every collapse, whoever makes it. Gives the half-edge from the vertex that disappears.
std::uint32_t vtkMTCollapseRegion::NoteCollapse(std::uint32_t h, const Vector& place)
{
  const std::uint32_t removed = this->KeepsFirst(h, this->GetRule(h), place) ? h ^ 1 : h;
  this->Surviving = this->GetState(this->Mesh.GetTarget(removed));
  this->Parents[this->GetState(this->Mesh.GetSource(removed)).Point] = this->Surviving.Point;
  this->Faces -= (this->Mesh.IsBorder(h) ? 0 : 1) + (this->Mesh.IsBorder(h ^ 1) ? 0 : 1);
  if (this->Seams)
  {
    this->SaveCorners(removed);
  }
  return removed;
}

std::uint32_t vtkMTCollapseRegion::Collapse(std::uint32_t h, const Vector& place)
{
  const std::uint32_t removed = this->NoteCollapse(h, place);
  const std::uint32_t kept = this->Mesh.GetTarget(removed);
  this->Mesh.Collapse(removed);
  this->Mesh.Places[kept].At = place;
  this->UpdateStates(kept);
  if (this->Foreseen.Edge == h && this->Foreseen.Place == place)
  {
    for (const ForeseenNormal& foreseen : this->Foreseen.Normals)
    {
      this->Normals[foreseen.Face].At = foreseen.Normal;
    }
    this->Foreseen.Edge = None;
    return kept;
  }
  this->UpdateNormals(kept);
  return kept;
}

void vtkMTCollapseRegion::BeginCollapse(std::uint32_t h, const Vector& place)
{
  this->NoteCollapse(h, place);
}

void vtkMTCollapseRegion::EndCollapse(std::uint32_t kept)
{
  this->UpdateStates(kept);
  this->UpdateNormals(kept);
}

void vtkMTCollapseRegion::UpdateStates(std::uint32_t kept)
{
  this->States[kept] = this->Surviving;
  if (this->Seams)
  {
    this->RestoreCorners();
    this->UpdateRanks(kept);
  }
}

// The corners of the triangles around both vertices as they will be, each found again by the half-edge opposite to it,
// which a collapse keeps.
void vtkMTCollapseRegion::SaveCorners(std::uint32_t removed)
{
  const vtkMTCollapseMesh& m = this->Mesh;
  const std::uint32_t back = removed ^ 1;
  const std::uint32_t atLeft = m.IsBorder(removed) ? m.GetPrevious(back) : removed;
  const std::uint32_t atRight = m.IsBorder(back) ? removed : m.GetPrevious(back);
  this->Saved.clear();
  // Around the removed vertex: its corners take the kept point's wedge of the same side, and a seam edge divides the
  // sides.
  std::uint32_t apex = m.Wedges[atLeft];
  for (std::uint32_t out = m.GetNextOut(removed); out != m.GetNext(back); out = m.GetNextOut(out))
  {
    if (this->IsSeamEdge(out))
    {
      apex = m.Wedges[atRight];
    }
    this->SaveCorner(out, apex);
  }
  for (std::uint32_t out = m.GetNextOut(back); out != m.GetNext(removed); out = m.GetNextOut(out))
  {
    this->SaveCorner(out, m.Wedges[m.GetPrevious(out)]);
  }
}

void vtkMTCollapseRegion::SaveCorner(std::uint32_t out, std::uint32_t apex)
{
  if (!this->Mesh.IsBorder(out))
  {
    const std::uint32_t link = this->Mesh.GetNext(out);
    this->Saved.push_back({ link, apex, this->Mesh.Wedges[out], this->Mesh.Wedges[link] });
  }
}

void vtkMTCollapseRegion::RestoreCorners()
{
  for (const SavedCorner& corner : this->Saved)
  {
    this->Mesh.Wedges[corner.Link] = corner.Target;
    this->Mesh.Wedges[this->Mesh.GetNext(corner.Link)] = corner.Apex;
    this->Mesh.Wedges[this->Mesh.GetPrevious(corner.Link)] = corner.Source;
  }
}

// Where seam edges have come together or have ended, vertices can change their rank.
void vtkMTCollapseRegion::UpdateRanks(std::uint32_t kept)
{
  if (this->Surviving.Rank < Seam)
  {
    return;
  }
  const std::uint32_t begin = this->Mesh.Outs[kept];
  std::uint32_t h = begin;
  do
  {
    const std::uint32_t v = this->Mesh.GetTarget(h);
    this->States[v].Rank = this->ComputeRank(v);
    h = this->Mesh.GetNextOut(h);
  } while (h != begin);
  this->States[kept].Rank = this->ComputeRank(kept);
}

vtkMTPoint vtkMTCollapseRegion::ToLattice(const Vector& p) const
{
  vtkMTPoint k;
  for (int i = 0; i < 3; ++i)
  {
    const std::int64_t v = this->Origin[i] + static_cast<std::int64_t>(std::nearbyint(p[i] * this->Scale));
    k[i] = static_cast<std::int32_t>(
      std::clamp<std::int64_t>(v, std::numeric_limits<std::int32_t>::min(), std::numeric_limits<std::int32_t>::max()));
  }
  return k;
}

void vtkMTCollapseRegion::Extract(vtkMTSimplification& result) const
{
  Extraction numbers{ std::vector<std::uint32_t>(this->Floor.Points.size(), None),
    std::vector<std::uint32_t>(this->Floor.GetNumberOfWedges(), None) };
  std::vector<std::uint32_t> ofVertices(this->Seams ? 0 : this->States.size(), None); // their wedges in the result
  result.Triangles.reserve(this->Faces);
  for (std::uint32_t h : this->Mesh.Faces)
  {
    if (h == None)
    {
      continue;
    }
    vtkMTTriangle triangle;
    for (std::uint32_t& corner : triangle)
    {
      const std::uint32_t v = this->Mesh.GetTarget(h);
      if (this->Seams)
      {
        corner = this->ExtractWedge(v, this->Mesh.Wedges[h], numbers, result);
      }
      else
      {
        std::uint32_t& ofVertex = ofVertices[v];
        ofVertex = ofVertex == None ? this->ExtractWedge(v, this->GetState(v).Wedge, numbers, result) : ofVertex;
        corner = ofVertex;
      }
      h = this->Mesh.GetNext(h);
    }
    result.Triangles.push_back(triangle);
  }
  this->ExtractHeirs(numbers.OfPoints, result);
}

// The result's number of a wedge of the vertex.
std::uint32_t vtkMTCollapseRegion::ExtractWedge(
  std::uint32_t v, std::uint32_t wedge, Extraction& numbers, vtkMTSimplification& result) const
{
  const VertexState& state = this->GetState(v);
  std::uint32_t& point = numbers.OfPoints[state.Point];
  if (point == None)
  {
    point = static_cast<std::uint32_t>(result.Points.size());
    const vtkMTPoint& before = this->Floor.Points[state.Point];
    result.Points.push_back(state.Lock ? before : this->ToLattice(this->Mesh.GetPlace(v)));
    result.PointOrigin.push_back(state.Point);
    result.Moved.push_back(result.Points.back() != before ? 1 : 0);
  }
  if (numbers.OfWedges[wedge] == None)
  {
    numbers.OfWedges[wedge] = static_cast<std::uint32_t>(result.WedgePoints.size());
    result.WedgePoints.push_back(point);
    result.WedgeOrigin.push_back(wedge);
  }
  return numbers.OfWedges[wedge];
}

void vtkMTCollapseRegion::ExtractHeirs(const std::vector<std::uint32_t>& pointMap, vtkMTSimplification& result) const
{
  std::vector<std::uint32_t> parents = this->Parents;
  result.Heirs.resize(parents.size());
  for (std::uint32_t p = 0; p < parents.size(); ++p)
  {
    std::uint32_t root = p;
    while (parents[root] != root)
    {
      parents[root] = parents[parents[root]];
      root = parents[root];
    }
    result.Heirs[p] = pointMap[root]; // None where no triangle uses it
  }
}
