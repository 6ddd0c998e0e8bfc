// SPDX-License-Identifier: BSD-3-Clause
// Memoryless quadrics with costs asked again on the 1-ring.
#include "vtkMTCollapseModes.h"
#include "vtkMTRingUpdate.h"

void vtkMTCollapse::RunFast(Region& region)
{
  vtkMTQuadrics quadrics(region);
  Run<FastTraits>(region, QuadricMode{ &quadrics }, QuadricCost{ &region, &quadrics });
}
