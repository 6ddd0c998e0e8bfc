// SPDX-License-Identifier: BSD-3-Clause
// The triangles of a polygon that overlap least. Not installed.
#ifndef vtkMTLeastOverlap_h
#define vtkMTLeastOverlap_h

#include "vtkMTPlaneOrientation.h"

#include <array>
#include <cstdint>
#include <vector>

/**
 * Of all ways to split a polygon into triangles of its corners, the one whose turned over triangles have the least area
 * in all; of several such the best shaped, by the sum of squared perimeter over area. By dynamic programming over
 * chains of corners (G. T. Klincsek, Minimal triangulations of polygonal domains, 1980): the time is cubic in the
 * number of corners, the memory quadratic.
 */
class vtkMTLeastOverlap
{
public:
  static constexpr std::size_t LargestCount = 128;

  /// corners: of the points, three at least, in order. Triangles are appended.
  static void Split(const std::vector<vtkMTPlaneOrientation::Point>& points, const std::vector<std::uint32_t>& corners,
    std::vector<std::array<std::uint32_t, 3>>& triangles);
};

#endif
