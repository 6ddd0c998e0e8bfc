// SPDX-License-Identifier: BSD-3-Clause
// The k-d tree of barycentres, and the shuffled order in which they come to it.
#include "MTPartitionFigures.h"
#include "vtkMTArrayScan.h"
#include "vtkMTKdPartition.h"
#include "vtkMTStreamShuffle.h"
#include "vtkMTVoronoiPartition.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <limits>
#include <memory>
#include <vector>

using namespace MTPartitionTest;

TEST(StreamShuffle, StreamNTakesOneOfTwoToTheN)
{
  constexpr std::uint64_t numbers = 1u << 20;
  std::array<double, vtkMTStreamShuffle::MaximumStream + 1> counts{};
  for (std::uint64_t number = 0; number < numbers; ++number)
  {
    ++counts[static_cast<std::size_t>(vtkMTStreamShuffle::GetStream(number))];
  }
  for (int stream = 0; stream < 12; ++stream)
  {
    const double share = std::ldexp(1.0, -stream - 1);
    const double sigma = std::sqrt(share * (1.0 - share) * numbers);
    EXPECT_NEAR(counts[static_cast<std::size_t>(stream)], share * numbers, 4.0 * sigma) << "stream " << stream;
  }
}

// A file's triangles come in sweeps; no octant may wait for its turn in the shuffled order.
TEST(StreamShuffle, EveryBeginningIsAnEvenSample)
{
  const Points barycentres = MakeFractalSphere(7).GetBarycentres();
  const auto getOctant = [](const Point& x)
  { return static_cast<std::size_t>(x[0] > 0.0) + 2 * std::size_t(x[1] > 0.0) + 4 * std::size_t(x[2] > 0.0); };
  std::array<double, 8> all{};
  std::for_each(barycentres.begin(), barycentres.end(), [&](const Point& x) { ++all[getOctant(x)]; });
  vtkMTArrayScan scan(barycentres);
  for (const int firstStream : { 2, 6 })
  {
    vtkMTStreamShuffle shuffle;
    ASSERT_TRUE(shuffle.Take(scan, firstStream));
    EXPECT_EQ(shuffle.Count, barycentres.size());
    for (const std::size_t part : { 4, 1 })
    {
      const std::size_t count = shuffle.Points.size() / part;
      std::array<double, 8> counts{};
      std::for_each(shuffle.Points.begin(), shuffle.Points.begin() + static_cast<std::ptrdiff_t>(count),
        [&](const Point& x) { ++counts[getOctant(x)]; });
      double most = 0.0;
      for (std::size_t octant = 0; octant < 8; ++octant)
      {
        const double share = all[octant] / static_cast<double>(barycentres.size());
        const double sigma = std::sqrt(share * (1.0 - share) * static_cast<double>(count));
        most = std::max(most, std::abs(counts[octant] - share * static_cast<double>(count)) / sigma);
      }
      std::cout << count << " of " << barycentres.size() << ": an octant is off by " << most << " sigma at most\n";
      EXPECT_LT(most, part == 1 ? 3.0 : 4.0);
      EXPECT_GT(count, 500u);
    }
  }
}

TEST(StreamShuffle, WhatIsNoNumberIsLeftOutAndSomethingIsAlwaysTaken)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Points barycentres = { { nan, 0.0, 0.0 }, { 1.0, 2.0, 3.0 }, { 0.0, nan, 0.0 } };
  vtkMTArrayScan scan(barycentres);
  vtkMTStreamShuffle shuffle;
  ASSERT_TRUE(shuffle.Take(scan, vtkMTStreamShuffle::MaximumStream));
  EXPECT_EQ(shuffle.Count, 1u);
  ASSERT_EQ(shuffle.Points.size(), 1u);
  EXPECT_EQ(shuffle.Points[0], (Point{ 1.0, 2.0, 3.0 }));
}

// Why planes alternate: a border of one level that is one of the next too stays locked for two levels.
TEST(KdPartition, PartitionsOfSuccessiveLevelsShareFewBorders)
{
  const Mesh mesh = MakeFractalSphere(7);
  const Points barycentres = mesh.GetBarycentres();
  vtkNew<vtkMTKdPartition> strategy;
  const auto share = [&](int level, int next)
  {
    const auto first = BuildPartition(strategy, barycentres, 1000.0, level);
    const auto second = BuildPartition(strategy, barycentres, 2000.0, next);
    return CompareBorders(mesh, LocateAll(*first, barycentres), LocateAll(*second, barycentres)).GetShare();
  };
  const double turned = share(0, 1);
  const double same = share(0, 0);
  std::cout << 100.0 * turned << " % of the borders are those of the level before, " << 100.0 * same
            << " % where planes do not alternate\n";
  EXPECT_LT(turned, 0.1);
  EXPECT_GT(same, 2.0 * turned);
}

TEST(KdPartition, ALeafIsAsFullInTheMeanAsItsSharesSay)
{
  const Points barycentres = MakeCloud(200000, 5);
  vtkNew<vtkMTKdPartition> strategy;
  for (const int level : { 0, 1 })
  {
    const Figures figures = Measure(*BuildPartition(strategy, barycentres, 300.0, level), barycentres, 300.0);
    Print("level " + std::to_string(level), figures);
    EXPECT_NEAR(figures.Mean, 1.0, 0.1);
    EXPECT_LT(figures.Largest, 2.5);
    EXPECT_LT(figures.Small, 0.05);
  }
}

TEST(KdPartition, ASeedLiesInItsRegion)
{
  const Points barycentres = MakeUnevenScene().GetBarycentres();
  vtkNew<vtkMTKdPartition> strategy;
  const auto partition = BuildPartition(strategy, barycentres, 100.0, 0);
  for (std::uint32_t region = 0; region < partition->GetNumberOfRegions(); ++region)
  {
    EXPECT_EQ(partition->Locate(partition->GetSeed(region)), region);
  }
  EXPECT_EQ(partition->Locate({ std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0 }), 0u);
}

// Not a time, which depends on the machine, but a ratio of two in one run.
TEST(KdPartition, IsPlacedFasterThanVoronoiRegions)
{
  const Points barycentres = MakeFractalSphere(8).GetBarycentres();
  const auto measure = [&](const vtkMTPartitionStrategy* strategy)
  {
    const double start = GetSeconds();
    const auto partition = BuildPartition(strategy, barycentres, 1000.0, 0);
    const Regions regions = LocateAll(*partition, barycentres);
    const double seconds = GetSeconds() - start;
    std::cout << strategy->GetStrategyName() << ": " << partition->GetNumberOfRegions() << " regions, "
              << 1e6 * seconds / static_cast<double>(regions.size()) << " us a triangle\n";
    return seconds;
  };
  const double voronoi = measure(vtkNew<vtkMTVoronoiPartition>());
  const double tree = measure(vtkNew<vtkMTKdPartition>());
  EXPECT_LT(tree, voronoi);
}
