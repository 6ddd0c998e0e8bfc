// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTSeedBound
 * @brief adds seeds until no region holds too many barycentres
 *
 * A region is overfull when it holds more than MaximumOverload times the target and more than the target besides those
 * barycentres that coincide with its seed: these are of one region whatever is done. An overfull region keeps its seed
 * and gets further ones among its own barycentres: those that do not coincide with the seed are split along a
 * space-filling curve into chunks of about the target, and the middle of each chunk becomes a seed. A seed that is
 * added never makes another region larger, and takes at least its own barycentre away: so the loop ends.
 *
 * All barycentres are counted by scans; only a sample of those in overfull regions is kept.
 */
#ifndef vtkMTSeedBound_h
#define vtkMTSeedBound_h

#include "vtkMTPartition.h"
#include "vtkMTSeedPartition.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

class vtkMTSeedBound
{
public:
  using Point = std::array<double, 3>;

  vtkMTSeedBound(vtkMTBarycentreScan& scan, double target, int samplesPerRegion, int level);

  /// The partition by the given seeds and those added; regions without barycentres are left out. Null when the scan
  /// failed.
  std::unique_ptr<vtkMTPartition> Hold(std::vector<Point> seeds);

private:
  struct Load
  {
    std::size_t All = 0;
    std::size_t Stride = 0; // of the sample; 0 unless the region is large, or overfull
    std::size_t AtSeed = 0; // of large regions
    std::size_t Seen = 0;
    std::vector<Point> Sample; // of the barycentres that are not at the seed
  };

  bool Count(const vtkMTSeedPartition& partition);
  bool MarkLarge();
  bool Gather(const vtkMTSeedPartition& partition);
  bool KeepOverfull();
  std::vector<Point> AddSeeds(const vtkMTSeedPartition& partition) const;
  std::vector<Point> RemoveEmpty(const vtkMTSeedPartition& partition) const;

  template <typename Visitor>
  bool Visit(const vtkMTSeedPartition& partition, Visitor&& visitor);

  vtkMTBarycentreScan& Scan;
  double Target;
  int SamplesPerRegion;
  int Level;
  std::vector<Load> Loads;            // per region
  std::vector<std::uint32_t> Regions; // of a block
};

#endif
