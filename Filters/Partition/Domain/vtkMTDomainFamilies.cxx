// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTDomainFamilies.h"

#include "vtkMTBarycentreSample.h"

#include <algorithm>

namespace
{
vtkMTRegularFamilies MakeSpace(double largest)
{
  const int smallest = vtkMTRegularFamily::GetSmallestExponent(largest);
  const int coarsest = std::min(smallest + 54, vtkMTRegularFamily::LargestExponent);
  return { vtkMTRegularFamily::GetFamilyOf(coarsest, vtkMTRegularFamily::Cubes),
    vtkMTRegularFamily::GetFamilyOf(smallest, vtkMTRegularFamily::Edges) };
}
}

//------------------------------------------------------------------------------
vtkMTDomainFamilies::vtkMTDomainFamilies(const vtkMTDomain& domain, double largest, bool isOddLevel)
  : Domain(domain)
  , Space(MakeSpace(largest))
  , SpaceType(isOddLevel ? vtkMTRegularFamily::Faces : vtkMTRegularFamily::Edges)
{
}

vtkMTDomainFamilies::~vtkMTDomainFamilies() = default;

bool vtkMTDomainFamilies::Locate(int family, const Point& x, Cell& cell) const
{
  if (family < Offset + this->GetCoarsest())
  {
    return this->Space.Locate(family, x, cell);
  }
  if (!vtkMTBarycentreSample::IsFinite(x))
  {
    return false;
  }
  cell = Cell();
  this->LocateInDomain(family - Offset, x, cell);
  cell.Family = family;
  return true;
}

int vtkMTDomainFamilies::GetReplacement(const Cell& cell, const Point& lo, const Point& hi, double excess) const
{
  if (cell.Family < Offset + this->GetCoarsest())
  {
    return this->Space.GetReplacement(cell, lo, hi, excess);
  }
  const int fitting = this->Space.GetFitting(lo, hi, this->SpaceType);
  const int family = cell.Family - Offset;
  const int finest = std::min(this->First + MostReplaced, this->GetFinest());
  // By two families at a time: those of successive levels are never the same then, and cells of faces are within one.
  int finer = family + 2;
  if (fitting == None || finer > finest)
  {
    return fitting;
  }
  const double needed = excess * this->GetNumberOfCells(family);
  while (finer + 2 <= finest && this->GetNumberOfCells(finer + 2) <= needed)
  {
    finer += 2;
  }
  return Offset + finer;
}

vtkMTDomainFamilies::Point vtkMTDomainFamilies::GetSeed(const Cell&, const Point& lo, const Point& hi) const
{
  Point seed{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    seed[axis] = std::clamp(0.5 * lo[axis] + 0.5 * hi[axis], lo[axis], hi[axis]);
  }
  return seed;
}
