// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTHilbertOrder
 * @brief the order of points along a Hilbert curve
 *
 * Neighbours on the curve are neighbours in space, so a part of the order with n points is a compact set of n points
 * whatever the density. The curve has 2^21 steps along each axis of a cube around the points (J. Skilling, "Programming
 * the Hilbert curve", 2004); points in the same step keep the order that they came in. The cube is half as large again
 * as the points need and its place depends on the level, so that the curves of different levels are split in different
 * places.
 */
#ifndef vtkMTHilbertOrder_h
#define vtkMTHilbertOrder_h

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

class vtkMTHilbertOrder
{
public:
  using Point = std::array<double, 3>;

  /// Indices of the (finite) points in their order along the curve.
  static std::vector<std::uint32_t> Sort(const std::vector<Point>& points, int level);

  /**
   * The points' order split into `chunks` chunks whose numbers of points differ by at most one: chunk c has the places
   * GetChunkBegin(c) to GetChunkBegin(c + 1) of it.
   */
  static std::size_t GetChunkBegin(std::size_t points, std::size_t chunks, std::size_t chunk)
  {
    return points / chunks * chunk + points % chunks * chunk / chunks;
  }

private:
  static std::uint64_t GetKey(std::array<std::uint32_t, 3> cell);
};

#endif
