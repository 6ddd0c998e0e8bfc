// SPDX-License-Identifier: BSD-3-Clause
#include "MTPartitionFigures.h"
#include "vtkMTArrayScan.h"
#include "vtkMTRegularFamily.h"
#include "vtkMTRegularPartition.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <limits>
#include <set>

using namespace MTPartitionTest;

namespace
{
double GetDistance(const Point& a, const Point& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

// The distance of x to the nearest seed of the family, by trying all seeds near it.
double FindNearest(int exponent, vtkMTRegularFamily::SeedType type, const Point& x)
{
  const double h = std::ldexp(1.0, exponent);
  double best = std::numeric_limits<double>::infinity();
  for (int n = 0; n < 8 * 8 * 8; ++n)
  {
    // Places half a cell apart: which of them are seeds is the definition of the family.
    const std::array<int, 3> half = { n % 8 - 4, n / 8 % 8 - 4, n / 64 - 4 };
    int between = 0;
    Point seed;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double place = 2.0 * std::floor(x[axis] / h) + half[axis];
      between += std::fmod(std::abs(place), 2.0) == 1.0 ? 1 : 0;
      seed[axis] = 0.5 * h * place;
    }
    const int wanted = type == vtkMTRegularFamily::Cubes ? 3 : type == vtkMTRegularFamily::Faces ? 2 : 1;
    best = between == wanted ? std::min(best, GetDistance(seed, x)) : best;
  }
  return best;
}
}

TEST(RegularFamily, ClosedFormIsTheNearestSeed)
{
  for (const auto type : { vtkMTRegularFamily::Cubes, vtkMTRegularFamily::Faces, vtkMTRegularFamily::Edges })
  {
    for (const int exponent : { -3, -2, -1, 0, 1, 2 })
    {
      const vtkMTRegularFamily family(vtkMTRegularFamily::GetFamilyOf(exponent, type));
      EXPECT_EQ(family.GetType(), type);
      for (const Point& p : MakeCloud(500, static_cast<unsigned>(exponent + 10)))
      {
        const Point x = { 10.0 * p[0] - 5.0, 10.0 * p[1] - 5.0, 10.0 * p[2] - 5.0 };
        vtkMTRegularFamily::Cell cell;
        ASSERT_TRUE(family.Locate(x, cell));
        EXPECT_NEAR(GetDistance(family.GetSeed(cell), x), FindNearest(exponent, type, x), 1e-12);
      }
    }
  }
}

TEST(RegularFamily, PointsThatNoCellCanHoldAreRefused)
{
  const vtkMTRegularFamily family(0);
  vtkMTRegularFamily::Cell cell;
  EXPECT_FALSE(family.Locate({ std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0 }, cell));
  EXPECT_FALSE(family.Locate({ 0.0, -std::numeric_limits<double>::infinity(), 0.0 }, cell));
  EXPECT_FALSE(family.Locate({ 0.0, 0.0, 1e16 }, cell));
  EXPECT_TRUE(family.Locate({ 0.0, 0.0, 1e15 }, cell));
  for (const double largest : { 1e-200, 1e-30, 1.0, 3.0, 4.0, 1e30, 1e200 })
  {
    const int exponent = vtkMTRegularFamily::GetSmallestExponent(largest);
    const vtkMTRegularFamily finest(vtkMTRegularFamily::GetFamilyOf(exponent, vtkMTRegularFamily::Edges));
    EXPECT_TRUE(finest.Locate({ largest, -largest, 0.0 }, cell)) << largest;
  }
}

TEST(RegularPartition, RegularStepReductionIsMeasured)
{
  const Points barycentres = MakeFractalSphere(7).GetBarycentres();
  const char* names[] = { "cubes", "faces", "edges" };
  std::size_t previous = 0;
  for (int family = vtkMTRegularFamily::GetFamilyOf(-4, vtkMTRegularFamily::Edges);
       family >= vtkMTRegularFamily::GetFamilyOf(0, vtkMTRegularFamily::Cubes); --family)
  {
    const vtkMTRegularFamily seeds(family);
    std::set<vtkMTRegularFamily::Cell> cells;
    for (const Point& x : barycentres)
    {
      vtkMTRegularFamily::Cell cell;
      ASSERT_TRUE(seeds.Locate(x, cell));
      cells.insert(cell);
    }
    const double reduction = static_cast<double>(previous) / static_cast<double>(cells.size());
    std::cout << "  " << names[seeds.GetType()] << ": " << cells.size() << " regions, step " << reduction << "\n";
    if (previous > 0 && cells.size() > 500)
    {
      // From edges to faces nothing is gained, the other two steps halve.
      const bool level = seeds.GetType() == vtkMTRegularFamily::Faces;
      EXPECT_NEAR(reduction, level ? 1.0 : 2.0, 0.3);
    }
    previous = cells.size();
  }
}

TEST(RegularPartition, RegionsAreTheNearestSeedsWhereNothingIsOverfull)
{
  const Points barycentres = MakeFractalSphere(6).GetBarycentres();
  vtkMTArrayScan scan(barycentres);
  vtkNew<vtkMTRegularPartition> strategy;
  for (const int level : { 0, 1 })
  {
    const auto partition = strategy->Build(scan, 1000.0, level);
    ASSERT_TRUE(partition);
    ASSERT_LT(Measure(*partition, barycentres, 1000.0).Largest, 4.0);
    for (std::size_t i = 0; i < barycentres.size(); i += 97)
    {
      const Point& x = barycentres[i];
      double best = std::numeric_limits<double>::infinity();
      for (std::uint32_t region = 0; region < partition->GetNumberOfRegions(); ++region)
      {
        best = std::min(best, GetDistance(x, partition->GetSeed(region)));
      }
      EXPECT_NEAR(GetDistance(x, partition->GetSeed(partition->Locate(x))), best, 1e-12);
    }
  }
}

TEST(RegularPartition, PartitionsOfOneSequenceFitWhateverMeshTheyAreBuiltOn)
{
  // Half of the triangles are gone and the rest has moved a little: the same cells at half the target.
  const Points fine = MakeFractalSphere(6).GetBarycentres();
  Points coarse;
  for (std::size_t i = 0; i < fine.size(); i += 2)
  {
    coarse.push_back({ fine[i][0], 0.999 * fine[i][1], fine[i][2] });
  }
  vtkMTArrayScan fineScan(fine);
  vtkMTArrayScan coarseScan(coarse);
  vtkNew<vtkMTRegularPartition> strategy;
  const auto first = strategy->Build(fineScan, 100.0, 0);
  const auto second = strategy->Build(coarseScan, 50.0, 0);
  ASSERT_TRUE(first);
  ASSERT_TRUE(second);
  std::set<Point> seeds;
  for (std::uint32_t region = 0; region < first->GetNumberOfRegions(); ++region)
  {
    seeds.insert(first->GetSeed(region));
  }
  std::size_t common = 0;
  for (std::uint32_t region = 0; region < second->GetNumberOfRegions(); ++region)
  {
    common += seeds.count(second->GetSeed(region));
  }
  std::cout << "  " << common << " of " << second->GetNumberOfRegions() << " seeds are the same\n";
  EXPECT_GT(common, 9 * second->GetNumberOfRegions() / 10);
}

TEST(RegularPartition, TimeOfBuildAndLocateIsMeasured)
{
  const Points barycentres = MakeFractalSphere(7).GetBarycentres();
  vtkMTArrayScan scan(barycentres);
  vtkNew<vtkMTRegularPartition> strategy;
  for (const double target : { 100.0, 1000.0 })
  {
    const double begin = GetSeconds();
    const auto partition = strategy->Build(scan, target, 0);
    const double middle = GetSeconds();
    ASSERT_TRUE(partition);
    const Regions regions = LocateAll(*partition, barycentres);
    const double end = GetSeconds();
    const double count = static_cast<double>(barycentres.size());
    std::cout << "  target " << target << ": microseconds of processor time per triangle: build "
              << 1e6 * (middle - begin) / count << ", locate " << 1e6 * (end - middle) / count << "\n";
    EXPECT_EQ(regions.size(), barycentres.size());
  }
}
