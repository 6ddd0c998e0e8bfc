// SPDX-License-Identifier: BSD-3-Clause
#include "MTPartitionFigures.h"

#include "vtkMTArrayScan.h"

#include <algorithm>
#include <ctime>
#include <iostream>
#include <map>
#include <set>

namespace MTPartitionTest
{
std::unique_ptr<vtkMTPartition> BuildPartition(
  const vtkMTPartitionStrategy* strategy, const Points& barycentres, double target, int level)
{
  vtkMTArrayScan scan(barycentres);
  return strategy->Build(scan, target, level);
}

Regions LocateAll(const vtkMTPartition& partition, const Points& barycentres)
{
  Regions regions(barycentres.size());
  std::transform(barycentres.begin(), barycentres.end(), regions.begin(),
    [&partition](const Point& x) { return partition.Locate(x); });
  return regions;
}

Figures Measure(const vtkMTPartition& partition, const Points& barycentres, double target)
{
  std::vector<Points> members(partition.GetNumberOfRegions());
  for (const Point& x : barycentres)
  {
    members.at(partition.Locate(x)).push_back(x);
  }
  Figures figures;
  figures.Regions = members.size();
  for (Points& region : members)
  {
    const double count = static_cast<double>(region.size());
    figures.Empty += region.empty() ? 1 : 0;
    figures.Small += count < 0.25 * target ? 1.0 / static_cast<double>(members.size()) : 0.0;
    figures.Largest = std::max(figures.Largest, count / target);
    if (count <= vtkMTPartitionStrategy::MaximumOverload * target)
    {
      continue;
    }
    std::sort(region.begin(), region.end());
    std::size_t coincident = 0;
    for (auto i = region.begin(); i != region.end();)
    {
      const auto next = std::upper_bound(i, region.end(), *i);
      coincident = std::max(coincident, static_cast<std::size_t>(next - i));
      i = next;
    }
    figures.Overfull += count > static_cast<double>(coincident) + target ? 1 : 0;
  }
  figures.Mean =
    static_cast<double>(barycentres.size()) / (target * static_cast<double>(figures.Regions - figures.Empty));
  return figures;
}

void Print(const std::string& name, const Figures& figures)
{
  std::cout << "  " << name << ": regions " << figures.Regions << ", mean " << figures.Mean << " target, largest "
            << figures.Largest << " target, small " << 100.0 * figures.Small << " %\n";
}

Borders CompareBorders(const Mesh& mesh, const Regions& first, const Regions& second)
{
  std::map<std::array<std::uint32_t, 2>, std::uint32_t> triangleAt;
  Borders borders;
  for (std::uint32_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    for (int i = 0; i < 3; ++i)
    {
      const std::uint32_t a = mesh.Triangles[t][i];
      const std::uint32_t b = mesh.Triangles[t][(i + 1) % 3];
      const auto place = triangleAt.try_emplace({ std::min(a, b), std::max(a, b) }, t);
      const std::uint32_t other = place.first->second;
      const bool inFirst = first[t] != first[other];
      const bool inSecond = second[t] != second[other];
      borders.First += inFirst ? 1 : 0;
      borders.Second += inSecond ? 1 : 0;
      borders.Both += inFirst && inSecond ? 1 : 0;
    }
  }
  return borders;
}

Elements MeasureCrossing(const Regions& first, const Regions& second)
{
  std::map<std::array<std::uint32_t, 2>, std::size_t> elements;
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    ++elements[{ first[i], second[i] }];
  }
  const double mean = static_cast<double>(first.size()) / static_cast<double>(elements.size());
  const auto small = std::count_if(elements.begin(), elements.end(),
    [mean](const auto& element) { return static_cast<double>(element.second) < 0.1 * mean; });
  const std::set<std::uint32_t> regions(first.begin(), first.end());
  Elements figures;
  figures.Count = elements.size();
  figures.PerRegion = static_cast<double>(elements.size()) / static_cast<double>(regions.size());
  figures.Small = static_cast<double>(small) / static_cast<double>(elements.size());
  return figures;
}

double GetSeconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}
}
