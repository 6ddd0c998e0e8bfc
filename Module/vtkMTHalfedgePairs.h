// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTHalfedgePairs
 * @brief which triangles of any mesh are neighbours across an edge
 *
 * Half-edge h = 3 t + e runs from corner e of triangle t to the next one. Two half-edges are opposite when they are the
 * only two between their points, run in opposite directions, and are not of two triangles with the same three points.
 * Every other half-edge has None, as at a border. Found from lists by the lower of the
 * two points, in linear time but for hubs, for which edges are sorted.
 */
#ifndef vtkMTHalfedgePairs_h
#define vtkMTHalfedgePairs_h

#include "vtkMTCoreModule.h" // For export macro

#include <cstddef>
#include <cstdint>
#include <vector>

struct VTKMTCORE_EXPORT vtkMTHalfedgePairs
{
  static constexpr std::uint32_t None = ~std::uint32_t(0);

  static std::uint32_t Next(std::uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static std::uint32_t Previous(std::uint32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }

  /// corners: the point of each corner, three for each triangle. Gives the opposite of each half-edge.
  static std::vector<std::uint32_t> Find(const std::vector<std::uint32_t>& corners);
  /// The same of points below a number.
  static std::vector<std::uint32_t> Find(const std::vector<std::uint32_t>& corners, std::size_t points);
};

#endif
