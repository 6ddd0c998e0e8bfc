// SPDX-License-Identifier: BSD-3-Clause
// Random floors of every kind of disorder: whatever comes in, the fragment is valid and pastes in where the floor was.
#include "SimplificationTesting.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

using namespace SimplificationTesting;
using MTTestMeshes::Random;

namespace
{
vtkMTPoint RandomPoint(Random& random, std::int32_t size)
{
  const auto coordinate = [&] { return static_cast<std::int32_t>(random.Below(static_cast<std::uint64_t>(size))); };
  const std::int32_t x = coordinate();
  const std::int32_t y = coordinate();
  return { x, y, coordinate() };
}

// Triangles on random points: most edges have another number of triangles than two.
vtkMTPatch MakeRandomTriangles(Random& random)
{
  vtkMTPatch floor;
  const std::uint64_t points = 3 + random.Below(40);
  const std::uint64_t triangles = 1 + random.Below(120);
  for (std::uint64_t i = 0; i < points; ++i)
  {
    floor.Points.push_back(RandomPoint(random, 1 << 16));
  }
  for (std::uint64_t t = 0; t < triangles; ++t)
  {
    const auto p = [&] { return static_cast<std::uint32_t>(random.Below(points)); };
    const std::uint32_t a = p();
    const std::uint32_t b = p();
    floor.Triangles.push_back({ a, b, p() });
  }
  return floor;
}

vtkMTPatch MakeOrderly(Random& random)
{
  if (random.Below(3) == 0)
  {
    return MakeFloor(MTTestMeshes::FractalSphere(1 + static_cast<int>(random.Below(2)), random.Next()), 1 << 16);
  }
  return MakeGrid(3 + static_cast<int>(random.Below(10)), 3 + static_cast<int>(random.Below(10)),
    random.Below(2) ? 0.0 : 0.2, 1 << 16);
}

// An orderly mesh spoilt: repeated, turned and removed triangles, fins, and points glued together.
vtkMTPatch MakeSpoilt(Random& random)
{
  vtkMTPatch floor = MakeOrderly(random);
  const std::uint64_t spoils = random.Below(12);
  for (std::uint64_t i = 0; i < spoils; ++i)
  {
    const std::size_t t = random.Below(floor.Triangles.size());
    const vtkMTTriangle triangle = floor.Triangles[t];
    switch (random.Below(6))
    {
      case 0:
        floor.Triangles.push_back(triangle);
        break;
      case 1:
        floor.Triangles.push_back({ triangle[1], triangle[0], triangle[2] });
        break;
      case 2:
        std::swap(floor.Triangles[t][0], floor.Triangles[t][1]);
        break;
      case 3:
        floor.Triangles.erase(floor.Triangles.begin() + static_cast<std::ptrdiff_t>(t));
        break;
      case 4:
        floor.Points.push_back(RandomPoint(random, 1 << 16));
        floor.Triangles.push_back({ triangle[0], triangle[1], static_cast<std::uint32_t>(floor.Points.size()) - 1 });
        break;
      default:
      {
        const auto from = static_cast<std::uint32_t>(random.Below(floor.Points.size()));
        for (vtkMTTriangle& other : floor.Triangles)
        {
          for (std::uint32_t& p : other)
          {
            p = p == from ? triangle[0] : p;
          }
        }
      }
    }
    if (floor.Triangles.empty())
    {
      return MakeOrderly(random);
    }
  }
  return floor;
}

// Hardly more places than points: edges without length and triangles without area everywhere.
vtkMTPatch MakeCoincident(Random& random)
{
  vtkMTPatch floor = MakeOrderly(random);
  for (vtkMTPoint& p : floor.Points)
  {
    for (std::int32_t& k : p)
    {
      k >>= 14;
    }
  }
  return floor;
}

vtkMTPatch MakeSoup(Random& random)
{
  vtkMTPatch floor;
  const auto triangles = static_cast<std::uint32_t>(1 + random.Below(60));
  for (std::uint32_t t = 0; t < triangles; ++t)
  {
    for (int i = 0; i < 3; ++i)
    {
      floor.Points.push_back(RandomPoint(random, 1 << 16));
    }
    floor.Triangles.push_back({ 3 * t, 3 * t + 1, 3 * t + 2 });
  }
  return floor;
}

// Each point gets three wedges and each corner one of them: by a plane that crosses the mesh, or at random.
enum WedgeKind : std::uint64_t
{
  NoWedges,
  TwoSides,
  AnyWedges
};

void AddWedges(Random& random, std::uint64_t kind, vtkMTPatch& floor)
{
  if (kind == NoWedges)
  {
    return;
  }
  const auto points = static_cast<std::uint32_t>(floor.Points.size());
  for (std::uint32_t w = 0; w < 3 * points; ++w)
  {
    floor.WedgePoints.push_back(w % points);
  }
  const std::int32_t cut = RandomPoint(random, 1 << 16)[0];
  for (vtkMTTriangle& t : floor.Triangles)
  {
    std::int64_t x = 0;
    for (const std::uint32_t p : t)
    {
      x += floor.Points[p][0];
    }
    const std::uint32_t side = x < 3 * static_cast<std::int64_t>(cut) ? 0 : 1;
    for (std::uint32_t& p : t)
    {
      p += points * (kind == TwoSides ? side : (random.Below(8) ? side : static_cast<std::uint32_t>(random.Below(3))));
    }
  }
}

Locks MakeLocks(Random& random, const vtkMTPatch& floor)
{
  Locks locked = random.Below(3) ? LockBorder(floor) : LockNothing(floor);
  const std::uint64_t more = random.Below(4);
  for (std::uint64_t i = 0; i < more; ++i)
  {
    locked[random.Below(floor.Points.size())] = 1;
  }
  return locked;
}

vtkMTPatch MakeAny(Random& random)
{
  vtkMTPatch floor;
  switch (random.Below(8))
  {
    case 0:
    case 1:
      floor = MakeRandomTriangles(random);
      break;
    case 2:
      floor = MakeSoup(random);
      break;
    case 3:
      floor = MakeCoincident(random);
      break;
    case 4:
      floor = MakeOrderly(random);
      break;
    default:
      floor = MakeSpoilt(random);
  }
  return floor;
}

// Whether all corners of each triangle are of one side of the cut.
bool AreSidesKept(const vtkMTPatch& floor, const vtkMTSimplification& result)
{
  const auto side = [&](std::uint32_t w) { return result.WedgeOrigin[w] / floor.Points.size(); };
  return std::all_of(result.Triangles.begin(), result.Triangles.end(),
    [&](const vtkMTTriangle& t) { return side(t[0]) == side(t[1]) && side(t[1]) == side(t[2]); });
}

void Fuzz(int mode, int patches, std::uint64_t seed)
{
  std::size_t before = 0;
  std::size_t after = 0;
  std::size_t flat = 0;
  for (int i = 0; i < patches; ++i)
  {
    SCOPED_TRACE(
      "patch " + std::to_string(i) + " of seed " + std::to_string(seed) + " in mode " + std::to_string(mode));
    Random random(seed * 1000003 + static_cast<std::uint64_t>(i));
    vtkMTPatch floor = MakeAny(random);
    const std::uint64_t wedges = random.Below(3);
    AddWedges(random, wedges, floor);
    const Locks locked = MakeLocks(random, floor);
    const std::size_t target = random.Below(2) ? floor.Triangles.size() / 2 : random.Below(floor.Triangles.size() + 1);
    const Outcome run = Simplify(floor, locked, target, mode);
    ASSERT_TRUE(run.Ok) << run.Error;
    ASSERT_EQ(FindFault(floor, locked, run.Result), "");
    ASSERT_TRUE(wedges != TwoSides || AreSidesKept(floor, run.Result));
    ASSERT_EQ(run.Result.Triangles.empty(), CountEdges(floor).empty());
    ASSERT_TRUE(run.Result.Triangles.size() <= std::max<std::size_t>(target, 1) || !run.Result.Blocked.empty());
    ASSERT_EQ(run.Result.Blocked.count("steps"), 0u);
    before += floor.Triangles.size();
    after += run.Result.Triangles.size();
    flat += CountFlatTriangles(ToPatch(run.Result));
  }
  std::printf(
    "mode %d: %d patches, %zu triangles to %zu, %zu of them without area\n", mode, patches, before, after, flat);
}
}

TEST(Fuzz, FastMakesValidFragmentsOfAnyFloor)
{
  Fuzz(vtkMTEdgeCollapse::FAST, 4000, 1);
}

TEST(Fuzz, BestMakesValidFragmentsOfAnyFloor)
{
  Fuzz(vtkMTEdgeCollapse::BEST, 1500, 2);
}

TEST(Fuzz, LindstromTurkMakesValidFragmentsOfAnyFloor)
{
  Fuzz(vtkMTEdgeCollapse::LINDSTROM_TURK, 700, 3);
}

TEST(Fuzz, GarlandHeckbertMakesValidFragmentsOfAnyFloor)
{
  Fuzz(vtkMTEdgeCollapse::GARLAND_HECKBERT, 700, 4);
}
