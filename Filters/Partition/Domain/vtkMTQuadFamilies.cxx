// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTQuadFamilies.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace
{
// Elements of another kind than a face or an edge, told apart by the axis of their cell.
enum Element : int
{
  OnBorder = 1,
  Strip = 2,
  Sector = 3
};

// Of a coordinate that is at least 0: the number of its quad in a row of so many, and the place relative to its middle.
std::int64_t FindQuad(double x, std::int64_t quads, double& place)
{
  const std::int64_t quad = std::min(static_cast<std::int64_t>(x), quads - 1);
  place = x - static_cast<double>(quad) - 0.5;
  return quad;
}

// The middle of the quad or of its nearest edge, in halves of a quad.
void FindElement(double x, double y, std::array<std::int64_t, 2> quads, bool isEdge, std::array<std::int64_t, 2>& place)
{
  std::array<double, 2> inside{};
  place = { 2 * FindQuad(x, quads[0], inside[0]) + 1, 2 * FindQuad(y, quads[1], inside[1]) + 1 };
  if (isEdge)
  {
    const std::size_t across = std::abs(inside[0]) >= std::abs(inside[1]) ? 0 : 1;
    place[across] += inside[across] >= 0.0 ? 1 : -1;
  }
}

// The number of an edge on the border of the rectangle, counted around it from a corner on; -1 for other elements.
std::int64_t FindBorderEdge(const std::array<std::int64_t, 2>& place, const std::array<std::int64_t, 2>& quads)
{
  if (place[1] == 0)
  {
    return place[0] / 2;
  }
  if (place[0] == 2 * quads[0])
  {
    return quads[0] + place[1] / 2;
  }
  if (place[1] == 2 * quads[1])
  {
    return 2 * quads[0] + quads[1] - 1 - place[0] / 2;
  }
  return place[0] == 0 ? 2 * (quads[0] + quads[1]) - 1 - place[1] / 2 : -1;
}

// Nearly 4 / pi times the arc tangent, off by 0.005 at most and its slope by 6 %, in products alone.
double Spread(double tangent)
{
  return tangent * (1.3476 - 0.3476 * std::abs(tangent));
}

// The third of the sphere, around the diagonal of its cube, that a direction lies in.
std::int64_t FindSector(const vtkMTDomain::Point& d)
{
  const vtkMTDomain::Point sides{ d[0] - d[1], d[1] - d[2], d[2] - d[0] };
  return std::max_element(sides.begin(), sides.end()) - sides.begin();
}
}

//------------------------------------------------------------------------------
vtkMTQuadFamilies::vtkMTQuadFamilies(const vtkMTDomain& domain, double largest, bool isOddLevel)
  : vtkMTDomainFamilies(domain, largest, isOddLevel)
{
  if (domain.IsPlane())
  {
    // A row twice as long where quads would be longer than sqrt(2) times their width.
    constexpr int most = 40;
    constexpr double squareRoot = 1.4142135623730951;
    const std::array<double, 2>& sides = domain.GetSides();
    for (double length = sides[0]; this->RowExponent < most && length > squareRoot * sides[1]; length *= 0.5)
    {
      ++this->RowExponent;
    }
  }
}

vtkMTQuadFamilies::~vtkMTQuadFamilies() = default;

double vtkMTQuadFamilies::GetNumberOfCells(int family) const
{
  if (this->GetDomain().IsPlane())
  {
    return std::ldexp(1.0, family);
  }
  return family < 0 ? (family == -1 ? 3.0 : 1.0) : std::ldexp(6.0, family);
}

//------------------------------------------------------------------------------
void vtkMTQuadFamilies::LocateInDomain(int family, const Point& x, Cell& cell) const
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

void vtkMTQuadFamilies::LocateInPlane(int family, const Point& x, Cell& cell) const
{
  const std::array<double, 2> place = this->GetDomain().ToRectangle(x);
  if (family < this->RowExponent)
  {
    const std::int64_t strips = std::int64_t(1) << family;
    const double moved = family > 0 && (this->RowExponent - family) % 2 != 0 ? 0.25 : 0.0;
    const double strip = std::max(place[0] * static_cast<double>(strips) - moved, 0.0);
    cell.I = std::min(static_cast<std::int64_t>(strip), strips - 1);
    cell.Axis = Strip;
    return;
  }
  const int divided = (family - this->RowExponent) / 2;
  const bool isEdge = (family - this->RowExponent) % 2 != 0;
  const std::array<std::int64_t, 2> quads{ std::int64_t(1) << (this->RowExponent + divided),
    std::int64_t(1) << divided };
  std::array<std::int64_t, 2> element{};
  FindElement(
    place[0] * static_cast<double>(quads[0]), place[1] * static_cast<double>(quads[1]), quads, isEdge, element);
  const std::int64_t border = isEdge ? FindBorderEdge(element, quads) : -1;
  if (border >= 0)
  {
    // The two edges at the corner where the numbers begin are a pair.
    cell.I = (border + 1) % (2 * (quads[0] + quads[1])) / 2;
    cell.Axis = OnBorder;
    return;
  }
  cell.I = element[0];
  cell.J = element[1];
}

void vtkMTQuadFamilies::LocateOnSphere(int family, const Point& x, Cell& cell) const
{
  const Point d = this->GetDomain().ToDirection(x);
  if (family < 0)
  {
    cell.I = family == -1 ? FindSector(d) : 0;
    cell.Axis = Sector;
    return;
  }
  std::size_t side = 0; // the axis that the cube's side is across
  while (std::abs(d[side]) != 1.0)
  {
    ++side;
  }
  const std::array<std::size_t, 2> axes{ side == 0 ? std::size_t(1) : 0, side == 2 ? std::size_t(1) : 2 };
  const std::int64_t quads = std::int64_t(1) << (family / 2);
  const double half = 0.5 * static_cast<double>(quads);
  std::array<std::int64_t, 2> element{};
  FindElement(
    (1.0 + Spread(d[axes[0]])) * half, (1.0 + Spread(d[axes[1]])) * half, { quads, quads }, family % 2 != 0, element);
  std::array<std::int64_t, 3> place{};
  place[side] = d[side] > 0.0 ? 2 * quads : 0;
  place[axes[0]] = element[0];
  place[axes[1]] = element[1];
  cell.I = place[0];
  cell.J = place[1];
  cell.K = place[2];
}
