// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTWedgeSplitter.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <unordered_map>

namespace
{
using Wedge = std::array<std::uint64_t, 3>; // point and key

struct Hash
{
  std::size_t operator()(const Wedge& wedge) const
  {
    std::uint64_t h = 0;
    for (const std::uint64_t part : wedge)
    {
      h = (h ^ part) * 0x9e3779b97f4a7c15u;
      h ^= h >> 29;
    }
    return static_cast<std::size_t>(h);
  }
};

void AppendCopiesTo(vtkDataArray* array, const std::vector<vtkIdType>& originals)
{
  // So that the source stays in place.
  array->Resize(array->GetNumberOfTuples() + static_cast<vtkIdType>(originals.size()));
  for (const vtkIdType original : originals)
  {
    array->InsertNextTuple(original, array);
  }
}
}

vtkMTWedgeSplitter::Result vtkMTWedgeSplitter::Split(
  std::size_t points, std::vector<vtkIdType>& corners, const std::vector<Key>& keys)
{
  Result result;
  result.Corners.assign(points, NoCorner);
  std::unordered_map<Wedge, vtkIdType, Hash> appended;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const std::size_t point = static_cast<std::size_t>(corners[i]);
    if (result.Corners[point] == NoCorner)
    {
      result.Corners[point] = i;
    }
    else if (keys[result.Corners[point]] != keys[i])
    {
      const auto inserted =
        appended.emplace(Wedge{ point, keys[i][0], keys[i][1] }, static_cast<vtkIdType>(result.Corners.size()));
      if (inserted.second)
      {
        result.Originals.push_back(corners[i]);
        result.Corners.push_back(i);
      }
      corners[i] = inserted.first->second;
    }
  }
  return result;
}

void vtkMTWedgeSplitter::AppendCopies(vtkPolyData* mesh, const std::vector<vtkIdType>& originals)
{
  AppendCopiesTo(mesh->GetPoints()->GetData(), originals);
  for (int i = 0; i < mesh->GetPointData()->GetNumberOfArrays(); ++i)
  {
    AppendCopiesTo(mesh->GetPointData()->GetArray(i), originals);
  }
}
