// SPDX-License-Identifier: BSD-3-Clause
// The normals of a region's triangles, which are kept, as each is asked for many times.
#include "vtkMTCollapseRegion.h"
#include "vtkMTWide.h"

#include <algorithm>
#include <iterator>

using namespace vtkMTWide;

namespace
{
// Of four triangles at a time, each given by one of its half-edges.
MT_FOR_WIDE_PROCESSORS
void ComputeNormals(
  const vtkMTCollapseMesh& mesh, const std::uint32_t* fours, std::size_t count, vtkMTCollapseMesh::Place* normals)
{
  const vtkMTCollapseMesh::Halfedge* const halfedges = mesh.Halfedges.data();
  const vtkMTCollapseMesh::Place* const places = mesh.Places.data();
  for (const std::uint32_t* four = fours; four < fours + count; four += 4)
  {
    const double* corners[3][4];
    double* results[4];
    for (int lane = 0; lane < 4; ++lane)
    {
      const vtkMTCollapseMesh::Halfedge& h = halfedges[four[lane]];
      corners[0][lane] = places[h.Target].At.data();
      corners[1][lane] = places[halfedges[h.Next].Target].At.data();
      corners[2][lane] = places[halfedges[four[lane] ^ 1].Target].At.data();
      results[lane] = normals[h.Face].At.data();
    }
    Wide3 p, a, b;
    Gather(corners[0][0], corners[0][1], corners[0][2], corners[0][3], p);
    Gather(corners[1][0], corners[1][1], corners[1][2], corners[1][3], a);
    Gather(corners[2][0], corners[2][1], corners[2][2], corners[2][3], b);
    Subtract(a, p, a);
    Subtract(b, p, b);
    Wide3 normal;
    Cross(a, b, normal);
    Wide unused{};
    Transpose(normal.X, normal.Y, normal.Z, unused);
    Store(results[0], normal.X);
    Store(results[1], normal.Y);
    Store(results[2], normal.Z);
    Store(results[3], unused);
  }
}
}

void vtkMTCollapseRegion::FillNormals()
{
  const std::vector<std::uint32_t>& faces = this->Mesh.Faces;
  // NOLINTNEXTLINE(modernize-make-unique): which would clear it
  this->Normals.reset(new vtkMTCollapseMesh::Place[faces.size()]);
  this->Ring.clear();
  std::remove_copy(faces.begin(), faces.end(), std::back_inserter(this->Ring), None);
  this->UpdateNormalsOfRing();
}

void vtkMTCollapseRegion::UpdateNormals(std::uint32_t v)
{
  this->Ring.clear();
  const std::uint32_t begin = this->Mesh.Outs[v];
  std::uint32_t h = begin;
  do
  {
    if (!this->Mesh.IsBorder(h))
    {
      this->Ring.push_back(h);
    }
    h = this->Mesh.GetNextOut(h);
  } while (h != begin);
  this->UpdateNormalsOfRing();
}

void vtkMTCollapseRegion::UpdateNormalsOfRing()
{
  while (this->Ring.size() % 4 != 0)
  {
    this->Ring.push_back(this->Ring.back());
  }
  ComputeNormals(this->Mesh, this->Ring.data(), this->Ring.size(), this->Normals.get());
}
