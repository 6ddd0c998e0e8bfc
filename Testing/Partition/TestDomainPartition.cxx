// SPDX-License-Identifier: BSD-3-Clause
// Subdivided planes and spheres: squares and hexagons.
#include "MTPartitionFigures.h"
#include "MTPartitionStrategies.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <map>
#include <memory>
#include <set>

using namespace MTPartitionTest;

namespace
{
// The regions of a sequence whose target grows by the reduction.
std::vector<Regions> BuildSequence(const vtkMTPartitionStrategy* strategy, const Points& barycentres, double target)
{
  std::vector<Regions> sequence;
  std::uint32_t regions = 0;
  for (int level = 0; regions != 1; ++level, target *= strategy->GetReduction())
  {
    const auto partition = BuildPartition(strategy, barycentres, target, level);
    regions = partition->GetNumberOfRegions();
    sequence.push_back(LocateAll(*partition, barycentres));
  }
  return sequence;
}

double Count(const Regions& regions)
{
  return static_cast<double>(std::set<std::uint32_t>(regions.begin(), regions.end()).size());
}

// Least and largest ratio of the numbers of regions on successive levels, as long as there are so many.
std::pair<double, double> MeasureRatios(const std::string& name, const std::vector<Regions>& sequence, double least)
{
  std::pair<double, double> ratios{ std::numeric_limits<double>::infinity(), 0.0 };
  std::cout << name << ":";
  for (std::size_t level = 0; level < sequence.size(); ++level)
  {
    const double count = Count(sequence[level]);
    std::cout << " " << count;
    if (level > 0 && count >= least)
    {
      const double ratio = Count(sequence[level - 1]) / count;
      ratios = { std::min(ratios.first, ratio), std::max(ratios.second, ratio) };
    }
  }
  std::cout << "; a step divides by " << ratios.first << " to " << ratios.second << "\n";
  return ratios;
}

Points Scale(Points points, const Point& factors)
{
  for (Point& x : points)
  {
    x = { factors[0] * x[0], factors[1] * x[1], factors[2] * x[2] };
  }
  return points;
}

using Edge = std::pair<std::uint32_t, std::uint32_t>;

// Edges of the mesh between two regions.
std::set<Edge> FindBorders(const Mesh& mesh, const Regions& regions)
{
  std::map<Edge, std::uint32_t> first;
  std::set<Edge> borders;
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      const Edge edge = std::minmax(mesh.Triangles[t][c], mesh.Triangles[t][(c + 1) % 3]);
      if (first.emplace(edge, regions[t]).first->second != regions[t])
      {
        borders.insert(edge);
      }
    }
  }
  return borders;
}

// The share of the first level's borders that are borders of all levels up to another one: what stays locked.
std::vector<double> MeasureLocked(const std::string& name, const Mesh& mesh, const std::vector<Regions>& sequence)
{
  std::set<Edge> locked = FindBorders(mesh, sequence[0]);
  const auto all = static_cast<double>(locked.size());
  std::vector<double> shares;
  std::cout << name << ": of " << all << " border edges are locked for more levels";
  for (std::size_t level = 1; level < std::min<std::size_t>(sequence.size(), 5); ++level)
  {
    const std::set<Edge> borders = FindBorders(mesh, sequence[level]);
    std::set<Edge> both;
    std::set_intersection(
      locked.begin(), locked.end(), borders.begin(), borders.end(), std::inserter(both, both.begin()));
    locked = both;
    shares.push_back(static_cast<double>(locked.size()) / all);
    std::cout << " " << 100.0 * shares.back() << " %";
  }
  std::cout << "\n";
  return shares;
}
}

TEST(QuadPartition, EveryStepHalvesExactly)
{
  vtkNew<vtkMTQuadPartition> strategy;
  const Points terrain = MakeTerrain(250).GetBarycentres();
  const std::map<std::string, Points> planes{ { "square terrain", terrain },
    { "terrain twice as long", Scale(terrain, { 2.0, 1.0, 1.0 }) },
    { "terrain 1 : 7", Scale(terrain, { 1.0, 7.0, 1.0 }) },
    { "line", Scale(MakeCloud(125000, 1), { 0.0, 1.0, 0.0 }) } };
  for (const auto& [name, points] : planes)
  {
    const auto [least, most] = MeasureRatios(name, BuildSequence(strategy, points, 100.0), 1.0);
    EXPECT_NEAR(least, 2.0, 0.05) << name;
    EXPECT_NEAR(most, 2.0, 0.05) << name;
  }
  const std::vector<Regions> sphere = BuildSequence(strategy, MakeFractalSphere(6).GetBarycentres(), 60.0);
  const auto [least, most] = MeasureRatios("sphere", sphere, 3.0);
  EXPECT_EQ(least, 2.0);
  EXPECT_EQ(most, 2.0);
}

TEST(HexagonPartition, EveryStepDividesByThree)
{
  vtkNew<vtkMTHexagonPartition> strategy;
  EXPECT_EQ(strategy->GetReduction(), 3.0);
  const std::vector<Regions> sphere = BuildSequence(strategy, MakeFractalSphere(6).GetBarycentres(), 60.0);
  const auto [least, most] = MeasureRatios("sphere", sphere, 92.0);
  EXPECT_NEAR(least, 3.0, 0.05);
  EXPECT_NEAR(most, 3.0, 0.05);
  for (const auto& regions : sphere)
  {
    const double above = Count(regions) - 2.0; // 10 times a power of three, or the last 4 or 1
    const double power = std::log(above / 10.0) / std::log(3.0);
    EXPECT_TRUE(above <= 2.0 || std::abs(power - std::round(power)) < 1e-9) << above + 2.0;
  }
  const Points terrain = MakeTerrain(400).GetBarycentres();
  for (const double length : { 1.0, 1.7, 4.0 })
  {
    const std::string name = "terrain 1 : " + std::to_string(length);
    const std::vector<Regions> plane = BuildSequence(strategy, Scale(terrain, { 1.0, length, 1.0 }), 60.0);
    const auto ratios = MeasureRatios(name, plane, 50.0);
    EXPECT_NEAR(ratios.first, 3.0, 0.3) << name; // hexagons at the border are whole or not there
    EXPECT_NEAR(ratios.second, 3.0, 0.3) << name;
  }
}

// Borders along the edges of a cube or an icosahedron would be borders of every level.
TEST(DomainPartition, NoBorderStaysLocked)
{
  const std::map<std::string, Mesh> meshes{ { "sphere", MakeFractalSphere(7) }, { "terrain", MakeTerrain(300) } };
  for (const std::string strategy : { "Quad", "Hexagon", "Kd", "AlongCurve" })
  {
    for (const auto& [name, mesh] : meshes)
    {
      const auto sequence = BuildSequence(MakeStrategy(strategy), mesh.GetBarycentres(), 500.0);
      const std::vector<double> locked = MeasureLocked(strategy + ", " + name, mesh, sequence);
      if (strategy == "Quad" || strategy == "Hexagon")
      {
        // The corners of regions, of which half or a third are corners on the next level.
        EXPECT_LT(locked[0], 0.05);
        for (std::size_t i = 1; i < locked.size(); ++i)
        {
          EXPECT_LT(locked[i], 0.7 * locked[i - 1]);
        }
      }
    }
  }
}

TEST(DomainPartition, TheDomainFollowsTheBoxUnlessItIsChosen)
{
  for (const std::string name : { "Quad", "Hexagon" })
  {
    const auto strategy = MakeStrategy(name);
    auto* domain = vtkMTDomainPartition::SafeDownCast(strategy);
    const auto locate = [&](const Points& points, int type)
    {
      domain->SetDomain(type);
      return LocateAll(*BuildPartition(strategy, points, 300.0, 1), points);
    };
    const Points sphere = MakeFractalSphere(5).GetBarycentres();
    const Points flat = Scale(sphere, { 0.45, 1.0, 1.0 });
    const Points thick = Scale(sphere, { 0.55, 1.0, 1.0 });
    const Regions ofFlat = locate(flat, vtkMTDomainPartition::AUTOMATIC);
    EXPECT_EQ(ofFlat, locate(flat, vtkMTDomainPartition::PLANE));
    EXPECT_NE(ofFlat, locate(flat, vtkMTDomainPartition::SPHERE));
    const Regions ofThick = locate(thick, vtkMTDomainPartition::AUTOMATIC);
    EXPECT_EQ(ofThick, locate(thick, vtkMTDomainPartition::SPHERE));
    EXPECT_NE(ofThick, locate(thick, vtkMTDomainPartition::PLANE));
    domain->SetDomain(99);
    EXPECT_EQ(domain->GetDomain(), vtkMTDomainPartition::SPHERE);
    EXPECT_NE(domain->GetSettings().find("sphere"), std::string::npos);
  }
}

// Everything is at a few places of the domain: what the plane cannot tell apart is divided in space.
TEST(DomainPartition, SheetsAboveOneAnotherAreDividedToo)
{
  Points sheets;
  for (int i = 0; i < 60000; ++i)
  {
    sheets.push_back({ i % 3 * 1.0, i / 3 % 2 * 1.0, 1e-6 * i });
  }
  for (const std::string name : { "Quad", "Hexagon" })
  {
    const auto partition = BuildPartition(MakeStrategy(name), sheets, 100.0, 0);
    const Figures figures = Measure(*partition, sheets, 100.0);
    Print(name, figures);
    EXPECT_EQ(figures.Overfull, 0u);
    EXPECT_EQ(figures.Empty, 0u);
    EXPECT_GT(figures.Mean, 0.25);
  }
}

// A third of a mesh twenty times as dense: its regions are finer ones, and borders of levels differ there as well.
TEST(DomainPartition, DenseRegionsAreReplaced)
{
  const Points wide = Scale(MakeCloud(20000, 1), { 1.0, 1.0, 0.001 });
  Points points = Scale(MakeCloud(100000, 2), { 0.5, 0.5, 0.001 });
  points.insert(points.end(), wide.begin(), wide.end());
  for (const std::string name : { "Quad", "Hexagon" })
  {
    const auto partition = BuildPartition(MakeStrategy(name), points, 100.0, 0);
    const Figures figures = Measure(*partition, points, 100.0);
    Print(name, figures);
    EXPECT_EQ(figures.Overfull, 0u);
    EXPECT_GT(figures.Mean, 0.3);
  }
}

// Every point is in the hexagon whose middle is nearest: known without the closed form, from the points of a hexagon.
TEST(HexagonPartition, RegionsAreNearestToTheirMiddles)
{
  const Points points = Scale(MakeCloud(400000, 4), { 1.0, 1.0, 0.0 });
  vtkNew<vtkMTHexagonPartition> strategy;
  for (const double target : { 2000.0, 6000.0 })
  {
    const auto partition = BuildPartition(strategy, points, target, 0);
    const Regions regions = LocateAll(*partition, points);
    std::vector<std::array<double, 3>> sums(partition->GetNumberOfRegions());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      sums[regions[i]] = { sums[regions[i]][0] + points[i][0], sums[regions[i]][1] + points[i][1],
        sums[regions[i]][2] + 1.0 };
    }
    const double radius = 2.0 * std::sqrt(target / static_cast<double>(points.size()));
    double inner = 0.0;
    double wrong = 0.0;
    for (std::size_t i = 0; i < points.size(); i += 7)
    {
      if (std::min({ points[i][0], points[i][1], 1.0 - points[i][0], 1.0 - points[i][1] }) < radius)
      {
        continue; // at the border middles are moved
      }
      const auto distance = [&](const std::array<double, 3>& sum)
      { return std::hypot(sum[0] / sum[2] - points[i][0], sum[1] / sum[2] - points[i][1]); };
      const auto nearest = std::min_element(
        sums.begin(), sums.end(), [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
      inner += 1.0;
      wrong += static_cast<std::size_t>(nearest - sums.begin()) == regions[i] ? 0.0 : 1.0;
    }
    std::cout << sums.size() << " regions: " << 100.0 * wrong / inner << " % of " << inner
              << " points are nearer to another middle\n";
    EXPECT_GT(inner, 10000.0);
    EXPECT_LT(wrong / inner, 0.03); // middles are known to some hundredths of a hexagon
  }
}

TEST(DomainPartition, NamesGiveStrategies)
{
  for (const std::string& name : vtkMTPartitionStrategy::GetNames())
  {
    const auto strategy = vtkMTPartitionStrategy::MakeByName(name);
    ASSERT_TRUE(strategy) << name;
    EXPECT_EQ(name.rfind(strategy->GetStrategyName(), 0), 0u);
    std::cout << name << ": " << strategy->GetSettings() << ", reduction " << strategy->GetReduction() << "\n";
  }
  for (const std::string name : { "quads", "quad-", "hexagon-cube", "", "hex" })
  {
    EXPECT_FALSE(vtkMTPartitionStrategy::MakeByName(name)) << name;
  }
}
