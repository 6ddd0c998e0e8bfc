// SPDX-License-Identifier: BSD-3-Clause
// The search for the worst place finds what is known, and certified errors that are too small.
#include "MTStiffLevels.h"
#include "MTStiffMeshes.h"
#include "MTStiffStudy.h"
#include "MTWorstPlace.h"

#include "vtkMTPatchStore.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace
{
using Place = MTWorstPlace::Place;

MTWorstPlace::Surface MakeSurface(const MTStiffMeshes::Mesh& mesh)
{
  MTWorstPlace::Surface surface;
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    surface.Points.emplace_back();
    mesh->GetPoint(p, surface.Points.back().data());
  }
  vtkNew<vtkIdList> corners;
  for (vtkIdType t = 0; t < mesh->GetNumberOfPolys(); ++t)
  {
    mesh->GetPolys()->GetCellAtId(t, corners);
    surface.Triangles.push_back({ static_cast<std::uint32_t>(corners->GetId(0)),
      static_cast<std::uint32_t>(corners->GetId(1)), static_cast<std::uint32_t>(corners->GetId(2)) });
  }
  return surface;
}

double GetLargest(const std::vector<double>& found)
{
  return *std::max_element(found.begin(), found.end());
}
}

// Corners, middles of edges and the barycentre of the triangle are all nearer than the place in between.
TEST(WorstPlace, IsFoundInsideATriangle)
{
  const MTWorstPlace::Surface triangle{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } } };
  // Small triangles at these places; what is farthest from all of them is known by looking at a fine grid of places.
  MTWorstPlace::Surface target;
  for (const Place& x : { Place{ 0, 0, 0 }, Place{ 1, 0, 0 }, Place{ 0, 1, 0 }, Place{ 0.5, 0, 0 },
         Place{ 0.5, 0.5, 0 }, Place{ 0, 0.5, 0 }, Place{ 1.0 / 3.0, 1.0 / 3.0, 0 } })
  {
    const auto first = static_cast<std::uint32_t>(target.Points.size());
    target.Points.insert(target.Points.end(), { x, { x[0] + 1e-9, x[1], x[2] }, { x[0], x[1] + 1e-9, x[2] } });
    target.Triangles.push_back({ first, first + 1, first + 2 });
  }
  const MTWorstPlace search(target);
  double expected = 0.0;
  for (int i = 0; i <= 1000; ++i)
  {
    for (int j = 0; i + j <= 1000; ++j)
    {
      expected = std::max(expected, search.GetDistance({ 1e-3 * i, 1e-3 * j, 0.0 }));
    }
  }
  const double sampled = GetLargest(search.Search(triangle, 0));
  const double climbed = GetLargest(search.Search(triangle, 1));
  std::printf(
    "a grid of half a million places: %.6f; without climbing %.6f, climbed %.6f\n", expected, sampled, climbed);
  EXPECT_LT(sampled, 0.1 * expected);
  EXPECT_NEAR(climbed, expected, 1e-3 * expected);
}

// The tree, edges and interiors apart, against every triangle in extended precision.
TEST(WorstPlace, DistancesAreThoseToTheNearestTriangle)
{
  for (const auto& mesh : { MTStiffMeshes::Spikes(1280), MTStiffMeshes::Slivers(1280, 1e8), MTStiffMeshes::Fan(500),
         MTStiffMeshes::Crumpled(1250) })
  {
    const MTWorstPlace::Surface surface = MakeSurface(mesh);
    const MTWorstPlace search(surface);
    std::vector<MTWorstPlace> single;
    for (const auto& triangle : surface.Triangles)
    {
      single.emplace_back(MTWorstPlace::Surface{
        { surface.Points[triangle[0]], surface.Points[triangle[1]], surface.Points[triangle[2]] }, { { 0, 1, 2 } } });
    }
    MTTestMeshes::Random random(3);
    double largest = 0.0;
    for (int i = 0; i < 30; ++i)
    {
      const Place x{ random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0) };
      double nearest = 1e300;
      for (const MTWorstPlace& triangle : single)
      {
        nearest = std::min(nearest, triangle.GetPreciseDistance(x));
      }
      largest = std::max(largest, std::abs(search.GetDistance(x) - nearest) / nearest);
      EXPECT_EQ(search.GetPreciseDistance(x), nearest);
    }
    std::printf("%d triangles: largest relative difference %g\n", static_cast<int>(single.size()), largest);
    EXPECT_LE(largest, 1e-9);
  }
}

TEST(WorstPlace, ErrorsThatAreTooSmallAreFound)
{
  const auto input = MTStiffMeshes::BumpySphere(1280);
  vtkMTPatchStore store;
  std::string error;
  ASSERT_TRUE(MTStiffStudy::Build(input, {}, store, error)) << error;
  const MTStiffStudy::Level sound = MTStiffLevels(input, store, 24, true).Measure(1, 1);
  for (vtkMTNode& node : store.GetMutableGraph().Nodes)
  {
    node.Error *= 0.85;
  }
  for (vtkMTArc& arc : store.GetMutableGraph().Arcs)
  {
    arc.ToInput *= 0.85f;
    arc.FromInput *= 0.85f;
  }
  const MTStiffStudy::Level planted = MTStiffLevels(input, store, 24, true).Measure(1, 1);
  std::printf("found over certified: %.4f and %.4f; errors planted: %.4f and %.4f\n", sound.ViolatedPatch,
    sound.ViolatedCut, planted.ViolatedPatch, planted.ViolatedCut);
  EXPECT_LE(std::max(sound.ViolatedPatch, sound.ViolatedCut), 1.0);
  EXPECT_GT(planted.ViolatedPatch, 1.0);
  EXPECT_GT(planted.ViolatedCut, 1.0);
}

TEST(WorstPlace, TrianglesThatAreTurnedAroundCountAsFlipped)
{
  const auto input = MTStiffMeshes::BumpySphere(1280);
  vtkMTPatchStore store;
  std::string error;
  ASSERT_TRUE(MTStiffStudy::Build(input, {}, store, error)) << error;
  EXPECT_EQ(MTStiffLevels(input, store, 0, true).Measure(1, 1).Flipped, 0);
  std::int64_t turned = 0;
  for (std::uint32_t arc = 0; arc < store.GetGraph().Arcs.size(); ++arc)
  {
    if (store.GetGraph().GetLevelOfArc(arc) == 1)
    {
      auto& triangle = store.GetMutablePatches()[arc].Triangles.front();
      std::swap(triangle[0], triangle[1]);
      ++turned;
    }
  }
  EXPECT_GT(turned, 0);
  const auto flipped = MTStiffLevels(input, store, 0, true).Measure(1, 1).Flipped;
  std::printf("%d of %d found\n", static_cast<int>(flipped), static_cast<int>(turned));
  EXPECT_GT(flipped, 0);
  EXPECT_LE(flipped, turned);
}
