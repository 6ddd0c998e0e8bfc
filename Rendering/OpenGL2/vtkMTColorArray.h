// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTColorArray
 * @brief which arrays are colours, and their values as bytes
 *
 * An array is colours when it has three or four components and is of bytes, or says that it is: its name has "rgb",
 * "color" or "colour" in it, in any case, or its components are named for red, green and blue. Normals, texture
 * coordinates and the like are none.
 *
 * Values become bytes as VTK's VTK_COLOR_MODE_DIRECT_SCALARS makes them: floating point from 0 to 1 becomes 0 to 255,
 * rounded, and integers up to 255 are taken as they are. That mode keeps the lowest byte of larger integers, which is
 * no colour; here the range of the whole model says what they are: above 255 the largest value of 16 bits, above that
 * the largest of the type, is full colour. Floating point that goes beyond 1 is taken for bytes likewise. Values
 * outside the range are clamped, and NaN is 0.
 */
#ifndef vtkMTColorArray_h
#define vtkMTColorArray_h

#include "vtkMTArrayInfo.h"
#include "vtkSmartPointer.h"

class vtkDataArray;
class vtkMTGraph;
class vtkUnsignedCharArray;

struct vtkMTColorArray
{
  static bool IsColors(const vtkMTArrayInfo& info);
  /// The first array of points that is colours, or else of cells; -1 when there is none.
  static int Find(const vtkMTGraph& graph);

  /// The value that is full colour, by the type and the largest value of red, green and blue in the model.
  static double GetFullValue(int type, double largest);
  /// Three or four bytes per tuple.
  static vtkSmartPointer<vtkUnsignedCharArray> ToBytes(vtkDataArray* values, double fullValue);
};

#endif
