// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTQuadrics.h"

#include <cmath>

namespace
{
constexpr double Regularisation = 1e-4; // of the trace, towards the midpoint
constexpr double LengthTerm = 1e-6;     // of the trace times the squared length of the edge
constexpr double CurveWeight = 4.0;     // of the planes along borders and seams, times the squared length of their edge
}

void vtkMTQuadrics::Quadric::AddPlane(const std::array<double, 4>& g)
{
  this->A[0] += g[0] * g[0];
  this->A[1] += g[0] * g[1];
  this->A[2] += g[0] * g[2];
  this->A[3] += g[1] * g[1];
  this->A[4] += g[1] * g[2];
  this->A[5] += g[2] * g[2];
  this->B[0] += g[0] * g[3];
  this->B[1] += g[1] * g[3];
  this->B[2] += g[2] * g[3];
  this->C += g[3] * g[3];
}

double vtkMTQuadrics::Quadric::Evaluate(const Point& p) const
{
  const double x = p.x();
  const double y = p.y();
  const double z = p.z();
  return x * (this->A[0] * x + 2.0 * (this->A[1] * y + this->A[2] * z + this->B[0])) +
    y * (this->A[3] * y + 2.0 * (this->A[4] * z + this->B[1])) + z * (this->A[5] * z + 2.0 * this->B[2]) + this->C;
}

void vtkMTQuadrics::Initialize()
{
  this->SumOf = Region::Halfedge();
  const Region::Mesh& m = this->R.Surface;
  this->Planes.resize(m.num_faces());
  this->Quadrics.resize(m.num_vertices());
  for (const Region::Face f : m.faces())
  {
    this->MakePlane(f);
  }
  for (const Region::Vertex v : m.vertices())
  {
    this->MakeQuadric(v);
  }
}

void vtkMTQuadrics::Update(Region::Vertex kept)
{
  this->SumOf = Region::Halfedge();
  const Region::Mesh& m = this->R.Surface;
  const Region::Halfedge begin = m.opposite(m.halfedge(kept));
  Region::Halfedge h = begin;
  do
  {
    if (!m.is_border(h))
    {
      this->MakePlane(m.face(h));
    }
    h = this->R.GetNextOut(h);
  } while (h != begin);
  this->MakeQuadric(kept);
  do
  {
    this->MakeQuadric(m.target(h));
    h = this->R.GetNextOut(h);
  } while (h != begin);
}

void vtkMTQuadrics::MakePlane(Region::Face f)
{
  const Region::Mesh& m = this->R.Surface;
  const Region::Halfedge h = m.halfedge(f);
  const Point& p = m.point(m.target(h));
  const Region::Vector n = CGAL::cross_product(m.point(m.target(m.next(h))) - p, m.point(m.source(h)) - p);
  const double length = std::sqrt(n.squared_length()); // twice the area
  const double factor = length > 0.0 ? 1.0 / std::sqrt(2.0 * length) : 0.0;
  const double x = n.x() * factor;
  const double y = n.y() * factor;
  const double z = n.z() * factor;
  this->Planes[f.idx()] = { x, y, z, -(x * p.x() + y * p.y() + z * p.z()) };
}

void vtkMTQuadrics::MakeQuadric(Region::Vertex v)
{
  const Region::Mesh& m = this->R.Surface;
  Quadric q;
  const Region::Halfedge begin = m.opposite(m.halfedge(v));
  Region::Halfedge h = begin;
  do
  {
    if (!m.is_border(h))
    {
      q.AddPlane(this->Planes[m.face(h).idx()]);
    }
    h = this->R.GetNextOut(h);
  } while (h != begin);
  const unsigned char rank = this->R.GetState(v).Rank;
  if (rank == Region::Border || rank == Region::Seam)
  {
    this->AddCurvePlanes(v, q);
  }
  this->Quadrics[v.idx()] = q;
}

void vtkMTQuadrics::AddCurvePlanes(Region::Vertex v, Quadric& q) const
{
  const Region::Mesh& m = this->R.Surface;
  const Point& p = m.point(v);
  const Region::Halfedge begin = m.opposite(m.halfedge(v));
  Region::Halfedge h = begin;
  do
  {
    const Region::Vector d = m.point(m.target(h)) - p;
    const bool border = this->R.IsBorderEdge(h);
    for (const Region::Halfedge side : { h, m.opposite(h) })
    {
      if (m.is_border(side) || (!border && !this->R.IsSeamEdge(h)))
      {
        continue;
      }
      const Plane& face = this->Planes[m.face(side).idx()];
      const Region::Vector n = CGAL::cross_product(d, Region::Vector(face[0], face[1], face[2]));
      const double length = std::sqrt(n.squared_length());
      const double factor = length > 0.0 ? std::sqrt(CurveWeight * d.squared_length()) / length : 0.0;
      const Region::Vector g = factor * n;
      q.AddPlane({ g.x(), g.y(), g.z(), -(g.x() * p.x() + g.y() * p.y() + g.z() * p.z()) });
    }
    h = this->R.GetNextOut(h);
  } while (h != begin);
}

const vtkMTQuadrics::Quadric& vtkMTQuadrics::GetSum(Region::Halfedge h) const
{
  if (h == this->SumOf)
  {
    return this->Sum;
  }
  this->SumOf = h;
  const Quadric& a = this->Quadrics[this->R.Surface.source(h).idx()];
  const Quadric& b = this->Quadrics[this->R.Surface.target(h).idx()];
  for (int i = 0; i < 6; ++i)
  {
    this->Sum.A[i] = a.A[i] + b.A[i];
  }
  for (int i = 0; i < 3; ++i)
  {
    this->Sum.B[i] = a.B[i] + b.B[i];
  }
  this->Sum.C = a.C + b.C;
  return this->Sum;
}

vtkMTQuadrics::Point vtkMTQuadrics::GetPlace(Region::Halfedge h, Region::Rule rule) const
{
  const Point& p0 = this->R.GetPlace(this->R.Surface.source(h));
  const Point& p1 = this->R.GetPlace(this->R.Surface.target(h));
  switch (rule)
  {
    case Region::Rule::First:
      return p0;
    case Region::Rule::Second:
      return p1;
    case Region::Rule::Ends:
    {
      const Quadric& q = this->GetSum(h);
      return q.Evaluate(p0) <= q.Evaluate(p1) ? p0 : p1;
    }
    default:
      break;
  }
  return this->R.Snap(Minimize(this->GetSum(h), CGAL::midpoint(p0, p1)));
}

// Solves (A + r I) y = -(A m + b) by cofactors, then refines once against A itself, which squares what r takes away
// from directions that A determines (corners stay corners to the last digit) and leaves the others at the midpoint m.
vtkMTQuadrics::Point vtkMTQuadrics::Minimize(const Quadric& q, const Point& m)
{
  const double r = Regularisation * q.GetTrace();
  const double a = q.A[0] + r;
  const double b = q.A[1];
  const double c = q.A[2];
  const double d = q.A[3] + r;
  const double e = q.A[4];
  const double f = q.A[5] + r;
  const double c00 = d * f - e * e;
  const double c01 = c * e - b * f;
  const double c02 = b * e - c * d;
  const double determinant = a * c00 + b * c01 + c * c02;
  if (!(determinant > 0.0))
  {
    return m;
  }
  const double s = 1.0 / determinant;
  const double c11 = a * f - c * c;
  const double c12 = b * c - a * e;
  const double c22 = a * d - b * b;
  Point p = m;
  for (int i = 0; i < 2; ++i)
  {
    const double x = -s * (q.A[0] * p.x() + b * p.y() + c * p.z() + q.B[0]);
    const double y = -s * (b * p.x() + q.A[3] * p.y() + e * p.z() + q.B[1]);
    const double z = -s * (c * p.x() + e * p.y() + q.A[5] * p.z() + q.B[2]);
    p = Point(p.x() + (c00 * x + c01 * y + c02 * z), p.y() + (c01 * x + c11 * y + c12 * z),
      p.z() + (c02 * x + c12 * y + c22 * z));
  }
  return std::isfinite(p.x() + p.y() + p.z()) ? p : m;
}

double vtkMTQuadrics::GetCost(Region::Halfedge h, const Point& place) const
{
  const Quadric& q = this->GetSum(h);
  const Point& p0 = this->R.GetPlace(this->R.Surface.source(h));
  const Point& p1 = this->R.GetPlace(this->R.Surface.target(h));
  const double trace = q.GetTrace();
  return q.Evaluate(place) + trace * LengthTerm * (p1 - p0).squared_length();
}
