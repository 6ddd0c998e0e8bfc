// SPDX-License-Identifier: BSD-3-Clause
// Seams: points with several wedges keep them apart, and collapses run along the seam.
#include "SimplificationTesting.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <set>

using namespace SimplificationTesting;

namespace
{
// A cylinder around z, closed in u: the points of column 0 have wedges for u = 0 and for u = 1. U is per wedge.
vtkMTPatch MakeCylinder(int columns, int rows, std::vector<double>& u)
{
  vtkMTPatch floor;
  u.clear();
  const auto n = static_cast<std::uint32_t>(columns);
  for (int j = 0; j < rows; ++j)
  {
    for (int i = 0; i < columns; ++i)
    {
      const double angle = 2.0 * vtkMath::Pi() * i / columns;
      floor.Points.push_back({ static_cast<std::int32_t>(std::lround(1e6 * std::cos(angle))),
        static_cast<std::int32_t>(std::lround(1e6 * std::sin(angle))), 4000000 / rows * j });
      floor.WedgePoints.push_back(static_cast<std::uint32_t>(floor.Points.size()) - 1);
      u.push_back(static_cast<double>(i) / columns);
    }
  }
  const auto right = static_cast<std::uint32_t>(u.size());
  for (int j = 0; j < rows; ++j)
  {
    floor.WedgePoints.push_back(static_cast<std::uint32_t>(j) * n);
    u.push_back(1.0);
  }
  for (std::uint32_t j = 0; j + 1 < static_cast<std::uint32_t>(rows); ++j)
  {
    for (std::uint32_t i = 0; i < n; ++i)
    {
      const std::uint32_t a = j * n + i;
      const std::uint32_t b = i + 1 < n ? a + 1 : right + j;
      const std::uint32_t c = i + 1 < n ? a + n + 1 : right + j + 1;
      floor.Triangles.push_back({ a, b, c });
      floor.Triangles.push_back({ a, c, a + n });
    }
  }
  return floor;
}

// Edges whose two triangles have different wedges at an end.
std::vector<Edge> FindSeamEdges(const vtkMTSimplification& r)
{
  std::map<Edge, Edge> wedges;
  for (const vtkMTTriangle& t : r.Triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      const std::uint32_t a = t[i];
      const std::uint32_t b = t[(i + 1) % 3];
      wedges[{ r.WedgePoints[a], r.WedgePoints[b] }] = { a, b };
    }
  }
  std::vector<Edge> seams;
  for (const auto& e : wedges)
  {
    const auto back = wedges.find({ e.first.second, e.first.first });
    if (e.first.first < e.first.second && back != wedges.end() &&
      (back->second.second != e.second.first || back->second.first != e.second.second))
    {
      seams.push_back(e.first);
    }
  }
  return seams;
}

double GetLargestSpan(const vtkMTSimplification& r, const std::vector<double>& u)
{
  double span = 0.0;
  for (const vtkMTTriangle& t : r.Triangles)
  {
    const auto range = std::minmax({ u[r.WedgeOrigin[t[0]]], u[r.WedgeOrigin[t[1]]], u[r.WedgeOrigin[t[2]]] });
    span = std::max(span, range.second - range.first);
  }
  return span;
}

// A box of n x n squares a side; every side has wedges of its own. SideOfWedge is filled.
vtkMTPatch MakeBox(int n, std::vector<int>& sideOfWedge)
{
  vtkMTPatch floor;
  std::map<vtkMTPoint, std::uint32_t> points;
  sideOfWedge.clear();
  for (int side = 0; side < 6; ++side)
  {
    const int axis = side / 2;
    const auto first = static_cast<std::uint32_t>(floor.WedgePoints.size());
    for (int j = 0; j <= n; ++j)
    {
      for (int i = 0; i <= n; ++i)
      {
        vtkMTPoint p;
        p[axis] = side % 2 ? 1000 * n : 0;
        p[(axis + 1) % 3] = 1000 * i;
        p[(axis + 2) % 3] = 1000 * j;
        const auto inserted = points.insert({ p, static_cast<std::uint32_t>(floor.Points.size()) });
        if (inserted.second)
        {
          floor.Points.push_back(p);
        }
        floor.WedgePoints.push_back(inserted.first->second);
        sideOfWedge.push_back(side);
      }
    }
    for (const Corners& t : MTTestMeshes::GridTriangles(n + 1, n + 1, first))
    {
      const auto a = static_cast<std::uint32_t>(t[0]);
      const auto b = static_cast<std::uint32_t>(t[1]);
      const auto c = static_cast<std::uint32_t>(t[2]);
      floor.Triangles.push_back(side % 2 ? vtkMTTriangle{ a, b, c } : vtkMTTriangle{ b, a, c });
    }
  }
  return floor;
}
}

TEST(Seams, ATextureAroundACylinderStaysContinuousInEveryTriangle)
{
  std::vector<double> u;
  const vtkMTPatch floor = MakeCylinder(48, 40, u);
  for (const int mode : AllModes)
  {
    for (const bool lock : { false, true })
    {
      const Locks locked = lock ? LockBorder(floor) : LockNothing(floor);
      for (const std::size_t divisor : { 2, 6, 12 })
      {
        const std::size_t target = floor.Triangles.size() / divisor;
        const Outcome run = Simplify(floor, locked, target, mode);
        ASSERT_EQ(FindFault(floor, locked, run.Result), "");
        EXPECT_LE(run.Result.Triangles.size(), target) << "mode " << mode << " lock " << lock;
        EXPECT_LT(GetLargestSpan(run.Result, u), 0.5) << "mode " << mode << " divisor " << divisor;
        // The seam is one path from end to end on its old line.
        std::map<std::uint32_t, int> degrees;
        for (const Edge& e : FindSeamEdges(run.Result))
        {
          ++degrees[e.first];
          ++degrees[e.second];
        }
        int ends = 0;
        for (const auto& d : degrees)
        {
          ends += d.second == 1 ? 1 : 0;
          EXPECT_LE(d.second, 2);
          EXPECT_EQ(run.Result.PointOrigin[d.first] % 48, 0u);
          EXPECT_FALSE(run.Result.Moved[d.first]);
        }
        EXPECT_EQ(ends, 2);
        EXPECT_TRUE(degrees.size() < 40 || divisor == 2 || mode == vtkMTEdgeCollapse::GARLAND_HECKBERT)
          << "nothing has collapsed along the seam: mode " << mode << " lock " << lock << " divisor " << divisor;
      }
    }
  }
}

TEST(Seams, ABoxWithHardEdgesBecomesTwelveTrianglesWithItsOwnNormals)
{
  std::vector<int> sides;
  const vtkMTPatch floor = MakeBox(8, sides);
  ASSERT_TRUE(IsClosedManifold(floor));
  const Locks locked = LockNothing(floor);
  for (const int mode : AllModes)
  {
    for (const std::size_t target : { floor.Triangles.size() / 2, std::size_t(60), std::size_t(12) })
    {
      const Outcome run = Simplify(floor, locked, target, mode);
      EXPECT_EQ(FindFault(floor, locked, run.Result), "");
      EXPECT_TRUE(IsClosedManifold(ToPatch(run.Result)));
      for (const vtkMTTriangle& t : run.Result.Triangles)
      {
        const int side = sides[run.Result.WedgeOrigin[t[0]]];
        EXPECT_EQ(sides[run.Result.WedgeOrigin[t[1]]], side);
        EXPECT_EQ(sides[run.Result.WedgeOrigin[t[2]]], side);
        for (const std::uint32_t w : t) // still in the plane of its side
        {
          EXPECT_EQ(run.Result.Points[run.Result.WedgePoints[w]][side / 2], side % 2 ? 8000 : 0);
        }
      }
      EXPECT_LE(run.Result.Triangles.size(), mode == vtkMTEdgeCollapse::LINDSTROM_TURK ? target + 60 : target);
    }
  }
}

TEST(Seams, WithoutSeamsWedgesChangeNothing)
{
  const vtkMTPatch plain = MakeGrid(20, 20);
  vtkMTPatch wedged = plain;
  for (std::uint32_t p = 0; p < plain.Points.size(); ++p)
  {
    wedged.WedgePoints.push_back(p);
  }
  const Outcome a = Simplify(plain, LockBorder(plain), 200);
  const Outcome b = Simplify(wedged, LockBorder(plain), 200);
  EXPECT_EQ(a.Result.Points, b.Result.Points);
  EXPECT_EQ(a.Result.Triangles, b.Result.Triangles);
  EXPECT_EQ(a.Result.WedgeOrigin, b.Result.WedgeOrigin);
}

TEST(Seams, JunctionsAndEndsOfSeamsKeepTheirPlace)
{
  // A cross of seams in a grid, one arm of which ends inside: wedges by quadrant, and by left and right only above
  // row 15.
  vtkMTPatch floor = MakeGrid(21, 21, 0.0);
  const auto points = static_cast<std::uint32_t>(floor.Points.size());
  for (std::uint32_t w = 0; w < 3 * points; ++w)
  {
    floor.WedgePoints.push_back(w % points);
  }
  for (std::size_t t = 0; t < floor.Triangles.size(); ++t)
  {
    const std::size_t column = t / 2 % 20;
    const std::size_t row = t / 2 / 20;
    const std::uint32_t side = row < 10 ? 0 : (column < 10 ? 1 : 2);
    for (std::uint32_t& p : floor.Triangles[t])
    {
      const bool above = p / 21 > 15 || (p / 21 == 15 && p % 21 == 10); // the seam between 1 and 2 ends here
      p += points * (side == 2 && above ? 1 : side);
    }
  }
  const Locks locked = LockBorder(floor);
  for (const int mode : AllModes)
  {
    const Outcome run = Simplify(floor, locked, 0, mode);
    EXPECT_EQ(FindFault(floor, locked, run.Result), "");
    const std::set<std::uint32_t> origins(run.Result.PointOrigin.begin(), run.Result.PointOrigin.end());
    EXPECT_EQ(origins.count(10 * 21 + 10), 1u);
    EXPECT_EQ(origins.count(15 * 21 + 10), 1u);
    EXPECT_GT(run.Result.Blocked.at("seam"), 0);
  }
}

TEST(Seams, WhereEveryCornerHasItsOwnWedgeNothingCanCollapse)
{
  vtkMTPatch floor = MakeGrid(8, 8);
  const vtkMTPatch grid = floor;
  floor.WedgePoints.clear();
  for (vtkMTTriangle& t : floor.Triangles)
  {
    for (std::uint32_t& p : t)
    {
      floor.WedgePoints.push_back(p);
      p = static_cast<std::uint32_t>(floor.WedgePoints.size()) - 1;
    }
  }
  const Outcome run = Simplify(floor, LockNothing(floor), 10);
  EXPECT_EQ(FindFault(floor, LockNothing(floor), run.Result), "");
  EXPECT_GT(run.Result.Triangles.size(), grid.Triangles.size() / 2);
  EXPECT_GT(run.Result.Blocked.at("seam"), 0);
}
