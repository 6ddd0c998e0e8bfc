// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTSliverMerge.h"

#include "vtkMTSeedPartition.h"

#include <algorithm>
#include <map>

namespace
{
using Sizes = std::map<std::uint32_t, std::size_t>;

std::vector<std::uint32_t> GetRemaining(const Sizes& sizes, std::size_t minimum)
{
  std::vector<std::uint32_t> remaining;
  for (const auto& element : sizes)
  {
    if (element.second >= minimum)
    {
      remaining.push_back(element.first);
    }
  }
  if (remaining.empty() && !sizes.empty())
  {
    // max_element gives the first of the largest.
    remaining.push_back(std::max_element(sizes.begin(), sizes.end(),
      [](const auto& a, const auto& b) {
        return a.second < b.second;
      })->first);
  }
  return remaining;
}
}

std::size_t vtkMTSliverMerge::MergeSlivers(const vtkMTPartition& partition,
  const std::vector<std::array<double, 3>>& barycentres, std::size_t minimum, std::vector<std::uint32_t>& regions)
{
  Sizes sizes;
  for (std::size_t begin = 0, end = 0; begin < regions.size(); begin = end)
  {
    while (end < regions.size() && regions[end] == regions[begin])
    {
      ++end;
    }
    sizes[regions[begin]] += end - begin;
  }
  const std::vector<std::uint32_t> remaining = GetRemaining(sizes, minimum);
  if (remaining.size() == sizes.size())
  {
    return 0;
  }
  std::vector<std::array<double, 3>> seeds(remaining.size());
  std::transform(remaining.begin(), remaining.end(), seeds.begin(),
    [&partition](std::uint32_t region) { return partition.GetSeed(region); });
  const vtkMTSeedPartition nearest(std::move(seeds));
  for (std::size_t i = 0; i < regions.size(); ++i)
  {
    if (!std::binary_search(remaining.begin(), remaining.end(), regions[i]))
    {
      regions[i] = remaining[nearest.Locate(barycentres[i])];
    }
  }
  return sizes.size() - remaining.size();
}
