// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTCollapseRegion.h"

#include "vtkMTSimplifier.h"

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cmath>
#include <limits>

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

bool vtkMTCollapseRegion::IsSeamEdge(Halfedge h) const
{
  if (!this->Seams || this->IsBorderEdge(h))
  {
    return false;
  }
  const Halfedge o = this->Surface.opposite(h);
  return this->HalfedgeWedges[h] != this->HalfedgeWedges[this->Surface.prev(o)] ||
    this->HalfedgeWedges[o] != this->HalfedgeWedges[this->Surface.prev(h)];
}

unsigned char vtkMTCollapseRegion::ComputeRank(Vertex v) const
{
  if (this->GetState(v).Lock)
  {
    return Kept;
  }
  int seams = 0;
  bool border = false;
  const Halfedge begin = this->Surface.opposite(this->Surface.halfedge(v));
  Halfedge h = begin;
  do
  {
    seams += this->IsSeamEdge(h) ? 1 : 0;
    border = border || this->Surface.is_border(h);
    h = this->GetNextOut(h);
  } while (h != begin);
  if (seams == 0)
  {
    return border ? Border : Plain;
  }
  return seams == 2 && !border ? Seam : Kept;
}

vtkMTCollapseRegion::Rule vtkMTCollapseRegion::GetRuleOfRanks(
  Halfedge h, unsigned char r0, unsigned char r1) const
{
  const unsigned char low = std::min(r0, r1);
  if (low == Kept || (low == Border && !this->IsBorderEdge(h)) || (low == Seam && !this->CanSlide(h)))
  {
    return Rule::Refused;
  }
  if (r0 == r1)
  {
    return low == Seam ? Rule::Ends : Rule::Free;
  }
  return r0 > r1 ? Rule::First : Rule::Second;
}

// Along a seam edge, unless the collapse would lay two seam edges upon each other.
bool vtkMTCollapseRegion::CanSlide(Halfedge h) const
{
  if (!this->IsSeamEdge(h))
  {
    return false;
  }
  const Halfedge o = this->Surface.opposite(h);
  return !(this->IsSeamEdge(this->Surface.next(h)) && this->IsSeamEdge(this->Surface.prev(h))) &&
    !(this->IsSeamEdge(this->Surface.next(o)) && this->IsSeamEdge(this->Surface.prev(o)));
}

bool vtkMTCollapseRegion::KeepsFirst(Halfedge h, Rule rule, const Point& place) const
{
  const Vertex v0 = this->Surface.source(h);
  const Vertex v1 = this->Surface.target(h);
  switch (rule)
  {
    case Rule::First:
      return true;
    case Rule::Second:
      return false;
    case Rule::Ends:
      return place == this->GetPlace(v0);
    default:
      break;
  }
  const double d0 = (place - this->GetPlace(v0)).squared_length();
  const double d1 = (place - this->GetPlace(v1)).squared_length();
  return d0 != d1 ? d0 < d1 : this->GetState(v0).Point < this->GetState(v1).Point;
}

bool vtkMTCollapseRegion::MakesChord(Halfedge h, Rule rule) const
{
  // All new edges join the vertex that is kept to a neighbour of the other one.
  const Halfedge removed = rule == Rule::First ? this->Surface.opposite(h) : h; // runs from the removed vertex
  const Vertex kept = this->Surface.target(removed);
  if (rule == Rule::Free || rule == Rule::Ends || !this->GetState(kept).Lock)
  {
    return false;
  }
  // The third vertices of the edge's own triangles are neighbours of the kept one already; there the edge must not become
  // a border because the removed triangle was the last one on its side.
  const Mesh& m = this->Surface;
  const Halfedge left = this->GetNextOut(removed);
  const Halfedge right = m.next(m.opposite(removed));
  for (Halfedge out = left; out != removed; out = this->GetNextOut(out))
  {
    if (!this->GetState(m.target(out)).Lock)
    {
      continue;
    }
    const bool ofLeft = out == left && !m.is_border(removed);
    const bool ofRight = out == right && !m.is_border(m.opposite(removed));
    if ((!ofLeft && !ofRight) || this->IsBorderEdge(out))
    {
      return true;
    }
  }
  return false;
}

bool vtkMTCollapseRegion::MakesDoubleEdge(Halfedge h) const
{
  if (!this->Split)
  {
    return false;
  }
  // Before the collapse no free vertex is next to two fans of one point. Afterwards the kept vertex could be, with one fan
  // next to either of the two, and so could a neighbour where the kept vertex is itself a fan.
  const Mesh& m = this->Surface;
  for (const Halfedge start : { h, m.opposite(h) })
  {
    const Vertex other = m.target(start);
    const bool otherIsFan = (this->GetState(other).Lock & vtkMTFanMesh::NonManifold) != 0;
    for (Halfedge out = this->GetNextOut(start); out != start; out = this->GetNextOut(out))
    {
      const Vertex v = m.target(out);
      if (((this->GetState(v).Lock & vtkMTFanMesh::NonManifold) && this->IsNextToOtherFan(other, v)) ||
        (otherIsFan && this->IsNextToOtherFan(v, other)))
      {
        return true;
      }
    }
  }
  return false;
}

// Whether v has a neighbour that is of fan's point but is not fan.
bool vtkMTCollapseRegion::IsNextToOtherFan(Vertex v, Vertex fan) const
{
  const std::uint32_t point = this->GetState(fan).Point;
  for (const Vertex w : CGAL::vertices_around_target(v, this->Surface))
  {
    if (w != fan && this->GetState(w).Point == point)
    {
      return true;
    }
  }
  return false;
}

bool vtkMTCollapseRegion::TurnsTriangle(Halfedge h, const Point& place) const
{
  const Halfedge o = this->Surface.opposite(h);
  return (place != this->GetPlace(this->Surface.source(h)) &&
           this->TurnsTriangleOf(h, this->Surface.next(o), place)) ||
    (place != this->GetPlace(this->Surface.target(h)) && this->TurnsTriangleOf(o, this->Surface.next(h), place));
}

// The triangles around the source of out, those at the edge itself left out: from after out until before end.
bool vtkMTCollapseRegion::TurnsTriangleOf(Halfedge out, Halfedge end, const Point& place) const
{
  const Point& p = this->GetPlace(this->Surface.source(out));
  for (Halfedge h = this->GetNextOut(out); h != end; h = this->GetNextOut(h))
  {
    if (this->Surface.is_border(h))
    {
      continue;
    }
    const Point& a = this->GetPlace(this->Surface.target(h));
    const Point& b = this->GetPlace(this->Surface.target(this->Surface.next(h)));
    const Vector before = CGAL::cross_product(a - p, b - p);
    const Vector after = CGAL::cross_product(a - place, b - place);
    if (!(before * after > 0.0) && before != CGAL::NULL_VECTOR)
    {
      return true;
    }
  }
  return false;
}

bool vtkMTCollapseRegion::AreUnfolded(const Point& p0, const Point& p1, const Point& p2, const Point& p3)
{
  const Vector d = p2 - p0;
  const Vector n = CGAL::cross_product(p1 - p0, d);
  const Vector m = CGAL::cross_product(d, p3 - p0);
  const double dot = n * m;
  constexpr double squaredCosine = 0.99969541350954788; // of one degree
  return dot > 0.0 || dot * dot <= squaredCosine * (n.squared_length() * m.squared_length());
}

// After the collapse the triangles around the kept vertex are, counter-clockwise, those of v0 from vL to vR and then those of
// v1 from vR to vL, each of them place, a, b with the half-edge a -> b opposite to place.
bool vtkMTCollapseRegion::FoldsEdge(Halfedge h, const Point& place) const
{
  const Mesh& m = this->Surface;
  Vertex previousA;
  Vertex previousB;
  Vertex firstA;
  Vertex firstB;
  for (const Halfedge start : { h, m.opposite(h) })
  {
    const Halfedge end = m.next(m.opposite(start));
    for (Halfedge out = this->GetNextOut(start); out != end; out = this->GetNextOut(out))
    {
      if (m.is_border(out))
      {
        continue;
      }
      const Halfedge link = m.next(out);
      const Vertex a = m.target(out);
      const Vertex b = m.target(link);
      if (this->FoldsAtLink(h, link, place) ||
        (previousB == a && !AreUnfolded(place, this->GetPlace(previousA), this->GetPlace(a), this->GetPlace(b))))
      {
        return true;
      }
      if (firstA == Mesh::null_vertex())
      {
        firstA = a;
        firstB = b;
      }
      previousA = a;
      previousB = b;
    }
  }
  return previousB != Mesh::null_vertex() && previousB == firstA && previousA != firstB &&
    !AreUnfolded(place, this->GetPlace(previousA), this->GetPlace(firstA), this->GetPlace(firstB));
}

// The triangle across a link edge stays where it is, unless it is one of those around the edge itself.
bool vtkMTCollapseRegion::FoldsAtLink(Halfedge h, Halfedge link, const Point& place) const
{
  const Mesh& m = this->Surface;
  const Halfedge outer = m.opposite(link);
  if (m.is_border(outer))
  {
    return false;
  }
  const Vertex w = m.target(m.next(outer));
  return w != m.source(h) && w != m.target(h) &&
    !AreUnfolded(this->GetPlace(m.target(outer)), this->GetPlace(w), this->GetPlace(m.target(link)), place);
}

void vtkMTCollapseRegion::BeginCollapse(Halfedge h, const Point& place)
{
  const bool first = this->KeepsFirst(h, this->GetRule(h), place);
  this->Surviving = this->GetState(first ? this->Surface.source(h) : this->Surface.target(h));
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
  // Around the removed vertex: its corners take the kept point's wedge of the same side, and a seam edge divides the sides.
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
    k[i] = static_cast<std::int32_t>(std::clamp<std::int64_t>(
      v, std::numeric_limits<std::int32_t>::min(), std::numeric_limits<std::int32_t>::max()));
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
}

void vtkMTCollapseRegion::MarkNeighbours(Vertex v) const
{
  if (++this->Mark == 0)
  {
    std::fill(this->Marks.begin(), this->Marks.end(), 0u);
    this->Mark = 1;
  }
  const Halfedge begin = this->Surface.opposite(this->Surface.halfedge(v));
  Halfedge h = begin;
  do
  {
    this->Marks[this->Surface.target(h).idx()] = this->Mark;
    h = this->GetNextOut(h);
  } while (h != begin);
}

bool vtkMTCollapseRegion::SatisfiesLink(Halfedge h) const
{
  const Mesh& m = this->Surface;
  const Halfedge o = m.opposite(h);
  bool border = false;
  int common = 0; // neighbours that both may have
  for (const Halfedge side : { h, o })
  {
    if (m.is_border(side))
    {
      border = true;
      // A hole of three edges would close to a double edge.
      if (m.next(m.next(m.next(side))) == side)
      {
        return false;
      }
      continue;
    }
    ++common;
    if (m.is_border(m.opposite(m.next(side))) && m.is_border(m.opposite(m.prev(side))))
    {
      return false;
    }
  }
  this->MarkNeighbours(m.target(h));
  bool border0 = false;
  Halfedge out = h;
  do
  {
    border0 = border0 || m.is_border(out);
    common -= this->Marks[m.target(out).idx()] == this->Mark ? 1 : 0;
    out = this->GetNextOut(out);
  } while (out != h);
  // The third vertices of the edge's triangles are always common.
  return common == 0 && (border || !border0 || !m.is_border(m.target(h))) && !CGAL::is_tetrahedron(h, m);
}

void vtkMTCollapseRegion::CountBlocked(std::map<std::string, std::int64_t>& blocked) const
{
  for (const Edge e : this->Surface.edges())
  {
    ++blocked[this->GetCause(this->Surface.halfedge(e))];
  }
}

const char* vtkMTCollapseRegion::GetCause(Halfedge h) const
{
  const Rule rule = this->GetRule(h);
  if (rule == Rule::Refused)
  {
    return this->GetCauseOfRanks(h);
  }
  if (!this->SatisfiesLink(h))
  {
    return "topology";
  }
  if (this->MakesChord(h, rule))
  {
    return "chord";
  }
  if (this->MakesDoubleEdge(h))
  {
    return "non_manifold";
  }
  return this->Steps > this->StepLimit ? "steps" : "fold";
}

const char* vtkMTCollapseRegion::GetCauseOfRanks(Halfedge h) const
{
  const VertexState& s0 = this->GetState(this->Surface.source(h));
  const VertexState& s1 = this->GetState(this->Surface.target(h));
  if (s0.Rank == Border || s1.Rank == Border)
  {
    return "topology";
  }
  if (!s0.Lock || !s1.Lock)
  {
    return "seam";
  }
  return ((s0.Lock | s1.Lock) & vtkMTFanMesh::NonManifold) ? "non_manifold" : "locked";
}
