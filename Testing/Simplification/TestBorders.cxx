// SPDX-License-Identifier: BSD-3-Clause
// Open borders that nothing outside shares are simplified and keep their shape; shared ones stay as they are.
#include "SimplificationTesting.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace SimplificationTesting;

namespace
{
double GetLength(const vtkMTPatch& mesh, const std::vector<Edge>& edges)
{
  double sum = 0.0;
  for (const Edge& e : edges)
  {
    double squares = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      const double d = static_cast<double>(mesh.Points[e.first][i]) - mesh.Points[e.second][i];
      squares += d * d;
    }
    sum += std::sqrt(squares);
  }
  return sum;
}

// Every point of the border starts one border edge and ends one.
bool IsBorderOfLoops(const std::vector<Edge>& border)
{
  std::map<std::uint32_t, int> balance;
  for (const Edge& e : border)
  {
    ++balance[e.first];
    balance[e.second] += 1000;
  }
  return std::all_of(balance.begin(), balance.end(), [](const auto& b) { return b.second == 1001; });
}
}

TEST(Borders, AFlatSquareBecomesTwoTrianglesWithTheSameOutline)
{
  const vtkMTPatch floor = MakeGrid(24, 24, 0.0);
  for (const int mode : { vtkMTEdgeCollapse::FAST, vtkMTEdgeCollapse::BEST })
  {
    for (const std::size_t target : { std::size_t(200), std::size_t(20), std::size_t(2) })
    {
      const Outcome outcome = Simplify(floor, LockNothing(floor), target, mode);
      const vtkMTPatch mesh = ToPatch(outcome.Result);
      EXPECT_EQ(FindFault(floor, LockNothing(floor), outcome.Result), "");
      EXPECT_LE(mesh.Triangles.size(), target) << "mode " << mode;
      EXPECT_EQ(mesh.GetBox(), floor.GetBox());
      EXPECT_NEAR(GetLength(mesh, FindBorder(mesh)), GetLength(floor, FindBorder(floor)), 1e-9 * (1 << 22));
    }
  }
}

TEST(Borders, AnOpenTerrainKeepsItsOutlineNearly)
{
  const vtkMTPatch floor = MakeGrid(60, 60, 0.1);
  const double length = GetLength(floor, FindBorder(floor));
  for (const int mode : AllModes)
  {
    const Outcome outcome = Simplify(floor, LockNothing(floor), floor.Triangles.size() / 8, mode);
    const vtkMTPatch mesh = ToPatch(outcome.Result);
    const std::vector<Edge> border = FindBorder(mesh);
    const Distance distance = Measure(floor, mesh);
    std::printf("mode %d: outline of %zu edges for %zu, %.4f of its length; RMS %.5f, max %.5f of the side\n", mode,
      border.size(), FindBorder(floor).size(), GetLength(mesh, border) / length, distance.Rms / (1 << 20),
      distance.Max / (1 << 20));
    EXPECT_LE(outcome.Result.Triangles.size(), floor.Triangles.size() / 8);
    EXPECT_TRUE(IsBorderOfLoops(border));
    EXPECT_LT(border.size(), FindBorder(floor).size() / 2);
    EXPECT_NEAR(GetLength(mesh, border) / length, 1.0, 0.01);
    EXPECT_LT(distance.Max, 0.02 * (1 << 20));
  }
}

TEST(Borders, CollapsesAloneCloseNoHole)
{
  vtkMTPatch floor = MakeGrid(30, 30, 0.05);
  std::vector<vtkMTTriangle> kept;
  for (std::size_t t = 0; t < floor.Triangles.size(); ++t)
  {
    const std::size_t column = t / 2 % 29;
    const std::size_t row = t / 2 / 29;
    if (column % 7 < 5 || row % 7 < 5)
    {
      kept.push_back(floor.Triangles[t]);
    }
  }
  floor.Triangles.swap(kept);
  const auto countLoops = [](const vtkMTPatch& mesh)
  {
    vtkMTPatch lines;
    lines.Points = mesh.Points;
    for (const Edge& e : FindBorder(mesh))
    {
      lines.Triangles.push_back({ e.first, e.second, e.second });
    }
    return CountComponents(lines);
  };
  for (const int mode : AllModes)
  {
    vtkNew<vtkMTEdgeCollapse> simplifier;
    simplifier->SetMode(mode);
    simplifier->SetComponentBound(0.0);
    vtkMTSimplification result;
    std::string error;
    ASSERT_TRUE(simplifier->Simplify(floor, LockNothing(floor), 0, result, error)) << error;
    EXPECT_EQ(FindFault(floor, LockNothing(floor), result), "");
    EXPECT_EQ(countLoops(ToPatch(result)), countLoops(floor)) << "mode " << mode;
  }
}

TEST(Borders, LockedBordersStayBitForBitWithTheirDirection)
{
  const vtkMTPatch floor = MakeFractalCap(5, 2000, 2);
  const Locks locked = LockBorder(floor);
  for (const int mode : AllModes)
  {
    const Outcome outcome = Simplify(floor, locked, 600, mode);
    const vtkMTPatch mesh = ToPatch(outcome.Result);
    std::vector<Edge> after;
    for (const Edge& e : FindBorder(mesh))
    {
      const std::uint32_t a = outcome.Result.PointOrigin[e.first];
      const std::uint32_t b = outcome.Result.PointOrigin[e.second];
      EXPECT_EQ(mesh.Points[e.first], floor.Points[a]);
      after.push_back({ a, b });
    }
    std::sort(after.begin(), after.end());
    EXPECT_EQ(after, FindBorder(floor)) << "mode " << mode;
  }
}

TEST(Borders, AnEarBetweenLockedPointsStays)
{
  // Without it the edge that its neighbour shares with it would become a border between locked points.
  vtkMTPatch floor = MakeGrid(3, 2, 0.0);
  floor.Points.push_back({ 1 << 19, -(1 << 18), 0 });
  floor.Triangles.push_back({ 0, 6, 1 });
  Locks locked = LockNothing(floor);
  locked[0] = locked[1] = 1;
  for (const int mode : AllModes)
  {
    const Outcome outcome = Simplify(floor, locked, 0, mode);
    EXPECT_EQ(FindFault(floor, locked, outcome.Result), "");
    EXPECT_GE(outcome.Result.Triangles.size(), 2u);
  }
}
