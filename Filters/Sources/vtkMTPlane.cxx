// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPlane.h"

#include "vtkMTSinglePrecision.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr std::size_t BlockSize = 16384;

std::uint64_t ChooseSquares(std::uint64_t triangles)
{
  const double half = static_cast<double>(triangles) / 2.0;
  const std::uint64_t low = static_cast<std::uint64_t>(std::sqrt(half));
  const double below = half - static_cast<double>(low * low);
  const double above = static_cast<double>((low + 1) * (low + 1)) - half;
  return std::clamp<std::uint64_t>(below <= above ? low : low + 1, 1, vtkMTPlane::MaximumSquares);
}
}

vtkMTPlane::vtkMTPlane(std::uint64_t triangles)
  : Squares(ChooseSquares(triangles))
{
}

vtkMTPlane::~vtkMTPlane() = default;

bool vtkMTPlane::Rewind()
{
  this->PointRow = 0;
  this->SquareRow = 0;
  return true;
}

bool vtkMTPlane::NextPoints(PointBlock& block)
{
  block.Points.clear();
  block.Columns.clear();
  const double n = static_cast<double>(this->Squares);
  for (; this->PointRow <= this->Squares && block.Points.size() < BlockSize; ++this->PointRow)
  {
    const double y = vtkMTSinglePrecision::Round(static_cast<double>(this->PointRow) / n);
    for (std::uint64_t i = 0; i <= this->Squares; ++i)
    {
      block.Points.push_back({ vtkMTSinglePrecision::Round(static_cast<double>(i) / n), y, 0.0 });
    }
  }
  return true;
}

bool vtkMTPlane::NextTriangles(TriangleBlock& block)
{
  block.Triangles.clear();
  block.CellIds.clear();
  block.Columns.clear();
  const std::uint64_t width = this->Squares + 1;
  std::int64_t cell = static_cast<std::int64_t>(2 * this->Squares * this->SquareRow);
  for (; this->SquareRow < this->Squares && block.Triangles.size() < BlockSize; ++this->SquareRow)
  {
    for (std::uint64_t i = 0; i < this->Squares; ++i)
    {
      const std::uint64_t corner = this->SquareRow * width + i;
      block.Triangles.push_back({ corner, corner + 1, corner + width + 1 });
      block.Triangles.push_back({ corner, corner + width + 1, corner + width });
      block.CellIds.push_back(cell++);
      block.CellIds.push_back(cell++);
    }
  }
  return true;
}
