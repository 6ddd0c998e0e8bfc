// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTHalfedgePairs.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <random>

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
