// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTAttributeTransfer
 * @brief gives a fragment the attribute values of its floor
 *
 * A wedge whose point has not moved keeps its values bit for bit. A moved one takes them from the nearest place on the
 * floor, among triangles that face the same way where there are any (so that a thin wall's other side is not asked):
 * barycentric for arrays that interpolate, the largest weight's value for those that take the nearest, unit length for
 * directions. Arrays that interpolate, texture coordinates excepted, are then fitted to the values of the whole floor
 * (vtkMTLinearFit): points that are not shared with another region take the values by which the fragment is nearest to
 * the floor in the mean of squares. Shared points, and those of seams, keep theirs, so values agree across the border
 * of a region. A triangle takes all cell values, the input's cell id among them, from the floor's triangle nearest to
 * its barycentre, again one that faces the same way.
 *
 * The nearest place is looked for from a triangle of the floor that is known to lie over the fragment's, or from where
 * its corners came from, by walking to nearer neighbours. All triangles are searched only where that ends on one that
 * faces the other way, or farther away than the fragment is certified to be.
 */
#ifndef vtkMTAttributeTransfer_h
#define vtkMTAttributeTransfer_h

#include "vtkMTConstructionModule.h" // For export macro
#include "vtkMTDeviation.h"
#include "vtkMTPatch.h"

#include <vector>

class vtkMTSurface;
struct vtkMTSimplification;

struct VTKMTCONSTRUCTION_EXPORT vtkMTAttributeTransfer
{
  struct Meshes
  {
    const vtkMTPatch& Floor;
    const vtkMTSurface& FloorSurface;
    const vtkMTSurface& FragmentSurface;
    const vtkMTSimplification& Simplification; ///< its points, wedges and triangles are the fragment's
    const vtkMTDeviation::Findings& Findings;
  };

  /// Fills fragment's columns.
  static void Run(const Meshes& meshes, const std::vector<vtkMTArrayInfo>& arrays, vtkMTPatch& fragment);
};

#endif
