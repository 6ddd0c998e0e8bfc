// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTStitch
 * @brief gives points that are one place on the surface one identity
 *
 * Meshes come apart at seams: an OBJ repeats a point for every texture coordinate, an STL for every triangle. A border
 * edge (one that a single triangle uses, by index) is stitched to another one when their ends are equal bit for bit,
 * when no third border edge lies there, and when they run in opposite directions. Edges of different parts do not see
 * each other. Nothing else is merged: sheets that
 * merely coincide, and points that merely are close, stay what their indices say.
 */
#ifndef vtkMTStitch_h
#define vtkMTStitch_h

#include "vtkMTConstructionModule.h" // For export macro

#include <array>
#include <cstdint>
#include <vector>

struct VTKMTCONSTRUCTION_EXPORT vtkMTStitch
{
  /// [points] the smallest index among the points that have become one.
  std::vector<std::uint32_t> Root;
  std::int64_t StitchedEdges = 0;  ///< pairs of border edges that were joined
  std::int64_t StitchedPoints = 0; ///< points that took another one's identity

  /// All indices must be in range; no triangle may have two corners at one place. parts: of each triangle; empty where
  /// there is only one. A point that triangles of several parts use is of the least of them.
  static vtkMTStitch Run(const std::vector<std::array<double, 3>>& points,
    const std::vector<std::array<std::uint32_t, 3>>& triangles, const std::vector<std::int32_t>& parts = {});
};

#endif
