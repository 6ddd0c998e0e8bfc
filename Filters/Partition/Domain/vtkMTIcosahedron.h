// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTIcosahedron
 * @brief the triangles of a regular icosahedron, and in which of them a direction lies
 */
#ifndef vtkMTIcosahedron_h
#define vtkMTIcosahedron_h

#include <array>
#include <vector>

class vtkMTIcosahedron
{
public:
  using Point = std::array<double, 3>;

  static const vtkMTIcosahedron& Get();

  /// A triangle and a place in it.
  struct Place
  {
    std::array<int, 3> Corners{}; ///< in ascending order, from 0 to 11
    Point Weights{};              ///< of the corners, not below 0; their sum is 1 but for rounding
  };

  /// Where the line from the middle in a direction, which is not 0, meets the surface.
  Place Find(const Point& direction) const;

private:
  vtkMTIcosahedron();

  struct Triangle
  {
    std::array<int, 3> Corners;
    Point Middle;                ///< in the direction of the middle, the same length for all
    std::array<Point, 3> Planes; ///< of the two other corners and the middle: 0 there, and 1 at the corner
  };
  std::vector<Triangle> Triangles;
};

#endif
