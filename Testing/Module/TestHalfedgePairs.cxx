// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTHalfedgePairs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <random>
#include <utility>

namespace
{
// By the definition: the only two between their points, in opposite directions, third points different.
std::uint32_t FindSlowly(const std::vector<std::uint32_t>& corners, std::uint32_t h)
{
  const std::uint32_t a = corners[h];
  const std::uint32_t b = corners[vtkMTHalfedgePairs::Next(h)];
  std::uint32_t found = vtkMTHalfedgePairs::None;
  int others = 0;
  for (std::uint32_t k = 0; k < corners.size(); ++k)
  {
    const std::uint32_t c = corners[k];
    const std::uint32_t d = corners[vtkMTHalfedgePairs::Next(k)];
    if (k != h && ((c == a && d == b) || (c == b && d == a)))
    {
      ++others;
      const bool fits =
        c == b && d == a && corners[vtkMTHalfedgePairs::Previous(k)] != corners[vtkMTHalfedgePairs::Previous(h)];
      found = fits ? k : vtkMTHalfedgePairs::None;
    }
  }
  return others == 1 ? found : vtkMTHalfedgePairs::None;
}

// Of every edge, the half-edges that run along it either way.
using Uses = std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>>;
Uses FindUses(const std::vector<vtkMTTriangle>& triangles)
{
  Uses uses;
  for (std::uint32_t h = 0; h < 3 * triangles.size(); ++h)
  {
    const vtkMTTriangle& t = triangles[h / 3];
    uses[std::minmax({ t[h % 3], t[(h + 1) % 3] })].push_back(h);
  }
  return uses;
}

std::size_t CountWrong(const std::vector<vtkMTTriangle>& triangles, std::size_t points)
{
  const vtkMTHalfedgePairs pairs(triangles, points);
  std::size_t wrong = 0;
  for (const auto& [edge, uses] : FindUses(triangles))
  {
    std::size_t odd = 0;
    for (const std::uint32_t h : uses)
    {
      const std::uint32_t partner = pairs.Partners[h];
      odd += partner == vtkMTHalfedgePairs::Odd ? 1 : 0;
      const bool isRight = uses.size() == 1 ? partner == vtkMTHalfedgePairs::None
        : uses.size() == 2                  ? partner == uses[0] + uses[1] - h
                           : partner == vtkMTHalfedgePairs::Odd || partner == vtkMTHalfedgePairs::Other;
      wrong += isRight && pairs.HasPartner(h) == (uses.size() == 2) ? 0 : 1;
    }
    wrong += odd == (uses.size() > 2 ? uses.size() % 2 : 0) ? 0 : 1;
  }
  return wrong;
}
}

TEST(HalfedgePairs, PartnersAreTheOnlyTwoAtAnEdgeWhicheverWayTheyRun)
{
  std::mt19937 random(3);
  std::map<std::size_t, std::size_t> edges; // by their uses
  for (int round = 0; round < 300; ++round)
  {
    std::vector<vtkMTTriangle> triangles;
    for (int t = 0; t < 14; ++t)
    {
      const std::uint32_t a = random() % 6;
      const std::uint32_t b = (a + 1 + random() % 5) % 6;
      triangles.push_back({ a, b, 6 + std::uint32_t(random() % 3) });
    }
    ASSERT_EQ(CountWrong(triangles, 9), 0u) << "round " << round;
    for (const auto& edge : FindUses(triangles))
    {
      ++edges[edge.second.size()];
    }
  }
  for (const auto& [uses, count] : edges)
  {
    std::printf("%zu edges of %zu triangles\n", count, uses);
  }
  EXPECT_GT(edges[1] * edges[2] * edges[3] * edges[4] * edges[5], 0u);
}

// Half-edges of a hub are not looked at one by one: with 100,000 of them that would take minutes.
TEST(HalfedgePairs, OfAFanHoweverLargeAreFoundAsOfAnyMesh)
{
  for (const std::uint32_t n : { 10u, 1000u, 100000u })
  {
    std::vector<vtkMTTriangle> triangles;
    for (std::uint32_t i = 1; i <= n; ++i)
    {
      triangles.push_back({ 0, i, i % n + 1 });
    }
    triangles.push_back({ 0, 1, n + 1 }); // a third one
    EXPECT_EQ(CountWrong(triangles, n + 2), 0u) << n;
    std::shuffle(triangles.begin(), triangles.end(), std::mt19937(4));
    EXPECT_EQ(CountWrong(triangles, n + 2), 0u) << n << ", shuffled";
  }
}

TEST(HalfedgePairs, AreThoseOfTheDefinition)
{
  std::mt19937 random(1);
  std::size_t pairs = 0;
  for (int round = 0; round < 200; ++round)
  {
    // So few points that edges of three triangles, twins and repeated triangles are common.
    std::vector<std::uint32_t> corners;
    for (int t = 0; t < 12; ++t)
    {
      const std::uint32_t a = random() % 7;
      const std::uint32_t b = (a + 1 + random() % 6) % 7;
      std::uint32_t c = random() % 7;
      while (c == a || c == b)
      {
        c = (c + 1) % 7;
      }
      corners.insert(corners.end(), { a, b, c });
    }
    const std::vector<std::uint32_t> opposites = vtkMTHalfedgePairs::Find(corners);
    ASSERT_EQ(opposites.size(), corners.size());
    for (std::uint32_t h = 0; h < corners.size(); ++h)
    {
      EXPECT_EQ(opposites[h], FindSlowly(corners, h)) << "round " << round << ", half-edge " << h;
      pairs += opposites[h] != vtkMTHalfedgePairs::None ? 1 : 0;
    }
  }
  std::printf("%zu half-edges with an opposite\n", pairs);
  EXPECT_GT(pairs, 0u);
}

// The lists of edges become long here, so that all is found again from buckets; some of these are sorted.
TEST(HalfedgePairs, AtHubsAreThoseOfTheDefinition)
{
  std::mt19937 random(2);
  std::size_t pairs = 0;
  for (int round = 0; round < 40; ++round)
  {
    const std::uint32_t spokes = 10 + 2 * static_cast<std::uint32_t>(round);
    std::vector<std::uint32_t> corners;
    for (std::uint32_t i = 0; i < spokes; ++i)
    {
      const std::uint32_t a = 1 + i;
      const std::uint32_t b = 1 + (i + 1) % spokes;
      corners.insert(corners.end(), { 0, a, b });
      if (random() % 4 == 0) // a third triangle at an edge, a twin, or the same one again
      {
        const std::uint32_t kind = random() % 3;
        const std::uint32_t c = kind == 0 ? spokes + 1 + random() % 5 : 0;
        kind == 1 ? corners.insert(corners.end(), { c, b, a }) : corners.insert(corners.end(), { c, a, b });
      }
    }
    const std::vector<std::uint32_t> opposites = vtkMTHalfedgePairs::Find(corners);
    for (std::uint32_t h = 0; h < corners.size(); ++h)
    {
      EXPECT_EQ(opposites[h], FindSlowly(corners, h)) << "round " << round << ", half-edge " << h;
      pairs += opposites[h] != vtkMTHalfedgePairs::None ? 1 : 0;
    }
  }
  std::printf("%zu half-edges with an opposite\n", pairs);
  EXPECT_GT(pairs, 0u);
}

TEST(HalfedgePairs, OfAGridAreAllButItsBorder)
{
  constexpr std::uint32_t n = 20;
  std::vector<std::uint32_t> corners;
  for (std::uint32_t j = 0; j < n; ++j)
  {
    for (std::uint32_t i = 0; i < n; ++i)
    {
      const std::uint32_t a = j * (n + 1) + i;
      const std::uint32_t c = a + n + 1;
      corners.insert(corners.end(), { a, a + 1, c + 1, a, c + 1, c });
    }
  }
  std::size_t open = 0;
  for (const std::uint32_t opposite : vtkMTHalfedgePairs::Find(corners))
  {
    open += opposite == vtkMTHalfedgePairs::None ? 1 : 0;
  }
  EXPECT_EQ(open, 4 * n);
}
