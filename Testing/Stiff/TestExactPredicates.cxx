// SPDX-License-Identifier: BSD-3-Clause
// Signs and intersections on the lattice are exact, and what is counted with them is what is there.
#include "MTStiffMeshes.h"
#include "MTStiffTopology.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

namespace
{
using namespace MTExactPredicates;

MTStiffTopology::Mesh MakeLatticeMesh(const MTStiffMeshes::Mesh& mesh, double scale)
{
  MTStiffTopology::Mesh lattice;
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    double x[3];
    mesh->GetPoint(p, x);
    lattice.Points.push_back({ std::llround(scale * x[0]), std::llround(scale * x[1]), std::llround(scale * x[2]) });
  }
  vtkNew<vtkIdList> corners;
  for (vtkIdType t = 0; t < mesh->GetNumberOfPolys(); ++t)
  {
    mesh->GetPolys()->GetCellAtId(t, corners);
    lattice.Triangles.push_back({ static_cast<std::uint32_t>(corners->GetId(0)),
      static_cast<std::uint32_t>(corners->GetId(1)), static_cast<std::uint32_t>(corners->GetId(2)) });
  }
  return lattice;
}
}

// Volumes of one sixth of a cell among coordinates of 32 bits: doubles cannot tell them from nothing.
TEST(ExactPredicates, OrientationsAreRightToTheLastBit)
{
  const std::int64_t big = (std::int64_t(1) << 31) - 1;
  const Point a{ 0, 0, 0 }, b{ big, big - 1, 1 }, c{ big - 1, big, 2 };
  MTTestMeshes::Random random(21);
  int wrong = 0;
  for (int i = 0; i < 1000; ++i)
  {
    // On the plane of a, b, c: a sum of both edges; beside it: one step more in z.
    const auto s = static_cast<std::int64_t>(random.Below(2)), t = static_cast<std::int64_t>(random.Below(2));
    const Point d{ s * b[0] + t * c[0] - big, s * b[1] + t * c[1] - big, s * b[2] + t * c[2] };
    const Point a1{ a[0] - big, a[1] - big, a[2] }, b1{ b[0] - big, b[1] - big, b[2] },
      c1{ c[0] - big, c[1] - big, c[2] };
    EXPECT_EQ(GetOrientation(a1, b1, c1, d), 0);
    const int above = GetOrientation(a1, b1, c1, { d[0], d[1], d[2] + 1 });
    EXPECT_EQ(above, -GetOrientation(a1, b1, c1, { d[0], d[1], d[2] - 1 }));
    EXPECT_EQ(above, -GetOrientation(a1, c1, b1, { d[0], d[1], d[2] + 1 }));
    wrong += above != 1;
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_TRUE(IsDegenerate({ a, Point{ big, big, big }, Point{ -big, -big, -big } }));
  EXPECT_FALSE(IsDegenerate({ a, Point{ big, big, big }, Point{ -big, -big, 1 - big } }));
}

// (b - a) x (c - a) of needles: their product is far beyond 128 bits, and its sign hangs on the last one.
TEST(ExactPredicates, ProductsOfNormalsHaveTheRightSign)
{
  const std::int64_t big = (std::int64_t(1) << 31) - 1;
  const Point o{ 0, 0, 0 };
  const Triangle x{ o, Point{ 0, big, 0 }, Point{ 0, 0, big } };       // normal (big^2, 0, 0)
  const Triangle y{ o, Point{ 0, 0, big }, Point{ big, 0, 0 } };       // normal (0, big^2, 0)
  const Triangle z{ o, Point{ big, 0, 0 }, Point{ -1, big, 0 } };      // normal (0, 0, big^2)
  const Triangle almostY{ o, Point{ 0, 0, big }, Point{ big, 1, 0 } }; // normal (-big, big^2, 0)
  const Triangle other{ o, Point{ 0, 0, big }, Point{ big, -1, 0 } };  // normal (big, big^2, 0)
  EXPECT_EQ(GetNormalProductSign(x, x), 1);
  EXPECT_EQ(GetNormalProductSign(x, { x[0], x[2], x[1] }), -1);
  EXPECT_EQ(GetNormalProductSign(x, y), 0);
  EXPECT_EQ(GetNormalProductSign(y, z), 0);
  EXPECT_EQ(GetNormalProductSign(x, almostY), -1);
  EXPECT_EQ(GetNormalProductSign(x, other), 1);
  EXPECT_EQ(GetNormalProductSign({ x[0], x[2], x[1] }, other), -1);
}

TEST(ExactPredicates, TrianglesMeetWhereTheyTouchAndNotAStepBeside)
{
  const std::int64_t n = std::int64_t(1) << 24;
  const Triangle flat{ Point{ 0, 0, 0 }, Point{ n, 0, 0 }, Point{ 0, n, 0 } };
  const auto standing = [n](std::int64_t x, std::int64_t y, std::int64_t z) {
    return Triangle{ Point{ x, y, z }, Point{ x + 1, y, n }, Point{ x, y + 1, n } };
  };
  EXPECT_TRUE(TrianglesMeet(flat, standing(n / 2, n / 2, 0))) << "a tip on an edge";
  EXPECT_FALSE(TrianglesMeet(flat, standing(n / 2, n / 2, 1)));
  EXPECT_FALSE(TrianglesMeet(flat, standing(n / 2, n / 2 + 1, 0)));
  EXPECT_TRUE(TrianglesMeet(flat, standing(n / 3, n / 3, -1)));
  // In one plane: inside, across, beside.
  const auto moved = [&](std::int64_t x, std::int64_t y, std::int64_t size) {
    return Triangle{ Point{ x, y, 0 }, Point{ x + size, y, 0 }, Point{ x, y + size, 0 } };
  };
  EXPECT_TRUE(TrianglesMeet(flat, moved(n / 8, n / 8, n / 8)));
  EXPECT_TRUE(TrianglesMeet(moved(n / 8, n / 8, n / 8), flat));
  EXPECT_TRUE(TrianglesMeet(flat, moved(-1, n / 2, n)));
  EXPECT_TRUE(TrianglesMeet(flat, moved(n / 2, n / 2, n)));
  EXPECT_FALSE(TrianglesMeet(flat, moved(n / 2 + 1, n / 2, n)));
  // Around a common corner, and at a common edge.
  EXPECT_FALSE(TrianglesMeetBeyondCorner(flat, { Point{ 0, 0, 0 }, Point{ -n, 0, 0 }, Point{ 0, -n, 0 } }));
  EXPECT_TRUE(TrianglesMeetBeyondCorner(flat, { Point{ 0, 0, 0 }, Point{ n, n, 1 }, Point{ n, n, -1 } }));
  EXPECT_TRUE(TrianglesFold(flat, { flat[0], flat[1], Point{ 5, 1, 0 } }));
  EXPECT_FALSE(TrianglesFold(flat, { flat[0], flat[1], Point{ 5, 1, 1 } }));
  EXPECT_FALSE(TrianglesFold(flat, { flat[0], flat[1], Point{ 5, -1, 0 } }));
}

TEST(StiffTopology, ComponentsEulerNumbersAndBordersAreThoseThatAreKnown)
{
  struct Known
  {
    const char* Name;
    MTStiffMeshes::Mesh Mesh;
    std::int64_t Components, Euler;
    bool IsClosed;
  };
  const Known meshes[] = { { "sphere", MTStiffMeshes::BumpySphere(1280), 1, 2, true },
    { "torus", MTTestMeshes::Torus(20, 10), 1, 0, true }, { "Klein bottle", MTStiffMeshes::Klein(1280), 1, 0, true },
    { "Moebius strip", MTStiffMeshes::Moebius(1280), 1, 0, false },
    { "plate", MTStiffMeshes::ThinPlate(800, 0.1, 0.0), 1, 2, true },
    { "sheets", MTStiffMeshes::ThinSheets(800, 0.1), 2, 2, false },
    { "cylinder", MTStiffMeshes::Cylinder(800), 1, 0, false },
    { "sponge of one step", MTStiffMeshes::Sponge(100), 1, -8, true }, // genus 5
    { "triangles", MTStiffMeshes::Components(100), 100, 100, false },
    { "two fans", MTStiffMeshes::TwoFans(100), 1, 1, false } };
  for (const Known& known : meshes)
  {
    const MTStiffTopology found = MTStiffTopology::Count(MakeLatticeMesh(known.Mesh, 1e6));
    std::printf("%s: %d components, Euler number %d, %d border edges\n", known.Name, static_cast<int>(found.Components),
      static_cast<int>(found.Euler), static_cast<int>(found.BorderEdges));
    EXPECT_EQ(found.Components, known.Components) << known.Name;
    EXPECT_EQ(found.Euler, known.Euler) << known.Name;
    EXPECT_EQ(found.BorderEdges == 0, known.IsClosed) << known.Name;
  }
}

TEST(StiffTopology, IntersectionsAreCountedAsByLookingAtEveryPair)
{
  for (const auto& mesh : { MTStiffMeshes::Crumpled(600), MTStiffMeshes::Klein(600), MTStiffMeshes::TJunctions(400),
         MTStiffMeshes::BumpySphere(320), MTStiffMeshes::Plane(600) })
  {
    const MTStiffTopology::Mesh lattice = MakeLatticeMesh(mesh, 4096.0);
    std::int64_t pairs = 0;
    for (std::size_t s = 0; s < lattice.Triangles.size(); ++s)
    {
      for (std::size_t t = 0; t < s; ++t)
      {
        // Alone, with nothing to sort.
        const MTStiffTopology::Mesh two{ lattice.Points, { lattice.Triangles[s], lattice.Triangles[t] } };
        pairs += MTStiffTopology::CountIntersections(two, 1);
      }
    }
    const std::int64_t found = MTStiffTopology::CountIntersections(lattice, std::size_t(1) << 40);
    std::printf(
      "%d triangles, %d pairs that meet\n", static_cast<int>(lattice.Triangles.size()), static_cast<int>(found));
    EXPECT_EQ(found, pairs);
  }
}
