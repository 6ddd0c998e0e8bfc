// SPDX-License-Identifier: BSD-3-Clause
// Memoryless quadrics in CGAL's own loop: after a collapse all edges that end next to the kept vertex are asked again.
#include "vtkMTCollapseModes.h"
#include "vtkMTQuadricMode.h"

#if vtkMT_CGAL_IS_KNOWN
namespace CGAL
{
namespace Surface_mesh_simplification
{
/// CGAL's test for folds also refuses neighbours of very different area, which blocks everything beside slivers and
/// triangles without area. The fast mode has no such bound either, so the two differ only in what they update.
template <>
inline bool vtkMTCollapse::Algorithm<vtkMTCollapse::Traits, vtkMTCollapse::QuadricMode,
  vtkMTCollapse::QuadricCost>::are_shared_triangles_valid(const Point& p0, const Point& p1, const Point& p2,
  const Point& p3) const
{
  return vtkMTCollapseRegion::AreUnfolded(p0, p1, p2, p3);
}
}
}
#endif

void vtkMTCollapse::RunBest(Region& region)
{
  vtkMTQuadrics quadrics(region);
  Run<Traits>(region, QuadricMode{ &quadrics }, QuadricCost{ &region, &quadrics });
}
