// SPDX-License-Identifier: BSD-3-Clause
// Regions of one mesh, each simplified without knowing of the others, fit together again, in any mixture with their
// floors.
#include "SimplificationTesting.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <limits>

using namespace SimplificationTesting;
using MTTestMeshes::Random;

namespace
{
struct Region
{
  vtkMTPatch Floor;
  std::vector<std::uint32_t> Points; // the mesh's point of each of the floor's
  Locks Locked;
};

// Each triangle goes to the nearest of some random seeds.
std::vector<Region> Divide(const vtkMTPatch& mesh, std::size_t count, Random& random)
{
  std::vector<vtkMTPoint> seeds;
  for (std::size_t i = 0; i < count; ++i)
  {
    seeds.push_back(mesh.Points[mesh.Triangles[random.Below(mesh.Triangles.size())][0]]);
  }
  std::vector<Region> regions(count);
  std::vector<std::uint32_t> regionOfPoint(mesh.Points.size(), std::numeric_limits<std::uint32_t>::max());
  std::vector<bool> shared(mesh.Points.size(), false);
  std::vector<std::uint32_t> regionOfTriangle;
  for (const vtkMTTriangle& t : mesh.Triangles)
  {
    double least = std::numeric_limits<double>::max();
    std::uint32_t nearest = 0;
    for (std::uint32_t s = 0; s < count; ++s)
    {
      double sum = 0.0;
      for (int i = 0; i < 3; ++i)
      {
        const double middle =
          (static_cast<double>(mesh.Points[t[0]][i]) + mesh.Points[t[1]][i] + mesh.Points[t[2]][i]) / 3.0;
        sum += (middle - seeds[s][i]) * (middle - seeds[s][i]);
      }
      nearest = sum < least ? s : nearest;
      least = std::min(least, sum);
    }
    regionOfTriangle.push_back(nearest);
    for (const std::uint32_t p : t)
    {
      shared[p] = shared[p] || (regionOfPoint[p] < count && regionOfPoint[p] != nearest);
      regionOfPoint[p] = nearest;
    }
  }
  std::vector<std::map<std::uint32_t, std::uint32_t>> local(count);
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    const std::uint32_t r = regionOfTriangle[t];
    Region& region = regions[r];
    vtkMTTriangle triangle = mesh.Triangles[t];
    for (std::uint32_t& p : triangle)
    {
      const auto inserted = local[r].insert({ p, static_cast<std::uint32_t>(region.Points.size()) });
      if (inserted.second)
      {
        region.Points.push_back(p);
        region.Floor.Points.push_back(mesh.Points[p]);
        region.Locked.push_back(shared[p] ? 1 : 0);
      }
      p = inserted.first->second;
    }
    region.Floor.Triangles.push_back(triangle);
  }
  return regions;
}

// Simplifies each region and assembles the fragments by identity; with a coin, takes a region's floor instead.
void Step(std::vector<Region>& regions, int mode, Random& random, vtkMTPatch& mesh, vtkMTPatch& mixture)
{
  mesh.Triangles.clear();
  mixture = mesh;
  for (const Region& region : regions)
  {
    const Outcome outcome = Simplify(region.Floor, region.Locked, region.Floor.Triangles.size() / 2, mode);
    ASSERT_EQ(FindFault(region.Floor, region.Locked, outcome.Result), "");
    const bool coarse = random.Below(2) != 0;
    for (std::size_t p = 0; p < outcome.Result.Points.size(); ++p)
    {
      mesh.Points[region.Points[outcome.Result.PointOrigin[p]]] = outcome.Result.Points[p];
    }
    for (const vtkMTTriangle& t : outcome.Result.Triangles)
    {
      vtkMTTriangle global;
      for (int i = 0; i < 3; ++i)
      {
        global[i] = region.Points[outcome.Result.PointOrigin[outcome.Result.WedgePoints[t[i]]]];
      }
      mesh.Triangles.push_back(global);
      if (coarse)
      {
        mixture.Triangles.push_back(global);
      }
    }
    for (const vtkMTTriangle& t : region.Floor.Triangles)
    {
      if (!coarse)
      {
        mixture.Triangles.push_back({ region.Points[t[0]], region.Points[t[1]], region.Points[t[2]] });
      }
    }
  }
}

void SimplifyInRegions(const vtkMTPatch& start, int mode, std::uint64_t seed)
{
  Random random(seed);
  vtkMTPatch mesh = start;
  for (std::size_t count = 3 + random.Below(30); count > 0; count /= 2)
  {
    std::vector<Region> regions = Divide(mesh, count, random);
    vtkMTPatch mixture;
    Step(regions, mode, random, mesh, mixture);
    ASSERT_TRUE(IsClosedManifold(mesh)) << "seed " << seed << " with " << count << " regions";
    ASSERT_TRUE(IsClosedManifold(mixture)) << "seed " << seed << " with " << count << " regions";
  }
}
}

TEST(Regions, SimplifiedApartTheyMakeAClosedManifoldAtEveryLevel)
{
  const vtkMTPatch sphere = MakeFloor(MTTestMeshes::FractalSphere(3));
  const vtkMTPatch torus = MakeFloor(MTTestMeshes::Torus(24, 16));
  for (const int mode : AllModes)
  {
    const bool own = mode == vtkMTEdgeCollapse::FAST || mode == vtkMTEdgeCollapse::BEST;
    for (std::uint64_t seed = 0; seed < (own ? 60u : 15u); ++seed)
    {
      SimplifyInRegions(seed % 2 ? sphere : torus, mode, seed);
      ASSERT_FALSE(::testing::Test::HasFatalFailure()) << "mode " << mode;
    }
  }
}
