// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTVerifyEars.h"

#include "vtkMTVector.h"

#include <algorithm>
#include <cmath>

using namespace vtkMTVector;

namespace
{
using Corner = vtkMTVerifyEars::Corner;

bool IsBetween(const Corner& a, const Corner& b, const Corner& x)
{
  return (x.X - a.X) * (x.X - b.X) + (x.Y - a.Y) * (x.Y - b.Y) < 0.0;
}
}

double vtkMTVerifyEars::GetTurn(const Corner& a, const Corner& b, const Corner& c)
{
  return (b.X - a.X) * (c.Y - a.Y) - (b.Y - a.Y) * (c.X - a.X);
}

bool vtkMTVerifyEars::IsEar(const std::vector<Corner>& corners, std::size_t index, bool isFlatAllowed)
{
  const std::size_t n = corners.size();
  const Corner& a = corners[(index + n - 1) % n];
  const Corner& b = corners[index];
  const Corner& c = corners[(index + 1) % n];
  const double turn = GetTurn(a, b, c);
  if (isFlatAllowed && turn == 0.0)
  {
    return true;
  }
  if (!(turn > 0.0))
  {
    return false;
  }
  for (std::size_t i = 0; i < n; ++i)
  {
    const Corner& x = corners[i];
    const Corner& y = corners[(i + 1) % n];
    const double side = GetTurn(c, a, x);
    if (!IsSamePlace(x, a) && !IsSamePlace(x, b) && !IsSamePlace(x, c))
    {
      const bool isInside = GetTurn(a, b, x) > 0.0 && GetTurn(b, c, x) > 0.0 && side > 0.0;
      if (isInside || (side == 0.0 && IsBetween(a, c, x)))
      {
        return false;
      }
    }
    const double otherSide = GetTurn(c, a, y);
    const bool isCrossing =
      ((side > 0.0 && otherSide < 0.0) || (side < 0.0 && otherSide > 0.0)) && GetTurn(x, y, a) * GetTurn(x, y, c) < 0.0;
    if (isCrossing)
    {
      return false;
    }
  }
  return true;
}

// The ear with the shortest diagonal; -1 when there is none.
int vtkMTVerifyEars::FindShortestEar(const std::vector<Corner>& corners, bool isFlatAllowed)
{
  const std::size_t n = corners.size();
  int best = -1;
  double shortest = 0.0;
  for (std::size_t i = 0; i < n; ++i)
  {
    const double length = Length(Subtract(corners[(i + n - 1) % n].Place, corners[(i + 1) % n].Place));
    if ((best < 0 || length < shortest) && IsEar(corners, i, isFlatAllowed))
    {
      best = static_cast<int>(i);
      shortest = length;
    }
  }
  return best;
}

// Takes the corner off.
void vtkMTVerifyEars::Cut(std::vector<Corner>& corners, std::size_t i, std::vector<vtkMTTriangle>& triangles)
{
  const std::size_t n = corners.size();
  triangles.push_back({ corners[(i + n - 1) % n].Point, corners[i].Point, corners[(i + 1) % n].Point });
  corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(i));
}

// Into the plane of the area vector.
vtkMTVerifyEars::Polygon vtkMTVerifyEars::Project(const std::vector<vtkIdType>& ids, const vtkMTSampledSurface& surface)
{
  const std::size_t n = ids.size();
  Polygon polygon;
  Vector area{ 0.0, 0.0, 0.0 };
  Vector middle{ 0.0, 0.0, 0.0 };
  const Vector& first = surface.Points[static_cast<std::size_t>(ids[0])];
  for (std::size_t i = 0; i < n; ++i)
  {
    const auto id = static_cast<std::uint32_t>(ids[i]);
    polygon.Corners.push_back({ id, surface.Points[id], 0.0, 0.0 });
    const Vector a = Subtract(surface.Points[id], first);
    const Vector term = Cross(a, Subtract(surface.Points[static_cast<std::size_t>(ids[(i + 1) % n])], first));
    for (int axis = 0; axis < 3; ++axis)
    {
      area[axis] += 0.5 * term[axis];
      middle[axis] += a[axis] / static_cast<double>(n);
    }
  }
  polygon.Area = Length(area);
  const Vector normal{ area[0] / polygon.Area, area[1] / polygon.Area, area[2] / polygon.Area };
  const auto isSmaller = [&](double x, double y) { return std::abs(x) < std::abs(y); };
  Vector u{ 0.0, 0.0, 0.0 };
  u[static_cast<std::size_t>(std::min_element(normal.begin(), normal.end(), isSmaller) - normal.begin())] = 1.0;
  u = Cross(normal, u);
  const double length = Length(u);
  u = { u[0] / length, u[1] / length, u[2] / length };
  const Vector v = Cross(normal, u);
  for (Corner& corner : polygon.Corners)
  {
    const Vector a = Subtract(Subtract(corner.Place, first), middle);
    corner.X = Dot(a, u);
    corner.Y = Dot(a, v);
    polygon.Thickness = std::max(polygon.Thickness, 2.0 * std::abs(Dot(a, normal)));
    polygon.Reach = std::max(polygon.Reach, 2.0 * Length(a));
  }
  return polygon;
}
