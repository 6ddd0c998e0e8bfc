// SPDX-License-Identifier: BSD-3-Clause
// Which edges may collapse, where to, and why the others may not.
#include "vtkMTCollapseRegion.h"

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>

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

vtkMTCollapseRegion::Rule vtkMTCollapseRegion::GetRuleOfRanks(Halfedge h, unsigned char r0, unsigned char r1) const
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
  // The third vertices of the edge's own triangles are neighbours of the kept one already; there the edge must not
  // become a border because the removed triangle was the last one on its side.
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
  // Before the collapse no free vertex is next to two fans of one point. Afterwards the kept vertex could be, with one
  // fan next to either of the two, and so could a neighbour where the kept vertex is itself a fan.
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
  return (place != this->GetPlace(this->Surface.source(h)) && this->TurnsTriangleOf(h, this->Surface.next(o), place)) ||
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

// After the collapse the triangles around the kept vertex are, counter-clockwise, those of v0 from vL to vR and then
// those of v1 from vR to vL, each of them place, a, b with the half-edge a -> b opposite to place.
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
