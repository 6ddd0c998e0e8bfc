// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTFarOutliers
 * @brief finds the few triangles that would coarsen the lattice for all others
 *
 * The lattice's step follows from the extent, so that one vertex at 1e38 would round a whole scan to a single point. A
 * triangle is a far outlier when all of this holds:
 *
 * 1. the lattice would be too coarse: the longest side over 2^bits is more than 1/16 of the median edge length;
 * 2. there is a gap: measured from the middle of the input (the median, axis by axis, of the triangles' corners) in the
 *    largest of the three coordinates, the triangle reaches at least 64 times as far as all triangles on the near side
 *    of the gap, and nothing lies in between;
 * 3. the triangles beyond the gap are few: at most 16 or 1/1000 of all, whichever is more, and never more than a
 *    quarter.
 *
 * Gaps are looked at from the outside, and only until the lattice is fine enough. More than a few triangles beyond a
 * gap, but not more than half of all, are no slip of somebody's: then the input is refused, with what can be done. More
 * than half (small things scattered over a vast space) have no near side; they are built as they are, with a warning.
 *
 * Distances and lengths are counted by powers of two, so the result does not depend on the order of the triangles; the
 * median edge length is taken as the power of two above it.
 */
#ifndef vtkMTFarOutliers_h
#define vtkMTFarOutliers_h

#include "vtkMTConstructionModule.h" // For export macro

#include <array>
#include <cstdint>
#include <string>
#include <vector>

struct VTKMTCONSTRUCTION_EXPORT vtkMTFarOutliers
{
  std::vector<std::uint32_t> Triangles; ///< the outliers, in ascending order
  std::string Message;                  ///< for a person, where there are any; or why the input is refused
  bool IsRefused = false;

  /// All indices must be in range and all coordinates finite.
  static vtkMTFarOutliers Find(const std::vector<std::array<double, 3>>& points,
    const std::vector<std::array<std::uint32_t, 3>>& triangles, int latticeBits);
};

#endif
