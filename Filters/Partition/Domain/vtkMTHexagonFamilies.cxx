// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTHexagonFamilies.h"

#include "vtkMTIcosahedron.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
constexpr double SquareRootOf3 = 1.7320508075688772;

double GetPower(int exponent)
{
  double power = 1.0;
  for (int i = 0; i < exponent; ++i)
  {
    power *= 3.0;
  }
  return power;
}

// The lattice point that is nearest to weights whose sum is a whole number, but for rounding.
std::array<std::int64_t, 3> FindNearest(const std::array<double, 3>& weights, bool isOdd)
{
  std::array<std::int64_t, 3> place{};
  std::array<double, 3> rest{};
  double sum = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const double whole = std::floor(weights[i]);
    place[i] = static_cast<std::int64_t>(whole);
    rest[i] = weights[i] - whole;
    sum += rest[i];
  }
  if (sum < 0.5 || sum > 2.5)
  {
    // A lattice point, or as near to it as rounding goes.
    for (std::int64_t& weight : place)
    {
      weight = (weight + (sum > 2.5 ? 1 : 0)) * (isOdd ? 3 : 1);
    }
    return place;
  }
  // A triangle's corners are one step up along one weight, or along all weights but one.
  const bool isUp = sum < 1.5;
  double most = 0.0;
  std::size_t corner = 0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const double weight = isUp ? rest[i] : 1.0 - rest[i];
    corner = weight > most ? i : corner;
    most = std::max(most, weight);
  }
  const bool isMiddle = isOdd && most < 2.0 / 3.0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    place[i] *= isOdd ? 3 : 1;
    const std::int64_t step = (i == corner) == isUp ? 1 : 0;
    place[i] += isMiddle ? (isUp ? 1 : 2) : step * (isOdd ? 3 : 1);
  }
  return place;
}
}

//------------------------------------------------------------------------------
vtkMTHexagonFamilies::vtkMTHexagonFamilies(const vtkMTDomain& domain, double largest, bool isOddLevel)
  : vtkMTDomainFamilies(domain, largest, isOddLevel)
{
  // In units of the longer side; what is narrower than an eighth of it counts as that, so that a line has a unit too.
  const std::array<double, 2>& sides = domain.GetSides();
  const double width = sides[0] > 0.0 ? sides[1] / sides[0] : 1.0;
  const double distance = std::sqrt(std::max(width, 0.125) * 2.0 / SquareRootOf3);
  this->Lo = { -0.27 / distance, -0.31 * width / distance };
  this->Hi = { 0.73 / distance, 0.69 * width / distance };
}

vtkMTHexagonFamilies::~vtkMTHexagonFamilies() = default;

double vtkMTHexagonFamilies::GetNumberOfCells(int family) const
{
  if (this->GetDomain().IsPlane())
  {
    return GetPower(family);
  }
  return family < 0 ? (family == -1 ? 4.0 : 1.0) : 10.0 * GetPower(family) + 2.0;
}

void vtkMTHexagonFamilies::LocateInDomain(int family, const Point& x, Cell& cell) const
{
  if (this->GetDomain().IsPlane())
  {
    this->LocateInPlane(family, x, cell);
  }
  else
  {
    this->LocateOnSphere(family, x, cell);
  }
}

//------------------------------------------------------------------------------
void vtkMTHexagonFamilies::LocateOnSphere(int family, const Point& x, Cell& cell) const
{
  const Point d = this->GetDomain().ToDirection(x);
  if (family < 0)
  {
    const std::array<double, 4> along{ d[0] + d[1] + d[2], d[0] - d[1] - d[2], d[1] - d[0] - d[2], d[2] - d[0] - d[1] };
    cell.I = family == -1 ? std::max_element(along.begin(), along.end()) - along.begin() : 0;
    cell.Axis = -1;
    return;
  }
  const vtkMTIcosahedron::Place at = vtkMTIcosahedron::Get().Find(d);
  const double n = GetPower(family / 2);
  // The last is what the others leave, so that they sum up to n.
  const std::array<double, 3> weights{ at.Weights[0] * n, at.Weights[1] * n,
    std::max(n - at.Weights[0] * n - at.Weights[1] * n, 0.0) };
  const Place place = FindNearest(weights, family % 2 != 0);
  Place used{};
  std::size_t count = 0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    if (place[i] != 0)
    {
      used[count++] = place[i];
      cell.Axis = 13 * cell.Axis + at.Corners[i] + 1;
    }
  }
  cell.I = used[0];
  cell.J = used[1];
  cell.K = used[2];
}

//------------------------------------------------------------------------------
void vtkMTHexagonFamilies::LocateInPlane(int family, const Point& x, Cell& cell) const
{
  const std::array<double, 2> at = this->GetDomain().ToRectangle(x);
  const Place2D point{ this->Lo[0] + at[0] * (this->Hi[0] - this->Lo[0]),
    this->Lo[1] + at[1] * (this->Hi[1] - this->Lo[1]) };
  const double n = GetPower(family / 2);
  const double second = point[1] * (2.0 / SquareRootOf3) * n;
  const double first = point[0] * n - 0.5 * second;
  Place place = FindNearest({ first, second, -first - second }, family % 2 != 0);
  if (!this->IsInside(this->GetPoint(family, place)))
  {
    this->MoveInside(family, point, place);
  }
  cell.I = place[0];
  cell.J = place[1];
}

// To the nearest of the neighbours that lie in the rectangle; where none does the point stays.
void vtkMTHexagonFamilies::MoveInside(int family, const Place2D& x, Place& place) const
{
  const std::array<Place, 6> even{ { { 1, -1, 0 }, { 1, 0, -1 }, { 0, 1, -1 }, { -1, 1, 0 }, { -1, 0, 1 },
    { 0, -1, 1 } } };
  const std::array<Place, 6> odd{ { { 1, 1, -2 }, { 2, -1, -1 }, { 1, -2, 1 }, { -1, -1, 2 }, { -2, 1, 1 },
    { -1, 2, -1 } } };
  const Place outside = place;
  double least = std::numeric_limits<double>::infinity();
  for (const Place& step : family % 2 != 0 ? odd : even)
  {
    const Place next{ outside[0] + step[0], outside[1] + step[1], outside[2] + step[2] };
    const Place2D point = this->GetPoint(family, next);
    const double distance = (point[0] - x[0]) * (point[0] - x[0]) + (point[1] - x[1]) * (point[1] - x[1]);
    if (this->IsInside(point) && distance < least)
    {
      least = distance;
      place = next;
    }
  }
}

vtkMTHexagonFamilies::Place2D vtkMTHexagonFamilies::GetPoint(int family, const Place& place) const
{
  const double unit = 1.0 / (GetPower(family / 2) * (family % 2 != 0 ? 3.0 : 1.0));
  const double first = static_cast<double>(place[0]) * unit;
  const double second = static_cast<double>(place[1]) * unit;
  return { first + 0.5 * second, second * (0.5 * SquareRootOf3) };
}

bool vtkMTHexagonFamilies::IsInside(const Place2D& point) const
{
  return point[0] >= this->Lo[0] && point[0] <= this->Hi[0] && point[1] >= this->Lo[1] && point[1] <= this->Hi[1];
}
