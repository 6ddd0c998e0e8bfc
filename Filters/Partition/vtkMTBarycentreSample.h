// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTBarycentreSample
 * @brief an even sample of a mesh's barycentres, and how many there are
 *
 * The scan is split into runs of `stride` barycentres and one is taken of each, at a place that a hash of the run's
 * number gives: no alignment with the rows of a grid, and the same sample every time. Barycentres that are not finite
 * are left out of everything.
 */
#ifndef vtkMTBarycentreSample_h
#define vtkMTBarycentreSample_h

#include "vtkMTPartition.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

class vtkMTBarycentreSample
{
public:
  using Point = std::array<double, 3>;

  /// False when the scan failed.
  bool Take(vtkMTBarycentreScan& scan, std::size_t stride);

  /// Some of the barycentres, in the order of the scan; none only when Count is 0.
  std::vector<Point> Points;
  /// Of all finite barycentres: how many they are, their mean, their box and the largest absolute value of a
  /// coordinate.
  std::size_t Count = 0;
  Point Mean = { 0.0, 0.0, 0.0 };
  Point Lo = { 0.0, 0.0, 0.0 };
  Point Hi = { 0.0, 0.0, 0.0 };
  double Largest = 0.0;

  static bool IsFinite(const Point& x) { return std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]); }

  /// The stride that leaves `wanted` of a region's `target` barycentres.
  static std::size_t GetStride(double target, int wanted)
  {
    const double stride = std::floor(target / wanted);
    return stride > 1.0 ? static_cast<std::size_t>(std::fmin(stride, 1e9)) : 1;
  }

  /// Whether the barycentre with this number is the one that its run gives to the sample.
  static bool IsTaken(std::size_t index, std::size_t stride)
  {
    return stride == 1 || index == GetPlaceInRun(index / stride, stride);
  }

  /// The number of the barycentre that a run gives.
  static std::size_t GetPlaceInRun(std::size_t run, std::size_t stride)
  {
    return run * stride + static_cast<std::size_t>(Hash(run) % stride);
  }

  /// A number that looks like chance and is always the same for the same number.
  static std::uint64_t Hash(std::uint64_t number);
};

#endif
