// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTCollapseRegion.h"

#include "vtkMTSimplifier.h"

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

vtkMTCollapseRegion::vtkMTCollapseRegion(const vtkMTPatch& floor, const vtkMTFanMesh& fans)
  : Floor(floor)
{
  this->Seams = fans.Seams;
  this->Faces = fans.GetNumberOfTriangles();
  this->PlaceOrigin();
  this->BuildSurface(fans);
}

void vtkMTCollapseRegion::PlaceOrigin()
{
  const vtkMTBox box = this->Floor.GetBox();
  double half = 1.0;
  for (int i = 0; i < 3; ++i)
  {
    const std::int64_t low = box[2 * i];
    const std::int64_t high = box[2 * i + 1];
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
}

void vtkMTCollapseRegion::BuildSurface(const vtkMTFanMesh& fans)
{
  const std::size_t corners = fans.Vertex.size();
  std::size_t borders = 0;
  for (const std::uint32_t f : fans.Opposite)
  {
    borders += f == vtkMTFanMesh::None ? 1 : 0;
  }
  const std::size_t edges = (corners + borders) / 2;
  using Size = Mesh::size_type;
  this->Surface.resize(
    static_cast<Size>(fans.GetNumberOfVertices()), static_cast<Size>(edges), static_cast<Size>(corners / 3));

  const double inverse = 1.0 / this->Scale;
  for (std::uint32_t v = 0; v < fans.GetNumberOfVertices(); ++v)
  {
    const vtkMTPoint& k = this->Floor.Points[fans.Point[v]];
    this->Surface.point(Vertex(v)) = Point(static_cast<double>(k[0] - this->Origin[0]) * inverse,
      static_cast<double>(k[1] - this->Origin[1]) * inverse, static_cast<double>(k[2] - this->Origin[2]) * inverse);
  }

  std::vector<Halfedge> halfedges(corners); // that of each edge of a triangle
  Size edge = 0;
  for (std::uint32_t c = 0; c < corners; ++c)
  {
    const std::uint32_t f = fans.Opposite[c];
    if (f == vtkMTFanMesh::None || c < f)
    {
      const Halfedge h = this->Surface.halfedge(Edge(edge++));
      halfedges[c] = h;
      if (f != vtkMTFanMesh::None)
      {
        halfedges[f] = this->Surface.opposite(h);
      }
    }
  }
  for (std::uint32_t c = 0; c < corners; ++c)
  {
    const Halfedge h = halfedges[c];
    const Face face(c / 3);
    const Vertex target(fans.Vertex[vtkMTFanMesh::Next(c)]);
    this->Surface.set_target(h, target);
    this->Surface.set_halfedge(target, h);
    this->Surface.set_next(h, halfedges[vtkMTFanMesh::Next(c)]);
    this->Surface.set_face(h, face);
    this->Surface.set_halfedge(face, h);
  }
  if (borders > 0)
  {
    this->LinkBorders(fans, halfedges);
  }
  this->FillStates(fans, halfedges);
}

// A vertex is one fan, so at most one border half-edge runs into it and one out of it.
void vtkMTCollapseRegion::LinkBorders(const vtkMTFanMesh& fans, const std::vector<Halfedge>& halfedges)
{
  std::vector<Halfedge> into(fans.GetNumberOfVertices());
  for (std::uint32_t c = 0; c < fans.Vertex.size(); ++c)
  {
    if (fans.Opposite[c] == vtkMTFanMesh::None)
    {
      const Halfedge h = this->Surface.opposite(halfedges[c]);
      const Vertex target(fans.Vertex[c]);
      this->Surface.set_target(h, target);
      this->Surface.set_face(h, Mesh::null_face());
      this->Surface.set_halfedge(target, h);
      into[target.idx()] = h;
    }
  }
  for (std::uint32_t c = 0; c < fans.Vertex.size(); ++c)
  {
    if (fans.Opposite[c] == vtkMTFanMesh::None)
    {
      const std::uint32_t source = fans.Vertex[vtkMTFanMesh::Next(c)];
      this->Surface.set_next(into[source], this->Surface.opposite(halfedges[c]));
    }
  }
}

void vtkMTCollapseRegion::FillStates(const vtkMTFanMesh& fans, const std::vector<Halfedge>& halfedges)
{
  this->States.resize(fans.GetNumberOfVertices());
  this->Parents.resize(this->Floor.Points.size());
  std::iota(this->Parents.begin(), this->Parents.end(), 0u);
  this->Marks.assign(fans.GetNumberOfVertices(), 0);
  for (std::uint32_t v = 0; v < fans.GetNumberOfVertices(); ++v)
  {
    this->States[v].Point = fans.Point[v];
    this->States[v].Lock = fans.Lock[v];
    this->States[v].Rank = fans.Lock[v] ? Kept : Plain;
    this->Split = this->Split || (fans.Lock[v] & vtkMTFanMesh::NonManifold);
  }
  if (this->Seams)
  {
    this->HalfedgeWedges.assign(this->Surface.number_of_halfedges(), vtkMTFanMesh::None);
  }
  for (std::uint32_t c = 0; c < fans.Vertex.size(); ++c)
  {
    VertexState& state = this->States[fans.Vertex[c]];
    state.Wedge = fans.Wedge[c];
    if (fans.Opposite[c] == vtkMTFanMesh::None && state.Rank == Plain)
    {
      state.Rank = Border;
    }
    if (this->Seams)
    {
      this->HalfedgeWedges[halfedges[vtkMTFanMesh::Previous(c)]] = fans.Wedge[c];
    }
  }
  if (this->Seams)
  {
    for (const Vertex v : this->Surface.vertices())
    {
      this->States[v.idx()].Rank = this->ComputeRank(v);
    }
  }
  this->Constrained.resize(this->Surface.number_of_edges());
  for (const Edge e : this->Surface.edges())
  {
    this->Constrained[e.idx()] =
      this->GetState(this->Surface.vertex(e, 0)).Lock && this->GetState(this->Surface.vertex(e, 1)).Lock ? 1 : 0;
  }
}

void vtkMTCollapseRegion::BeginCollapse(Halfedge h, const Point& place)
{
  const bool first = this->KeepsFirst(h, this->GetRule(h), place);
  this->Surviving = this->GetState(first ? this->Surface.source(h) : this->Surface.target(h));
  const VertexState& removed = this->GetState(first ? this->Surface.target(h) : this->Surface.source(h));
  this->Parents[removed.Point] = this->Surviving.Point;
  this->Faces -= (this->Surface.is_border(h) ? 0 : 1) + (this->Surface.is_border(this->Surface.opposite(h)) ? 0 : 1);
  if (this->Seams)
  {
    this->SaveCorners(h, first);
  }
}

void vtkMTCollapseRegion::EndCollapse(Vertex kept)
{
  this->States[kept.idx()] = this->Surviving;
  if (this->Seams)
  {
    this->RestoreCorners(kept);
  }
}

void vtkMTCollapseRegion::SaveCorners(Halfedge h, bool keepsFirst)
{
  const Mesh& m = this->Surface;
  const Halfedge removed = keepsFirst ? m.opposite(h) : h; // from the removed vertex to the kept one
  const Halfedge back = m.opposite(removed);
  const bool hasLeft = !m.is_border(removed);
  const bool hasRight = !m.is_border(back);
  const std::uint32_t left = this->HalfedgeWedges[hasLeft ? removed : m.prev(back)];
  const std::uint32_t right = this->HalfedgeWedges[hasRight ? m.prev(back) : removed];

  this->Saved.clear();
  // Around the removed vertex: its corners take the kept point's wedge of the same side, and a seam edge divides the
  // sides.
  std::uint32_t apex = left;
  for (Halfedge out = this->GetNextOut(removed); out != m.next(back); out = this->GetNextOut(out))
  {
    if (this->IsSeamEdge(out))
    {
      apex = right;
    }
    this->SaveCorner(out, apex);
  }
  for (Halfedge out = this->GetNextOut(back); out != m.next(removed); out = this->GetNextOut(out))
  {
    this->SaveCorner(out, this->HalfedgeWedges[m.prev(out)]);
  }
}

void vtkMTCollapseRegion::SaveCorner(Halfedge out, std::uint32_t apex)
{
  if (!this->Surface.is_border(out))
  {
    const Halfedge link = this->Surface.next(out);
    this->Saved.push_back({ link, apex, this->HalfedgeWedges[out], this->HalfedgeWedges[link] });
  }
}

void vtkMTCollapseRegion::RestoreCorners(Vertex kept)
{
  for (const SavedCorner& corner : this->Saved)
  {
    this->HalfedgeWedges[corner.Link] = corner.Target;
    this->HalfedgeWedges[this->Surface.next(corner.Link)] = corner.Apex;
    this->HalfedgeWedges[this->Surface.prev(corner.Link)] = corner.Source;
  }
  // Where seam edges have come together or have ended, vertices can change their rank.
  if (this->Surviving.Rank >= Seam)
  {
    for (const Halfedge h : CGAL::halfedges_around_target(kept, this->Surface))
    {
      const Vertex v = this->Surface.source(h);
      this->States[v.idx()].Rank = this->ComputeRank(v);
    }
    this->States[kept.idx()].Rank = this->ComputeRank(kept);
  }
}

vtkMTPoint vtkMTCollapseRegion::ToLattice(const Point& p) const
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
  constexpr std::uint32_t none = vtkMTFanMesh::None;
  std::vector<std::uint32_t> pointMap(this->Floor.Points.size(), none);
  std::vector<std::uint32_t> wedgeMap(this->Floor.GetNumberOfWedges(), none);
  result.Triangles.reserve(this->Faces);
  for (const Face f : this->Surface.faces())
  {
    vtkMTTriangle triangle;
    Halfedge h = this->Surface.halfedge(f);
    for (std::uint32_t& corner : triangle)
    {
      const Vertex v = this->Surface.target(h);
      const VertexState& state = this->GetState(v);
      const std::uint32_t wedge = this->Seams ? this->HalfedgeWedges[h] : state.Wedge;
      if (pointMap[state.Point] == none)
      {
        pointMap[state.Point] = static_cast<std::uint32_t>(result.Points.size());
        const vtkMTPoint& before = this->Floor.Points[state.Point];
        result.Points.push_back(state.Lock ? before : this->ToLattice(this->GetPlace(v)));
        result.PointOrigin.push_back(state.Point);
        result.Moved.push_back(result.Points.back() != before ? 1 : 0);
      }
      if (wedgeMap[wedge] == none)
      {
        wedgeMap[wedge] = static_cast<std::uint32_t>(result.WedgePoints.size());
        result.WedgePoints.push_back(pointMap[state.Point]);
        result.WedgeOrigin.push_back(wedge);
      }
      corner = wedgeMap[wedge];
      h = this->Surface.next(h);
    }
    result.Triangles.push_back(triangle);
  }
  this->ExtractHeirs(pointMap, result);
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
