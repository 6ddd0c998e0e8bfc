// SPDX-License-Identifier: BSD-3-Clause
// The search of triangles by edges: hubs give what others give, and do not take the square of their triangles.
#include "MTTestMeshes.h"

#include "vtkMTTriangleEdges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace
{
using MTTestMeshes::Random;
using Triangles = std::vector<vtkMTTriangle>;
using Corner = vtkMTTriangleEdges::Corner;

// What the class says, word for word.
Corner LookThroughAll(const Triangles& triangles, const vtkMTTriangleEdges& edges, std::uint32_t a, std::uint32_t b)
{
  const auto hasReverse = [&](const vtkMTTriangle& t)
  {
    const vtkMTTriangle back = { t[0], t[2], t[1] };
    return std::any_of(triangles.begin(), triangles.end(),
      [&](vtkMTTriangle other)
      {
        for (int i = 0; i < 3; ++i)
        {
          std::rotate(other.begin(), other.begin() + 1, other.end());
          if (other == back)
          {
            return true;
          }
        }
        return false;
      });
  };
  Corner first;
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
  {
    for (std::uint32_t c = 0; c < 3; ++c)
    {
      if (edges.IsFinished(t) || triangles[t][c] != a || triangles[t][(c + 1) % 3] != b)
      {
        continue;
      }
      if (hasReverse(triangles[t]))
      {
        return { t, c };
      }
      first = first.Triangle == vtkMTTriangleEdges::None ? Corner{ t, c } : first;
    }
  }
  return first;
}

Triangles MakeSoup(Random& random, std::uint32_t vertices)
{
  Triangles triangles(50 + random.Below(250));
  for (vtkMTTriangle& t : triangles)
  {
    for (std::uint32_t& v : t)
    {
      v = static_cast<std::uint32_t>(random.Below(vertices));
    }
  }
  return triangles;
}

// A fan around vertex 0, and pages at the edge of 0 and 1, on both sides.
Triangles MakeHub(std::uint32_t count)
{
  Triangles triangles;
  for (std::uint32_t i = 0; i < count; ++i)
  {
    triangles.push_back({ 0, 2 + i, 3 + i });
    triangles.push_back({ 0, 1, 2 + i });
    triangles.push_back({ 1, 0, 2 + i });
  }
  return triangles;
}
}

TEST(TriangleEdges, HubsGiveWhatALookThroughAllGives)
{
  std::size_t looks = 0;
  std::size_t found = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed)
  {
    Random random(seed);
    const auto vertices = static_cast<std::uint32_t>(2 + random.Below(12));
    const Triangles triangles = MakeSoup(random, vertices);
    vtkMTTriangleEdges edges(triangles, vertices);
    for (int i = 0; i < 300; ++i)
    {
      const auto a = static_cast<std::uint32_t>(random.Below(vertices));
      const auto b = static_cast<std::uint32_t>(random.Below(vertices));
      const Corner expected = LookThroughAll(triangles, edges, a, b);
      const Corner corner = edges.Find(a, b);
      ASSERT_EQ(corner.Triangle, expected.Triangle) << "seed " << seed;
      ASSERT_EQ(corner.Index, expected.Index) << "seed " << seed;
      if (corner.Triangle != vtkMTTriangleEdges::None)
      {
        edges.Finish(random.Below(2) ? corner.Triangle : static_cast<std::uint32_t>(random.Below(triangles.size())));
        ++found;
      }
    }
    looks += edges.GetNumberOfLooks();
  }
  std::printf("%zu found, %zu looks at corners of hubs\n", found, looks);
  EXPECT_GT(found, 5000u);
  EXPECT_GT(looks, 5000u) << "there were no hubs";
}

// Looked through, they would be 3 n (3 n) / 2: 10,000 times as many.
TEST(TriangleEdges, LooksAtHubsGrowLikeNLogN)
{
  for (const std::uint32_t count : { 2000u, 64000u })
  {
    const Triangles triangles = MakeHub(count);
    vtkMTTriangleEdges edges(triangles, count + 3);
    for (const vtkMTTriangle& t : triangles)
    {
      for (int c = 0; c < 3; ++c)
      {
        const Corner corner = edges.Find(t[c], t[(c + 1) % 3]);
        if (corner.Triangle != vtkMTTriangleEdges::None)
        {
          edges.Finish(corner.Triangle);
        }
      }
    }
    const auto n = static_cast<double>(triangles.size());
    const double perTriangle = static_cast<double>(edges.GetNumberOfLooks()) / n;
    std::printf("%.0f triangles: %.1f looks each\n", n, perTriangle);
    EXPECT_LT(perTriangle, 4.0 * std::log2(n));
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
    {
      ASSERT_TRUE(edges.IsFinished(t));
    }
  }
}
