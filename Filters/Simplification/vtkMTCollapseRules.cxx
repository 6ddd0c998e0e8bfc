// SPDX-License-Identifier: BSD-3-Clause
// Which edges may collapse, where to, and why the others may not.
#include "vtkMTCollapseRegion.h"

#include <algorithm>

using namespace vtkMTVector;

bool vtkMTCollapseRegion::IsSeamEdge(std::uint32_t h) const
{
  if (!this->Seams || this->Mesh.IsBorderEdge(h))
  {
    return false;
  }
  const std::uint32_t o = h ^ 1;
  return this->Mesh.Wedges[h] != this->Mesh.Wedges[this->Mesh.GetPrevious(o)] ||
    this->Mesh.Wedges[o] != this->Mesh.Wedges[this->Mesh.GetPrevious(h)];
}

unsigned char vtkMTCollapseRegion::ComputeRank(std::uint32_t v) const
{
  if (this->GetState(v).Lock || this->IsHub(v))
  {
    return Kept;
  }
  int seams = 0;
  bool border = false;
  const std::uint32_t begin = this->Mesh.Outs[v];
  std::uint32_t h = begin;
  do
  {
    seams += this->IsSeamEdge(h) ? 1 : 0;
    border = border || this->Mesh.IsBorder(h);
    h = this->Mesh.GetNextOut(h);
  } while (h != begin);
  if (seams == 0)
  {
    return border ? Border : Plain;
  }
  return seams == 2 && !border ? Seam : Kept;
}

vtkMTCollapseRegion::Rule vtkMTCollapseRegion::GetRuleOfRanks(std::uint32_t h, unsigned char r0, unsigned char r1) const
{
  const unsigned char low = std::min(r0, r1);
  if (low == Kept || (low == Border && !this->Mesh.IsBorderEdge(h)) || (low == Seam && !this->CanSlide(h)))
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
bool vtkMTCollapseRegion::CanSlide(std::uint32_t h) const
{
  if (!this->IsSeamEdge(h))
  {
    return false;
  }
  const std::uint32_t o = h ^ 1;
  return !(this->IsSeamEdge(this->Mesh.GetNext(h)) && this->IsSeamEdge(this->Mesh.GetPrevious(h))) &&
    !(this->IsSeamEdge(this->Mesh.GetNext(o)) && this->IsSeamEdge(this->Mesh.GetPrevious(o)));
}

bool vtkMTCollapseRegion::KeepsFirst(std::uint32_t h, Rule rule, const Vector& place) const
{
  const std::uint32_t v0 = this->Mesh.GetSource(h);
  const std::uint32_t v1 = this->Mesh.GetTarget(h);
  switch (rule)
  {
    case Rule::First:
      return true;
    case Rule::Second:
      return false;
    case Rule::Ends:
      return place == this->Mesh.GetPlace(v0);
    default:
      break;
  }
  const Vector from0 = Subtract(place, this->Mesh.GetPlace(v0));
  const Vector from1 = Subtract(place, this->Mesh.GetPlace(v1));
  const double d0 = Dot(from0, from0);
  const double d1 = Dot(from1, from1);
  return d0 != d1 ? d0 < d1 : this->GetState(v0).Point < this->GetState(v1).Point;
}

bool vtkMTCollapseRegion::MakesChord(std::uint32_t h, Rule rule) const
{
  // All new edges join the vertex that is kept to a neighbour of the other one.
  const std::uint32_t removed = rule == Rule::First ? h ^ 1 : h; // runs from the removed vertex
  const std::uint32_t kept = this->Mesh.GetTarget(removed);
  if (rule == Rule::Free || rule == Rule::Ends || !this->GetState(kept).Lock)
  {
    return false;
  }
  // The third vertices of the edge's own triangles are neighbours of the kept one already; there the edge must not
  // become a border because the removed triangle was the last one on its side.
  const vtkMTCollapseMesh& m = this->Mesh;
  const std::uint32_t left = this->Mesh.GetNextOut(removed);
  const std::uint32_t right = m.GetNext(removed ^ 1);
  for (std::uint32_t out = left; out != removed; out = this->Mesh.GetNextOut(out))
  {
    if (!this->GetState(m.GetTarget(out)).Lock)
    {
      continue;
    }
    const bool ofLeft = out == left && !m.IsBorder(removed);
    const bool ofRight = out == right && !m.IsBorder(removed ^ 1);
    if ((!ofLeft && !ofRight) || this->Mesh.IsBorderEdge(out))
    {
      return true;
    }
  }
  return false;
}

bool vtkMTCollapseRegion::MakesDoubleEdge(std::uint32_t h) const
{
  if (!this->Split)
  {
    return false;
  }
  // Before the collapse no free vertex is next to two fans of one point. Afterwards the kept vertex could be, with one
  // fan next to either of the two, and so could a neighbour where the kept vertex is itself a fan.
  const vtkMTCollapseMesh& m = this->Mesh;
  for (const std::uint32_t start : { h, h ^ 1 })
  {
    const std::uint32_t other = m.GetTarget(start);
    const bool otherIsFan = (this->GetState(other).Lock & vtkMTFanMesh::NonManifold) != 0;
    for (std::uint32_t out = this->Mesh.GetNextOut(start); out != start; out = this->Mesh.GetNextOut(out))
    {
      const std::uint32_t v = m.GetTarget(out);
      if (((this->GetState(v).Lock & vtkMTFanMesh::NonManifold) && this->IsNextToOtherFan(other, v)) ||
        (otherIsFan && this->IsNextToOtherFan(v, other)))
      {
        return true;
      }
    }
  }
  return false;
}

bool vtkMTCollapseRegion::HasVertexAbove(std::uint32_t valence) const
{
  const std::vector<std::uint32_t>& valences = this->Mesh.Valences;
  return !valences.empty() && *std::max_element(valences.begin(), valences.end()) > valence;
}

// Whether v has a neighbour that is of fan's point but is not fan; a hub may have.
bool vtkMTCollapseRegion::IsNextToOtherFan(std::uint32_t v, std::uint32_t fan) const
{
  if (this->IsHub(v))
  {
    return true;
  }
  const std::uint32_t point = this->GetState(fan).Point;
  const std::uint32_t begin = this->Mesh.Outs[v];
  std::uint32_t h = begin;
  do
  {
    const std::uint32_t w = this->Mesh.GetTarget(h);
    if (w != fan && this->GetState(w).Point == point)
    {
      return true;
    }
    h = this->Mesh.GetNextOut(h);
  } while (h != begin);
  return false;
}

namespace
{
// Whether two neighbouring triangles with these normals, as long as their areas, lie back to back within a degree.
bool AreFolded(const Vector& n, const Vector& m)
{
  constexpr double squaredCosine = 0.99969541350954788; // of one degree
  const double dot = Dot(n, m);
  return dot <= 0.0 && dot * dot > squaredCosine * (Dot(n, n) * Dot(m, m));
}
}

// After the collapse the triangles around the kept vertex are, counter-clockwise, those of v0 from vL to vR and then
// those of v1 from vR to vL, each of them place, a, b with the half-edge a -> b opposite to place.
bool vtkMTCollapseRegion::SpoilsShape(std::uint32_t h, const Vector& place) const
{
  const vtkMTCollapseMesh& m = this->Mesh;
  Run ring;
  this->Foreseen.Edge = None;
  this->Foreseen.Normals.clear();
  for (const std::uint32_t start : { h, h ^ 1 })
  {
    const Vector& center = m.GetPlace(m.GetSource(start));
    const bool isMoved = center != place;
    const std::uint32_t end = m.GetNext(start ^ 1);
    for (std::uint32_t out = m.GetNextOut(start); out != end; out = m.GetNextOut(out))
    {
      if (m.IsBorder(out))
      {
        continue;
      }
      const std::uint32_t link = m.GetNext(out);
      const std::uint32_t a = m.GetTarget(out);
      const std::uint32_t b = m.GetTarget(link);
      const bool isNext = ring.LastB == a;
      const Vector toA = isNext ? ring.ToLastB : Subtract(m.GetPlace(a), place);
      const Vector toB = Subtract(m.GetPlace(b), place);
      const Vector normal = Cross(toA, toB);
      const std::uint32_t face = m.GetFace(out);
      if ((isMoved && this->IsTurned(this->GetNormal(face), normal)) ||
        (isNext && AreFolded(ring.LastNormal, normal)) || this->FoldsAtLink(h, link, normal))
      {
        return true;
      }
      if (ring.FirstA == None)
      {
        ring.FirstA = a;
        ring.FirstB = b;
        ring.FirstNormal = normal;
      }
      ring.LastA = a;
      ring.LastB = b;
      ring.LastNormal = normal;
      ring.ToLastB = toB;
      this->Foreseen.Normals.push_back({ normal, face });
    }
  }
  if (ring.LastB != None && ring.LastB == ring.FirstA && ring.LastA != ring.FirstB &&
    AreFolded(ring.LastNormal, ring.FirstNormal))
  {
    return true;
  }
  this->Foreseen.Edge = h;
  this->Foreseen.Place = place;
  return false;
}

bool vtkMTCollapseRegion::IsTurned(const Vector& before, const Vector& after)
{
  return !(Dot(before, after) > 0.0) && before != Vector{ 0.0, 0.0, 0.0 };
}

// The triangle across a link edge stays where it is, unless it is one of those around the edge itself.
bool vtkMTCollapseRegion::FoldsAtLink(std::uint32_t h, std::uint32_t link, const Vector& normal) const
{
  const vtkMTCollapseMesh& m = this->Mesh;
  const std::uint32_t outer = link ^ 1;
  if (m.IsBorder(outer))
  {
    return false;
  }
  if (!AreFolded(this->GetNormal(m.GetFace(outer)), normal))
  {
    return false;
  }
  const std::uint32_t w = m.GetTarget(m.GetNext(outer));
  return w != m.GetSource(h) && w != m.GetTarget(h);
}

void vtkMTCollapseRegion::MarkNeighbours(std::uint32_t v) const
{
  if (++this->Mark == 0)
  {
    std::fill(this->Marks.begin(), this->Marks.end(), 0u);
    this->Mark = 1;
  }
  const std::uint32_t begin = this->Mesh.Outs[v];
  std::uint32_t h = begin;
  do
  {
    this->Marks[this->Mesh.GetTarget(h)] = this->Mark;
    h = this->Mesh.GetNextOut(h);
  } while (h != begin);
}

bool vtkMTCollapseRegion::SatisfiesLink(std::uint32_t h) const
{
  const vtkMTCollapseMesh& m = this->Mesh;
  const std::uint32_t o = h ^ 1;
  bool border = false;
  int common = 0; // neighbours that both may have
  for (const std::uint32_t side : { h, o })
  {
    if (m.IsBorder(side))
    {
      border = true;
      // A hole of three edges would close to a double edge.
      if (m.GetNext(m.GetNext(m.GetNext(side))) == side)
      {
        return false;
      }
      continue;
    }
    ++common;
    if (m.IsBorder(m.GetNext(side) ^ 1) && m.IsBorder(m.GetPrevious(side) ^ 1))
    {
      return false;
    }
  }
  this->MarkNeighbours(m.GetTarget(h));
  bool border0 = false;
  std::uint32_t out = h;
  do
  {
    border0 = border0 || m.IsBorder(out);
    common -= this->Marks[m.GetTarget(out)] == this->Mark ? 1 : 0;
    out = this->Mesh.GetNextOut(out);
  } while (out != h);
  // The third vertices of the edge's triangles are always common.
  return common == 0 && (border || !border0 || !m.IsBorderVertex(m.GetTarget(h))) && !this->IsTetrahedron(h);
}

// A closed component of four triangles.
bool vtkMTCollapseRegion::IsTetrahedron(std::uint32_t h) const
{
  const vtkMTCollapseMesh& m = this->Mesh;
  const std::uint32_t apex = m.GetTarget(m.GetNext(h ^ 1));
  for (const std::uint32_t side : { h, m.GetNext(h), m.GetPrevious(h) })
  {
    if (m.IsBorderEdge(side) || m.GetTarget(m.GetNext(side ^ 1)) != apex)
    {
      return false;
    }
    // Three triangles at the apex, no more.
    const std::uint32_t up = m.GetPrevious(side ^ 1);
    if (m.GetNextOut(m.GetNextOut(m.GetNextOut(up))) != up)
    {
      return false;
    }
  }
  return true;
}

void vtkMTCollapseRegion::CountBlocked(std::map<std::string, std::int64_t>& blocked) const
{
  for (std::uint32_t e = 0; e < this->Mesh.GetNumberOfEdges(); ++e)
  {
    if (this->Mesh.IsEdge(e))
    {
      ++blocked[this->GetCause(2 * e)];
    }
  }
}

const char* vtkMTCollapseRegion::GetCause(std::uint32_t h) const
{
  const Rule rule = this->GetRule(h);
  if (rule == Rule::Refused)
  {
    return this->GetCauseOfRanks(h);
  }
  if (this->MakesHub(h))
  {
    return "valence";
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

const char* vtkMTCollapseRegion::GetCauseOfRanks(std::uint32_t h) const
{
  const VertexState& s0 = this->GetState(this->Mesh.GetSource(h));
  const VertexState& s1 = this->GetState(this->Mesh.GetTarget(h));
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
