// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTRegularRegions.h"

#include "vtkMTPartitionStrategy.h"

#include <algorithm>
#include <cmath>

vtkMTRegularRegions::vtkMTRegularRegions(int family, int lastFamily)
  : FirstFamily(family)
  , Nearest({ { 0.0, 0.0, 0.0 } })
{
  for (int i = family; i <= std::max(family, lastFamily); ++i)
  {
    this->Families.emplace_back(i);
  }
}

vtkMTRegularRegions::~vtkMTRegularRegions() = default;

std::uint32_t vtkMTRegularRegions::GetNumberOfRegions() const
{
  return this->Nearest.GetNumberOfRegions();
}

vtkMTRegularRegions::Point vtkMTRegularRegions::GetSeed(std::uint32_t region) const
{
  return this->Nearest.GetSeed(region);
}

std::uint32_t vtkMTRegularRegions::Locate(const Point& x) const
{
  vtkMTRegularFamily::Cell cell;
  int family = this->FirstFamily;
  while (this->GetFamily(family).Locate(x, cell))
  {
    const auto place = this->Cells.find(cell);
    if (place == this->Cells.end())
    {
      break;
    }
    if (place->second.Replacement == NotReplaced)
    {
      return place->second.Region;
    }
    family = place->second.Replacement;
  }
  return this->Nearest.Locate(x);
}

void vtkMTRegularRegions::Add(const Point& x)
{
  vtkMTRegularFamily::Cell cell;
  int family = this->FirstFamily;
  while (this->GetFamily(family).Locate(x, cell))
  {
    Entry& entry = this->Cells[cell];
    if (entry.Replacement != NotReplaced)
    {
      family = entry.Replacement;
      continue;
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      entry.Lo[axis] = entry.Count == 0 ? x[axis] : std::min(entry.Lo[axis], x[axis]);
      entry.Hi[axis] = entry.Count == 0 ? x[axis] : std::max(entry.Hi[axis], x[axis]);
    }
    ++entry.Count;
    return;
  }
}

bool vtkMTRegularRegions::Count(vtkMTBarycentreScan& scan)
{
  for (auto& item : this->Cells)
  {
    item.second.Count = 0;
  }
  return scan.Scan(
    [this](const Point* barycentres, std::size_t count)
    {
      for (std::size_t i = 0; i < count; ++i)
      {
        this->Add(barycentres[i]);
      }
    });
}

int vtkMTRegularRegions::GetReplacement(const vtkMTRegularFamily::Cell& cell, const Entry& entry) const
{
  const double extent = std::max({ entry.Hi[0] - entry.Lo[0], entry.Hi[1] - entry.Lo[1], entry.Hi[2] - entry.Lo[2] });
  const int last = this->FirstFamily + static_cast<int>(this->Families.size()) - 1;
  if (!(extent > 0.0) || cell.Family >= last)
  {
    return NotReplaced;
  }
  // Cells of twice the extent divide nothing yet, or nearly so: everything coarser can be left out.
  const int exponent = std::min(std::ilogb(extent) + 1, vtkMTRegularFamily::LargestExponent);
  const int fitting = vtkMTRegularFamily::GetFamilyOf(exponent, vtkMTRegularFamily::Cubes);
  return std::min(last, std::max(cell.Family + 1, fitting));
}

bool vtkMTRegularRegions::Replace(double target)
{
  const double bound = vtkMTPartitionStrategy::MaximumOverload * target;
  bool any = false;
  for (auto& item : this->Cells)
  {
    Entry& entry = item.second;
    if (entry.Replacement == NotReplaced && static_cast<double>(entry.Count) > bound)
    {
      entry.Replacement = this->GetReplacement(item.first, entry);
      any = any || entry.Replacement != NotReplaced;
    }
  }
  return any;
}

void vtkMTRegularRegions::Number()
{
  std::vector<vtkMTRegularFamily::Cell> cells;
  for (const auto& item : this->Cells)
  {
    if (item.second.Replacement == NotReplaced)
    {
      cells.push_back(item.first);
    }
  }
  if (cells.empty())
  {
    return; // nothing finite in the scan: the seed at the origin stays
  }
  std::sort(cells.begin(), cells.end());
  std::vector<Point> seeds(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    this->Cells[cells[i]].Region = static_cast<std::uint32_t>(i);
    seeds[i] = this->GetFamily(cells[i].Family).GetSeed(cells[i]);
  }
  this->Nearest = vtkMTSeedPartition(std::move(seeds));
}

bool vtkMTRegularRegions::Fill(vtkMTBarycentreScan& scan, double target)
{
  do
  {
    if (!this->Count(scan))
    {
      return false;
    }
  } while (this->Replace(target));
  this->Number();
  return true;
}
