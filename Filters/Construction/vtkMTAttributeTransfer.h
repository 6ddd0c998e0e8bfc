// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTAttributeTransfer
 * @brief gives a fragment the attribute values of its floor
 *
 * A wedge whose point has not moved keeps its values bit for bit, so values agree across the border of a region. A
 * moved one takes them from the nearest place on the floor, among triangles that face the same way where there are any
 * (so that a thin wall's other side is not asked): barycentric for arrays that interpolate, the largest weight's value
 * for those that take the nearest, unit length for directions. A triangle takes all cell values, the input's cell id
 * among them, from the floor's triangle nearest to its barycentre, again one that faces the same way.
 */
#ifndef vtkMTAttributeTransfer_h
#define vtkMTAttributeTransfer_h

#include "vtkMTConstructionModule.h" // For export macro
#include "vtkMTPatch.h"

#include <vector>

class vtkMTTriangleTree;
struct vtkMTSimplification;

struct VTKMTCONSTRUCTION_EXPORT vtkMTAttributeTransfer
{
  /// Fills fragment's columns; its points, wedges and triangles are those of the simplification. floorTree was made of
  /// floor with the given origin.
  static void Run(const vtkMTPatch& floor, const vtkMTTriangleTree& floorTree, const vtkMTPoint& origin,
    const vtkMTSimplification& simplification, const std::vector<vtkMTArrayInfo>& arrays, vtkMTPatch& fragment);
};

#endif
