// SPDX-License-Identifier: BSD-3-Clause
#include "MTPartitionFigures.h"
#include "vtkMTSeedPartition.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <limits>

using namespace MTPartitionTest;

namespace
{
std::uint32_t FindNearest(const Points& seeds, const Point& x)
{
  std::uint32_t best = 0;
  double bestDistance = std::numeric_limits<double>::infinity();
  for (std::uint32_t i = 0; i < seeds.size(); ++i)
  {
    const double dx = seeds[i][0] - x[0];
    const double dy = seeds[i][1] - x[1];
    const double dz = seeds[i][2] - x[2];
    const double distance = dx * dx + dy * dy + dz * dz;
    if (distance < bestDistance)
    {
      best = i;
      bestDistance = distance;
    }
  }
  return best;
}

std::size_t CountWrong(const Points& seeds, const Points& queries)
{
  const vtkMTSeedPartition partition(seeds);
  std::vector<std::uint32_t> regions(queries.size());
  partition.LocateAll(queries.data(), queries.size(), regions.data());
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < queries.size(); ++i)
  {
    const std::uint32_t nearest = FindNearest(seeds, queries[i]);
    wrong += partition.Locate(queries[i]) != nearest || regions[i] != nearest ? 1 : 0;
  }
  return wrong;
}

Points Scale(Points points, double factor, double offset)
{
  for (Point& p : points)
  {
    p = { factor * p[0] + offset, factor * p[1] + offset, factor * p[2] + offset };
  }
  return points;
}
}

TEST(SeedPartition, LocateIsNearestSeedForAnyNumberOfSeeds)
{
  const Points queries = MakeCloud(300, 2);
  for (std::size_t count = 1; count <= 70; ++count)
  {
    EXPECT_EQ(CountWrong(MakeCloud(count, static_cast<unsigned>(count)), queries), 0u) << count << " seeds";
  }
  EXPECT_EQ(CountWrong(MakeCloud(2000, 1), Scale(MakeCloud(3000, 3), 1.4, -0.2)), 0u);
}

TEST(SeedPartition, TiesGoToTheSmallerIndex)
{
  // Whole coordinates: most queries have several seeds at exactly the same distance, and many seeds coincide.
  Points seeds = MakeCloud(900, 4);
  Points queries = MakeCloud(4000, 5);
  for (Points* points : { &seeds, &queries })
  {
    for (Point& p : *points)
    {
      p = { std::floor(8.0 * p[0]), std::floor(8.0 * p[1]), std::floor(8.0 * p[2]) };
    }
  }
  EXPECT_EQ(CountWrong(seeds, queries), 0u);
}

TEST(SeedPartition, LocateIsNearestSeedAtAllScales)
{
  for (const double factor : { 1e-30, 1e-6, 1.0, 1e30 })
  {
    for (const double offset : { 0.0, 4e6 * factor, 1e12 * factor })
    {
      EXPECT_EQ(CountWrong(Scale(MakeCloud(500, 6), factor, offset), Scale(MakeCloud(1000, 7), factor, offset)), 0u)
        << "factor " << factor << ", offset " << offset;
    }
  }
}

TEST(SeedPartition, LocateIsNearestSeedWhereDensityVaries)
{
  EXPECT_EQ(CountWrong(MakeShrinkingHelix(1500), MakeShrinkingHelix(4001)), 0u);
}

TEST(SeedPartition, CoincidentSeedsAreTheFirstOfThem)
{
  const Points seeds(100, { 1.0, 2.0, 3.0 });
  EXPECT_EQ(vtkMTSeedPartition(seeds).Locate({ 0.0, 0.0, 0.0 }), 0u);
}

TEST(SeedPartition, PointsThatAreNotFiniteAreInRegionZero)
{
  const vtkMTSeedPartition partition(MakeCloud(100, 8));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(partition.Locate({ nan, 0.5, 0.5 }), 0u);
  EXPECT_EQ(partition.Locate({ 0.5, nan, nan }), 0u);
  EXPECT_EQ(partition.Locate({ infinity, 0.5, 0.5 }), 0u);
  EXPECT_EQ(partition.Locate({ 0.5, -infinity, nan }), 0u);
  EXPECT_EQ(partition.Locate({ 1e300, 1e300, 0.5 }), 0u);
  const Points points = { { 0.9, 0.9, 0.9 }, { nan, 0.5, 0.5 }, { 0.1, 0.2, 0.3 }, { 1e300, 1e300, 0.5 } };
  std::vector<std::uint32_t> regions(points.size());
  partition.LocateAll(points.data(), points.size(), regions.data());
  EXPECT_EQ(regions[1], 0u);
  EXPECT_EQ(regions[2], partition.Locate(points[2]));
  EXPECT_EQ(regions[3], 0u);
}

TEST(SeedPartition, TimeOfLocateIsMeasured)
{
  const Points barycentres = MakeFractalSphere(7).GetBarycentres();
  Points seeds;
  for (std::size_t i = 0; i < barycentres.size(); i += barycentres.size() / 10000)
  {
    seeds.push_back(barycentres[i]);
  }
  const vtkMTSeedPartition partition(seeds);
  const double begin = GetSeconds();
  std::uint64_t sum = 0;
  for (const Point& x : barycentres)
  {
    sum += partition.Locate(x);
  }
  const double seconds = GetSeconds() - begin;
  std::cout << "  " << seeds.size() << " seeds, one thread: " << 1e6 * seconds / static_cast<double>(barycentres.size())
            << " microseconds of processor time for each of " << barycentres.size() << " barycentres\n";
  EXPECT_GT(sum, 0u);
}
