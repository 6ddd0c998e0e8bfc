// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTDeviation.h"
#include "vtkMTSurface.h"
#include "vtkMTTriangleTree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

namespace
{
using Vector = std::array<double, 3>;

// A grid over [0, size]^2 with n x n cells and heights from a function; diagonals alternate when asked.
template <class Height>
vtkMTPatch MakeGrid(int n, int size, const Height& height, bool otherDiagonal = false)
{
  vtkMTPatch mesh;
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      const int x = size / n * i;
      const int y = size / n * j;
      mesh.Points.push_back({ x, y, static_cast<std::int32_t>(std::lround(height(x, y))) });
    }
  }
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      const auto a = static_cast<std::uint32_t>(j * (n + 1) + i);
      const std::uint32_t b = a + 1;
      const std::uint32_t c = a + static_cast<std::uint32_t>(n) + 1;
      const std::uint32_t d = c + 1;
      if (otherDiagonal)
      {
        mesh.Triangles.push_back({ a, b, c });
        mesh.Triangles.push_back({ b, d, c });
      }
      else
      {
        mesh.Triangles.push_back({ a, b, d });
        mesh.Triangles.push_back({ a, d, c });
      }
    }
  }
  return mesh;
}

vtkMTDeviation GetDeviation(const vtkMTPatch& a, const vtkMTPatch& b)
{
  const vtkMTPoint origin{ 0, 0, 0 };
  vtkMTDeviation::Findings findings;
  return vtkMTDeviation::Between(vtkMTSurface(a, origin), vtkMTSurface(b, origin), {}, findings);
}

// Distance from a point to a triangle by a method of its own: minimise over a fine barycentric grid, then over finer
// ones around the best place.
double SlowDistance(const Vector& x, const std::array<Vector, 3>& t)
{
  double bestU = 1.0 / 3;
  double bestV = 1.0 / 3;
  double best = 1e300;
  double width = 1.0;
  for (int round = 0; round < 40; ++round, width *= 0.6)
  {
    const double u0 = bestU;
    const double v0 = bestV;
    for (int i = -4; i <= 4; ++i)
    {
      for (int j = -4; j <= 4; ++j)
      {
        const double u = std::clamp(u0 + width * i / 4.0, 0.0, 1.0);
        const double v = std::clamp(v0 + width * j / 4.0, 0.0, 1.0 - u);
        double d = 0.0;
        for (int k = 0; k < 3; ++k)
        {
          const double p = t[0][k] * (1 - u - v) + t[1][k] * u + t[2][k] * v - x[k];
          d += p * p;
        }
        if (d < best)
        {
          best = d;
          bestU = u;
          bestV = v;
        }
      }
    }
  }
  return std::sqrt(best);
}

// Largest distance of random points of a from b.
double SampleDistance(const vtkMTPatch& a, const vtkMTPatch& b, int samplesPerTriangle, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const vtkMTSurface surface(a, { 0, 0, 0 });
  const vtkMTSurface other(b, { 0, 0, 0 });
  vtkMTTriangleTree tree(other);
  double largest = 0.0;
  for (std::uint32_t t = 0; t < a.Triangles.size(); ++t)
  {
    for (int s = 0; s < samplesPerTriangle; ++s)
    {
      double u = unit(random);
      double v = unit(random);
      if (u + v > 1.0)
      {
        u = 1.0 - u;
        v = 1.0 - v;
      }
      Vector x;
      for (int k = 0; k < 3; ++k)
      {
        x[k] =
          surface.GetCorner(t, 0)[k] * (1 - u - v) + surface.GetCorner(t, 1)[k] * u + surface.GetCorner(t, 2)[k] * v;
      }
      largest = std::max(largest, std::sqrt(tree.FindNearest(x).Distance2));
    }
  }
  return largest;
}

double Hills(double x, double y)
{
  return 3000.0 * std::sin(x * 2e-4) * std::cos(y * 1.7e-4) + 500.0 * std::sin(x * 9e-4 + y * 7e-4);
}
}

TEST(Surface, ProjectionAgreesWithSlowSearch)
{
  std::mt19937 random(7);
  std::uniform_int_distribution<int> coordinate(-1000, 1000);
  double worst = 0.0;
  for (int i = 0; i < 300; ++i)
  {
    vtkMTPatch mesh;
    for (int p = 0; p < 3; ++p)
    {
      mesh.Points.push_back({ coordinate(random), coordinate(random), coordinate(random) });
    }
    if (i % 10 == 0)
    {
      mesh.Points[2] = mesh.Points[i % 20 == 0 ? 0 : 1]; // degenerate ones too
    }
    mesh.Triangles.push_back({ 0, 1, 2 });
    const vtkMTSurface surface(mesh, { 0, 0, 0 });
    const Vector x{ coordinate(random) * 1.5, coordinate(random) * 1.5, coordinate(random) * 1.5 };
    const double slow = SlowDistance(x, { surface.GetCorner(0, 0), surface.GetCorner(0, 1), surface.GetCorner(0, 2) });
    const vtkMTSurface::Hit hit = surface.Project(x, 0);
    EXPECT_NEAR(std::sqrt(hit.Distance2), slow, 1e-3 * (1.0 + slow));
    worst = std::max(worst, std::abs(std::sqrt(hit.Distance2) - slow));
    EXPECT_NEAR(hit.Weights[0] + hit.Weights[1] + hit.Weights[2], 1.0, 1e-12);
  }
  std::printf("worst difference to the slow search: %g of 1000\n", worst);
}

TEST(TriangleTree, NearestIsTheLeastOverAllTriangles)
{
  const vtkMTPatch mesh = MakeGrid(12, 12000, Hills);
  const vtkMTSurface surface(mesh, { 0, 0, 0 });
  vtkMTTriangleTree tree(surface);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> coordinate(-3000.0, 15000.0);
  for (int i = 0; i < vtkMTTriangleTree::QueriesWithoutTree + 500; ++i)
  {
    const Vector x{ coordinate(random), coordinate(random), coordinate(random) };
    double nearest = 1e300;
    for (std::uint32_t t = 0; t < mesh.Triangles.size(); ++t)
    {
      nearest = std::min(nearest, surface.Project(x, t).Distance2);
    }
    EXPECT_EQ(tree.FindNearest(x).Distance2, nearest);
  }
}

namespace
{
// Triangles of all sizes and directions around the origin, each with points of its own.
vtkMTPatch MakeHeap(std::uint32_t triangles, unsigned seed)
{
  std::mt19937 random(seed);
  std::normal_distribution<double> coordinate(0.0, 10000.0);
  const auto round = [](double x) { return static_cast<std::int32_t>(std::lround(x)); };
  vtkMTPatch mesh;
  for (std::uint32_t i = 0; i < triangles; ++i)
  {
    const vtkMTPoint a{ round(coordinate(random)), round(coordinate(random)), round(coordinate(random)) };
    const vtkMTPoint b{ round(coordinate(random)), round(coordinate(random)), round(coordinate(random)) };
    mesh.Points.insert(mesh.Points.end(), { a, b, { -a[0] - b[0], -a[1] - b[1], -a[2] - b[2] } });
    mesh.Triangles.push_back({ 3 * i, 3 * i + 1, 3 * i + 2 });
  }
  return mesh;
}
}

TEST(TriangleTree, WorkIsInProportionEvenWhereNoTreeHelps)
{
  const vtkMTPatch mesh = MakeHeap(3000, 5);
  const vtkMTSurface surface(mesh, { 0, 0, 0 });
  vtkMTTriangleTree tree(surface, vtkMTTriangleTree::GetEnoughEffort(surface));
  std::mt19937 random(3);
  std::normal_distribution<double> coordinate(0.0, 10000.0);
  std::uint64_t before = 0;
  for (int i = 0; i < 6000; ++i)
  {
    const bool wasExhausted = tree.IsExhausted();
    before = tree.GetEffort();
    const vtkMTTriangleTree::Hit hit = tree.FindNearest({ coordinate(random), coordinate(random), coordinate(random) });
    ASSERT_LT(hit.Triangle, mesh.Triangles.size());
    ASSERT_TRUE(std::isfinite(hit.Distance2));
    ASSERT_LE(tree.GetEffort() - before, wasExhausted ? 100u : 6000u);
  }
  std::printf("looked at %.0f nodes and triangles per triangle in 6000 queries\n",
    static_cast<double>(tree.GetEffort()) / 3000.0);
  EXPECT_TRUE(tree.IsExhausted());
}

// Around one point, all triangles are nearest to it: looking among them takes the square of their number.
TEST(Deviation, FansTakePiecesInProportionAndAreBoundTightly)
{
  const auto makeFan = [](std::uint32_t count)
  {
    vtkMTPatch mesh;
    mesh.Points.push_back({ 0, 0, 100000 });
    for (std::uint32_t i = 0; i < count; ++i)
    {
      const double angle = 2.0 * 3.14159265358979 * i / count;
      mesh.Points.push_back({ static_cast<std::int32_t>(std::lround(1e6 * std::cos(angle))),
        static_cast<std::int32_t>(std::lround(1e6 * std::sin(angle))), 0 });
      mesh.Triangles.push_back({ 0, 1 + i, 1 + (i + 1) % count });
    }
    return mesh;
  };
  double perTriangle[2];
  for (const std::uint32_t count : { 1000u, 4000u })
  {
    const vtkMTDeviation result = GetDeviation(makeFan(count), makeFan(count / 2));
    perTriangle[count / 4000] = static_cast<double>(result.Pieces) / count;
    std::printf("%u triangles: %.2f pieces for each, bound %.3f, at least %.3f\n", count, perTriangle[count / 4000],
      result.UpperBound, result.LowerBound);
    EXPECT_FALSE(result.BudgetUsedUp);
    EXPECT_LE(result.UpperBound, 2.0 * result.LowerBound + 1.0);
  }
  EXPECT_LE(perTriangle[1], 2.0 * perTriangle[0] + 1.0);
}

TEST(Deviation, BoundHoldsForHeapsOfTriangles)
{
  const vtkMTPatch one = MakeHeap(1200, 7);
  const vtkMTPatch other = MakeHeap(600, 8);
  const vtkMTDeviation deviation = GetDeviation(one, other);
  const double sampled = std::max(SampleDistance(one, other, 3, 1), SampleDistance(other, one, 3, 2));
  std::printf("bound %g, sampled %g, %zu pieces\n", deviation.UpperBound, sampled, deviation.Pieces);
  EXPECT_GE(deviation.UpperBound, sampled);
}

TEST(Deviation, EqualMeshesHaveDistanceZeroExactly)
{
  const vtkMTPatch mesh = MakeGrid(16, 16000, Hills);
  EXPECT_EQ(GetDeviation(mesh, mesh).UpperBound, 0.0);
}

TEST(Deviation, CoplanarOverlapIsZeroExactly)
{
  // The same tilted plane, triangulated in three ways with no common diagonals or, for the last one, no common inner
  // points.
  const auto plane = [](double x, double y) { return 3.0 * x - 2.0 * y; };
  const vtkMTPatch fine = MakeGrid(24, 24000, plane);
  const vtkMTPatch other = MakeGrid(24, 24000, plane, true);
  const vtkMTPatch coarse = MakeGrid(5, 24000, plane, true);
  EXPECT_EQ(GetDeviation(fine, other).UpperBound, 0.0);
  EXPECT_EQ(GetDeviation(fine, coarse).UpperBound, 0.0);
  std::printf("pieces: %zu for %zu triangles\n", GetDeviation(fine, coarse).Pieces, fine.Triangles.size());
}

TEST(Deviation, BoundHoldsAndIsTight)
{
  for (int coarseCells : { 4, 6, 11, 16 })
  {
    const vtkMTPatch fine = MakeGrid(24, 24000, Hills);
    const vtkMTPatch coarse = MakeGrid(coarseCells, 24000, Hills, true);
    const vtkMTDeviation deviation = GetDeviation(fine, coarse);
    const double sampled = std::max(SampleDistance(fine, coarse, 20, 1), SampleDistance(coarse, fine, 200, 2));
    std::printf("%d cells: certified %.3f, lower bound %.3f, sampled %.3f, ratio %.3f, %zu pieces%s\n", coarseCells,
      deviation.UpperBound, deviation.LowerBound, sampled, deviation.UpperBound / sampled, deviation.Pieces,
      deviation.BudgetUsedUp ? ", budget used up" : "");
    EXPECT_GE(deviation.UpperBound, sampled);
    EXPECT_LE(deviation.LowerBound, deviation.UpperBound);
    EXPECT_LE(deviation.UpperBound, 1.25 * sampled);
    EXPECT_FALSE(deviation.BudgetUsedUp);
  }
}

TEST(Deviation, BoundHoldsForRandomSoups)
{
  std::mt19937 random(11);
  std::uniform_int_distribution<int> coordinate(0, 10000);
  for (int round = 0; round < 20; ++round)
  {
    std::array<vtkMTPatch, 2> soups;
    for (vtkMTPatch& soup : soups)
    {
      for (std::uint32_t i = 0; i < 20; ++i)
      {
        for (int c = 0; c < 3; ++c)
        {
          soup.Points.push_back({ coordinate(random), coordinate(random), coordinate(random) });
        }
        soup.Triangles.push_back({ 3 * i, 3 * i + 1, 3 * i + 2 });
      }
    }
    const double sampled =
      std::max(SampleDistance(soups[0], soups[1], 300, 1), SampleDistance(soups[1], soups[0], 300, 2));
    const vtkMTDeviation deviation = GetDeviation(soups[0], soups[1]);
    EXPECT_GE(deviation.UpperBound, sampled);
    EXPECT_LE(deviation.UpperBound, 1.3 * sampled);
  }
}

TEST(Deviation, MissingPartIsSeen)
{
  // A component that the other mesh does not have, far away.
  vtkMTPatch mesh = MakeGrid(4, 4000, [](double, double) { return 0.0; });
  const vtkMTPatch without = mesh;
  const auto first = static_cast<std::uint32_t>(mesh.Points.size());
  mesh.Points.insert(mesh.Points.end(), { { 2000, 2000, 500 }, { 2010, 2000, 500 }, { 2000, 2010, 500 } });
  mesh.Triangles.push_back({ first, first + 1, first + 2 });
  const double bound = GetDeviation(mesh, without).UpperBound;
  EXPECT_GE(bound, 500.0);
  EXPECT_LE(bound, 500.0 * vtkMTDeviation::Looseness);
}

TEST(Deviation, LongTrianglesAcrossThousandsAreBoundTightly)
{
  // A ribbon of narrow triangles, wavy but for its last tenth, and a flat one of two triangles.
  constexpr std::uint32_t Columns = 1500;
  vtkMTPatch ribbon;
  for (std::uint32_t i = 0; i <= Columns; ++i)
  {
    const auto z = static_cast<std::int32_t>(i < Columns * 9 / 10 ? std::lround(40.0 * std::sin(0.7 * i)) : 0);
    const auto x = static_cast<std::int32_t>(100 * i);
    ribbon.Points.push_back({ x, 0, z });
    ribbon.Points.push_back({ x, 3000, -z });
  }
  for (std::uint32_t i = 0; i < Columns; ++i)
  {
    ribbon.Triangles.push_back({ 2 * i, 2 * i + 2, 2 * i + 1 });
    ribbon.Triangles.push_back({ 2 * i + 1, 2 * i + 2, 2 * i + 3 });
  }
  vtkMTPatch flat;
  const auto end = static_cast<std::int32_t>(100 * Columns);
  flat.Points = { { 0, 0, 0 }, { end, 0, 0 }, { end, 3000, 0 }, { 0, 3000, 0 } };
  flat.Triangles = { { 0, 1, 2 }, { 0, 2, 3 } };
  const vtkMTDeviation deviation = GetDeviation(ribbon, flat);
  std::printf(
    "%zu pieces, bound %.2f, lower bound %.2f\n", deviation.Pieces, deviation.UpperBound, deviation.LowerBound);
  EXPECT_FALSE(deviation.BudgetUsedUp);
  EXPECT_LE(deviation.UpperBound, 1.2 * deviation.LowerBound);
  EXPECT_GE(deviation.LowerBound, 39.0);
}

// Halves of long and thin triangles get nowhere: what is near enough to one triangle is split off at once.
TEST(Deviation, StretchedMeshesAreBoundTightly)
{
  std::size_t piecesOfFirst = 0;
  for (const std::int32_t factor : { 1, 100, 10000, 50000 })
  {
    vtkMTPatch fine = MakeGrid(24, 24000, Hills);
    vtkMTPatch coarse = MakeGrid(6, 24000, Hills, true);
    for (vtkMTPatch* mesh : { &fine, &coarse })
    {
      for (vtkMTPoint& point : mesh->Points)
      {
        point[0] *= factor;
      }
    }
    const vtkMTDeviation deviation = GetDeviation(fine, coarse);
    std::printf("%5d times as long: bound %.1f, lower bound %.1f, %zu pieces%s\n", factor, deviation.UpperBound,
      deviation.LowerBound, deviation.Pieces, deviation.BudgetUsedUp ? ", budget used up" : "");
    piecesOfFirst = factor == 1 ? deviation.Pieces : piecesOfFirst;
    EXPECT_LE(deviation.UpperBound, 1.5 * deviation.LowerBound);
    EXPECT_LE(deviation.Pieces, 2 * piecesOfFirst);
    EXPECT_FALSE(deviation.BudgetUsedUp);
  }
}

// A comb whose teeth are thin, and one with fewer, longer ones.
TEST(Deviation, CombsAreBoundTightly)
{
  const auto makeComb = [](int teeth, int wide, int length)
  {
    vtkMTPatch mesh;
    for (int i = 0; i < teeth; ++i)
    {
      const auto first = static_cast<std::uint32_t>(mesh.Points.size());
      mesh.Points.insert(mesh.Points.end(),
        { { wide * i, 0, 0 }, { wide * (i + 1), 0, 0 }, { wide * i + wide / 2, length + 7 * (i % 13), (i % 5) * 3 } });
      mesh.Triangles.push_back({ first, first + 1, first + 2 });
    }
    return mesh;
  };
  for (const int length : { 2000, 200000, 20000000 })
  {
    const vtkMTPatch fine = makeComb(1000, 20, length);
    const vtkMTPatch coarse = makeComb(500, 40, length);
    const vtkMTDeviation deviation = GetDeviation(fine, coarse);
    std::printf("teeth of %d: bound %.2f, lower bound %.2f, %zu pieces%s\n", length, deviation.UpperBound,
      deviation.LowerBound, deviation.Pieces, deviation.BudgetUsedUp ? ", budget used up" : "");
    EXPECT_LE(deviation.UpperBound, 1.5 * deviation.LowerBound);
    EXPECT_FALSE(deviation.BudgetUsedUp);
  }
}
