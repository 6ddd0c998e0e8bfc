// SPDX-License-Identifier: BSD-3-Clause
#include "MTPartitionFigures.h"
#include "vtkMTSeedPartition.h"
#include "vtkMTSliverMerge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

using namespace MTPartitionTest;

namespace
{
std::map<std::uint32_t, std::size_t> GetSizes(const Regions& regions)
{
  std::map<std::uint32_t, std::size_t> sizes;
  for (const std::uint32_t region : regions)
  {
    ++sizes[region];
  }
  return sizes;
}
}

TEST(SliverMerge, TrianglesOfASliverGoToTheNearestSeedThatRemains)
{
  const Points seeds = MakeCloud(40, 1);
  const vtkMTSeedPartition partition(seeds);
  const Points barycentres = MakeCloud(3000, 2);
  const Regions before = LocateAll(partition, barycentres);
  const std::size_t minimum = 60;
  Regions after = before;
  const std::size_t merged = vtkMTSliverMerge::MergeSlivers(partition, barycentres, minimum, after);

  auto sizes = GetSizes(before);
  std::size_t small = 0;
  for (const auto& element : sizes)
  {
    small += element.second < minimum ? 1 : 0;
  }
  ASSERT_GT(small, 0u);
  ASSERT_LT(small, sizes.size());
  EXPECT_EQ(merged, small);
  EXPECT_EQ(GetSizes(after).size(), sizes.size() - small);
  for (std::size_t i = 0; i < barycentres.size(); ++i)
  {
    if (sizes[before[i]] >= minimum)
    {
      EXPECT_EQ(after[i], before[i]);
      continue;
    }
    std::uint32_t best = 0;
    double bestDistance = 1e300;
    for (const auto& element : sizes)
    {
      const Point& seed = seeds[element.first];
      const double dx = seed[0] - barycentres[i][0];
      const double dy = seed[1] - barycentres[i][1];
      const double dz = seed[2] - barycentres[i][2];
      const double distance = dx * dx + dy * dy + dz * dz;
      if (element.second >= minimum && distance < bestDistance)
      {
        best = element.first;
        bestDistance = distance;
      }
    }
    EXPECT_EQ(after[i], best);
  }
}

TEST(SliverMerge, TheLargestStaysWhenAllAreSmall)
{
  const vtkMTSeedPartition partition(Points{ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 } });
  const Points barycentres(7, { 0.0, 0.0, 0.0 });
  Regions regions = { 3, 1, 2, 2, 3, 1, 0 };
  EXPECT_EQ(vtkMTSliverMerge::MergeSlivers(partition, barycentres, 100, regions), 3u);
  EXPECT_EQ(regions, Regions(7, 1u)) << "the first of the largest";
}

TEST(SliverMerge, NothingChangesWhereNothingIsSmall)
{
  const vtkMTSeedPartition partition(Points{ { 0, 0, 0 }, { 1, 0, 0 } });
  Regions regions = { 1, 0, 1, 0 };
  const Regions before = regions;
  const Points barycentres(4, { 0.9, 0.0, 0.0 });
  EXPECT_EQ(vtkMTSliverMerge::MergeSlivers(partition, barycentres, 2, regions), 0u);
  EXPECT_EQ(vtkMTSliverMerge::MergeSlivers(partition, barycentres, 0, regions), 0u);
  EXPECT_EQ(regions, before);
  Regions none;
  EXPECT_EQ(vtkMTSliverMerge::MergeSlivers(partition, {}, 10, none), 0u);
}
