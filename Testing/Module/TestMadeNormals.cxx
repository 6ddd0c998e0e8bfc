// SPDX-License-Identifier: BSD-3-Clause
// Normals that follow from triangles: what they are, that they are the same everywhere, and where they are kept.
#include "MTTestMeshes.h"

#include "vtkMTMadeNormals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace
{
using MTTestMeshes::Random;
using Vector = std::array<double, 3>;
using Terms = std::array<Vector, 3>;

double Dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector Cross(const Vector& a, const Vector& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

// By the sine, which is exact for small angles.
double GetAngle(const Vector& a, const Vector& b)
{
  return std::atan2(std::sqrt(Dot(Cross(a, b), Cross(a, b))), Dot(a, b));
}

Vector DrawDirection(Random& random)
{
  for (;;)
  {
    const Vector d{ random.Uniform() - 0.5, random.Uniform() - 0.5, random.Uniform() - 0.5 };
    const double length = std::sqrt(Dot(d, d));
    if (length > 0.01 && length < 0.5)
    {
      return { d[0] / length, d[1] / length, d[2] / length };
    }
  }
}

vtkMTPoint DrawPoint(Random& random, std::int32_t size)
{
  const auto draw = [&]
  { return static_cast<std::int32_t>(random.Below(2 * static_cast<std::uint64_t>(size))) - size; };
  return { draw(), draw(), draw() };
}

// Any triangles of a few points, some of them degenerate.
vtkMTPatch DrawMesh(Random& random, std::int32_t size)
{
  vtkMTPatch mesh;
  for (int i = 0; i < 60; ++i)
  {
    mesh.Points.push_back(DrawPoint(random, size));
  }
  for (int t = 0; t < 500; ++t)
  {
    const auto draw = [&] { return static_cast<std::uint32_t>(random.Below(60)); };
    mesh.Triangles.push_back({ draw(), draw(), draw() });
  }
  return mesh;
}

Terms GetTerms(const vtkMTPoint& a, const vtkMTPoint& b, const vtkMTPoint& c)
{
  Terms terms;
  vtkMTMadeNormals::GetTerms({ &a, &b, &c }, terms);
  return terms;
}
}

TEST(MadeNormals, EveryPlaceIsThatOfItsOwnNormal)
{
  for (int bits = vtkMTMadeNormals::MinimumBits; bits <= vtkMTMadeNormals::MaximumBits; ++bits)
  {
    const int half = (1 << (bits - 1)) - 1;
    const int step = std::max(1, half / 700) | 1;
    std::uint64_t places = 0;
    std::uint64_t others = 0;
    for (int u = -half; u <= half; u += step)
    {
      for (int v = -half; v <= half; v += step)
      {
        const vtkMTMadeNormals::Place place{ static_cast<std::uint16_t>(u + half),
          static_cast<std::uint16_t>(v + half) };
        const vtkMTMadeNormals::Place found =
          vtkMTMadeNormals::GetPlace(vtkMTMadeNormals::GetNormal(place, bits), bits);
        const bool isOnRim = std::abs(u) == half || std::abs(v) == half;
        const std::array<int, 2> positive{ std::abs(u), std::abs(v) };
        const std::array<int, 2> centered{ found[0] - half, found[1] - half };
        const std::array<int, 2> expected{ std::abs(v) == half ? positive[0] : u,
          std::abs(u) == half ? positive[1] : v };
        others += centered != (isOnRim ? expected : std::array<int, 2>{ u, v }) ? 1 : 0;
        ++places;
      }
    }
    EXPECT_EQ(others, 0u) << bits << " bits, " << places << " places";
    const vtkMTMadeNormals::Place none{ static_cast<std::uint16_t>(2 * half + 1),
      static_cast<std::uint16_t>(2 * half + 1) };
    EXPECT_EQ(vtkMTMadeNormals::GetPlace(std::array<float, 3>{ 0.0f, 0.0f, 0.0f }, bits), none);
    EXPECT_EQ(vtkMTMadeNormals::GetNormal(none, bits), (std::array<float, 3>{ 0.0f, 0.0f, 0.0f }));
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(vtkMTMadeNormals::GetPlace(std::array<float, 3>{ 0.0f, nan, 1.0f }, bits), none);
  }
}

TEST(MadeNormals, AreWithinTheRoundingThatIsPromised)
{
  Random random(1);
  for (int bits = vtkMTMadeNormals::MinimumBits; bits <= vtkMTMadeNormals::MaximumBits; ++bits)
  {
    double worst = 0.0;
    for (int i = 0; i < 100000; ++i)
    {
      const Vector d = DrawDirection(random);
      const std::array<float, 3> normal{ static_cast<float>(d[0]), static_cast<float>(d[1]), static_cast<float>(d[2]) };
      const std::array<float, 3> kept = vtkMTMadeNormals::GetNormal(vtkMTMadeNormals::GetPlace(normal, bits), bits);
      worst = std::max(worst, GetAngle({ normal[0], normal[1], normal[2] }, { kept[0], kept[1], kept[2] }));
    }
    const double promised = vtkMTMadeNormals::GetRounding(bits);
    std::printf("%d bits: %.6f degrees, promised %.6f\n", bits, worst * 57.29578, promised * 57.29578);
    EXPECT_LE(worst, promised);
    EXPECT_GE(worst, 0.8 * promised);
  }
}

TEST(MadeNormals, TermsAreUnitNormalsByAngles)
{
  Random random(2);
  double worst = 0.0;
  for (const std::int32_t size : { 3, 1000, 1 << 23, 1 << 30 })
  {
    for (int i = 0; i < 20000; ++i)
    {
      const std::array<vtkMTPoint, 3> x{ DrawPoint(random, size), DrawPoint(random, size), DrawPoint(random, size) };
      const Terms terms = GetTerms(x[0], x[1], x[2]);
      for (std::size_t c = 0; c < 3; ++c)
      {
        Vector u;
        Vector v;
        for (std::size_t k = 0; k < 3; ++k)
        {
          u[k] = static_cast<double>(x[(c + 1) % 3][k]) - x[c][k];
          v[k] = static_cast<double>(x[(c + 2) % 3][k]) - x[c][k];
        }
        const Vector normal = Cross(u, v);
        const double length = std::sqrt(Dot(normal, normal));
        const double angle = GetAngle(u, v);
        for (std::size_t k = 0; k < 3; ++k)
        {
          const double expected = length > 0.0 ? normal[k] / length * angle : 0.0;
          worst = std::max(worst, std::abs(terms[c][k] / 131072.0 - expected));
        }
      }
    }
  }
  std::printf("largest error of a term: %.2e\n", worst);
  EXPECT_LT(worst, 3e-5);
}

// Whole numbers, so that fragments and patches, which have the triangles in other orders, find the same sums.
TEST(MadeNormals, SumsDoNotDependOnTheOrderOfTrianglesNorOnTheirFirstCorners)
{
  Random random(3);
  for (int round = 0; round < 50; ++round)
  {
    const vtkMTPatch mesh = DrawMesh(random, round % 2 ? 1 << 23 : 10);
    std::vector<vtkMTMadeNormals::Sum> sums;
    vtkMTMadeNormals::GetSums(mesh, true, sums);
    vtkMTPatch other = mesh;
    for (std::size_t i = other.Triangles.size(); i > 1; --i)
    {
      std::swap(other.Triangles[i - 1], other.Triangles[random.Below(i)]);
    }
    for (vtkMTTriangle& t : other.Triangles)
    {
      std::rotate(t.begin(), t.begin() + static_cast<std::ptrdiff_t>(random.Below(3)), t.end());
    }
    std::vector<vtkMTMadeNormals::Sum> others;
    vtkMTMadeNormals::GetSums(other, true, others);
    EXPECT_EQ(sums, others);
    for (vtkMTTriangle& t : other.Triangles)
    {
      std::swap(t[0], t[1]);
    }
    vtkMTMadeNormals::GetSums(other, true, others);
    for (vtkMTMadeNormals::Sum& sum : others)
    {
      sum = { -sum[0], -sum[1], -sum[2] };
    }
    EXPECT_EQ(sums, others) << "reversed";
  }
}

// Blocks are computed several triangles at once.
TEST(MadeNormals, ManyTrianglesAtOnceAreAsOneAfterTheOther)
{
  Random random(4);
  for (int round = 0; round < 20; ++round)
  {
    vtkMTPatch mesh = DrawMesh(random, 1 << 20);
    mesh.Triangles.resize(1 + random.Below(500));
    mesh.WedgePoints.resize(90);
    for (std::uint32_t& point : mesh.WedgePoints)
    {
      point = static_cast<std::uint32_t>(random.Below(60));
    }
    for (vtkMTTriangle& t : mesh.Triangles)
    {
      t[random.Below(3)] = static_cast<std::uint32_t>(random.Below(90));
    }
    for (const bool ofPoints : { false, true })
    {
      std::vector<vtkMTMadeNormals::Sum> expected(ofPoints ? 60 : 90, vtkMTMadeNormals::Sum{ 0, 0, 0 });
      for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
      {
        const vtkMTTriangle p = mesh.GetPointsOfTriangle(t);
        const Terms terms = GetTerms(mesh.Points[p[0]], mesh.Points[p[1]], mesh.Points[p[2]]);
        for (std::size_t c = 0; c < 3; ++c)
        {
          for (std::size_t k = 0; k < 3; ++k)
          {
            expected[ofPoints ? p[c] : mesh.Triangles[t][c]][k] += static_cast<std::int64_t>(terms[c][k]);
          }
        }
      }
      std::vector<vtkMTMadeNormals::Sum> sums;
      vtkMTMadeNormals::GetSums(mesh, ofPoints, sums);
      EXPECT_EQ(sums, expected);
      std::vector<std::uint16_t> u;
      std::vector<std::uint16_t> v;
      vtkMTMadeNormals::GetPlaces(mesh, ofPoints, 13, u, v);
      ASSERT_EQ(u.size(), sums.size());
      for (std::size_t i = 0; i < sums.size(); ++i)
      {
        EXPECT_EQ((vtkMTMadeNormals::Place{ u[i], v[i] }), vtkMTMadeNormals::GetPlace(sums[i], 13));
      }
    }
  }
}

// Few triangles are summed in 32 bits, many in 64.
TEST(MadeNormals, AFanOfAnyNumberOfTrianglesHasTheSumOfThem)
{
  for (const std::uint32_t count : { 100u, 4999u, 5000u, 5001u, 100000u })
  {
    // A screw: all triangles have the same two edges at the middle, and nearly a straight angle.
    vtkMTPatch mesh;
    mesh.Points = { { 0, 0, 0 }, { -1000, 1, 0 }, { 1000, 1, 0 } };
    mesh.Triangles.assign(count, { 0, 2, 1 });
    std::vector<vtkMTMadeNormals::Sum> sums;
    vtkMTMadeNormals::GetSums(mesh, true, sums);
    const Terms terms = GetTerms(mesh.Points[0], mesh.Points[2], mesh.Points[1]);
    EXPECT_EQ(sums[0][2], static_cast<std::int64_t>(terms[0][2]) * count);
    EXPECT_GT(terms[0][2] / 131072.0, 3.13);
    std::vector<std::uint16_t> u;
    std::vector<std::uint16_t> v;
    vtkMTMadeNormals::GetPlaces(mesh, true, 12, u, v);
    EXPECT_EQ((vtkMTMadeNormals::Place{ u[0], v[0] }), (vtkMTMadeNormals::Place{ 2047, 2047 })) << count;
  }
}

// Files hold differences to these numbers: another one would be another normal in every file.
TEST(MadeNormals, AreTheSameToTheLastBitOnEveryMachine)
{
  Random random(5);
  std::uint64_t hash = 14695981039346656037u;
  const auto add = [&hash](std::uint64_t x) { hash = (hash ^ x) * 1099511628211u; };
  for (int round = 0; round < 20; ++round)
  {
    const vtkMTPatch mesh = DrawMesh(random, (1 << round) + 2);
    std::vector<vtkMTMadeNormals::Sum> sums;
    vtkMTMadeNormals::GetSums(mesh, true, sums);
    for (const vtkMTMadeNormals::Sum& sum : sums)
    {
      add(static_cast<std::uint64_t>(sum[0]));
      add(static_cast<std::uint64_t>(sum[1]));
      add(static_cast<std::uint64_t>(sum[2]));
      const vtkMTMadeNormals::Place place = vtkMTMadeNormals::GetPlace(sum, 16);
      add(place[0]);
      add(place[1]);
    }
  }
  std::printf("%llu\n", static_cast<unsigned long long>(hash));
  EXPECT_EQ(hash, 9815313859221331531u);
}

TEST(MadeNormals, TheTriangulationOfAFlatPartHasNoInfluence)
{
  // A cube's corner whose three sides are split into one triangle, two and a fan of five.
  const std::int32_t a = 1 << 20;
  vtkMTPatch mesh;
  mesh.Points = { { 0, 0, 0 }, { a, 0, 0 }, { 0, a, 0 }, { 0, 0, a }, { a, a, 0 } };
  mesh.Triangles = { { 0, 2, 4 }, { 0, 4, 1 }, { 0, 3, 2 } };
  std::uint32_t last = 1;
  for (std::int32_t i = 1; i < 5; ++i)
  {
    mesh.Points.push_back({ a, 0, i * a / 9 });
    mesh.Triangles.push_back({ 0, last, static_cast<std::uint32_t>(mesh.Points.size() - 1) });
    last = static_cast<std::uint32_t>(mesh.Points.size() - 1);
  }
  mesh.Triangles.push_back({ 0, last, 3 });
  std::vector<vtkMTMadeNormals::Sum> sums;
  vtkMTMadeNormals::GetSums(mesh, true, sums);
  const Vector sum{ static_cast<double>(sums[0][0]), static_cast<double>(sums[0][1]), static_cast<double>(sums[0][2]) };
  const double angle = GetAngle(sum, { -1.0, -1.0, -1.0 });
  std::printf("off by %.5f degrees\n", angle * 57.29578);
  EXPECT_LT(angle, 0.01 / 57.29578);
  EXPECT_EQ(vtkMTMadeNormals::GetNormal(vtkMTMadeNormals::GetPlace(vtkMTMadeNormals::Sum{ 0, 0, 0 }, 12), 12),
    (std::array<float, 3>{ 0.0f, 0.0f, 1.0f }));
}

TEST(MadeNormals, BitsOfAnArrayAreWithinTheirRange)
{
  vtkMTArrayInfo info;
  EXPECT_EQ(vtkMTMadeNormals::GetBits(info), 12);
  for (int bits = vtkMTMadeNormals::MinimumBits; bits <= vtkMTMadeNormals::MaximumBits; ++bits)
  {
    vtkMTMadeNormals::SetBits(bits, info);
    EXPECT_EQ(vtkMTMadeNormals::GetBits(info), bits);
  }
  for (const char* text : { "", "5", "17", "-8", "8.5", "99999999999999999999", "1e1", " 8" })
  {
    info.Properties["normal_bits"] = text;
    EXPECT_EQ(vtkMTMadeNormals::GetBits(info), 12) << text;
  }
}
