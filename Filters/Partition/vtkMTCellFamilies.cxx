// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTCellFamilies.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>

vtkMTCellFamilies::~vtkMTCellFamilies() = default;

double vtkMTCellFamilies::CountCells(const std::vector<Point>& points, int family, double enough) const
{
  std::unordered_set<Cell, vtkMTRegularFamily::Hash> cells;
  Cell cell;
  for (const Point& point : points)
  {
    if (this->Locate(family, point, cell))
    {
      cells.insert(cell);
    }
    if (static_cast<double>(cells.size()) >= enough)
    {
      break;
    }
  }
  return static_cast<double>(cells.size());
}

//------------------------------------------------------------------------------
vtkMTRegularFamilies::vtkMTRegularFamilies(int first, int last)
  : First(first)
  , Last(std::max(first, last))
{
  for (int family = this->First; family <= this->Last; ++family)
  {
    this->Families.emplace_back(family);
  }
}

vtkMTRegularFamilies::~vtkMTRegularFamilies() = default;

int vtkMTRegularFamilies::GetFitting(const Point& lo, const Point& hi, vtkMTRegularFamily::SeedType type) const
{
  const double extent = std::max({ hi[0] - lo[0], hi[1] - lo[1], hi[2] - lo[2] });
  if (!(extent > 0.0))
  {
    return None;
  }
  // Cells of twice the extent divide nothing yet, or nearly so: everything coarser can be left out.
  const int exponent = std::min(std::ilogb(extent) + 1, vtkMTRegularFamily::LargestExponent);
  return std::clamp(vtkMTRegularFamily::GetFamilyOf(exponent, type), this->First, this->Last);
}

int vtkMTRegularFamilies::GetReplacement(const Cell& cell, const Point& lo, const Point& hi, double) const
{
  const int fitting = this->GetFitting(lo, hi, vtkMTRegularFamily::Cubes);
  return fitting == None || cell.Family >= this->Last ? None : std::max(cell.Family + 1, fitting);
}

vtkMTCellFamilies::Point vtkMTRegularFamilies::GetSeed(const Cell& cell, const Point&, const Point&) const
{
  return this->Get(cell.Family).GetSeed(cell);
}
