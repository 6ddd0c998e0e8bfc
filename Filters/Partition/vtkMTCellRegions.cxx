// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTCellRegions.h"

#include "vtkMTPartitionStrategy.h"

#include <algorithm>
#include <utility>

vtkMTCellRegions::vtkMTCellRegions(std::unique_ptr<const vtkMTCellFamilies> families, int firstFamily)
  : Families(std::move(families))
  , FirstFamily(firstFamily)
  , Nearest({ { 0.0, 0.0, 0.0 } })
{
}

vtkMTCellRegions::~vtkMTCellRegions() = default;

std::uint32_t vtkMTCellRegions::GetNumberOfRegions() const
{
  return this->Nearest.GetNumberOfRegions();
}

vtkMTCellRegions::Point vtkMTCellRegions::GetSeed(std::uint32_t region) const
{
  return this->Nearest.GetSeed(region);
}

std::uint32_t vtkMTCellRegions::Locate(const Point& x) const
{
  Cell cell;
  int family = this->FirstFamily;
  while (this->Families->Locate(family, x, cell))
  {
    const auto place = this->Cells.find(cell);
    if (place == this->Cells.end())
    {
      break;
    }
    if (place->second.Replacement == vtkMTCellFamilies::None)
    {
      return place->second.Region;
    }
    family = place->second.Replacement;
  }
  return this->Nearest.Locate(x);
}

void vtkMTCellRegions::Add(const Point& x)
{
  Cell cell;
  int family = this->FirstFamily;
  while (this->Families->Locate(family, x, cell))
  {
    Entry& entry = this->Cells[cell];
    if (entry.Replacement != vtkMTCellFamilies::None)
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

bool vtkMTCellRegions::Count(vtkMTBarycentreScan& scan)
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

bool vtkMTCellRegions::Replace(double target)
{
  const double bound = vtkMTPartitionStrategy::MaximumOverload * target;
  bool any = false;
  for (auto& item : this->Cells)
  {
    Entry& entry = item.second;
    if (entry.Replacement == vtkMTCellFamilies::None && static_cast<double>(entry.Count) > bound)
    {
      entry.Replacement =
        this->Families->GetReplacement(item.first, entry.Lo, entry.Hi, static_cast<double>(entry.Count) / target);
      any = any || entry.Replacement != vtkMTCellFamilies::None;
    }
  }
  return any;
}

void vtkMTCellRegions::Number()
{
  std::vector<Cell> cells;
  for (const auto& item : this->Cells)
  {
    if (item.second.Replacement == vtkMTCellFamilies::None)
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
    Entry& entry = this->Cells[cells[i]];
    entry.Region = static_cast<std::uint32_t>(i);
    seeds[i] = this->Families->GetSeed(cells[i], entry.Lo, entry.Hi);
  }
  this->Nearest = vtkMTSeedPartition(std::move(seeds));
}

bool vtkMTCellRegions::Fill(vtkMTBarycentreScan& scan, double target)
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
