// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTRadiusScan
 * @brief the seed set of BMT section 4.2.2: each barycentre that is farther than a radius from all seeds before it
 *
 * Every other barycentre, by a hash of its number and the level, is passed over: the scans of different levels then
 * find different seeds even with the same radius, and successive partitions do not have the same borders.
 *
 * Seeds are kept in a hash table of cubes of twice the radius, so that at most eight cubes can hold a seed within the
 * radius of a point. Two cubes may share a hash: that costs a comparison of distances and changes nothing.
 */
#ifndef vtkMTRadiusScan_h
#define vtkMTRadiusScan_h

#include "vtkMTPartition.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

class vtkMTRadiusScan
{
public:
  using Point = std::array<double, 3>;

  /// The radius must be positive.
  vtkMTRadiusScan(double radius, int level);

  /// Adds the next point of the scan to the seeds if it is farther than the radius from all of them and not passed
  /// over.
  void Add(const Point& x);

  const std::vector<Point>& GetSeeds() const { return this->Seeds; }

  /**
   * The seeds of a whole scan with the radius that gives about `wanted` of them on the given sample of it: found by
   * bisection, to within a fiftieth where that is possible. False when the scan failed.
   */
  static bool PlaceSeeds(vtkMTBarycentreScan& scan, const std::vector<Point>& sample, std::size_t wanted, int level,
    std::vector<Point>& seeds);

private:
  static double FindRadius(const std::vector<Point>& sample, std::size_t wanted, int level);
  static std::size_t CountSeeds(const std::vector<Point>& sample, double radius, int level, std::size_t enough);
  bool IsPassedOver();
  bool HasSeedWithin(const Point& x, std::uint64_t cube) const;

  double Radius;
  std::uint64_t Salt;
  std::uint64_t Added = 0;
  std::vector<Point> Seeds;
  std::vector<std::uint32_t> Next;                         // the seed before this one in the same cube
  std::unordered_map<std::uint64_t, std::uint32_t> Latest; // the latest seed of a cube
};

#endif
