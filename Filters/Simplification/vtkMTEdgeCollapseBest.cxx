// SPDX-License-Identifier: BSD-3-Clause
// Memoryless quadrics in CGAL's own loop: after a collapse all edges that end next to the kept vertex are asked again.
#include "vtkMTCollapseModes.h"
#include "vtkMTQuadricMode.h"

void vtkMTCollapse::RunBest(Region& region)
{
  vtkMTQuadrics quadrics(region);
  Run<Traits>(region, QuadricMode{ &quadrics }, QuadricCost{ &region, &quadrics });
}
