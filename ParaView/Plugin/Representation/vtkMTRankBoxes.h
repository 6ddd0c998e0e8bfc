// SPDX-License-Identifier: BSD-3-Clause
// The boxes that ParaView puts the ranks in an order by, from back to front, where something translucent is in a view.
#ifndef vtkMTRankBoxes_h
#define vtkMTRankBoxes_h

#include "vtkBoundingBox.h"

#include <array>
#include <vector>

class vtkView;

namespace vtkMTRankBoxes
{
/// A point of a plane and its normal, which points to what is drawn.
using Plane = std::array<double, 6>;

/// Whether the ranks' pictures are put over each other in an order, in the picture that the view is about to make.
bool AreOrdered(vtkView* view);

/// The boxes of all ranks in that order's tree, which is the same in all of them; none where there is no order.
std::vector<vtkBoundingBox> Get(vtkView* view);

/// Whether no two of them have more in common than faces.
bool AreApart(const std::vector<vtkBoundingBox>& boxes);

/**
 * The planes between a rank's box and those of others. What lies outside of all boxes belongs to one at their border.
 * The planes lie a millionth beside the boxes' faces: flat parts of models lie on round numbers, as faces do, and in a
 * plane they would be drawn by two ranks.
 */
std::vector<Plane> GetPlanes(const std::vector<vtkBoundingBox>& boxes, int rank);

/// The largest number of planes that a rank has.
int GetMostPlanes(const std::vector<vtkBoundingBox>& boxes);
}

#endif
