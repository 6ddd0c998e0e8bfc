// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTSeedRelaxation
 * @brief seeds along a space-filling curve, and Lloyd's relaxation of seeds
 *
 * Works on a sample of the barycentres, where every region shall have PerRegion of them. Sums are made in the order of
 * the sample, so results do not depend on the threads that look for the nearest seeds.
 */
#ifndef vtkMTSeedRelaxation_h
#define vtkMTSeedRelaxation_h

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

class vtkMTSeedRelaxation
{
public:
  using Point = std::array<double, 3>;

  /// Points of the sample in a region as it should be.
  double PerRegion = 1.0;
  /// Regions with less than this share of PerRegion lose their seed.
  double SmallRegion = 0.25;
  /// Whether regions with more than twice PerRegion are divided in place of being moved.
  bool DivideLarge = true;
  /// Says where the curves that divide regions lie.
  int Level = 0;

  /**
   * Splits the points along the curve into chunks whose numbers of points differ by at most one, and gives the mean of
   * each. At most one seed per point, at least one.
   */
  static std::vector<Point> PlaceAlongCurve(const std::vector<Point>& points, std::size_t wanted, int level);

  /// One of Lloyd's steps: small regions removed, large ones divided, all other seeds moved to the mean of their
  /// region.
  std::vector<Point> Step(const std::vector<Point>& points, std::vector<Point> seeds) const;

private:
  static Point GetMean(const std::vector<Point>& points, const std::uint32_t* begin, const std::uint32_t* end);
};

#endif
