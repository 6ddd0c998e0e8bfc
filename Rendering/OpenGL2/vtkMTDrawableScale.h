// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTDrawableScale
 * @brief whether VTK can draw what lies in these bounds
 *
 * VTK hands the camera's matrices to the GPU in single precision, which ends at 3.4e38, and the camera stands a few
 * times the model's size away; vtkCamera comes no nearer to its focal point than 1e-20. Models of other scales can be
 * built, verified and cut, but their picture is empty.
 */
#ifndef vtkMTDrawableScale_h
#define vtkMTDrawableScale_h

#include "vtkMTRenderingOpenGL2Module.h" // For export macro

#include <string>

struct VTKMTRENDERINGOPENGL2_EXPORT vtkMTDrawableScale
{
  static constexpr double LargestCoordinate = 1e37;
  static constexpr double LeastSize = 1e-19;

  /// Nothing where they can be drawn; otherwise why they cannot.
  static std::string FindProblem(const double bounds[6]);
};

#endif
