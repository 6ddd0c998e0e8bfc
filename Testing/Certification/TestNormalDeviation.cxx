// SPDX-License-Identifier: BSD-3-Clause
// Certified angles between shading normals, held against angles that are computed here.
#include "vtkMTDeviation.h"
#include "vtkMTNormalDeviation.h"
#include "vtkMTSurface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

namespace
{
using Vector = std::array<double, 3>;
using Normals = std::vector<std::array<float, 3>>;

double Dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector Minus(const Vector& a, const Vector& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

double Length(const Vector& a)
{
  return std::sqrt(Dot(a, a));
}

double GetAngle(const Vector& a, const Vector& b)
{
  const Vector cross{ a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
  return std::atan2(Length(cross), Dot(a, b));
}

// A place of a triangle, and the normal there.
struct Shaded
{
  Vector Place{ 0.0, 0.0, 0.0 };
  Vector Normal{ 0.0, 0.0, 0.0 };
};

Shaded GetPlace(const vtkMTPatch& mesh, const Normals& normals, std::size_t t, const Vector& weights)
{
  const vtkMTTriangle points = mesh.GetPointsOfTriangle(t);
  Shaded place;
  for (int c = 0; c < 3; ++c)
  {
    for (int i = 0; i < 3; ++i)
    {
      place.Place[i] += weights[c] * mesh.Points[points[c]][i];
      place.Normal[i] += weights[c] * normals[3 * t + c][i];
    }
  }
  return place;
}

std::vector<Vector> MakeWeights(int n)
{
  std::vector<Vector> weights;
  for (int i = 0; i <= n; ++i)
  {
    for (int j = 0; i + j <= n; ++j)
    {
      weights.push_back({ double(i) / n, double(j) / n, double(n - i - j) / n });
    }
  }
  return weights;
}

// Two grids of triangles over the unit square of 2^12 steps, the second one coarser: a wave of the given height, with
// the wave's own normals at the points.
void MakeWave(int n, int size, double height, vtkMTPatch& mesh, Normals& normals)
{
  const auto wave = [&](double x, double y) { return height * std::sin(x / size * 7.0) * std::cos(y / size * 5.0); };
  const auto getNormal = [&](double x, double y)
  {
    const double h = 1e-3 * size;
    const Vector n{ (wave(x - h, y) - wave(x + h, y)) / (2 * h), (wave(x, y - h) - wave(x, y + h)) / (2 * h), 1.0 };
    return std::array<float, 3>{ static_cast<float>(n[0] / Length(n)), static_cast<float>(n[1] / Length(n)),
      static_cast<float>(n[2] / Length(n)) };
  };
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      const int x = size * i / n;
      const int y = size * j / n;
      mesh.Points.push_back({ x, y, static_cast<std::int32_t>(std::lround(wave(x, y))) });
    }
  }
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      const auto a = static_cast<std::uint32_t>(j * (n + 1) + i);
      const auto c = static_cast<std::uint32_t>(a + n + 1);
      mesh.Triangles.push_back({ a, a + 1, c + 1 });
      mesh.Triangles.push_back({ a, c + 1, c });
    }
  }
  for (const vtkMTTriangle& t : mesh.Triangles)
  {
    for (const std::uint32_t p : t)
    {
      normals.push_back(getNormal(mesh.Points[p][0], mesh.Points[p][1]));
    }
  }
}

struct Tally
{
  std::size_t Broken = 0;
  double Certified = 0.0; // the largest bound
  double Sampled = 0.0;   // the largest angle to the best partner within the distance
};

// Every sample of one mesh has a partner on the other within the distance and the angle of the fragment's triangle: one
// and the same.
Tally Check(const vtkMTPatch& floor, const Normals& floorNormals, const vtkMTPatch& fragment, const Normals& normals,
  const vtkMTDeviation::Findings& findings)
{
  Tally tally;
  const std::vector<Vector> few = MakeWeights(3);
  const std::vector<Vector> many = MakeWeights(8);
  std::vector<Shaded> ofFloor;
  std::vector<Shaded> ofFragment;
  for (std::size_t t = 0; t < floor.Triangles.size(); ++t)
  {
    for (const Vector& w : many)
    {
      ofFloor.push_back(GetPlace(floor, floorNormals, t, w));
    }
  }
  for (std::size_t s = 0; s < fragment.Triangles.size(); ++s)
  {
    for (const Vector& w : many)
    {
      ofFragment.push_back(GetPlace(fragment, normals, s, w));
    }
  }
  // The partners are samples too: so far from the place that was meant, and so much of an angle, they may be.
  const auto getSize = [](const vtkMTPatch& mesh)
  {
    const double side = mesh.Points[1][0] - mesh.Points[0][0];
    return 1.5 * side / 8.0;
  };
  const auto test = [&](const Shaded& x, double distance, double angle, const std::vector<Shaded>& others,
                      std::size_t first, std::size_t last, double size)
  {
    double best = 4.0;
    for (std::size_t i = first; i < last; ++i)
    {
      if (Length(Minus(others[i].Place, x.Place)) <= distance + size)
      {
        best = std::min(best, GetAngle(others[i].Normal, x.Normal));
      }
    }
    return best <= angle + 0.02 ? best : best + 10.0;
  };
  for (std::size_t s = 0; s < fragment.Triangles.size(); ++s)
  {
    const vtkMTTriangleDeviation& found = findings.Deviations[s];
    const double angle = vtkMTNormalDeviation::ToRadians(found.NormalToInput);
    tally.Certified = std::max({ tally.Certified, angle, vtkMTNormalDeviation::ToRadians(found.NormalFromInput) });
    for (const Vector& w : few)
    {
      const double best =
        test(GetPlace(fragment, normals, s, w), found.ToInput, angle, ofFloor, 0, ofFloor.size(), getSize(floor));
      tally.Broken += best > 4.0 ? 1 : 0;
      tally.Sampled = std::max(tally.Sampled, best > 4.0 ? 0.0 : best);
    }
  }
  for (std::size_t t = 0; t < floor.Triangles.size(); ++t)
  {
    for (const Vector& w : few)
    {
      const Shaded x = GetPlace(floor, floorNormals, t, w);
      bool isFound = false;
      for (std::size_t s = 0; s < fragment.Triangles.size() && !isFound; ++s)
      {
        const vtkMTTriangleDeviation& found = findings.Deviations[s];
        isFound = test(x, found.FromInput, vtkMTNormalDeviation::ToRadians(found.NormalFromInput), ofFragment,
                    s * many.size(), (s + 1) * many.size(), getSize(fragment)) <= 4.0;
      }
      tally.Broken += isFound ? 0 : 1;
    }
  }
  return tally;
}

double Certify(const vtkMTPatch& floor, const Normals& floorNormals, const vtkMTPatch& fragment, const Normals& normals,
  const std::vector<vtkMTTriangleDeviation>& known, vtkMTDeviation::Findings& findings)
{
  const vtkMTPoint origin{ 0, 0, 0 };
  const vtkMTSurface floorSurface(floor, origin);
  const vtkMTSurface fragmentSurface(fragment, origin);
  vtkMTDeviation::Relation relation;
  relation.FloorDeviations = known;
  findings.KeepPairs = true;
  vtkMTDeviation::Between(floorSurface, fragmentSurface, relation, findings);
  return vtkMTNormalDeviation::Add({ floorSurface, floorNormals }, { fragmentSurface, normals }, { known }, findings)
    .Largest;
}
}

TEST(NormalDeviation, OfAnyTwoPointsWithinTheDistanceIsWithinTheBound)
{
  std::mt19937 random(3);
  std::uniform_int_distribution<int> place(0, 1000);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::normal_distribution<double> gauss;
  std::size_t tested = 0;
  std::size_t broken = 0;
  double tightest = 0.0;
  for (int round = 0; round < 4000; ++round)
  {
    std::array<vtkMTPatch, 2> meshes;
    std::array<Normals, 2> normals;
    const double spread = 0.6 * unit(random);
    for (int m = 0; m < 2; ++m)
    {
      for (int c = 0; c < 3; ++c)
      {
        meshes[m].Points.push_back({ place(random), place(random), place(random) / 10 });
        normals[m].push_back({ static_cast<float>(spread * gauss(random)), static_cast<float>(spread * gauss(random)),
          static_cast<float>(1.0 + 0.3 * spread * gauss(random)) });
      }
      meshes[m].Triangles.push_back({ 0, 1, 2 });
    }
    const double distance = 300.0 * unit(random) * unit(random);
    const vtkMTSurface a(meshes[0], { 0, 0, 0 });
    const vtkMTSurface b(meshes[1], { 0, 0, 0 });
    const double bound = vtkMTNormalDeviation::Between({ a, normals[0] }, 0, { b, normals[1] }, 0, distance);
    for (int sample = 0; sample < 60; ++sample)
    {
      std::array<Shaded, 2> places;
      for (int m = 0; m < 2; ++m)
      {
        const double u = unit(random);
        const double v = unit(random) * (1.0 - u);
        places[m] = GetPlace(meshes[m], normals[m], 0, { 1.0 - u - v, u, v });
      }
      if (Length(Minus(places[0].Place, places[1].Place)) <= distance)
      {
        const double angle = GetAngle(places[0].Normal, places[1].Normal);
        ++tested;
        broken += angle > bound ? 1 : 0;
        tightest = std::max(tightest, bound < 3.0 ? angle / bound : 0.0);
      }
    }
  }
  std::printf("%zu pairs of points, the largest angle over its bound %.3f\n", tested, tightest);
  EXPECT_GT(tested, 1000u);
  EXPECT_EQ(broken, 0u);
  EXPECT_GT(tightest, 0.5);
}

TEST(NormalDeviation, PartnersAreWithinDistanceAndAngleBothWays)
{
  for (const double height : { 0.0, 100.0, 400.0 })
  {
    vtkMTPatch floor;
    vtkMTPatch fragment;
    Normals floorNormals;
    Normals normals;
    MakeWave(16, 4096, height, floor, floorNormals);
    MakeWave(8, 4096, height, fragment, normals);
    vtkMTDeviation::Findings findings;
    const std::vector<vtkMTTriangleDeviation> known(floor.Triangles.size());
    const double largest = Certify(floor, floorNormals, fragment, normals, known, findings);
    const Tally tally = Check(floor, floorNormals, fragment, normals, findings);
    std::printf("height %.0f: certified %.4f, sampled %.4f\n", height, tally.Certified, tally.Sampled);
    EXPECT_EQ(tally.Broken, 0u);
    EXPECT_EQ(largest, tally.Certified);
    EXPECT_EQ(largest == 0.0, height == 0.0) << "the same normals everywhere are no deviation";
  }
}

TEST(NormalDeviation, DoesNotGrowWithTheCurvatureOfLargeTriangles)
{
  // Interpolated normals agree to second order: half the size, a quarter of the angle.
  double before = 0.0;
  for (const int n : { 8, 16, 32 })
  {
    vtkMTPatch floor;
    vtkMTPatch fragment;
    Normals floorNormals;
    Normals normals;
    MakeWave(2 * n, 1 << 20, 50000.0, floor, floorNormals);
    MakeWave(n, 1 << 20, 50000.0, fragment, normals);
    vtkMTDeviation::Findings findings;
    const std::vector<vtkMTTriangleDeviation> known(floor.Triangles.size());
    const double angle = Certify(floor, floorNormals, fragment, normals, known, findings);
    std::printf("%d cells: %.5f\n", n, angle);
    EXPECT_TRUE(before == 0.0 || angle < before / 3.0);
    before = angle;
  }
}

TEST(NormalDeviation, WhatIsKnownOfTheFloorIsAdded)
{
  vtkMTPatch mesh;
  Normals normals;
  MakeWave(4, 4096, 0.0, mesh, normals);
  std::vector<vtkMTTriangleDeviation> known(mesh.Triangles.size());
  vtkMTDeviation::Findings findings;
  EXPECT_EQ(Certify(mesh, normals, mesh, normals, known, findings), 0.0);
  known[7].NormalToInput = vtkMTNormalDeviation::RoundUp(0.5);
  known[9].NormalFromInput = vtkMTNormalDeviation::RoundUp(0.25);
  findings = vtkMTDeviation::Findings();
  EXPECT_NEAR(Certify(mesh, normals, mesh, normals, known, findings), 0.5, 1e-4);
  const auto toInput = [&](std::size_t s) { return findings.Deviations[s].NormalToInput; };
  EXPECT_EQ(toInput(7), known[7].NormalToInput);
  EXPECT_EQ(findings.Deviations[9].NormalFromInput, known[9].NormalFromInput);
  EXPECT_EQ(toInput(20) + findings.Deviations[20].NormalFromInput, 0) << "far from both";
}

TEST(NormalDeviation, OppositeAndMissingNormalsAreAStraightAngle)
{
  vtkMTPatch mesh;
  Normals normals;
  MakeWave(4, 4096, 0.0, mesh, normals);
  Normals turned = normals;
  turned[0] = { 0.0f, 0.0f, -1.0f };
  Normals none = normals;
  none[0] = none[1] = none[2] = { 0.0f, 0.0f, 0.0f };
  const std::vector<vtkMTTriangleDeviation> known(mesh.Triangles.size());
  for (const Normals& other : { turned, none })
  {
    vtkMTDeviation::Findings findings;
    EXPECT_EQ(Certify(mesh, normals, mesh, other, known, findings), vtkMTNormalDeviation::Pi);
    EXPECT_EQ(findings.Deviations[0].NormalToInput, 65535u);
    EXPECT_EQ(findings.Deviations[20].NormalToInput, 0u);
  }
  vtkMTDeviation::Findings findings;
  EXPECT_EQ(Certify(mesh, none, mesh, none, known, findings), vtkMTNormalDeviation::Pi) << "of both";
}

TEST(NormalDeviation, AnglesAreStoredRoundedUpAndDoNotDrift)
{
  for (unsigned units = 0; units <= 65535; ++units)
  {
    ASSERT_EQ(vtkMTNormalDeviation::RoundUp(vtkMTNormalDeviation::ToRadians(static_cast<std::uint16_t>(units))), units);
  }
  for (const double angle : { 1e-6, 0.1, 1.0, 3.0 })
  {
    EXPECT_GE(vtkMTNormalDeviation::ToRadians(vtkMTNormalDeviation::RoundUp(angle)), angle);
  }
  EXPECT_EQ(vtkMTNormalDeviation::RoundUp(4.0), 65535u);
}
