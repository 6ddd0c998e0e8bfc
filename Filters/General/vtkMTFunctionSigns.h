// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTFunctionSigns
 * @brief which signs an implicit function can have in a box
 *
 * The values of an implicit function are no distances in general, so its values at the corners of a box say nothing of
 * what is between them. What is done instead:
 *
 * - vtkPlane, vtkPlanes, vtkSphere and vtkBox are looked at by their geometry. The answer is certain: where it says
 * that a sign does not occur, it does not. (The other way round, vtkPlanes may be called negative near a corner.)
 * - A vtkImplicitBoolean of such functions (union, intersection, difference) likewise, sign by sign.
 * - A linear transform of such a function: the box is turned into the function's own coordinates, and the box of its
 *   corners there is looked at. Certain, a little less tight.
 * - Any other function, and any other transform: it is sampled with its gradient at 5 x 5 x 5 points of the box, and
 *   taken to change from a sample to the middle between samples by no more than twice what the steepest of these
 *   gradients says. That is an estimate: what is smaller than a quarter of the box, and whose slope no sample sees, can
 *   be missed. Where a value is not finite, every sign is possible.
 */
#ifndef vtkMTFunctionSigns_h
#define vtkMTFunctionSigns_h

#include "vtkMTFiltersModule.h" // For export macro

class vtkImplicitFunction;

struct VTKMTFILTERS_EXPORT vtkMTFunctionSigns
{
  bool CanBeNegative = true; ///< or zero
  bool CanBePositive = true; ///< or zero

  static vtkMTFunctionSigns Find(vtkImplicitFunction* function, const double box[6]);
};

#endif
