// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTDomain.h"

#include <algorithm>
#include <cmath>

namespace
{
// Both give the lower end for what is no number.
double Clamp(double value, double lo, double hi)
{
  return value > lo ? (value < hi ? value : hi) : lo;
}

double ToUnit(double x, double corner, double side)
{
  return side > 0.0 ? Clamp((x - corner) / side, 0.0, 1.0) : 0.5;
}

std::size_t FindLargest(const vtkMTDomain::Point& d)
{
  std::size_t largest = 0;
  for (std::size_t axis = 1; axis < 3; ++axis)
  {
    largest = std::abs(d[axis]) > std::abs(d[largest]) ? axis : largest;
  }
  return largest;
}
}

//------------------------------------------------------------------------------
vtkMTDomain::vtkMTDomain(int shape, const Point& lo, const Point& hi, bool isTurned)
  : IsFlat(shape == Plane)
  , IsTurned(isTurned)
{
  const Point sides{ hi[0] - lo[0], hi[1] - lo[1], hi[2] - lo[2] };
  std::array<std::size_t, 3> axes{ 0, 1, 2 };
  std::stable_sort(axes.begin(), axes.end(), [&sides](std::size_t a, std::size_t b) { return sides[a] > sides[b]; });
  this->IsFlat = shape == Automatic ? sides[axes[2]] <= 0.5 * sides[axes[1]] : this->IsFlat;
  const std::array<double, 2> before{ isTurned ? 1.0 / 7.0 : 0.0, isTurned ? 1.0 / 11.0 : 0.0 };
  const double larger = 1.0 + before[0] + before[1];
  for (std::size_t i = 0; i < 2; ++i)
  {
    this->Axes[i] = axes[i];
    this->Corner[i] = lo[axes[i]] - before[i] * sides[axes[i]];
    this->Sides[i] = larger * sides[axes[i]];
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    this->Centre[axis] = 0.5 * lo[axis] + 0.5 * hi[axis];
  }
}

//------------------------------------------------------------------------------
std::array<double, 2> vtkMTDomain::ToRectangle(const Point& x) const
{
  return { ToUnit(x[this->Axes[0]], this->Corner[0], this->Sides[0]),
    ToUnit(x[this->Axes[1]], this->Corner[1], this->Sides[1]) };
}

vtkMTDomain::Point vtkMTDomain::ToDirection(const Point& x) const
{
  Point d{ x[0] - this->Centre[0], x[1] - this->Centre[1], x[2] - this->Centre[2] };
  if (this->IsTurned)
  {
    // The rotation of the quaternion (3, 1, 2, 1).
    const Point t{ d[0] / 15.0, d[1] / 15.0, d[2] / 15.0 };
    d = { 5.0 * t[0] - 2.0 * t[1] + 14.0 * t[2], 10.0 * t[0] + 11.0 * t[1] - 2.0 * t[2],
      10.0 * t[1] + 5.0 * t[2] - 10.0 * t[0] };
  }
  const std::size_t largest = FindLargest(d);
  const double length = std::abs(d[largest]);
  if (!(length > 0.0))
  {
    return { 1.0, 0.0, 0.0 };
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    d[axis] = axis == largest ? (d[axis] > 0.0 ? 1.0 : -1.0) : Clamp(d[axis] / length, -1.0, 1.0);
  }
  return d;
}
