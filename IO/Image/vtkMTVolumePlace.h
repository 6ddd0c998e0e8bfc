// SPDX-License-Identifier: BSD-3-Clause
// Where a volume's samples are in the world that its file declares. Not installed.
#ifndef vtkMTVolumePlace_h
#define vtkMTVolumePlace_h

#include "vtkMTWorldFrame.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

struct vtkMTVolumePlace
{
  using Vector = std::array<double, 3>;

  std::array<Vector, 3> Axes{ { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } } }; ///< a step along i, j, k
  Vector Origin{ 0.0, 0.0, 0.0 };                                                            ///< of the sample 0 0 0
  vtkMTWorldFrame World;

  static Vector Cross(const Vector& a, const Vector& b)
  {
    return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
  }
  static double Dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

  double GetDeterminant() const { return Dot(this->Axes[0], Cross(this->Axes[1], this->Axes[2])); }
  /// Then a surface's triangles change their sense on the way to the world.
  bool IsLeftHanded() const { return this->GetDeterminant() < 0.0; }

  /// Whether all is finite and the axes span space.
  bool IsSound() const
  {
    double box = 1.0;
    for (const Vector& axis : this->Axes)
    {
      box *= std::sqrt(Dot(axis, axis));
    }
    return std::isfinite(box) && std::isfinite(Dot(this->Origin, this->Origin)) && box > 0.0 &&
      std::abs(this->GetDeterminant()) > 1e-12 * box;
  }

  Vector ToWorld(const Vector& index) const
  {
    Vector world = this->Origin;
    for (std::size_t i = 0; i < 3; ++i)
    {
      world[i] += index[0] * this->Axes[0][i] + index[1] * this->Axes[1][i] + index[2] * this->Axes[2][i];
    }
    return world;
  }

  /// A normal goes by the inverse transposed matrix: that of the cofactors, over the determinant. Of length 1, or 0.
  Vector TurnNormal(const Vector& normal) const
  {
    const double sign = this->IsLeftHanded() ? -1.0 : 1.0;
    Vector turned{ 0.0, 0.0, 0.0 };
    for (std::size_t a = 0; a < 3; ++a)
    {
      const Vector cofactor = Cross(this->Axes[(a + 1) % 3], this->Axes[(a + 2) % 3]);
      for (std::size_t i = 0; i < 3; ++i)
      {
        turned[i] += sign * cofactor[i] * normal[a];
      }
    }
    const double largest = std::max({ std::abs(turned[0]), std::abs(turned[1]), std::abs(turned[2]) });
    const double scale = largest > 0.0 ? 1.0 / largest : 0.0; // so that squares neither overflow nor vanish
    turned = { turned[0] * scale, turned[1] * scale, turned[2] * scale };
    const double length = std::sqrt(Dot(turned, turned));
    return length > 0.0 ? Vector{ turned[0] / length, turned[1] / length, turned[2] / length } : turned;
  }
};

#endif
