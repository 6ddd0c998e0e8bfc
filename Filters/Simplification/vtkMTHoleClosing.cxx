// SPDX-License-Identifier: BSD-3-Clause
// Small holes are closed when a region is stuck above its target: a hole keeps three edges at the least, so a terrain
// with voids could not get below a few triangles for each of them.
#include "vtkMTCollapseRegion.h"

#include <algorithm>
#include <cmath>

std::size_t vtkMTCollapseRegion::CloseHoles(double maximumDiagonal)
{
  std::size_t closed = 0;
  std::vector<std::uint32_t> holes;
  for (std::uint32_t h = 0; h < this->Mesh.Halfedges.size(); ++h)
  {
    if (this->IsClosableHole(h, maximumDiagonal))
    {
      holes.push_back(h);
    }
  }
  for (const std::uint32_t h : holes)
  {
    // A hole that is next to one just closed may have become the open side of a closed component.
    if (this->IsClosableHole(h, maximumDiagonal))
    {
      this->CloseHole(h);
      ++closed;
    }
  }
  this->FillNormals();
  return closed;
}

// Whether three border edges, of which h has the smallest index, are a hole between free points.
bool vtkMTCollapseRegion::IsClosableHole(std::uint32_t h, double maximumDiagonal) const
{
  const vtkMTCollapseMesh& m = this->Mesh;
  if (!m.IsEdge(h / 2) || !m.IsBorder(h))
  {
    return false;
  }
  const std::array<std::uint32_t, 3> loop{ h, m.GetNext(h), m.GetNext(m.GetNext(h)) };
  if (m.GetNext(loop[2]) != h || loop[1] < h || loop[2] < h)
  {
    return false;
  }
  double low[3];
  double high[3];
  for (int i = 0; i < 3; ++i)
  {
    low[i] = high[i] = this->Mesh.GetPlace(m.GetTarget(h))[i];
  }
  for (std::size_t e = 0; e < 3; ++e)
  {
    if (this->GetState(m.GetTarget(loop[e])).Rank != Border)
    {
      return false;
    }
    // The triangle behind the edge must not be the hole's own twin: that would make two triangles back to back.
    if (m.GetTarget(m.GetNext(loop[e] ^ 1)) == m.GetTarget(loop[(e + 1) % 3]))
    {
      return false;
    }
    for (int i = 0; i < 3; ++i)
    {
      low[i] = std::min(low[i], this->Mesh.GetPlace(m.GetTarget(loop[e]))[i]);
      high[i] = std::max(high[i], this->Mesh.GetPlace(m.GetTarget(loop[e]))[i]);
    }
  }
  const double diagonal =
    std::sqrt(std::pow(high[0] - low[0], 2) + std::pow(high[1] - low[1], 2) + std::pow(high[2] - low[2], 2));
  return diagonal * this->Scale <= maximumDiagonal;
}

void vtkMTCollapseRegion::CloseHole(std::uint32_t h)
{
  const vtkMTCollapseMesh& m = this->Mesh;
  const std::array<std::uint32_t, 3> loop{ h, m.GetNext(h), m.GetNext(m.GetNext(h)) };
  for (std::size_t e = 0; e < 3; ++e)
  {
    if (this->Seams)
    {
      // A border point has one wedge: that of its corner in the triangle behind the next edge.
      this->Mesh.Wedges[loop[e]] = this->Mesh.Wedges[loop[(e + 1) % 3] ^ 1];
    }
    this->States[m.GetTarget(loop[e])].Rank = Plain;
  }
  this->Mesh.FillHole(h);
  ++this->Faces;
}
