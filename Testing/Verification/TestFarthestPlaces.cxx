// SPDX-License-Identifier: BSD-3-Clause
// The search that climbs from samples finds what they miss.
#include "MTTestMeshes.h"

#include "vtkMTClosestPoint.h"
#include "vtkMTFarthestPlaces.h"
#include "vtkMTSampledSurface.h"
#include "vtkMTSurfaceSampler.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace
{
using Places = vtkMTFarthestPlaces::Places;

bool GoOn(double)
{
  return true;
}

// Triangles side by side, each of area 0.5.
vtkMTSampledSurface MakeFlat(int count)
{
  vtkMTSampledSurface surface;
  for (int i = 0; i < count; ++i)
  {
    const auto first = static_cast<std::uint32_t>(surface.Points.size());
    const double x = 2.0 * i;
    surface.Points.insert(surface.Points.end(), { { x, 0.0, 0.0 }, { x + 1.0, 0.0, 0.0 }, { x, 1.0, 0.0 } });
    surface.Triangles.push_back({ first, first + 1, first + 2 });
  }
  return surface;
}

// Tiny triangles at random places over the others: what is farthest from all of them is a corner of a Voronoi diagram.
vtkMTSampledSurface MakeDots(int count, MTTestMeshes::Random& random)
{
  vtkMTSampledSurface surface;
  for (int i = 0; i < 5 * count; ++i)
  {
    const auto first = static_cast<std::uint32_t>(surface.Points.size());
    const double x = 2.0 * (i / 5) + random.Uniform(0.0, 1.0);
    const double y = random.Uniform(0.0, 1.0);
    surface.Points.insert(surface.Points.end(), { { x, y, 0.0 }, { x + 1e-9, y, 0.0 }, { x, y + 1e-9, 0.0 } });
    surface.Triangles.push_back({ first, first + 1, first + 2 });
  }
  return surface;
}

double GetFarthest(const vtkMTClosestPoint& search, std::uint32_t triangle)
{
  double farthest = 0.0;
  for (int i = 0; i <= 300; ++i)
  {
    for (int j = 0; i + j <= 300; ++j)
    {
      farthest = std::max(farthest, search.Find({ 2.0 * triangle + i / 300.0, j / 300.0, 0.0 }).Distance2);
    }
  }
  return std::sqrt(farthest);
}
}

TEST(FarthestPlaces, AreFoundFromAFewSamplesOfEachGroup)
{
  constexpr std::uint32_t Triangles = 40;
  MTTestMeshes::Random random(5);
  const vtkMTSampledSurface from = MakeFlat(Triangles);
  const vtkMTSampledSurface dots = MakeDots(Triangles, random);
  const vtkMTClosestPoint nearest(dots);
  const vtkMTFarthestPlaces search(from, nearest);
  const vtkMTSurfaceSampler::Samples samples = vtkMTSurfaceSampler(from, 15 * Triangles, 1).Take(0, 15 * Triangles);
  Places places;
  Places climbed;
  ASSERT_TRUE(search.Measure(samples.Points, samples.Triangles, places, GoOn));
  const auto getTriangle = [](const vtkMTFarthestPlaces::Place& place) { return place.Triangle; };
  ASSERT_TRUE(search.Climb(places, getTriangle, 4 * Triangles, climbed, GoOn));
  ASSERT_EQ(climbed.size(), 4 * Triangles);
  double worstSampled = 1.0;
  double worstClimbed = 1.0;
  for (std::uint32_t t = 0; t < Triangles; ++t)
  {
    const auto getLargest = [t](const Places& all)
    {
      double largest = 0.0;
      for (const vtkMTFarthestPlaces::Place& place : all)
      {
        largest = place.Triangle == t ? std::max(largest, place.Distance) : largest;
      }
      return largest;
    };
    const double farthest = GetFarthest(nearest, t);
    worstSampled = std::min(worstSampled, getLargest(places) / farthest);
    worstClimbed = std::min(worstClimbed, getLargest(climbed) / farthest);
  }
  std::printf("of what is farthest away samples find %.3f, and %.4f after climbing\n", worstSampled, worstClimbed);
  EXPECT_LT(worstSampled, 0.9);
  EXPECT_GT(worstClimbed, 0.9);
}

TEST(FarthestPlaces, AreInTheirTrianglesAndAsFarAwayAsTheySay)
{
  MTTestMeshes::Random random(6);
  const vtkMTSampledSurface from = MakeFlat(10);
  const vtkMTSampledSurface dots = MakeDots(10, random);
  const vtkMTClosestPoint nearest(dots);
  const vtkMTFarthestPlaces search(from, nearest);
  const vtkMTSurfaceSampler::Samples samples = vtkMTSurfaceSampler(from, 500, 2).Take(0, 500);
  Places places;
  Places climbed;
  ASSERT_TRUE(search.Measure(samples.Points, samples.Triangles, places, GoOn));
  ASSERT_TRUE(search.Climb(
    places, [](const vtkMTFarthestPlaces::Place&) { return 0; }, 50, climbed, GoOn));
  ASSERT_EQ(climbed.size(), 50u);
  for (const vtkMTFarthestPlaces::Place& place : climbed)
  {
    const double x = place.Point[0] - 2.0 * place.Triangle;
    EXPECT_GE(x, 0.0);
    EXPECT_GE(place.Point[1], 0.0);
    EXPECT_LE(x + place.Point[1], 1.0 + 1e-12);
    const vtkMTClosestPoint::Result found = nearest.Find(place.Point);
    EXPECT_EQ(place.Distance, std::sqrt(found.Distance2));
    EXPECT_EQ(place.Nearest, found.Triangle);
  }
}

TEST(FarthestPlaces, StopWhenAsked)
{
  MTTestMeshes::Random random(7);
  const vtkMTSampledSurface from = MakeFlat(3);
  const vtkMTSampledSurface dots = MakeDots(3, random);
  const vtkMTClosestPoint nearest(dots);
  const vtkMTFarthestPlaces search(from, nearest);
  Places places;
  Places climbed;
  EXPECT_FALSE(search.Measure({ { 0.1, 0.1, 0.0 } }, { 0 }, places, [](double) { return false; }));
  ASSERT_TRUE(search.Measure({ { 0.1, 0.1, 0.0 } }, { 0 }, places, GoOn));
  EXPECT_FALSE(search.Climb(
    places, [](const vtkMTFarthestPlaces::Place&) { return 0; }, 1, climbed, [](double) { return false; }));
}
