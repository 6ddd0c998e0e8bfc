// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class VTKMTVERIFICATION_EXPORT vtkMTPrincipalAxes
 * @brief a rotation of space in which the boxes of a surface's triangles are small
 *
 * A rod that runs askew, of triangles as long as itself: its triangles' boxes all overlap, and in the frame of its
 * principal axes hardly any do. Best takes these axes (of the edges, weighted by length) where the triangles' boxes get
 * less surface by it, and leaves everything where it is otherwise.
 */
#ifndef vtkMTPrincipalAxes_h
#define vtkMTPrincipalAxes_h

#include "vtkMTSampledSurface.h"

#include <array>

class VTKMTVERIFICATION_EXPORT vtkMTPrincipalAxes
{
public:
  /// None.
  vtkMTPrincipalAxes() = default;
  static vtkMTPrincipalAxes Best(const vtkMTSampledSurface& surface);

  bool IsNone() const { return this->None; }
  vtkMTRealPoint Apply(const vtkMTRealPoint& x) const;
  /// How far a point is off by rounding, as a share of its largest coordinate.
  static constexpr double Rounding = 1e-14;

private:
  double GetBoxSurface(const vtkMTSampledSurface& surface) const;

  bool None = true;
  std::array<vtkMTRealPoint, 3> Axes{ { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } } };
};

#endif
