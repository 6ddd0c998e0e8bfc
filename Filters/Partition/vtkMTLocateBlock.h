// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTLocateBlock
 * @brief the regions of many points at once, by several threads
 *
 * Every point's region goes to its own place, so the result does not depend on the threads.
 */
#ifndef vtkMTLocateBlock_h
#define vtkMTLocateBlock_h

#include "vtkMTPartition.h"

#include <array>
#include <cstddef>
#include <cstdint>

class vtkMTLocateBlock
{
public:
  template <typename Id>
  static void Locate(
    const vtkMTPartition& partition, const std::array<double, 3>* points, std::size_t count, Id* regions)
  {
    const std::int64_t end = static_cast<std::int64_t>(count);
#pragma omp parallel for schedule(static) if (end > 1024)
    for (std::int64_t i = 0; i < end; ++i)
    {
      regions[i] = static_cast<Id>(partition.Locate(points[i]));
    }
  }
};

#endif
