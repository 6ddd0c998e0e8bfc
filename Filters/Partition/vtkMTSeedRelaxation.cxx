// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTSeedRelaxation.h"

#include "vtkMTHilbertOrder.h"
#include "vtkMTLocateBlock.h"
#include "vtkMTSeedPartition.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace
{
// The points of each region, in the order of the points: region r has the places Begin[r] to Begin[r + 1] of Members.
struct Groups
{
  std::vector<std::size_t> Begin;
  std::vector<std::uint32_t> Members;

  Groups(const std::vector<vtkMTSeedRelaxation::Point>& points, const vtkMTSeedPartition& partition)
    : Begin(partition.GetNumberOfRegions() + std::size_t(1), 0)
    , Members(points.size())
  {
    std::vector<std::uint32_t> regions(points.size());
    vtkMTLocateBlock::Locate(partition, points.data(), points.size(), regions.data());
    for (const std::uint32_t region : regions)
    {
      ++this->Begin[region + 1];
    }
    for (std::size_t region = 1; region < this->Begin.size(); ++region)
    {
      this->Begin[region] += this->Begin[region - 1];
    }
    std::vector<std::size_t> next(this->Begin.begin(), this->Begin.end() - 1);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      this->Members[next[regions[i]]++] = static_cast<std::uint32_t>(i);
    }
  }

  std::size_t GetSize(std::size_t region) const { return this->Begin[region + 1] - this->Begin[region]; }

  std::size_t GetLargest() const
  {
    std::size_t largest = 0;
    for (std::size_t region = 1; region + 1 < this->Begin.size(); ++region)
    {
      largest = this->GetSize(region) > this->GetSize(largest) ? region : largest;
    }
    return largest;
  }
};
}

vtkMTSeedRelaxation::Point vtkMTSeedRelaxation::GetMean(
  const std::vector<Point>& points, const std::uint32_t* begin, const std::uint32_t* end)
{
  // Relative to the first point, so that a place far from the origin costs no precision.
  const Point first = points[*begin];
  Point sum = { 0.0, 0.0, 0.0 };
  for (const std::uint32_t* i = begin; i != end; ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      sum[axis] += points[*i][axis] - first[axis];
    }
  }
  const double count = static_cast<double>(end - begin);
  return { first[0] + sum[0] / count, first[1] + sum[1] / count, first[2] + sum[2] / count };
}

std::vector<vtkMTSeedRelaxation::Point> vtkMTSeedRelaxation::PlaceAlongCurve(
  const std::vector<Point>& points, std::size_t wanted, int level)
{
  const std::size_t chunks = std::max<std::size_t>(1, std::min(wanted, points.size()));
  const std::vector<std::uint32_t> order = vtkMTHilbertOrder::Sort(points, level);
  std::vector<Point> seeds(chunks);
  for (std::size_t chunk = 0; chunk < chunks; ++chunk)
  {
    seeds[chunk] = GetMean(points, order.data() + vtkMTHilbertOrder::GetChunkBegin(points.size(), chunks, chunk),
      order.data() + vtkMTHilbertOrder::GetChunkBegin(points.size(), chunks, chunk + 1));
  }
  return seeds;
}

std::vector<vtkMTSeedRelaxation::Point> vtkMTSeedRelaxation::Step(
  const std::vector<Point>& points, std::vector<Point> seeds) const
{
  const vtkMTSeedPartition partition(std::move(seeds));
  const Groups groups(points, partition);
  const std::size_t largest = groups.GetLargest();
  std::vector<Point> result;
  for (std::size_t region = 0; region < partition.GetNumberOfRegions(); ++region)
  {
    const double share = static_cast<double>(groups.GetSize(region)) / this->PerRegion;
    const std::uint32_t* begin = groups.Members.data() + groups.Begin[region];
    const std::uint32_t* end = groups.Members.data() + groups.Begin[region + 1];
    if (region != largest && (begin == end || share < this->SmallRegion))
    {
      continue;
    }
    if (!this->DivideLarge || share <= 2.0)
    {
      result.push_back(GetMean(points, begin, end));
      continue;
    }
    std::vector<Point> members(groups.GetSize(region));
    std::transform(begin, end, members.begin(), [&points](std::uint32_t i) { return points[i]; });
    const std::vector<Point> parts = PlaceAlongCurve(members, static_cast<std::size_t>(std::round(share)), this->Level);
    result.insert(result.end(), parts.begin(), parts.end());
  }
  return result;
}
