// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTRegularFamily.h"

#include <algorithm>
#include <cmath>

namespace
{
// Whole numbers are exact in double below this: finer cells could not be told apart.
constexpr double MostCells = 4503599627370496.0; // 2^52

// Families count downwards in exponents, three to each; this is the division that rounds up.
int GetExponent(int family)
{
  return family > 0 ? -(family / 3) : (-family + 2) / 3;
}
}

std::size_t vtkMTRegularFamily::Hash::operator()(const Cell& cell) const
{
  std::uint64_t hash = static_cast<std::uint64_t>(cell.Family) * 4 + static_cast<std::uint64_t>(cell.Axis);
  for (const std::int64_t coordinate : { cell.I, cell.J, cell.K })
  {
    hash = (hash ^ static_cast<std::uint64_t>(coordinate)) * 0x9e3779b97f4a7c15u;
    hash ^= hash >> 32;
  }
  return static_cast<std::size_t>(hash);
}

vtkMTRegularFamily::vtkMTRegularFamily(int family)
  : Family(family)
  , Type(static_cast<SeedType>(family + 3 * GetExponent(family)))
  , CellSize(std::ldexp(1.0, GetExponent(family)))
  , CellsPerUnit(std::ldexp(1.0, -GetExponent(family)))
{
}

int vtkMTRegularFamily::GetSmallestExponent(double largest)
{
  const int exponent = largest > 0.0 ? std::ilogb(largest) - 51 : -LargestExponent;
  return std::clamp(exponent, -LargestExponent, LargestExponent);
}

bool vtkMTRegularFamily::Locate(const Point& x, Cell& cell) const
{
  std::array<std::int64_t, 3> index;
  std::array<double, 3> place; // relative to the cube's centre, in cells
  for (int axis = 0; axis < 3; ++axis)
  {
    const double cells = x[axis] * this->CellsPerUnit;
    if (!(std::abs(cells) < MostCells))
    {
      return false;
    }
    const double whole = std::floor(cells);
    index[axis] = static_cast<std::int64_t>(whole);
    place[axis] = cells - whole - 0.5;
  }
  cell.Axis = 0;
  if (this->Type != Cubes)
  {
    const bool faces = this->Type == Faces;
    for (int axis = 1; axis < 3; ++axis)
    {
      const double difference = std::abs(place[axis]) - std::abs(place[cell.Axis]);
      cell.Axis = (faces ? difference > 0.0 : difference < 0.0) ? axis : cell.Axis;
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      const bool onPlane = faces == (axis == cell.Axis);
      index[axis] += onPlane && place[axis] >= 0.0 ? 1 : 0;
    }
  }
  cell.I = index[0];
  cell.J = index[1];
  cell.K = index[2];
  cell.Family = this->Family;
  return true;
}

vtkMTRegularFamily::Point vtkMTRegularFamily::GetSeed(const Cell& cell) const
{
  const std::int64_t index[3] = { cell.I, cell.J, cell.K };
  Point seed;
  for (int axis = 0; axis < 3; ++axis)
  {
    const bool onPlane = this->Type != Cubes && (this->Type == Faces) == (axis == cell.Axis);
    seed[axis] = (static_cast<double>(index[axis]) + (onPlane ? 0.0 : 0.5)) * this->CellSize;
  }
  return seed;
}
