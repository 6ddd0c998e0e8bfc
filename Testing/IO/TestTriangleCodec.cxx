// SPDX-License-Identifier: BSD-3-Clause
// The codec of triangles alone: every set of triangles comes back, in few bits and in an order that suits a GPU, and no
// bytes do harm.
#include "MTTestMeshes.h"

#include "vtkMTTriangleCodec.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <string>

namespace
{
using MTTestMeshes::Random;
using vtkMTTriangleCodec::None;
using Triangles = std::vector<vtkMTTriangle>;

// Rows of columns x rows cells, closed or not in both directions; a closed one may be twisted.
Triangles MakeGrid(std::uint32_t columns, std::uint32_t rows, bool isClosedAcross, bool isClosedAlong, bool isTwisted)
{
  const std::uint32_t across = columns + (isClosedAcross ? 0 : 1);
  const std::uint32_t along = rows + (isClosedAlong ? 0 : 1);
  const auto at = [&](std::uint32_t x, std::uint32_t y)
  {
    const bool isOver = isTwisted && y == along;
    x %= across;
    return y % along * across + (isOver ? across - 1 - x : x);
  };
  Triangles triangles;
  for (std::uint32_t y = 0; y < rows; ++y)
  {
    for (std::uint32_t x = 0; x < columns; ++x)
    {
      triangles.push_back({ at(x, y), at(x + 1, y), at(x + 1, y + 1) });
      triangles.push_back({ at(x, y), at(x + 1, y + 1), at(x, y + 1) });
    }
  }
  return triangles;
}

// Any triangles of so few vertices that edges have many of them, and some are points or lines.
Triangles MakeSoup(Random& random)
{
  const std::uint64_t vertices = 1 + random.Below(30);
  Triangles triangles(random.Below(200));
  for (vtkMTTriangle& t : triangles)
  {
    for (std::uint32_t& v : t)
    {
      v = static_cast<std::uint32_t>(random.Below(vertices));
    }
  }
  return triangles;
}

// Triangles around one edge, and around one vertex.
Triangles MakeBook(std::uint32_t pages)
{
  Triangles triangles;
  for (std::uint32_t i = 0; i < pages; ++i)
  {
    triangles.push_back({ i % 2, 1 - i % 2, i + 2 });
    triangles.push_back({ 0, i + 2, i + 3 });
  }
  return triangles;
}

void Remove(Random& random, double share, Triangles& triangles)
{
  triangles.erase(std::remove_if(triangles.begin(), triangles.end(),
                    [&](const vtkMTTriangle& /*t*/) { return random.Uniform() < share; }),
    triangles.end());
}

void Shuffle(Random& random, Triangles& triangles)
{
  for (std::size_t i = triangles.size(); i > 1; --i)
  {
    std::swap(triangles[i - 1], triangles[random.Below(i)]);
  }
  for (vtkMTTriangle& t : triangles)
  {
    std::rotate(t.begin(), t.begin() + static_cast<std::ptrdiff_t>(random.Below(3)), t.end());
  }
}

Triangles MakeAny(Random& random)
{
  const auto size = [&random](std::uint64_t most) { return static_cast<std::uint32_t>(3 + random.Below(most)); };
  const auto flag = [&random] { return random.Below(2) != 0; };
  Triangles triangles = random.Below(5) == 0 ? MakeSoup(random)
    : random.Below(6) == 0                   ? MakeBook(size(60))
                                             : MakeGrid(size(30), size(30), flag(), flag(), flag());
  if (random.Below(12) == 0)
  {
    triangles = MakeGrid(3, 400, true, flag(), false); // a ring goes along it whose other end is far away
  }
  if (flag())
  {
    Remove(random, random.Uniform(), triangles);
  }
  Shuffle(random, triangles);
  return triangles;
}

std::uint32_t CountVertices(const Triangles& triangles)
{
  std::uint32_t count = 0;
  for (const vtkMTTriangle& t : triangles)
  {
    count = std::max({ count, t[0] + 1, t[1] + 1, t[2] + 1 });
  }
  return count;
}

vtkMTTriangle TurnLeastFirst(const vtkMTTriangle& t)
{
  return std::min({ t, vtkMTTriangle{ t[1], t[2], t[0] }, vtkMTTriangle{ t[2], t[0], t[1] } });
}

// By when they are met.
Triangles Number(const Triangles& triangles)
{
  std::map<std::uint32_t, std::uint32_t> numbers;
  Triangles result = triangles;
  for (vtkMTTriangle& t : result)
  {
    for (std::uint32_t& v : t)
    {
      v = numbers.insert({ v, static_cast<std::uint32_t>(numbers.size()) }).first->second;
    }
  }
  return result;
}

struct Result
{
  bool IsGood;
  Triangles Taken;
  std::vector<std::uint32_t> Owners;
};

Result Decode(std::vector<unsigned char> steps, std::vector<unsigned char> names, std::size_t triangles,
  std::size_t vertices, vtkMTTriangleCodec::Decoded& decoded)
{
  const std::size_t sizes[2] = { steps.size(), names.size() };
  steps.resize(steps.size() + 8, 0xa5);
  names.resize(names.size() + 8, 0x5a);
  Result result{
    vtkMTTriangleCodec::Decode(steps.data(), sizes[0], names.data(), sizes[1], triangles, vertices, decoded), {}, {}
  };
  for (std::size_t t = 0; result.IsGood && t < triangles; ++t)
  {
    const auto& four = decoded.Triangles[t];
    result.Taken.push_back({ four[0], four[1], four[2] });
    result.Owners.push_back(four[3]);
  }
  return result;
}

Triangles GetTriangles(const vtkMTTriangleCodec::Decoded& mesh)
{
  Triangles result;
  for (std::uint32_t t = 0; t < mesh.NumberOfTriangles; ++t)
  {
    const auto& four = mesh.Triangles[t];
    result.push_back({ four[0], four[1], four[2] });
  }
  return result;
}

// What the encoder says will be found, and what the decoder finds, apart from the triangles' vertices.
void ExpectSame(const vtkMTTriangleCodec::Decoded& foreseen, const vtkMTTriangleCodec::Decoded& decoded)
{
  EXPECT_EQ(foreseen.NumberOfTriangles, decoded.NumberOfTriangles);
  ASSERT_EQ(foreseen.NumberOfVertices, decoded.NumberOfVertices);
  for (std::uint32_t t = 0; t < foreseen.NumberOfTriangles; ++t)
  {
    EXPECT_EQ(foreseen.Triangles[t][3], decoded.Triangles[t][3]);
  }
  for (std::uint32_t v = 0; v < foreseen.NumberOfVertices; ++v)
  {
    const vtkMTTriangleCodec::Basis& a = foreseen.Bases[v];
    const vtkMTTriangleCodec::Basis& b = decoded.Bases[v];
    EXPECT_TRUE(a.A == b.A && a.B == b.B && a.C == b.C);
  }
  EXPECT_EQ(foreseen.Border, decoded.Border);
}

Triangles Apply(const Triangles& triangles, const std::vector<std::uint32_t>& order)
{
  Triangles result;
  for (const std::uint32_t t : order)
  {
    result.push_back(triangles[t]);
  }
  return result;
}

// Misses per triangle of a cache that keeps the vertices that were loaded last.
double CountMisses(const Triangles& triangles, std::size_t size)
{
  std::vector<std::uint32_t> cache;
  double misses = 0;
  for (const vtkMTTriangle& t : triangles)
  {
    for (const std::uint32_t v : t)
    {
      const auto begin = cache.end() - static_cast<std::ptrdiff_t>(std::min(size, cache.size()));
      if (std::find(begin, cache.end(), v) == cache.end())
      {
        cache.push_back(v);
        ++misses;
      }
    }
  }
  return misses / static_cast<double>(triangles.size());
}
}

TEST(TriangleCodec, AnyTrianglesComeBackInTheOrderOfTheirCode)
{
  vtkMTTriangleCodec::Decoded decoded; // what is left of one must not show in the next
  vtkMTTriangleCodec::Decoded foreseen;
  double bits = 0;
  double count = 0;
  for (std::uint64_t seed = 0; seed < 1500; ++seed)
  {
    Random random(seed);
    const Triangles triangles = MakeAny(random);
    const std::size_t vertices = CountVertices(triangles) + random.Below(3);
    const vtkMTTriangleCodec::Coded coded = vtkMTTriangleCodec::Encode(triangles, vertices, foreseen);

    Triangles expected = Apply(triangles, coded.Order);
    ASSERT_EQ(expected.size(), triangles.size());
    ASSERT_EQ(std::set<std::uint32_t>(coded.Order.begin(), coded.Order.end()).size(), triangles.size());
    std::transform(expected.begin(), expected.end(), expected.begin(), TurnLeastFirst);
    const Triangles inOrderOfUse = GetTriangles(foreseen);
    Triangles said = inOrderOfUse;
    for (vtkMTTriangle& t : said)
    {
      t = { coded.Vertices[t[0]], coded.Vertices[t[1]], coded.Vertices[t[2]] };
    }
    ASSERT_EQ(inOrderOfUse, Number(said)) << "seed " << seed;
    ASSERT_EQ(std::set<std::uint32_t>(coded.Vertices.begin(), coded.Vertices.end()).size(), vertices);
    std::transform(said.begin(), said.end(), said.begin(), TurnLeastFirst);
    ASSERT_EQ(said, expected) << "seed " << seed;

    const Result result = Decode(coded.Steps, coded.Names, triangles.size(), vertices, decoded);
    ASSERT_TRUE(result.IsGood) << "seed " << seed;
    ASSERT_EQ(result.Taken, inOrderOfUse) << "seed " << seed;
    ExpectSame(foreseen, decoded);
    for (std::size_t t = 0; t < triangles.size(); ++t)
    {
      ASSERT_TRUE(result.Owners[t] == None || result.Owners[t] < t) << "seed " << seed;
    }
    bits += 8.0 * static_cast<double>(coded.Steps.size() + coded.Names.size());
    count += static_cast<double>(triangles.size());
  }
  std::printf("%.0f triangles of all kinds, %.2f bits each\n", count, bits / count);
}

TEST(TriangleCodec, BorderHoldsWhatHasNothingAcrossLoopByLoop)
{
  vtkMTTriangleCodec::Decoded decoded;
  std::size_t edges[2] = {};
  std::size_t inside[2] = {};
  std::size_t alone[2] = {};
  for (std::uint64_t seed = 0; seed < 200; ++seed)
  {
    Random random(seed);
    const bool isDisk = seed % 2 == 0; // else there are holes, and several components
    Triangles triangles =
      MakeGrid(3 + static_cast<std::uint32_t>(random.Below(20)), 3 + static_cast<std::uint32_t>(random.Below(20)),
        !isDisk && random.Below(2) != 0, !isDisk && random.Below(2) != 0, false);
    Remove(random, isDisk ? 0.0 : random.Uniform(0.0, 0.3), triangles);
    Shuffle(random, triangles);
    const std::size_t vertices = CountVertices(triangles);
    const vtkMTTriangleCodec::Coded coded = vtkMTTriangleCodec::Encode(triangles, vertices, decoded);
    const Result result = Decode(coded.Steps, coded.Names, triangles.size(), vertices, decoded);
    ASSERT_TRUE(result.IsGood);
    std::set<std::pair<std::uint32_t, std::uint32_t>> directed;
    for (const vtkMTTriangle& t : result.Taken)
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        directed.insert({ t[c], t[(c + 1) % 3] });
      }
    }
    std::multiset<std::uint32_t> starts;
    std::set<std::pair<std::uint32_t, std::uint32_t>> border;
    for (const auto& edge : directed)
    {
      if (directed.count({ edge.second, edge.first }) == 0)
      {
        starts.insert(edge.first);
        border.insert(edge);
      }
    }
    const std::multiset<std::uint32_t> found(decoded.Border.begin(), decoded.Border.end());
    ASSERT_TRUE(std::includes(found.begin(), found.end(), starts.begin(), starts.end())) << "seed " << seed;
    // All but the last ones of the loops are followed by where their edge ends.
    std::size_t followed = 0;
    for (std::size_t i = 1; i < decoded.Border.size(); ++i)
    {
      followed += border.count({ decoded.Border[i - 1], decoded.Border[i] });
    }
    edges[isDisk] += border.size();
    inside[isDisk] += found.size() - starts.size();
    alone[isDisk] += border.size() - followed;
  }
  for (const bool isDisk : { true, false })
  {
    std::printf("%s: %zu edges of the border, %zu of them not followed by the next one, %zu edges that are inside\n",
      isDisk ? "disks" : "with holes", edges[isDisk], alone[isDisk], inside[isDisk]);
  }
  EXPECT_LT(alone[1], edges[1] / 10);
  EXPECT_LT(inside[1], edges[1] / 4);
}

TEST(TriangleCodec, SurfacesTakeFewBitsAndKeepToTheVertexCache)
{
  for (const std::uint32_t size : { 24u, 100u })
  {
    Random random(size);
    Triangles triangles = MakeGrid(size, size, false, false, false);
    // Diagonals as they come, so that vertices have four to eight neighbours.
    for (std::size_t i = 0; i < triangles.size(); i += 2)
    {
      if (random.Below(2) != 0)
      {
        const vtkMTTriangle a = triangles[i];
        const std::uint32_t d = triangles[i + 1][2];
        triangles[i] = { a[0], a[1], d };
        triangles[i + 1] = { a[1], a[2], d };
      }
    }
    Shuffle(random, triangles);
    vtkMTTriangleCodec::Decoded decoded;
    const vtkMTTriangleCodec::Coded coded = vtkMTTriangleCodec::Encode(triangles, CountVertices(triangles), decoded);
    const double bits =
      8.0 * static_cast<double>(coded.Steps.size() + coded.Names.size()) / static_cast<double>(triangles.size());
    const double misses = CountMisses(GetTriangles(decoded), 32);
    std::printf("%zu triangles: %.2f bits each, %.3f misses each (shuffled %.3f)\n", triangles.size(), bits, misses,
      CountMisses(triangles, 32));
    EXPECT_LT(bits, 2.5);
    EXPECT_LT(misses, 0.7);
  }
}

TEST(TriangleCodec, DamagedStepsAndNamesAreRefusedOrGiveTrianglesOfTheVertices)
{
  vtkMTTriangleCodec::Decoded decoded;
  int refused = 0;
  constexpr int damages = 20000;
  for (std::uint64_t seed = 0; seed < damages; ++seed)
  {
    Random random(seed);
    const Triangles triangles =
      MakeGrid(2 + static_cast<std::uint32_t>(random.Below(6)), 6, random.Below(2) != 0, false, false);
    const std::size_t vertices = CountVertices(triangles);
    vtkMTTriangleCodec::Coded coded = vtkMTTriangleCodec::Encode(triangles, vertices, decoded);
    for (std::uint64_t i = 1 + random.Below(4); i > 0; --i)
    {
      auto& bytes = random.Below(3) == 0 && !coded.Names.empty() ? coded.Names : coded.Steps;
      if (random.Below(8) == 0)
      {
        bytes.resize(random.Below(bytes.size() + 3));
      }
      else if (!bytes.empty())
      {
        bytes[random.Below(bytes.size())] = static_cast<unsigned char>(random.Below(256));
      }
    }
    const std::size_t wantedTriangles = triangles.size() + random.Below(3) - random.Below(2);
    const std::size_t wantedVertices = vertices + random.Below(3) - random.Below(2);
    const Result result = Decode(coded.Steps, coded.Names, wantedTriangles, wantedVertices, decoded);
    refused += result.IsGood ? 0 : 1;
    for (std::size_t t = 0; t < result.Taken.size(); ++t)
    {
      for (const std::uint32_t v : result.Taken[t])
      {
        ASSERT_LT(v, wantedVertices) << "seed " << seed;
      }
      ASSERT_TRUE(result.Owners[t] == None || result.Owners[t] < t) << "seed " << seed;
    }
    for (const std::uint32_t v : result.IsGood ? decoded.Border : std::vector<std::uint32_t>())
    {
      ASSERT_LT(v, wantedVertices) << "seed " << seed;
    }
  }
  std::printf("%d of %d refused\n", refused, damages);
  EXPECT_GT(refused, damages * 95 / 100);
}
