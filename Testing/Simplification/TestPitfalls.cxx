// SPDX-License-Identifier: BSD-3-Clause
// One test for each thing that is known to go wrong when regions are simplified with CGAL.
#include "SimplificationTesting.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <set>
#include <thread>

using namespace SimplificationTesting;
using MTTestMeshes::Random;

namespace
{
// The floor's points whose identity goes on.
std::set<std::uint32_t> GetOrigins(const vtkMTSimplification& result)
{
  return { result.PointOrigin.begin(), result.PointOrigin.end() };
}

bool AreEqual(const vtkMTSimplification& a, const vtkMTSimplification& b)
{
  return a.Points == b.Points && a.PointOrigin == b.PointOrigin && a.Moved == b.Moved &&
    a.WedgePoints == b.WedgePoints && a.WedgeOrigin == b.WedgeOrigin && a.Triangles == b.Triangles &&
    a.Blocked == b.Blocked;
}

vtkMTPatch Shift(vtkMTPatch floor, const vtkMTPoint& by)
{
  for (vtkMTPoint& p : floor.Points)
  {
    for (int i = 0; i < 3; ++i)
    {
      p[i] += by[i];
    }
  }
  return floor;
}

double GetArea(const vtkMTPatch& mesh)
{
  double sum = 0.0;
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    const vtkMTTriangle p = mesh.GetPointsOfTriangle(t);
    double u[3];
    double v[3];
    double n[3];
    for (int i = 0; i < 3; ++i)
    {
      u[i] = static_cast<double>(mesh.Points[p[1]][i]) - mesh.Points[p[0]][i];
      v[i] = static_cast<double>(mesh.Points[p[2]][i]) - mesh.Points[p[0]][i];
    }
    vtkMath::Cross(u, v, n);
    sum += 0.5 * vtkMath::Norm(n);
  }
  return sum;
}
}

// Pitfall 1: CGAL deletes the locked vertex's own descriptor about every second time.
TEST(Pitfalls, LockedPointsKeepPlaceAndIdentityWhicheverDescriptorIsDeleted)
{
  const vtkMTPatch floor = MakeGrid(40, 40);
  Random random(1);
  Locks locked = LockBorder(floor);
  for (int i = 0; i < 100; ++i)
  {
    locked[random.Below(locked.size())] = 1;
  }
  for (const int mode : AllModes)
  {
    const Outcome run = Simplify(floor, locked, floor.Triangles.size() / 4, mode);
    ASSERT_TRUE(run.Ok) << run.Error;
    EXPECT_EQ(FindFault(floor, locked, run.Result), "");
    const std::set<std::uint32_t> origins = GetOrigins(run.Result);
    for (std::uint32_t p = 0; p < locked.size(); ++p)
    {
      EXPECT_TRUE(!locked[p] || origins.count(p)) << "point " << p << " in mode " << mode;
    }
  }
}

// Pitfall 2: quadrics of far coordinates lose all digits.
TEST(Pitfalls, TheSameShapeFarAwayGivesTheSameResultShifted)
{
  const vtkMTPatch floor = MakeGrid(30, 30, 0.1, 1000.0); // fine against where it goes
  const Locks locked = LockBorder(floor);
  const std::array<vtkMTPoint, 3> shifts = { { { 2147480000, -2147480000, 1 }, { -2000000001, 1, 2147480000 },
    { 1000000007, 1000000007, -1000000007 } } };
  for (const int mode : AllModes)
  {
    const Outcome near = Simplify(floor, locked, floor.Triangles.size() / 3, mode);
    for (const vtkMTPoint& shift : shifts)
    {
      const Outcome far = Simplify(Shift(floor, shift), locked, floor.Triangles.size() / 3, mode);
      EXPECT_EQ(far.Result.Points, Shift(ToPatch(near.Result), shift).Points) << "mode " << mode;
      EXPECT_EQ(far.Result.Triangles, near.Result.Triangles) << "mode " << mode;
      EXPECT_EQ(far.Result.PointOrigin, near.Result.PointOrigin) << "mode " << mode;
    }
  }
}

TEST(Pitfalls, AFloorAsLargeAsTheWholeLatticeIsSimplified)
{
  vtkMTPatch floor = MakeGrid(20, 20, 0.1, 1 << 20);
  for (vtkMTPoint& p : floor.Points)
  {
    p[0] =
      static_cast<std::int32_t>((static_cast<std::int64_t>(p[0]) << 12) - 2147483648LL - (p[0] == 1 << 20 ? 1 : 0));
    p[1] = static_cast<std::int32_t>(std::min<std::int64_t>(
      (static_cast<std::int64_t>(p[1]) << 12) - 2147483648LL, std::numeric_limits<std::int32_t>::max()));
  }
  const Outcome run = Simplify(floor, LockNothing(floor), 100);
  EXPECT_TRUE(run.Ok) << run.Error;
  EXPECT_EQ(FindFault(floor, LockNothing(floor), run.Result), "");
  EXPECT_LE(run.Result.Triangles.size(), 100u);
}

// Pitfall 3: CGAL counts edges.
TEST(Pitfalls, TheTargetIsMetInTriangles)
{
  const vtkMTPatch open = MakeGrid(50, 50);
  const vtkMTPatch closed = MakeFloor(MTTestMeshes::FractalSphere(4));
  for (const int mode : AllModes)
  {
    for (const bool lock : { false, true })
    {
      for (const vtkMTPatch* floor : { &open, &closed })
      {
        for (const std::size_t divisor : { 2, 5 })
        {
          const std::size_t target = floor->Triangles.size() / divisor;
          const Outcome run = Simplify(*floor, lock ? LockBorder(*floor) : LockNothing(*floor), target, mode);
          EXPECT_LE(run.Result.Triangles.size(), target);
          EXPECT_GE(run.Result.Triangles.size() + 1, target);
          EXPECT_TRUE(run.Result.Blocked.empty());
        }
      }
    }
  }
}

// Pitfall 4: two regions on both sides of a border could each make the same edge between two of its points.
TEST(Pitfalls, NoNewEdgeJoinsTwoLockedPoints)
{
  const vtkMTPatch floor = MakeGrid(24, 24);
  const Locks locked = LockBorder(floor);
  for (const int mode : AllModes)
  {
    const Outcome run = Simplify(floor, locked, 0, mode);
    EXPECT_EQ(FindFault(floor, locked, run.Result), "");
    const std::map<Edge, int> before = CountEdges(floor);
    for (const auto& e : CountEdges(ToPatch(run.Result)))
    {
      const std::uint32_t a = run.Result.PointOrigin[e.first.first];
      const std::uint32_t b = run.Result.PointOrigin[e.first.second];
      EXPECT_TRUE(!locked[a] || !locked[b] || before.count({ a, b })) << "edge " << a << " -> " << b;
    }
    EXPECT_GT(run.Result.Blocked.at("locked"), 0);
    EXPECT_GT(run.Result.Blocked.at("chord"), 0);
  }
}

// What goes around a vertex of thousands of edges for every collapse next to it takes the square of them.
TEST(Pitfalls, CollapsesLeaveHubsAloneUntilTheyAreNone)
{
  constexpr std::uint32_t spokes = 4000;
  std::vector<Place> places{ { 0.0, 0.0, 0.3 } };
  std::vector<Corners> triangles;
  for (std::uint32_t i = 0; i < spokes; ++i)
  {
    const double angle = 2.0 * 3.14159265358979 * i / spokes;
    places.push_back({ std::cos(angle), std::sin(angle), 0.0 });
    const auto next = static_cast<vtkIdType>(1 + (i + 1) % spokes);
    triangles.push_back({ 0, static_cast<vtkIdType>(1 + i), next });
  }
  const vtkMTPatch floor = MakeFloor(places, triangles);
  for (const int mode : AllModes)
  {
    const Outcome locked = Simplify(floor, LockBorder(floor), spokes / 2, mode);
    EXPECT_EQ(locked.Result.Blocked.at("valence"), spokes);
    const Outcome free = Simplify(floor, LockNothing(floor), spokes / 16, mode);
    EXPECT_EQ(FindFault(floor, LockNothing(floor), free.Result), "");
    EXPECT_LE(free.Result.Triangles.size(), spokes / 16);
  }
}

// Pitfall 5: CGAL collapses edges without length first and asks no predicate.
TEST(Pitfalls, EdgesWithoutLengthStopAtTheTargetAndRespectLocks)
{
  vtkMTPatch floor = MakeGrid(21, 21);
  for (vtkMTPoint& p : floor.Points)
  {
    p = { p[0] >> 18, p[1] >> 18, 0 }; // 25 places for 441 points
  }
  Locks locked = LockBorder(floor);
  locked[221] = locked[222] = locked[243] = 1;
  for (const int mode : AllModes)
  {
    const std::size_t target = floor.Triangles.size() * 3 / 4;
    const Outcome run = Simplify(floor, locked, target, mode);
    EXPECT_TRUE(run.Ok) << run.Error;
    EXPECT_EQ(FindFault(floor, locked, run.Result), "");
    EXPECT_GE(run.Result.Triangles.size() + 1, target);
    std::printf(
      "mode %d: %zu triangles, wanted %zu of %zu\n", mode, run.Result.Triangles.size(), target, floor.Triangles.size());
  }
  const Outcome fast = Simplify(floor, locked, floor.Triangles.size() * 3 / 4);
  EXPECT_LE(fast.Result.Triangles.size(), floor.Triangles.size() * 3 / 4);
}

TEST(Pitfalls, AFloorOfOnePlaceIsSimplified)
{
  vtkMTPatch floor = MakeFloor(MTTestMeshes::Icosphere(3));
  floor.Points.assign(floor.Points.size(), { 5, -7, 2000000000 });
  for (const int mode : AllModes)
  {
    const Outcome run = Simplify(floor, LockNothing(floor), floor.Triangles.size() / 2, mode);
    EXPECT_TRUE(run.Ok) << run.Error;
    EXPECT_TRUE(IsClosedManifold(ToPatch(run.Result)));
    EXPECT_EQ(run.Result.Points[0], floor.Points[0]);
  }
  EXPECT_LE(Simplify(floor, LockNothing(floor), 640).Result.Triangles.size(), 640u);
}

// Pitfall 6: CGAL's add_face rejects triangles without a word.
TEST(Pitfalls, NoTriangleOfANonManifoldFloorIsLost)
{
  vtkMTPatch floor = MakeGrid(6, 6);
  const vtkMTTriangle some = floor.Triangles[20];
  floor.Triangles.push_back(some);                          // a duplicate
  floor.Triangles.push_back({ some[1], some[0], some[2] }); // an opposite face
  floor.Points.push_back({ 1000, 1000, 900000 });
  floor.Triangles.push_back({ floor.Triangles[30][0], floor.Triangles[30][1], 36 }); // a fin
  floor.Triangles.push_back({ 0, 0, 1 });                                            // no triangle
  const Locks locked = LockNothing(floor);
  for (const int mode : AllModes)
  {
    const Outcome same = Simplify(floor, locked, 1000, mode);
    EXPECT_EQ(same.Result.Triangles.size(), floor.Triangles.size() - 1);
    EXPECT_EQ(CountEdges(ToPatch(same.Result)).size(), CountEdges(floor).size());
    EXPECT_TRUE(same.Result.Blocked.empty());
    const Outcome least = Simplify(floor, locked, 0, mode);
    EXPECT_EQ(FindFault(floor, locked, least.Result), "");
    EXPECT_GT(least.Result.Blocked.at("non_manifold"), 0);
  }
}

TEST(Pitfalls, AnEdgeOfFourTrianglesIsNotMadeWhereARegionTouchesItself)
{
  // Two fans of one point, and a ring of triangles around both.
  vtkMTPatch floor = MakeGrid(9, 9);
  vtkMTPatch cut = floor;
  cut.Triangles.clear();
  for (std::size_t t = 0; t < floor.Triangles.size(); ++t)
  {
    const std::size_t square = t / 2;
    if (square != 3 * 8 + 3 && square != 4 * 8 + 4) // two squares that meet at the middle
    {
      cut.Triangles.push_back(floor.Triangles[t]);
    }
  }
  for (const int mode : AllModes)
  {
    const Outcome run = Simplify(cut, LockNothing(cut), 0, mode);
    EXPECT_EQ(FindFault(cut, LockNothing(cut), run.Result), "");
    EXPECT_EQ(GetOrigins(run.Result).count(40), 1u);
  }
}

// Pitfall 7: an endless loop known upstream (CGAL #7529).
TEST(Pitfalls, ARegionThatTakesTooManyStepsEndsWithWhatItHas)
{
  const vtkMTPatch floor = MakeGrid(60, 60);
  const Locks locked = LockBorder(floor);
  for (const int mode : AllModes)
  {
    vtkNew<vtkMTEdgeCollapse> simplifier;
    simplifier->SetMode(mode);
    simplifier->SetStepsPerEdge(2);
    vtkMTSimplification result;
    std::string error;
    ASSERT_TRUE(simplifier->Simplify(floor, locked, 100, result, error)) << error;
    EXPECT_EQ(FindFault(floor, locked, result), "");
    EXPECT_GT(result.Triangles.size(), 100u);
    EXPECT_LT(result.Triangles.size(), floor.Triangles.size());
    EXPECT_GT(result.Blocked.at("steps"), 0);
  }
}

// Pitfall 7: slivers on flat parts (CGAL #8988).
TEST(Pitfalls, FlatPartsGetNoSlivers)
{
  const vtkMTPatch floor = MakeGrid(60, 60, 0.0);
  for (const int mode : { vtkMTEdgeCollapse::FAST, vtkMTEdgeCollapse::BEST })
  {
    const Outcome run = Simplify(floor, LockBorder(floor), floor.Triangles.size() / 4, mode);
    const vtkMTPatch mesh = ToPatch(run.Result);
    EXPECT_EQ(CountFlatTriangles(mesh), 0u);
    EXPECT_NEAR(GetArea(mesh), GetArea(floor), 1e-9 * GetArea(floor));
    double sum = 0.0;
    for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
    {
      vtkMTPatch one = mesh;
      one.Triangles = { mesh.Triangles[t] };
      double squares = 0.0;
      const vtkMTTriangle p = mesh.GetPointsOfTriangle(t);
      for (int e = 0; e < 3; ++e)
      {
        for (int i = 0; i < 3; ++i)
        {
          const double d = static_cast<double>(mesh.Points[p[e]][i]) - mesh.Points[p[(e + 1) % 3]][i];
          squares += d * d;
        }
      }
      sum += 4.0 * std::sqrt(3.0) * GetArea(one) / squares; // 1 for an equilateral triangle
    }
    const double quality = sum / static_cast<double>(mesh.Triangles.size());
    std::printf("mode %d: mean quality %.3f\n", mode, quality);
    EXPECT_GT(quality, 0.6);
  }
}

// Pitfall 8: a small closed component must not be flattened into a double face.
TEST(Pitfalls, ClosedComponentsEndAsTetrahedra)
{
  vtkMTPatch floor;
  for (int i = 0; i < 12; ++i)
  {
    const vtkMTPatch one = MakeFloor(MTTestMeshes::Icosphere(1 + i % 3), 1000.0 + 100.0 * i);
    const auto first = static_cast<std::uint32_t>(floor.Points.size());
    for (const vtkMTPoint& p : one.Points)
    {
      floor.Points.push_back({ p[0] + 10000 * i, p[1], p[2] });
    }
    for (const vtkMTTriangle& t : one.Triangles)
    {
      floor.Triangles.push_back({ t[0] + first, t[1] + first, t[2] + first });
    }
  }
  for (const int mode : AllModes)
  {
    vtkNew<vtkMTEdgeCollapse> simplifier;
    simplifier->SetMode(mode);
    simplifier->SetComponentBound(0.0);
    vtkMTSimplification result;
    std::string error;
    ASSERT_TRUE(simplifier->Simplify(floor, LockNothing(floor), 0, result, error)) << error;
    EXPECT_TRUE(IsClosedManifold(ToPatch(result)));
    EXPECT_EQ(CountComponents(ToPatch(result)), 12u);
    EXPECT_LE(result.Triangles.size(), 12u * 8u);
    EXPECT_GE(result.Triangles.size(), 12u * 4u);
    std::printf("mode %d: 12 spheres in %zu triangles\n", mode, result.Triangles.size());
  }
}

TEST(Pitfalls, AClosedManifoldStaysOneAtEveryTarget)
{
  const vtkMTPatch floor = MakeFloor(MTTestMeshes::Torus(30, 20));
  for (const int mode : AllModes)
  {
    for (std::size_t target = floor.Triangles.size(); target > 0; target /= 2)
    {
      const Outcome run = Simplify(floor, LockNothing(floor), target, mode);
      EXPECT_TRUE(IsClosedManifold(ToPatch(run.Result))) << target << " triangles in mode " << mode;
    }
  }
}

// Pitfall 9: regions are independent of each other, also in threads.
TEST(Pitfalls, ThreadsGiveTheSameResultsAsOneAfterTheOther)
{
  const vtkMTPatch floor = MakeFractalCap(5, 3000, 1);
  const Locks locked = LockBorder(floor);
  vtkNew<vtkMTEdgeCollapse> simplifier;
  std::array<vtkMTSimplification, 4> results;
  std::vector<std::thread> threads;
  for (vtkMTSimplification& result : results)
  {
    threads.emplace_back(
      [&]
      {
        std::string error;
        simplifier->Simplify(floor, locked, 1000, result, error);
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  const Outcome alone = Simplify(floor, locked, 1000);
  for (const vtkMTSimplification& result : results)
  {
    EXPECT_TRUE(AreEqual(result, alone.Result));
  }
}
