// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTDomain
 * @brief the plane or the sphere that points are projected to, so that their places have two coordinates
 *
 * Of a box. The plane is that of its two longest sides; the projection leaves the third coordinate out. The sphere is
 * around its centre. A turned domain is another one of the same kind, whose parts have no borders in common with those
 * of the first: the plane's rectangle is larger by a seventh and an eleventh, which are at two sides of it, and the
 * sphere is turned by 78 degrees about (1, 2, 1), which is no axis of what it is divided by.
 *
 * Nothing but sums, products and quotients: the same results wherever they are computed. Points that are not in the
 * box have a place like any other, the nearest one on the border of the rectangle.
 */
#ifndef vtkMTDomain_h
#define vtkMTDomain_h

#include <array>
#include <cstddef>

class vtkMTDomain
{
public:
  using Point = std::array<double, 3>;

  /// Those of vtkMTDomainPartition.
  enum Shape
  {
    Automatic = 0, ///< a plane where the box's least side is at most half the middle one, or a sphere
    Plane = 1,
    Sphere = 2
  };

  vtkMTDomain(int shape, const Point& lo, const Point& hi, bool isTurned);

  bool IsPlane() const { return this->IsFlat; }

  /// Of a plane: the longer side of the rectangle and the other one.
  const std::array<double, 2>& GetSides() const { return this->Sides; }
  /// The place in the rectangle, along the longer side and along the other one, from 0 to 1.
  std::array<double, 2> ToRectangle(const Point& x) const;

  /// Of a sphere: the direction from its centre. The absolutely largest coordinate is 1 or -1; (1, 0, 0) at the centre.
  Point ToDirection(const Point& x) const;

private:
  bool IsFlat;
  bool IsTurned;
  std::array<std::size_t, 2> Axes{ 0, 1 };
  std::array<double, 2> Corner{ 0.0, 0.0 };
  std::array<double, 2> Sides{ 0.0, 0.0 };
  Point Centre{ 0.0, 0.0, 0.0 };
};

#endif
