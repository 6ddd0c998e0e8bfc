// SPDX-License-Identifier: BSD-3-Clause
// Attribute values of corners as VTK wants them: of points. Not installed.
#ifndef vtkMTWedgeSplitter_h
#define vtkMTWedgeSplitter_h

#include "vtkType.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

class vtkPolyData;

namespace vtkMTWedgeSplitter
{
/// What tells the corners of one point apart, such as two indices or the bits of two numbers.
using Key = std::array<std::uint64_t, 2>;

struct Result
{
  std::vector<vtkIdType> Originals; ///< of which point each appended point is a copy
  std::vector<std::size_t> Corners; ///< for each point, a corner that has its values, or NoCorner
};

constexpr std::size_t NoCorner = ~std::size_t(0);

/**
 * corners are the point indices of all polygons, keys one for each. A point keeps its index for the key of its first
 * corner; for every other key a point is appended, and the corners are changed to it.
 */
Result Split(std::size_t points, std::vector<vtkIdType>& corners, const std::vector<Key>& keys);

/// Appends copies of these points, with all their values.
void AppendCopies(vtkPolyData* mesh, const std::vector<vtkIdType>& originals);
}

#endif
