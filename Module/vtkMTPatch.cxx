// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPatch.h"

#include <algorithm>
#include <cmath>
#include <limits>

//------------------------------------------------------------------------------
vtkMTBox vtkMTPatch::GetBox() const
{
  constexpr std::int32_t lowest = std::numeric_limits<std::int32_t>::min();
  constexpr std::int32_t highest = std::numeric_limits<std::int32_t>::max();
  vtkMTPoint low{ highest, highest, highest };
  vtkMTPoint high{ lowest, lowest, lowest };
  std::vector<unsigned char> isUsed(this->Points.size(), 0); // each is looked at once, not by all its triangles
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    const vtkMTTriangle points = this->GetPointsOfTriangle(t);
    isUsed[points[0]] = isUsed[points[1]] = isUsed[points[2]] = 1;
  }
  for (std::size_t p = 0; p < isUsed.size(); ++p)
  {
    if (isUsed[p] != 0)
    {
      const vtkMTPoint& x = this->Points[p];
      low = { std::min(low[0], x[0]), std::min(low[1], x[1]), std::min(low[2], x[2]) };
      high = { std::max(high[0], x[0]), std::max(high[1], x[1]), std::max(high[2], x[2]) };
    }
  }
  return this->Triangles.empty() ? vtkMTBox{ 0, -1, 0, -1, 0, -1 }
                                 : vtkMTBox{ low[0], high[0], low[1], high[1], low[2], high[2] };
}

//------------------------------------------------------------------------------
double vtkMTPatch::GetMeanEdgeLength() const
{
  double sum = 0.0;
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    const vtkMTTriangle points = this->GetPointsOfTriangle(t);
    for (int i = 0; i < 3; ++i)
    {
      const vtkMTPoint& a = this->Points[points[i]];
      const vtkMTPoint& b = this->Points[points[(i + 1) % 3]];
      const double d[3] = { static_cast<double>(a[0]) - b[0], static_cast<double>(a[1]) - b[1],
        static_cast<double>(a[2]) - b[2] };
      sum += std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    }
  }
  return this->Triangles.empty() ? 0.0 : sum / (3.0 * static_cast<double>(this->Triangles.size()));
}

//------------------------------------------------------------------------------
std::size_t vtkMTPatch::GetMemorySize() const
{
  std::size_t size = this->Points.size() * sizeof(vtkMTPoint) + this->Ids.size() * sizeof(std::uint64_t) +
    this->WedgePoints.size() * sizeof(std::uint32_t) + this->Triangles.size() * sizeof(vtkMTTriangle);
  for (const vtkMTColumn& column : this->PointColumns)
  {
    size += column.size();
  }
  for (const vtkMTColumn& column : this->CellColumns)
  {
    size += column.size();
  }
  return size;
}

//------------------------------------------------------------------------------
std::vector<vtkMTRange> vtkMTPatch::GetRanges(const std::vector<vtkMTArrayInfo>& arrays) const
{
  std::vector<vtkMTRange> ranges;
  std::size_t next[2] = { 0, 0 };
  for (const vtkMTArrayInfo& array : arrays)
  {
    const bool ofCells = array.Association == vtkMTArrayInfo::Cell;
    const std::vector<vtkMTColumn>& columns = ofCells ? this->CellColumns : this->PointColumns;
    const std::size_t column = next[ofCells ? 1 : 0]++;
    const std::vector<vtkMTRange> own = array.GetRanges(column < columns.size() ? columns[column] : vtkMTColumn());
    ranges.insert(ranges.end(), own.begin(), own.end());
  }
  return ranges;
}
