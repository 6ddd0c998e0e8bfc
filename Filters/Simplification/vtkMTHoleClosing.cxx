// SPDX-License-Identifier: BSD-3-Clause
// Small holes are closed when a region is stuck above its target: a hole keeps three edges at the least, so a terrain
// with voids could not get below a few triangles for each of them.
#include "vtkMTCollapseRegion.h"

#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <cmath>

std::size_t vtkMTCollapseRegion::CloseHoles(double maximumDiagonal)
{
  std::size_t closed = 0;
  std::vector<Halfedge> holes;
  for (const Halfedge h : this->Surface.halfedges())
  {
    if (this->IsClosableHole(h, maximumDiagonal))
    {
      holes.push_back(h);
    }
  }
  for (const Halfedge h : holes)
  {
    // A hole that is next to one just closed may have become the open side of a closed component.
    if (this->IsClosableHole(h, maximumDiagonal))
    {
      this->CloseHole(h);
      ++closed;
    }
  }
  return closed;
}

// Whether three border edges, of which h has the smallest index, are a hole between free points.
bool vtkMTCollapseRegion::IsClosableHole(Halfedge h, double maximumDiagonal) const
{
  const Mesh& m = this->Surface;
  if (m.is_removed(h) || !m.is_border(h))
  {
    return false;
  }
  const std::array<Halfedge, 3> loop{ h, m.next(h), m.next(m.next(h)) };
  if (m.next(loop[2]) != h || loop[1] < h || loop[2] < h)
  {
    return false;
  }
  double low[3];
  double high[3];
  for (int i = 0; i < 3; ++i)
  {
    low[i] = high[i] = this->GetPlace(m.target(h))[i];
  }
  for (std::size_t e = 0; e < 3; ++e)
  {
    if (this->GetState(m.target(loop[e])).Rank != Border)
    {
      return false;
    }
    // The triangle behind the edge must not be the hole's own twin: that would make two triangles back to back.
    if (m.target(m.next(m.opposite(loop[e]))) == m.target(loop[(e + 1) % 3]))
    {
      return false;
    }
    for (int i = 0; i < 3; ++i)
    {
      low[i] = std::min(low[i], this->GetPlace(m.target(loop[e]))[i]);
      high[i] = std::max(high[i], this->GetPlace(m.target(loop[e]))[i]);
    }
  }
  const double diagonal =
    std::sqrt(std::pow(high[0] - low[0], 2) + std::pow(high[1] - low[1], 2) + std::pow(high[2] - low[2], 2));
  return diagonal * this->Scale <= maximumDiagonal;
}

void vtkMTCollapseRegion::CloseHole(Halfedge h)
{
  Mesh& m = this->Surface;
  const std::array<Halfedge, 3> loop{ h, m.next(h), m.next(m.next(h)) };
  for (std::size_t e = 0; e < 3; ++e)
  {
    if (this->Seams)
    {
      // A border point has one wedge: that of its corner in the triangle behind the next edge.
      this->HalfedgeWedges[loop[e]] = this->HalfedgeWedges[m.opposite(loop[(e + 1) % 3])];
    }
    this->States[m.target(loop[e]).idx()].Rank = Plain;
  }
  CGAL::Euler::fill_hole(h, m);
  ++this->Faces;
}
