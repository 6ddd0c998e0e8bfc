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

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

class vtkMTLocateBlock
{
public:
  static void Locate(
    const vtkMTPartition& partition, const std::array<double, 3>* points, std::size_t count, std::uint32_t* regions)
  {
    const std::size_t chunk = 1024;
    const std::int64_t chunks = static_cast<std::int64_t>((count + chunk - 1) / chunk);
#pragma omp parallel for schedule(static) if (chunks > 1)
    for (std::int64_t i = 0; i < chunks; ++i)
    {
      const std::size_t begin = static_cast<std::size_t>(i) * chunk;
      partition.LocateAll(points + begin, std::min(chunk, count - begin), regions + begin);
    }
  }
};

#endif
