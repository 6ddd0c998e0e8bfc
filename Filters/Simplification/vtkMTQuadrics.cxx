// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTQuadrics.h"

#include "vtkMTQuadricKernels.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numeric>

using namespace vtkMTVector;

namespace
{
constexpr double CurveWeight = 4.0; // of the planes along borders and seams, times the squared length of their edge
}

// Adds the squared distance to a plane times the squared length of its normal.
void vtkMTQuadrics::AddPlane(const Vector& n, const Vector& on, Quadric& q)
{
  const double d = -Dot(n, on);
  const double plane[10] = { n[0] * n[0], n[0] * n[1], n[0] * n[2], n[1] * n[1], n[1] * n[2], n[2] * n[2], n[0] * d,
    n[1] * d, n[2] * d, d * d };
  std::transform(plane, plane + 10, q.V, q.V, std::plus<double>());
}

void vtkMTQuadrics::Initialize()
{
  const vtkMTCollapseMesh& m = this->R.Mesh;
  // NOLINTBEGIN(modernize-make-unique): which would clear them
  this->FaceQuadrics.reset(new Quadric[m.Faces.size()]);
  this->Quadrics.reset(new OfVertex[m.Outs.size()]);
  // NOLINTEND(modernize-make-unique)
  this->List.clear();
  std::remove_copy(m.Faces.begin(), m.Faces.end(), std::back_inserter(this->List), vtkMTCollapseMesh::None);
  this->MakeFaceQuadrics();
  this->List.resize(m.Outs.size());
  std::iota(this->List.begin(), this->List.end(), 0u);
  this->List.erase(std::remove_if(this->List.begin(), this->List.end(),
                     [&m](std::uint32_t v) { return m.Outs[v] == vtkMTCollapseMesh::None; }),
    this->List.end());
  this->MakeQuadrics();
}

void vtkMTQuadrics::Update(std::uint32_t kept)
{
  const vtkMTCollapseMesh& m = this->R.Mesh;
  this->List.clear();
  const std::uint32_t begin = m.Outs[kept];
  std::uint32_t h = begin;
  do
  {
    if (!m.IsBorder(h))
    {
      this->List.push_back(h);
    }
    h = m.GetNextOut(h);
  } while (h != begin);
  this->MakeFaceQuadrics();
  this->List.assign(1, kept);
  do
  {
    if (!this->R.IsHub(m.GetTarget(h)) || !this->IsStillGood(m.GetTarget(h)))
    {
      this->List.push_back(m.GetTarget(h));
    }
    h = m.GetNextOut(h);
  } while (h != begin);
  this->MakeQuadrics();
}

// Whether a hub has few changes, of which one more is counted.
bool vtkMTQuadrics::IsStillGood(std::uint32_t v)
{
  std::uint32_t& changes = this->ChangesOfHubs[v];
  changes = 8 * changes < this->R.Mesh.GetValence(v) ? changes + 1 : 0;
  return changes > 0;
}

// Of the listed half-edges' faces, each weighted by its area.
void vtkMTQuadrics::MakeFaceQuadrics()
{
  while (this->List.size() % 4 != 0)
  {
    this->List.push_back(this->List.back());
  }
  vtkMTQuadricKernels::MakeFaceQuadrics(this->R, this->List.data(), this->List.size(), this->FaceQuadrics.get());
}

// Of the listed vertices.
void vtkMTQuadrics::MakeQuadrics()
{
  vtkMTQuadricKernels::SumAroundVertices(
    this->R.Mesh, this->List.data(), this->List.size(), this->FaceQuadrics.get(), this->Quadrics.get());
  for (const std::uint32_t v : this->List)
  {
    const unsigned char rank = this->R.GetState(v).Rank;
    if (rank == vtkMTCollapseRegion::Border || rank == vtkMTCollapseRegion::Seam)
    {
      this->AddCurveQuadrics(v, this->Quadrics[v].Sum);
    }
  }
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
      AddPlane(Scale(n, length > 0.0 ? std::sqrt(CurveWeight * Dot(d, d)) / length : 0.0), p, q);
    }
    h = m.GetNextOut(h);
  } while (h != begin);
}

void vtkMTQuadrics::Propose(const Request* requests, std::size_t count, Four* proposals) const
{
  vtkMTQuadricKernels::Propose(this->R, requests, count, this->Quadrics.get(), proposals);
}

vtkMTQuadrics::Proposal vtkMTQuadrics::Propose(std::uint32_t h, Rule rule) const
{
  const Request four[4] = { { h, rule }, { h, rule }, { h, rule }, { h, rule } };
  Four proposals;
  this->Propose(four, 4, &proposals);
  return { { proposals.Place[0][0], proposals.Place[1][0], proposals.Place[2][0] }, proposals.Cost[0] };
}
