// SPDX-License-Identifier: BSD-3-Clause
/// @brief the modes of vtkMTEdgeCollapse, each compiled in a source of its own
#ifndef vtkMTCollapseModes_h
#define vtkMTCollapseModes_h

class vtkMTCollapseRegion;

namespace vtkMTCollapse
{
///@{
/// One pass of a mode, until the target is reached or nothing is left to collapse. Throws
/// vtkMTCollapseRegion::StepLimitReached.
void RunFast(vtkMTCollapseRegion& region);
void RunBest(vtkMTCollapseRegion& region);
void RunLindstromTurk(vtkMTCollapseRegion& region);
void RunGarlandHeckbert(vtkMTCollapseRegion& region);
///@}
}

#endif
