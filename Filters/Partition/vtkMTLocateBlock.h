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
    const std::size_t piece = 1024;
    const std::int64_t pieces = static_cast<std::int64_t>((count + piece - 1) / piece);
#pragma omp parallel for schedule(static) if (pieces > 1)
    for (std::int64_t i = 0; i < pieces; ++i)
    {
      const std::size_t begin = static_cast<std::size_t>(i) * piece;
      partition.LocateAll(points + begin, std::min(piece, count - begin), regions + begin);
    }
  }
};

#endif
