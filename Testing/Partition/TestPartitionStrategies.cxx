// SPDX-License-Identifier: BSD-3-Clause
// What every strategy promises.
#include "MTPartitionFigures.h"
#include "MTPartitionStrategies.h"
#include "vtkMTArrayScan.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <cmath>
#include <iostream>
#include <limits>

using namespace MTPartitionTest;

namespace
{
class PartitionStrategy : public testing::TestWithParam<std::string>
{
protected:
  void SetUp() override { this->Strategy = MakeStrategy(this->GetParam()); }

  std::unique_ptr<vtkMTPartition> Build(const Points& barycentres, double target, int level = 0) const
  {
    vtkMTArrayScan scan(barycentres);
    return this->Strategy->Build(scan, target, level);
  }

  void ExpectBound(const std::string& name, const Points& barycentres, double target) const
  {
    const auto partition = this->Build(barycentres, target);
    ASSERT_TRUE(partition) << name;
    const Figures figures = Measure(*partition, barycentres, target);
    Print(name + ", target " + std::to_string(static_cast<int>(target)), figures);
    EXPECT_EQ(figures.Overfull, 0u) << name;
    EXPECT_EQ(figures.Empty, 0u) << name;
  }

  vtkSmartPointer<vtkMTPartitionStrategy> Strategy;
};

// A scan that fails after some of its barycentres, as a damaged file would make it.
class FailingScan : public vtkMTBarycentreScan
{
public:
  explicit FailingScan(int scans)
    : Left(scans)
  {
  }
  std::size_t GetNumberOfTriangles() const override { return this->Barycentres.size(); }
  bool Scan(const Block& block) override
  {
    block(this->Barycentres.data(), this->Barycentres.size() / 2);
    if (this->Left-- <= 0)
    {
      return false;
    }
    block(this->Barycentres.data() + this->Barycentres.size() / 2, this->Barycentres.size() / 2);
    return true;
  }

private:
  Points Barycentres = MakeCloud(10000, 3);
  int Left;
};
}

TEST_P(PartitionStrategy, NoRegionExceedsFourTimesTheTarget)
{
  this->ExpectBound("fractal sphere", MakeFractalSphere(6).GetBarycentres(), 500.0);
  this->ExpectBound("terrain", MakeTerrain(200).GetBarycentres(), 500.0);
  this->ExpectBound("uneven scene", MakeUnevenScene().GetBarycentres(), 50.0);
  this->ExpectBound("uneven scene", MakeUnevenScene().GetBarycentres(), 1000.0);
  this->ExpectBound("cloud", MakeCloud(30000, 1), 200.0);
  this->ExpectBound("shrinking helix", MakeShrinkingHelix(30000), 100.0);
}

TEST_P(PartitionStrategy, NoRegionExceedsFourTimesTheTargetWhereHalfOfTheMeshIsOnePoint)
{
  Points barycentres = MakeCloud(10000, 1);
  for (std::size_t i = 0; i < barycentres.size(); i += 2)
  {
    barycentres[i] = { 0.25, 0.5, 0.125 };
  }
  this->ExpectBound("half at one point", barycentres, 100.0);
}

TEST_P(PartitionStrategy, CoincidentBarycentresTerminate)
{
  for (const Point& place : Points{ { 0.0, 0.0, 0.0 }, { 1e30, -1e-30, 4e6 } })
  {
    const Points barycentres(5000, place);
    const auto partition = this->Build(barycentres, 100.0);
    ASSERT_TRUE(partition);
    EXPECT_EQ(partition->GetNumberOfRegions(), 1u);
  }
  // Two places that differ by the last bit.
  Points barycentres(5000, { 1.0, 1.0, 1.0 });
  for (std::size_t i = 0; i < 2500; ++i)
  {
    barycentres[i][0] = std::nextafter(1.0, 2.0);
  }
  const auto partition = this->Build(barycentres, 100.0);
  ASSERT_TRUE(partition);
  EXPECT_EQ(partition->GetNumberOfRegions(), 2u);
}

TEST_P(PartitionStrategy, OneRegionWhenTargetIsWholeMesh)
{
  const Points barycentres = MakeFractalSphere(3).GetBarycentres();
  for (const double target : { 1280.0, 1281.0, 1e30, std::numeric_limits<double>::infinity() })
  {
    const auto partition = this->Build(barycentres, target, 7);
    ASSERT_TRUE(partition);
    EXPECT_EQ(partition->GetNumberOfRegions(), 1u) << target;
  }
}

TEST_P(PartitionStrategy, MeanIsNearTheTarget)
{
  const Points barycentres = MakeFractalSphere(6).GetBarycentres();
  for (const double target : { 30.0, 200.0, 1000.0, 7000.0 })
  {
    for (int level = 0; level < 4; ++level)
    {
      const auto partition = this->Build(barycentres, target, level);
      ASSERT_TRUE(partition);
      const Figures figures = Measure(*partition, barycentres, target);
      Print("target " + std::to_string(static_cast<int>(target)) + ", level " + std::to_string(level), figures);
      // A factor of 2^(3/4) is what the grid of a regular partition allows; half as much again for chance in few
      // regions.
      EXPECT_LT(figures.Mean, 2.0);
      EXPECT_GT(figures.Mean, 0.5);
    }
  }
}

TEST_P(PartitionStrategy, SameResultForAnyNumberOfThreads)
{
  const Points barycentres = MakeUnevenScene().GetBarycentres();
  const int threads = omp_get_max_threads();
  Regions expected;
  for (const int count : { 1, 2, 3, 8 })
  {
    omp_set_num_threads(count);
    const auto partition = this->Build(barycentres, 300.0, 1);
    ASSERT_TRUE(partition);
    const Regions regions = LocateAll(*partition, barycentres);
    expected = count == 1 ? regions : expected;
    EXPECT_EQ(regions, expected) << count << " threads";
  }
  omp_set_num_threads(threads);
}

TEST_P(PartitionStrategy, SameResultForAnySizeOfBlocks)
{
  class OneByOne : public vtkMTArrayScan
  {
  public:
    using vtkMTArrayScan::vtkMTArrayScan;
    bool Scan(const Block& block) override
    {
      return this->vtkMTArrayScan::Scan(
        [&block](const Point* barycentres, std::size_t count)
        {
          for (std::size_t i = 0; i < count; ++i)
          {
            block(barycentres + i, 1);
          }
        });
    }
  };
  const Points barycentres = MakeTerrain(60).GetBarycentres();
  OneByOne scan(barycentres);
  const auto single = this->Strategy->Build(scan, 100.0, 0);
  ASSERT_TRUE(single);
  EXPECT_EQ(LocateAll(*single, barycentres), LocateAll(*this->Build(barycentres, 100.0), barycentres));
}

TEST_P(PartitionStrategy, WorksAtAllScalesAndOffsets)
{
  const Points sphere = MakeFractalSphere(4).GetBarycentres();
  for (const double factor : { 1e-30, 1e-6, 1.0, 1e6, 1e30 })
  {
    for (const double offset : { 0.0, 1e6 * factor })
    {
      Points barycentres = sphere;
      for (Point& x : barycentres)
      {
        x = { factor * x[0] + offset, factor * x[1] - offset, factor * x[2] + offset };
      }
      const auto partition = this->Build(barycentres, 100.0);
      ASSERT_TRUE(partition);
      const Figures figures = Measure(*partition, barycentres, 100.0);
      EXPECT_EQ(figures.Overfull, 0u);
      EXPECT_EQ(figures.Empty, 0u);
      EXPECT_GT(figures.Mean, 0.5) << "factor " << factor << ", offset " << offset;
      EXPECT_LT(figures.Mean, 2.0) << "factor " << factor << ", offset " << offset;
    }
  }
}

TEST_P(PartitionStrategy, LinesPlanesAndSingleTrianglesAreMeshesToo)
{
  Points line(5000);
  for (std::size_t i = 0; i < line.size(); ++i)
  {
    line[i] = { 3.0, 0.001 * static_cast<double>(i), -7.0 };
  }
  this->ExpectBound("line", line, 100.0);
  Points plane = MakeCloud(5000, 9);
  for (Point& x : plane)
  {
    x[1] = 2.0;
  }
  this->ExpectBound("plane", plane, 100.0);
  this->ExpectBound("two triangles", { { 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 } }, 1.0);
  for (const std::size_t count : { 0, 1 })
  {
    const auto partition = this->Build(Points(count, { 5.0, 6.0, 7.0 }), 1.0);
    ASSERT_TRUE(partition);
    EXPECT_EQ(partition->GetNumberOfRegions(), 1u);
    EXPECT_EQ(partition->Locate({ 0.0, 0.0, 0.0 }), 0u);
  }
}

TEST_P(PartitionStrategy, BarycentresThatAreNotFiniteHaveNoInfluence)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const Points clean = MakeCloud(4000, 2);
  Points dirty;
  for (const Point& x : clean)
  {
    dirty.push_back({ nan, x[1], x[2] });
    dirty.push_back(x);
    dirty.push_back({ x[0], -infinity, infinity });
  }
  const auto expected = this->Build(clean, 100.0);
  const auto partition = this->Build(dirty, 100.0);
  ASSERT_TRUE(partition);
  EXPECT_EQ(LocateAll(*partition, clean), LocateAll(*expected, clean));
  EXPECT_EQ(partition->Locate(dirty[0]), 0u);
  EXPECT_EQ(partition->Locate(dirty[2]), 0u);
  const auto none = this->Build(Points(10, { nan, nan, nan }), 2.0);
  ASSERT_TRUE(none);
  EXPECT_EQ(none->GetNumberOfRegions(), 1u);
}

TEST_P(PartitionStrategy, PointsAwayFromTheMeshHaveARegionToo)
{
  const Points sphere = MakeFractalSphere(4).GetBarycentres();
  const auto partition = this->Build(sphere, 100.0);
  ASSERT_TRUE(partition);
  Points away = MakeCloud(1000, 3);
  away.push_back({ 1e30, 0.0, 0.0 });
  away.push_back({ -1e300, 1e300, 0.0 });
  for (const Point& x : away)
  {
    EXPECT_LT(partition->Locate(x), partition->GetNumberOfRegions());
  }
}

TEST_P(PartitionStrategy, AScanThatFailsGivesNoPartition)
{
  for (int scans = 0; scans < 2; ++scans)
  {
    FailingScan scan(scans);
    EXPECT_FALSE(this->Strategy->Build(scan, 100.0, 0)) << scans << " scans without failure";
  }
}

TEST_P(PartitionStrategy, SuccessivePartitionsShareFewBorders)
{
  const Mesh mesh = MakeFractalSphere(6);
  const Points barycentres = mesh.GetBarycentres();
  // A regular partition may come upon the same cubes again where the targets hardly grow.
  const double slowest = this->GetParam() == "Regular" ? 1.5 : 1.0;
  for (const double growth : { 2.0, slowest })
  {
    Regions previous;
    double target = 250.0;
    for (int level = 0; level < 5; ++level, target *= growth)
    {
      const auto partition = this->Build(barycentres, target, level);
      ASSERT_TRUE(partition);
      const Regions regions = LocateAll(*partition, barycentres);
      if (level > 0)
      {
        const Borders borders = CompareBorders(mesh, previous, regions);
        const Elements elements = MeasureCrossing(previous, regions);
        std::cout << "  growth " << growth << ", levels " << level - 1 << " and " << level << ": "
                  << 100.0 * borders.GetShare() << " % of " << borders.Second << " border edges are shared; "
                  << elements.PerRegion << " elements per region, " << 100.0 * elements.Small << " % slivers\n";
        EXPECT_LT(borders.GetShare(), growth > 1.0 ? 0.15 : 0.3);
      }
      previous = regions;
    }
  }
}

TEST_P(PartitionStrategy, SettingsNameTheStrategy)
{
  EXPECT_EQ(this->Strategy->GetSettings().rfind(this->Strategy->GetStrategyName(), 0), 0u);
  std::cout << "  " << this->Strategy->GetSettings() << "\n";
}

INSTANTIATE_TEST_SUITE_P(All, PartitionStrategy, testing::ValuesIn(GetStrategyNames()));
