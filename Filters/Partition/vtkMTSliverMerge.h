// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTSliverMerge
 * @brief dissolves the slivers among the elements of a crossing, one fragment at a time
 *
 * Regions of two partitions cross in elements of very different size. The triangles of one region a of the first
 * partition may be divided among the regions of the second in any way: whoever divides them decides it once, and the
 * triangles' regions are inherited from then on. So an element with too few triangles is dissolved: each of its
 * triangles goes where it would have gone without the sliver's seed, to the nearest seed (ties to the smaller index)
 * among those of the fragment's elements that remain.
 */
#ifndef vtkMTSliverMerge_h
#define vtkMTSliverMerge_h

#include "vtkMTPartition.h"
#include "vtkMTPartitionModule.h" // For export macro

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

class VTKMTPARTITION_EXPORT vtkMTSliverMerge
{
public:
  /**
   * For the triangles of one region of the first partition: `regions` holds the region of each in the second partition
   * and is changed in place. Elements with fewer than `minimum` triangles are dissolved; when all are smaller, the
   * largest (the first of them by index) takes all. Depends on the arguments alone; the elements that remain keep all
   * their triangles. `barycentres` has as many entries as `regions`, in the coordinates of the partition. Returns the
   * number of elements dissolved.
   */
  static std::size_t MergeSlivers(const vtkMTPartition& partition,
    const std::vector<std::array<double, 3>>& barycentres, std::size_t minimum, std::vector<std::uint32_t>& regions);
};

#endif
