// SPDX-License-Identifier: BSD-3-Clause
// A view's frustum as planes in model units, for many boxes. Not installed.
#ifndef vtkMTFrustum_h
#define vtkMTFrustum_h

#include "vtkMTArcBounds.h"
#include "vtkMTView.h"

#include <array>
#include <cmath>

class vtkMTFrustum
{
public:
  vtkMTFrustum() = default;
  explicit vtkMTFrustum(const vtkMTView& view)
  {
    // Of eye space: what is inside has a value of no less than 0.
    const double x = view.HalfSize[0];
    const double y = view.HalfSize[1];
    const double planes[6][4] = { { 1, 0, view.ParallelProjection ? 0 : -x, view.ParallelProjection ? x : 0 },
      { -1, 0, view.ParallelProjection ? 0 : -x, view.ParallelProjection ? x : 0 },
      { 0, 1, view.ParallelProjection ? 0 : -y, view.ParallelProjection ? y : 0 },
      { 0, -1, view.ParallelProjection ? 0 : -y, view.ParallelProjection ? y : 0 }, { 0, 0, -1, -view.Near },
      { 0, 0, 1, view.Far } };
    for (int i = 0; i < 6; ++i)
    {
      for (int j = 0; j < 4; ++j)
      {
        Plane& plane = this->Planes[i];
        plane.Value[j] = j == 3 ? planes[i][3] : 0.0;
        plane.Size[j] = std::abs(plane.Value[j]);
        for (int k = 0; k < 3; ++k)
        {
          const double term = planes[i][k] * view.ModelToEye[4 * k + j];
          plane.Value[j] += term;
          plane.Size[j] += std::abs(term);
        }
      }
    }
  }

  /// False only when no point of the box, grown by so much on every side, can be seen.
  bool IsVisible(const vtkMTArcBounds& bounds, double grown = 0.0) const
  {
    if (bounds.Box[0] > bounds.Box[1])
    {
      return false;
    }
    for (const Plane& plane : this->Planes)
    {
      // The value at the corner that lies farthest inside, with what rounding may have taken off it.
      double value = plane.Value[3];
      double size = plane.Size[3];
      for (int i = 0; i < 3; ++i)
      {
        const double half = 0.5 * (bounds.Box[2 * i + 1] - bounds.Box[2 * i]) + grown;
        value += plane.Value[i] * bounds.Center[i] + std::abs(plane.Value[i]) * half;
        size += plane.Size[i] * (std::abs(bounds.Center[i]) + half);
      }
      if (value < -Rounding * size)
      {
        return false;
      }
    }
    return true;
  }

private:
  // Many times the relative rounding error of the sums above.
  static constexpr double Rounding = 1e-14;

  struct Plane
  {
    std::array<double, 4> Value{ 0, 0, 0, 0 };
    std::array<double, 4> Size{ 0, 0, 0, 0 }; // sums of the absolute values of what Value is the sum of
  };
  std::array<Plane, 6> Planes;
};

#endif
