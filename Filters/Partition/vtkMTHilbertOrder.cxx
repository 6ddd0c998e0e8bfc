// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTHilbertOrder.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace
{
constexpr int Bits = 21;
constexpr double CubeOverExtent = 1.5;

struct Cube
{
  std::array<double, 3> Origin;
  double Size;
};

// Additive recurrence with the powers of the root of x^4 = x + 1: no two levels, and no two axes, get the same shift.
double GetShift(int level, int axis)
{
  constexpr double steps[3] = { 0.8191725133961645, 0.6710436067037893, 0.5497004779019703 };
  const double place = (level + 1) * steps[axis];
  return place - std::floor(place);
}

Cube GetCube(const std::vector<vtkMTHilbertOrder::Point>& points, int level)
{
  std::array<double, 3> lo = points[0];
  std::array<double, 3> hi = points[0];
  for (const vtkMTHilbertOrder::Point& point : points)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      lo[axis] = std::min(lo[axis], point[axis]);
      hi[axis] = std::max(hi[axis], point[axis]);
    }
  }
  const double extent = std::max({ hi[0] - lo[0], hi[1] - lo[1], hi[2] - lo[2] });
  Cube cube = { lo, CubeOverExtent * extent };
  for (int axis = 0; axis < 3; ++axis)
  {
    cube.Origin[axis] -= (CubeOverExtent - 1.0) * extent * GetShift(level, axis);
  }
  return cube;
}

std::uint32_t GetStep(double x, double origin, double size)
{
  constexpr double steps = 1u << Bits;
  const double step = (x - origin) / size * steps;
  // Written so that a size of zero, or one that has overflown, gives a step as well.
  return step > 0.0 ? static_cast<std::uint32_t>(std::min(step, steps - 1.0)) : 0u;
}
}

std::uint64_t vtkMTHilbertOrder::GetKey(std::array<std::uint32_t, 3> cell)
{
  // Undo the rotations and reflections of the subcubes, from the largest to the smallest.
  for (std::uint32_t bit = 1u << (Bits - 1); bit > 1; bit >>= 1)
  {
    const std::uint32_t below = bit - 1;
    for (std::uint32_t& coordinate : cell)
    {
      if (coordinate & bit)
      {
        cell[0] ^= below;
      }
      else
      {
        const std::uint32_t exchange = (cell[0] ^ coordinate) & below;
        cell[0] ^= exchange;
        coordinate ^= exchange;
      }
    }
  }
  // Gray code.
  cell[1] ^= cell[0];
  cell[2] ^= cell[1];
  std::uint32_t parity = 0;
  for (std::uint32_t bit = 1u << (Bits - 1); bit > 1; bit >>= 1)
  {
    parity ^= cell[2] & bit ? bit - 1 : 0u;
  }
  std::uint64_t key = 0;
  for (int bit = Bits - 1; bit >= 0; --bit)
  {
    for (const std::uint32_t coordinate : cell)
    {
      key = (key << 1) | (((coordinate ^ parity) >> bit) & 1u);
    }
  }
  return key;
}

std::vector<std::uint32_t> vtkMTHilbertOrder::Sort(const std::vector<Point>& points, int level)
{
  std::vector<std::uint32_t> order(points.size());
  if (points.empty())
  {
    return order;
  }
  const Cube cube = GetCube(points, level);
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keys(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    std::array<std::uint32_t, 3> cell;
    for (int axis = 0; axis < 3; ++axis)
    {
      cell[axis] = GetStep(points[i][axis], cube.Origin[axis], cube.Size);
    }
    keys[i] = { GetKey(cell), static_cast<std::uint32_t>(i) };
  }
  std::sort(keys.begin(), keys.end());
  std::transform(keys.begin(), keys.end(), order.begin(), [](const auto& key) { return key.second; });
  return order;
}
