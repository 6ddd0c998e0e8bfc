// SPDX-License-Identifier: BSD-3-Clause
// The corners of cells, one cell behind the other. Not installed.
#ifndef vtkMTCellCorners_h
#define vtkMTCellCorners_h

#include <cstddef>
#include <cstdint>
#include <vector>

struct vtkMTCellCorners
{
  std::vector<std::uint64_t> Points; ///< of the whole file
  std::vector<std::size_t> Ends;     ///< of each cell in Points
};

#endif
