// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPolygonTriangulation.h"

#include "vtkMTLeastOverlap.h"
#include "vtkMTVector.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace
{
using vtkMTVector::Cross;
using vtkMTVector::Dot;
using vtkMTVector::Norm;
using vtkMTVector::Subtract;
using vtkMTVector::Vector;

constexpr double SmallestArea = 1e-12; // of the squared extent: less is rounding
constexpr double LargestBend = 1e-6;   // of the extent, out of the plane of what is plane
constexpr double LargestOverlap = 1e-6;

// For a convex quad: 0 or 1 for the diagonal from corner 0 or from corner 1, the shorter one; -1 when it is not convex.
int ChooseDiagonal(const std::vector<Vector>& p)
{
  const Vector diagonals[2] = { Subtract(p[2], p[0]), Subtract(p[3], p[1]) };
  const Vector normal = Cross(diagonals[0], diagonals[1]);
  for (std::size_t i = 0; i < 4; ++i)
  {
    const Vector corner = Cross(Subtract(p[i], p[(i + 3) % 4]), Subtract(p[(i + 1) % 4], p[i]));
    if (!(Dot(corner, normal) > 0.0))
    {
      return -1;
    }
  }
  return Dot(diagonals[1], diagonals[1]) < Dot(diagonals[0], diagonals[0]) ? 1 : 0;
}
}

bool vtkMTPolygonTriangulation::SplitQuad(const std::vector<Place>& corners)
{
  const int first = ChooseDiagonal(corners);
  if (first < 0)
  {
    return false;
  }
  const auto a = static_cast<std::uint32_t>(first);
  this->Triangles = { { a, a + 1, a + 2 }, { a, a + 2, (a + 3) % 4 } };
  return true;
}

// By a power of two, so that products neither overflow nor are rounded otherwise.
void vtkMTPolygonTriangulation::Scale(const std::vector<Place>& corners)
{
  double largest = 0.0;
  for (const Place& corner : corners)
  {
    largest = std::max({ largest, std::abs(corner[0]), std::abs(corner[1]), std::abs(corner[2]) });
  }
  int exponent = 0;
  std::frexp(largest, &exponent);
  this->Outline.Places = corners;
  double least[3] = { 1.0, 1.0, 1.0 };
  double most[3] = { -1.0, -1.0, -1.0 };
  for (Place& place : this->Outline.Places)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      place[axis] = std::ldexp(place[axis], -exponent);
      least[axis] = std::min(least[axis], place[axis]);
      most[axis] = std::max(most[axis], place[axis]);
    }
  }
  this->Extent = Norm({ most[0] - least[0], most[1] - least[1], most[2] - least[2] });
}

// The mean normal, as vtkPolygon has it; where it vanishes although there are triangles, the normal of the largest of
// them. False when there is no area at all.
bool vtkMTPolygonTriangulation::FindNormal(bool& isCrossed)
{
  const std::vector<Vector>& places = this->Outline.Places;
  Vector sum = { 0.0, 0.0, 0.0 };
  Vector largest = sum;
  for (std::size_t i = 1; i + 1 < places.size(); ++i)
  {
    const Vector normal = Cross(Subtract(places[i], places[0]), Subtract(places[i + 1], places[0]));
    sum = vtkMTVector::Add(sum, normal);
    largest = Norm(normal) > Norm(largest) ? normal : largest;
  }
  const double smallest = SmallestArea * this->Extent * this->Extent;
  isCrossed = !(Norm(sum) > smallest);
  sum = isCrossed ? largest : sum;
  const double length = Norm(sum);
  this->Outline.Normal = { sum[0] / length, sum[1] / length, sum[2] / length };
  return length > smallest;
}

// What is plane is projected along an axis, which keeps its coordinates as they are; what is not, along the normal.
void vtkMTPolygonTriangulation::Project()
{
  const Vector& normal = this->Outline.Normal;
  const std::vector<Vector>& places = this->Outline.Places;
  const bool isPlane = std::all_of(places.begin(), places.end(),
    [&](const Vector& place)
    { return std::abs(Dot(Subtract(place, places[0]), normal)) <= LargestBend * this->Extent; });
  std::size_t axis = 0;
  for (std::size_t i = 1; i < 3; ++i)
  {
    axis = std::abs(normal[i]) > std::abs(normal[axis]) ? i : axis;
  }
  std::size_t axes[2] = { (axis + 1) % 3, (axis + 2) % 3 };
  if (normal[axis] < 0.0)
  {
    std::swap(axes[0], axes[1]);
  }
  Vector right = { 0.0, 0.0, 0.0 };
  right[axes[0]] = 1.0;
  right = vtkMTVector::Subtract(right, vtkMTVector::Scale(normal, normal[axes[0]]));
  right = vtkMTVector::Scale(right, 1.0 / Norm(right));
  const Vector up = Cross(normal, right);
  this->Outline.Points.clear();
  for (const Vector& place : places)
  {
    const Vector from = Subtract(place, places[0]);
    this->Outline.Points.push_back(isPlane ? vtkMTPlaneOrientation::Point{ place[axes[0]], place[axes[1]] }
                                           : vtkMTPlaneOrientation::Point{ Dot(from, right), Dot(from, up) });
  }
}

bool vtkMTPolygonTriangulation::ClipEars()
{
  if (this->Ears.Clip(this->Outline, this->Triangles))
  {
    return this->Ears.TurnsOnce();
  }
  std::vector<std::uint32_t> left(this->Outline.Points.size());
  std::iota(left.begin(), left.end(), 0);
  if (left.size() <= vtkMTLeastOverlap::LargestCount)
  {
    this->Triangles.clear();
  }
  else
  {
    this->Ears.ClipAnyway(vtkMTLeastOverlap::LargestCount, this->Triangles);
    left = this->Ears.GetLeft();
  }
  vtkMTLeastOverlap::Split(this->Outline.Points, left, this->Triangles);
  return this->Ears.TurnsOnce();
}

bool vtkMTPolygonTriangulation::IsCoveredOnce() const
{
  const std::vector<vtkMTPlaneOrientation::Point>& points = this->Outline.Points;
  double covered = 0.0;
  double turned = 0.0;
  for (const Triangle& triangle : this->Triangles)
  {
    const double area = vtkMTPlaneOrientation::Of(points[triangle[0]], points[triangle[1]], points[triangle[2]]);
    (area < 0.0 ? turned : covered) += std::abs(area);
  }
  return turned <= LargestOverlap * covered;
}

bool vtkMTPolygonTriangulation::Triangulate(const std::vector<Place>& corners)
{
  this->Triangles.clear();
  if (corners.size() == 3)
  {
    this->Triangles = { { 0, 1, 2 } };
    return true;
  }
  if (corners.size() == 4 && this->SplitQuad(corners))
  {
    return true;
  }
  this->Scale(corners);
  bool isCrossed = false;
  if (!this->FindNormal(isCrossed))
  {
    // On a line: the triangles have no area, whichever they are.
    for (std::uint32_t i = 1; i + 1 < corners.size(); ++i)
    {
      this->Triangles.push_back({ 0, i, i + 1 });
    }
    return true;
  }
  this->Project();
  const bool turnsOnce = this->ClipEars();
  return turnsOnce && !isCrossed && this->IsCoveredOnce();
}
