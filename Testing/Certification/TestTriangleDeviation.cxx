// SPDX-License-Identifier: BSD-3-Clause
// What the certification says of single triangles, by distances computed here.
#include "MTTestMeshes.h"

#include "vtkMTDeviation.h"
#include "vtkMTEdgeCollapse.h"
#include "vtkMTSurface.h"

#include "vtkNew.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>

namespace
{
using Vector = std::array<double, 3>;

double Dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector Minus(const Vector& a, const Vector& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

Vector Blend(const Vector& a, const Vector& b, const Vector& c, double u, double v)
{
  Vector x;
  for (int i = 0; i < 3; ++i)
  {
    x[i] = a[i] + u * (b[i] - a[i]) + v * (c[i] - a[i]);
  }
  return x;
}

// Distance from a point to a triangle by regions (Ericson, "Real-Time Collision Detection", 5.1.5).
double GetDistance(const Vector& x, const std::array<Vector, 3>& t)
{
  const Vector ab = Minus(t[1], t[0]);
  const Vector ac = Minus(t[2], t[0]);
  const auto at = [&](double u, double v)
  {
    const Vector d = Minus(x, Blend(t[0], t[1], t[2], u, v));
    return std::sqrt(Dot(d, d));
  };
  const double d1 = Dot(ab, Minus(x, t[0]));
  const double d2 = Dot(ac, Minus(x, t[0]));
  const double d3 = Dot(ab, Minus(x, t[1]));
  const double d4 = Dot(ac, Minus(x, t[1]));
  const double d5 = Dot(ab, Minus(x, t[2]));
  const double d6 = Dot(ac, Minus(x, t[2]));
  const double va = d3 * d6 - d5 * d4;
  const double vb = d5 * d2 - d1 * d6;
  const double vc = d1 * d4 - d3 * d2;
  const double sum = va + vb + vc;
  if (va > 0.0 && vb > 0.0 && vc > 0.0)
  {
    return at(vb / sum, vc / sum);
  }
  const auto share = [](double from, double to)
  { return from + to > 0.0 ? std::clamp(from / (from + to), 0.0, 1.0) : 0.0; };
  const double ofAb = share(d1, -d3);
  const double ofAc = share(d2, -d6);
  const double ofBc = share(d4 - d3, d5 - d6);
  return std::min({ at(ofAb, 0.0), at(0.0, ofAc), at(1.0 - ofBc, ofBc) });
}

std::array<Vector, 3> GetCorners(const vtkMTPatch& mesh, std::size_t t)
{
  std::array<Vector, 3> corners;
  const vtkMTTriangle points = mesh.GetPointsOfTriangle(t);
  for (int c = 0; c < 3; ++c)
  {
    for (int i = 0; i < 3; ++i)
    {
      corners[c][i] = mesh.Points[points[c]][i];
    }
  }
  return corners;
}

// Corners, middles of sides and random places of a triangle.
std::vector<Vector> GetSamples(const std::array<Vector, 3>& t, std::mt19937& random)
{
  std::vector<Vector> samples{ t[0], t[1], t[2], Blend(t[0], t[1], t[2], 0.5, 0.5), Blend(t[0], t[1], t[2], 0.5, 0.0),
    Blend(t[0], t[1], t[2], 0.0, 0.5) };
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int i = 0; i < 6; ++i)
  {
    const double u = unit(random);
    const double v = unit(random) * (1.0 - u);
    samples.push_back(Blend(t[0], t[1], t[2], u, v));
  }
  return samples;
}

struct Tally
{
  std::size_t Broken = 0;
  double Bound = 0.0;
  double Sampled = 0.0; // the largest distance
  std::size_t ByPieces = 0;
  std::size_t Triangles = 0;
};

// Every sample of a fragment's triangle is within its ToInput of the floor; every sample of the floor is within
// FromInput of some triangle of the fragment.
Tally Check(const vtkMTPatch& floor, const vtkMTPatch& fragment, const std::vector<std::uint32_t>& heirs, unsigned seed)
{
  vtkMTDeviation::Relation relation;
  relation.Heirs = heirs;
  vtkMTDeviation::Findings findings;
  const vtkMTPoint origin{ 0, 0, 0 };
  const vtkMTDeviation deviation =
    vtkMTDeviation::Between(vtkMTSurface(floor, origin), vtkMTSurface(fragment, origin), relation, findings);
  Tally tally;
  tally.Bound = deviation.UpperBound;
  tally.ByPieces = deviation.TrianglesByPieces;
  tally.Triangles = floor.Triangles.size() + fragment.Triangles.size();
  std::mt19937 random(seed);
  for (std::size_t s = 0; s < fragment.Triangles.size(); ++s)
  {
    for (const Vector& x : GetSamples(GetCorners(fragment, s), random))
    {
      double nearest = 1e300;
      for (std::size_t t = 0; t < floor.Triangles.size(); ++t)
      {
        nearest = std::min(nearest, GetDistance(x, GetCorners(floor, t)));
      }
      tally.Sampled = std::max(tally.Sampled, nearest);
      tally.Broken += nearest > findings.Deviations[s].ToInput + 1e-6 ? 1 : 0;
    }
  }
  for (std::size_t t = 0; t < floor.Triangles.size(); ++t)
  {
    for (const Vector& x : GetSamples(GetCorners(floor, t), random))
    {
      double nearest = 1e300;
      bool isWithin = false;
      for (std::size_t s = 0; s < fragment.Triangles.size(); ++s)
      {
        const double distance = GetDistance(x, GetCorners(fragment, s));
        nearest = std::min(nearest, distance);
        isWithin = isWithin || distance <= findings.Deviations[s].FromInput + 1e-6;
      }
      tally.Sampled = std::max(tally.Sampled, nearest);
      tally.Broken += isWithin ? 0 : 1;
    }
  }
  EXPECT_GE(tally.Bound, tally.Sampled - 1e-6);
  return tally;
}

// A grid of n x n cells with sides of 1000 steps and random heights up to the given one.
vtkMTPatch MakeRoughGrid(int n, int height, std::mt19937& random)
{
  std::uniform_int_distribution<int> z(0, height);
  vtkMTPatch mesh;
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      mesh.Points.push_back({ 1000 * i, 1000 * j, z(random) });
    }
  }
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      const auto a = static_cast<std::uint32_t>(j * (n + 1) + i);
      const std::uint32_t c = a + static_cast<std::uint32_t>(n) + 1;
      mesh.Triangles.push_back({ a, a + 1, c + 1 });
      mesh.Triangles.push_back({ a, c + 1, c });
    }
  }
  return mesh;
}

std::vector<unsigned char> LockBorder(const vtkMTPatch& grid, int n)
{
  std::vector<unsigned char> locked(grid.Points.size(), 0);
  for (std::size_t p = 0; p < locked.size(); ++p)
  {
    const auto& k = grid.Points[p];
    locked[p] = k[0] == 0 || k[1] == 0 || k[0] == 1000 * n || k[1] == 1000 * n ? 1 : 0;
  }
  return locked;
}

vtkMTSimplification Simplify(const vtkMTPatch& floor, const std::vector<unsigned char>& locked)
{
  vtkNew<vtkMTEdgeCollapse> collapse;
  vtkMTSimplification result;
  std::string error;
  EXPECT_TRUE(collapse->Simplify(floor, locked, floor.Triangles.size() / 2, result, error)) << error;
  return result;
}

vtkMTPatch ToPatch(const vtkMTSimplification& simplification)
{
  vtkMTPatch patch;
  patch.Points = simplification.Points;
  patch.WedgePoints = simplification.WedgePoints;
  patch.Triangles = simplification.Triangles;
  return patch;
}

std::vector<std::uint32_t> MakeRandomHeirs(std::size_t floorPoints, std::size_t fragmentPoints, std::mt19937& random)
{
  std::uniform_int_distribution<std::uint32_t> point(0, static_cast<std::uint32_t>(fragmentPoints) - 1);
  std::vector<std::uint32_t> heirs(floorPoints);
  for (std::uint32_t& heir : heirs)
  {
    heir = random() % 8 == 0 ? vtkMTSimplification::NoHeir : point(random);
  }
  return heirs;
}

std::vector<std::uint32_t> MakeEqualHeirs(std::size_t points)
{
  std::vector<std::uint32_t> heirs(points);
  for (std::uint32_t p = 0; p < points; ++p)
  {
    heirs[p] = p;
  }
  return heirs;
}
}

TEST(TriangleDeviation, EveryTriangleIsWithinItsOwn)
{
  std::mt19937 random(1);
  for (const int height : { 0, 200, 1000, 4000 })
  {
    const vtkMTPatch floor = MakeRoughGrid(16, height, random);
    const vtkMTSimplification simplification = Simplify(floor, LockBorder(floor, 16));
    const Tally tally = Check(floor, ToPatch(simplification), simplification.Heirs, 2);
    std::printf("height %4d: certified %.1f, sampled %.1f; %zu of %zu triangles by pieces\n", height, tally.Bound,
      tally.Sampled, tally.ByPieces, tally.Triangles);
    EXPECT_EQ(tally.Broken, 0u);
    EXPECT_LE(tally.Bound, 1.5 * tally.Sampled + 1e-3);
  }
}

TEST(TriangleDeviation, HoldsWhereBordersMove)
{
  std::mt19937 random(3);
  const vtkMTPatch floor = MakeRoughGrid(14, 500, random);
  const vtkMTSimplification simplification = Simplify(floor, std::vector<unsigned char>(floor.Points.size(), 0));
  const Tally tally = Check(floor, ToPatch(simplification), simplification.Heirs, 4);
  std::printf("certified %.1f, sampled %.1f; %zu of %zu triangles by pieces\n", tally.Bound, tally.Sampled,
    tally.ByPieces, tally.Triangles);
  EXPECT_EQ(tally.Broken, 0u);
}

// Heirs are where the search begins and nothing else.
TEST(TriangleDeviation, HoldsWhateverTheHeirs)
{
  std::mt19937 random(5);
  for (int round = 0; round < 12; ++round)
  {
    const vtkMTPatch floor = MakeRoughGrid(8, 1500, random);
    const vtkMTPatch fragment = ToPatch(Simplify(floor, LockBorder(floor, 8)));
    const auto heirs = MakeRandomHeirs(floor.Points.size(), fragment.Points.size(), random);
    EXPECT_EQ(Check(floor, fragment, heirs, 6).Broken, 0u);
  }
}

// Fragments that no simplifier would make: points moved at random, until triangles are turned over and lie in folds;
// triangles left out, or there twice.
TEST(TriangleDeviation, HoldsForFragmentsThatAreFoldedOrTorn)
{
  std::mt19937 random(7);
  std::size_t byPieces = 0;
  std::size_t triangles = 0;
  for (int round = 0; round < 40; ++round)
  {
    const vtkMTPatch floor = MakeRoughGrid(7, 600, random);
    vtkMTPatch fragment = floor;
    const int largest = 50 << (round % 7);
    std::uniform_int_distribution<int> shift(-largest, largest);
    for (vtkMTPoint& p : fragment.Points)
    {
      for (int i = 0; i < 3 && random() % 4 != 0; ++i)
      {
        p[i] += shift(random);
      }
    }
    if (round % 3 == 1)
    {
      fragment.Triangles.erase(fragment.Triangles.begin() + 40, fragment.Triangles.begin() + 44);
    }
    if (round % 3 == 2)
    {
      fragment.Triangles.insert(
        fragment.Triangles.end(), fragment.Triangles.begin() + 20, fragment.Triangles.begin() + 23);
    }
    const Tally tally = Check(floor, fragment, MakeEqualHeirs(floor.Points.size()), 8);
    EXPECT_EQ(tally.Broken, 0u) << "round " << round;
    byPieces += tally.ByPieces;
    triangles += tally.Triangles;
  }
  std::printf("%zu of %zu triangles by pieces\n", byPieces, triangles);
}

// A fragment with a second sheet, above the first, that no point of the floor was merged into.
TEST(TriangleDeviation, SheetThatTheFloorDoesNotCoverIsSeen)
{
  std::mt19937 random(9);
  const vtkMTPatch floor = MakeRoughGrid(6, 0, random);
  vtkMTPatch fragment = floor;
  const auto points = static_cast<std::uint32_t>(floor.Points.size());
  for (const vtkMTPoint& p : floor.Points)
  {
    fragment.Points.push_back({ p[0], p[1], p[2] + 700 });
  }
  for (const vtkMTTriangle& t : floor.Triangles)
  {
    fragment.Triangles.push_back({ t[0] + points, t[1] + points, t[2] + points });
  }
  const Tally tally = Check(floor, fragment, MakeEqualHeirs(points), 10);
  EXPECT_EQ(tally.Broken, 0u);
  EXPECT_GE(tally.Bound, 700.0);
  EXPECT_LE(tally.Bound, 1.1 * 700.0);
}

// What makes building fast: on an ordinary surface hardly any triangle needs pieces.
TEST(TriangleDeviation, HardlyAnyTriangleOfAClosedSurfaceIsBoundByPieces)
{
  const auto input = MTTestMeshes::FractalSphere(4);
  vtkMTPatch floor;
  for (vtkIdType p = 0; p < input->GetNumberOfPoints(); ++p)
  {
    const double* x = input->GetPoint(p);
    floor.Points.push_back({ static_cast<std::int32_t>(std::lround(1e6 * x[0])),
      static_cast<std::int32_t>(std::lround(1e6 * x[1])), static_cast<std::int32_t>(std::lround(1e6 * x[2])) });
  }
  for (vtkIdType t = 0; t < input->GetNumberOfCells(); ++t)
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    input->GetCellPoints(t, count, ids);
    floor.Triangles.push_back(
      { static_cast<std::uint32_t>(ids[0]), static_cast<std::uint32_t>(ids[1]), static_cast<std::uint32_t>(ids[2]) });
  }
  const vtkMTSimplification simplification = Simplify(floor, std::vector<unsigned char>(floor.Points.size(), 0));
  vtkMTDeviation::Relation relation;
  relation.Heirs = simplification.Heirs;
  vtkMTDeviation::Findings findings;
  const vtkMTPatch fragment = ToPatch(simplification);
  const vtkMTPoint origin{ 0, 0, 0 };
  const vtkMTDeviation deviation =
    vtkMTDeviation::Between(vtkMTSurface(floor, origin), vtkMTSurface(fragment, origin), relation, findings);
  const std::size_t all = floor.Triangles.size() + fragment.Triangles.size();
  std::printf("%zu of %zu triangles by pieces\n", deviation.TrianglesByPieces, all);
  EXPECT_LE(deviation.TrianglesByPieces, all / 20);
}
