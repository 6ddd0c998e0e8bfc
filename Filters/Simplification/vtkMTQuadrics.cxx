// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTQuadrics.h"

#include <cmath>

using namespace vtkMTVector;

namespace
{
constexpr double Regularisation = 1e-4; // of the trace, towards the midpoint
constexpr double LengthTerm = 1e-6;     // of the trace times the squared length of the edge
constexpr double CurveWeight = 4.0;     // of the planes along borders and seams, times the squared length of their edge
}

double vtkMTQuadrics::Quadric::Evaluate(const Vector& p) const
{
  const double x = p[0];
  const double y = p[1];
  const double z = p[2];
  return x * (this->V[0] * x + 2.0 * (this->V[1] * y + this->V[2] * z + this->V[6])) +
    y * (this->V[3] * y + 2.0 * (this->V[4] * z + this->V[7])) + z * (this->V[5] * z + 2.0 * this->V[8]) + this->V[9];
}

// Squared distance to a plane times the squared length of its normal.
vtkMTQuadrics::Quadric vtkMTQuadrics::MakePlaneQuadric(const Vector& n, const Vector& on)
{
  const double d = -Dot(n, on);
  return { { n[0] * n[0], n[0] * n[1], n[0] * n[2], n[1] * n[1], n[1] * n[2], n[2] * n[2], n[0] * d, n[1] * d, n[2] * d,
    d * d } };
}

void vtkMTQuadrics::Initialize()
{
  const vtkMTCollapseMesh& m = this->R.Mesh;
  this->FaceQuadrics.resize(m.Faces.size());
  this->Quadrics.resize(m.Outs.size());
  for (const std::uint32_t h : m.Faces)
  {
    if (h != vtkMTCollapseMesh::None)
    {
      this->MakeFaceQuadric(h);
    }
  }
  for (std::uint32_t v = 0; v < m.Outs.size(); ++v)
  {
    if (m.Outs[v] != vtkMTCollapseMesh::None)
    {
      this->MakeQuadric(v);
    }
  }
}

void vtkMTQuadrics::Update(std::uint32_t kept)
{
  const vtkMTCollapseMesh& m = this->R.Mesh;
  const std::uint32_t begin = m.Outs[kept];
  std::uint32_t h = begin;
  do
  {
    if (!m.IsBorder(h))
    {
      this->MakeFaceQuadric(h);
    }
    h = m.GetNextOut(h);
  } while (h != begin);
  this->MakeQuadric(kept);
  do
  {
    if (!this->IsStillGood(m.GetTarget(h)))
    {
      this->MakeQuadric(m.GetTarget(h));
    }
    h = m.GetNextOut(h);
  } while (h != begin);
}

// Whether a vertex is a hub with few changes, of which one more is counted.
bool vtkMTQuadrics::IsStillGood(std::uint32_t v)
{
  if (!this->R.IsHub(v))
  {
    return false;
  }
  std::uint32_t& changes = this->ChangesOfHubs[v];
  changes = 8 * changes < this->R.Mesh.GetValence(v) ? changes + 1 : 0;
  return changes > 0;
}

// Of the half-edge's face, weighted by its area.
void vtkMTQuadrics::MakeFaceQuadric(std::uint32_t h)
{
  const vtkMTCollapseMesh& m = this->R.Mesh;
  const Vector& p = m.GetPlace(m.GetTarget(h));
  const Vector n = Cross(Subtract(m.GetPlace(m.GetTarget(m.GetNext(h))), p), Subtract(m.GetPlace(m.GetSource(h)), p));
  const double length = Norm(n); // twice the area
  const double factor = length > 0.0 ? 1.0 / std::sqrt(2.0 * length) : 0.0;
  this->FaceQuadrics[m.GetFace(h)] = MakePlaneQuadric(Scale(n, factor), p);
}

void vtkMTQuadrics::MakeQuadric(std::uint32_t v)
{
  const vtkMTCollapseMesh& m = this->R.Mesh;
  Quadric q;
  const std::uint32_t begin = m.Outs[v];
  std::uint32_t h = begin;
  do
  {
    if (!m.IsBorder(h))
    {
      q.Add(this->FaceQuadrics[m.GetFace(h)]);
    }
    h = m.GetNextOut(h);
  } while (h != begin);
  const unsigned char rank = this->R.GetState(v).Rank;
  if (rank == vtkMTCollapseRegion::Border || rank == vtkMTCollapseRegion::Seam)
  {
    this->AddCurveQuadrics(v, q);
  }
  this->Quadrics[v] = q;
}

void vtkMTQuadrics::AddCurveQuadrics(std::uint32_t v, Quadric& q) const
{
  const vtkMTCollapseMesh& m = this->R.Mesh;
  const Vector& p = m.GetPlace(v);
  const std::uint32_t begin = m.Outs[v];
  std::uint32_t h = begin;
  do
  {
    const Vector d = Subtract(m.GetPlace(m.GetTarget(h)), p);
    const bool border = m.IsBorderEdge(h);
    for (const std::uint32_t side : { h, h ^ 1 })
    {
      if (m.IsBorder(side) || (!border && !this->R.IsSeamEdge(h)))
      {
        continue;
      }
      const Vector across = Subtract(m.GetPlace(m.GetTarget(m.GetNext(side))), p);
      const Vector n = Cross(d, Cross(d, across)); // of the plane through the edge, at right angles to the face
      const double length = Norm(n);
      q.Add(MakePlaneQuadric(Scale(n, length > 0.0 ? std::sqrt(CurveWeight * Dot(d, d)) / length : 0.0), p));
    }
    h = m.GetNextOut(h);
  } while (h != begin);
}

vtkMTQuadrics::Quadric vtkMTQuadrics::GetSum(std::uint32_t h) const
{
  Quadric sum = this->Quadrics[this->R.Mesh.GetSource(h)];
  sum.Add(this->Quadrics[this->R.Mesh.GetTarget(h)]);
  return sum;
}

vtkMTQuadrics::Proposal vtkMTQuadrics::Propose(std::uint32_t h, Rule rule) const
{
  const Vector& p0 = this->R.Mesh.GetPlace(this->R.Mesh.GetSource(h));
  const Vector& p1 = this->R.Mesh.GetPlace(this->R.Mesh.GetTarget(h));
  const Quadric q = this->GetSum(h);
  Vector place;
  switch (rule)
  {
    case Rule::First:
      place = p0;
      break;
    case Rule::Second:
      place = p1;
      break;
    case Rule::Ends:
      place = q.Evaluate(p0) <= q.Evaluate(p1) ? p0 : p1;
      break;
    default:
      place = this->R.Snap(Minimize(q, Scale(Add(p0, p1), 0.5)));
      break;
  }
  return { place, this->GetCost(q, h, place) };
}

// Solves (A + r I) y = -(A m + b) by cofactors, then refines once against A itself, which squares what r takes away
// from directions that A determines (corners stay corners to the last digit) and leaves the others at the midpoint m.
vtkMTQuadrics::Vector vtkMTQuadrics::Minimize(const Quadric& q, const Vector& m)
{
  const double r = Regularisation * q.GetTrace();
  const double a = q.V[0] + r;
  const double b = q.V[1];
  const double c = q.V[2];
  const double d = q.V[3] + r;
  const double e = q.V[4];
  const double f = q.V[5] + r;
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
  Vector p = m;
  for (int i = 0; i < 2; ++i)
  {
    const double x = -s * (q.V[0] * p[0] + b * p[1] + c * p[2] + q.V[6]);
    const double y = -s * (b * p[0] + q.V[3] * p[1] + e * p[2] + q.V[7]);
    const double z = -s * (c * p[0] + e * p[1] + q.V[5] * p[2] + q.V[8]);
    p = { p[0] + (c00 * x + c01 * y + c02 * z), p[1] + (c01 * x + c11 * y + c12 * z),
      p[2] + (c02 * x + c12 * y + c22 * z) };
  }
  return std::isfinite(p[0] + p[1] + p[2]) ? p : m;
}

double vtkMTQuadrics::GetCost(const Quadric& q, std::uint32_t h, const Vector& place) const
{
  const Vector along =
    Subtract(this->R.Mesh.GetPlace(this->R.Mesh.GetTarget(h)), this->R.Mesh.GetPlace(this->R.Mesh.GetSource(h)));
  return q.Evaluate(place) + q.GetTrace() * LengthTerm * Dot(along, along);
}

double vtkMTQuadrics::GetCost(std::uint32_t h, const Vector& place) const
{
  return this->GetCost(this->GetSum(h), h, place);
}
