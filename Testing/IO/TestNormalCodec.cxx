// SPDX-License-Identifier: BSD-3-Clause
// Made normals as differences to what the triangles say: what comes back, what it takes, and what damage does.
#include "MTTestMeshes.h"

#include "vtkMTMadeNormals.h"
#include "vtkMTNormalCodec.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>

namespace
{
using MTTestMeshes::Random;
using Normal = std::array<float, 3>;
using Bytes = std::vector<unsigned char>;
constexpr std::size_t Slack = 8;

vtkMTColumn ToColumn(const std::vector<Normal>& normals)
{
  vtkMTColumn column(normals.size() * sizeof(Normal));
  std::memcpy(column.data(), normals.data(), column.size());
  return column;
}

Normal OnNet(const Normal& normal, int bits)
{
  return vtkMTMadeNormals::GetNormal(vtkMTMadeNormals::GetPlace(normal, bits), bits);
}

bool Decode(const Bytes& bytes, const vtkMTPatch& patch, vtkMTColumn& column)
{
  // A copy, so that what is read behind the slack is seen.
  std::vector<unsigned char> data(bytes);
  data.resize(bytes.size() + Slack, 0xff);
  return vtkMTNormalCodec::Decode(data.data(), bytes.size(), patch, column);
}

// A bumpy sheet of n x n cells, its points in any order; the first `shared` ones have ids.
vtkMTPatch MakeSheet(Random& random, std::uint32_t n, std::int32_t scale)
{
  vtkMTPatch patch;
  const std::uint32_t across = n + 1;
  for (std::uint32_t p = 0; p < across * across; ++p)
  {
    const auto jitter = [&]
    { return static_cast<std::int32_t>(random.Below(1 + static_cast<std::uint64_t>(scale) / 2)); };
    patch.Points.push_back({ static_cast<std::int32_t>(p % across) * scale + jitter(),
      static_cast<std::int32_t>(p / across) * scale + jitter(), jitter() });
  }
  for (std::uint32_t y = 0; y < n; ++y)
  {
    for (std::uint32_t x = 0; x < n; ++x)
    {
      const std::uint32_t a = y * across + x;
      patch.Triangles.push_back({ a, a + 1, a + across + 1 });
      patch.Triangles.push_back({ a, a + across + 1, a + across });
    }
  }
  return patch;
}

// What may be wrong with triangles, and what a patch may look like.
std::vector<vtkMTPatch> MakePatches(Random& random)
{
  std::vector<vtkMTPatch> patches;
  for (const std::int32_t scale : { 4, 1000, 1 << 22 })
  {
    patches.push_back(MakeSheet(random, 9, scale));
    vtkMTPatch degenerate = MakeSheet(random, 9, scale);
    for (std::size_t t = 0; t < degenerate.Triangles.size(); t += 3)
    {
      degenerate.Triangles[t][2] = degenerate.Triangles[t][random.Below(2)];
    }
    patches.push_back(degenerate);
    vtkMTPatch seams = MakeSheet(random, 9, scale);
    for (std::uint32_t p = 0; p < seams.Points.size(); ++p)
    {
      seams.WedgePoints.push_back(p);
      seams.WedgePoints.insert(seams.WedgePoints.end(), p % 5 == 0 ? 1 : 0, p);
    }
    for (vtkMTTriangle& t : seams.Triangles)
    {
      for (std::uint32_t& w : t)
      {
        const auto first = std::lower_bound(seams.WedgePoints.begin(), seams.WedgePoints.end(), w);
        w = static_cast<std::uint32_t>(first - seams.WedgePoints.begin()) +
          (w % 5 == 0 ? static_cast<std::uint32_t>(random.Below(2)) : 0u);
      }
    }
    patches.push_back(seams);
  }
  vtkMTPatch fan; // without area
  for (std::int32_t i = 0; i < 70; ++i)
  {
    fan.Points.push_back({ i, 2 * i, -i });
    fan.Triangles.push_back({ 0, static_cast<std::uint32_t>(i), static_cast<std::uint32_t>((i + 1) % 70) });
  }
  patches.push_back(fan);
  vtkMTPatch one;
  one.Points = { { 0, 0, 0 }, { 5, 0, 1 }, { 0, 7, 2 } };
  one.Triangles = { { 0, 1, 2 } };
  patches.push_back(one);
  vtkMTPatch sheets = one; // back to back: the sum is zero
  sheets.Triangles.push_back({ 0, 2, 1 });
  patches.push_back(sheets);
  for (vtkMTPatch& patch : patches)
  {
    patch.Ids.resize(random.Below(patch.Points.size() + 1));
  }
  vtkMTPatch points;
  points.Points.assign(65, { 1, 2, 3 });
  patches.push_back(points);
  return patches;
}

std::vector<Normal> DrawNormals(Random& random, std::size_t count)
{
  std::vector<Normal> normals(count);
  for (Normal& normal : normals)
  {
    const auto draw = [&] { return static_cast<float>(static_cast<double>(random.Below(2001)) / 1000.0 - 1.0); };
    normal = { draw(), draw(), draw() };
    // Places where the net is folded or cut open, too.
    for (float& x : normal)
    {
      x = random.Below(6) == 0 ? 0.0f : x;
    }
  }
  return normals;
}

// The normals of the mesh itself, by a sum of its own: doubles, arc tangents, triangle by triangle.
std::vector<Normal> GetOwnNormals(const vtkMTPatch& patch)
{
  std::vector<std::array<double, 3>> sums(patch.GetNumberOfWedges(), std::array<double, 3>{ 0.0, 0.0, 0.0 });
  for (std::size_t t = 0; t < patch.Triangles.size(); ++t)
  {
    const vtkMTTriangle p = patch.GetPointsOfTriangle(t);
    for (int c = 0; c < 3; ++c)
    {
      const vtkMTPoint& x = patch.Points[p[c]];
      const vtkMTPoint& y = patch.Points[p[(c + 1) % 3]];
      const vtkMTPoint& z = patch.Points[p[(c + 2) % 3]];
      std::array<double, 3> u;
      std::array<double, 3> v;
      for (int i = 0; i < 3; ++i)
      {
        u[i] = static_cast<double>(y[i]) - x[i];
        v[i] = static_cast<double>(z[i]) - x[i];
      }
      const std::array<double, 3> n{ u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0] };
      const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
      const double angle = std::atan2(length, u[0] * v[0] + u[1] * v[1] + u[2] * v[2]);
      for (int i = 0; i < 3 && length > 0.0; ++i)
      {
        sums[patch.Triangles[t][c]][i] += n[i] / length * angle;
      }
    }
  }
  std::vector<Normal> normals(sums.size());
  for (std::size_t i = 0; i < sums.size(); ++i)
  {
    const double length = std::sqrt(sums[i][0] * sums[i][0] + sums[i][1] * sums[i][1] + sums[i][2] * sums[i][2]);
    for (int k = 0; k < 3 && length > 0.0; ++k)
    {
      normals[i][k] = static_cast<float>(sums[i][k] / length);
    }
  }
  return normals;
}
}

TEST(NormalCodec, AnyNormalsOfAnyTrianglesComeBackAsTheirPlaces)
{
  Random random(1);
  std::size_t normals = 0;
  for (const int bits : { 6, 7, 11, 12, 13, 16 })
  {
    for (int round = 0; round < 20; ++round)
    {
      for (const vtkMTPatch& patch : MakePatches(random))
      {
        std::vector<Normal> drawn = DrawNormals(random, patch.GetNumberOfWedges());
        const std::vector<Normal> own = GetOwnNormals(patch);
        for (std::size_t w = 0; w < drawn.size(); ++w) // most of them near what is expected
        {
          drawn[w] = random.Below(4) == 0 ? drawn[w] : own[w];
        }
        Bytes bytes;
        vtkMTNormalCodec::Encode(ToColumn(drawn), patch, bits, bytes);
        for (Normal& normal : drawn)
        {
          normal = OnNet(normal, bits);
        }
        vtkMTColumn column;
        ASSERT_TRUE(Decode(bytes, patch, column));
        EXPECT_EQ(column, ToColumn(drawn)) << bits << " bits";
        Bytes again; // what is on the net stays where it is
        vtkMTNormalCodec::Encode(column, patch, bits, again);
        EXPECT_EQ(again, bytes);
        normals += drawn.size();
      }
    }
  }
  std::printf("%zu normals\n", normals);
}

TEST(NormalCodec, NormalsOfTheTrianglesTakeAByteForSixtyFour)
{
  Random random(2);
  vtkMTPatch patch = MakeSheet(random, 40, 100000);
  std::vector<vtkMTMadeNormals::Sum> sums;
  vtkMTMadeNormals::GetSums(patch, true, sums);
  std::vector<Normal> normals;
  for (const vtkMTMadeNormals::Sum& sum : sums)
  {
    normals.push_back(vtkMTMadeNormals::GetNormal(vtkMTMadeNormals::GetPlace(sum, 12), 12));
  }
  Bytes bytes;
  vtkMTNormalCodec::Encode(ToColumn(normals), patch, 12, bytes);
  std::printf("%zu bytes for %zu normals\n", bytes.size(), normals.size());
  EXPECT_EQ(bytes.size(), 8 + (normals.size() + 63) / 64);
  vtkMTColumn column;
  ASSERT_TRUE(Decode(bytes, patch, column));
  EXPECT_EQ(column, ToColumn(normals));
  // Those of arc tangents are the same but for some that are at the edge of a place.
  const std::vector<Normal> own = GetOwnNormals(patch);
  std::size_t others = 0;
  for (std::size_t i = 0; i < own.size(); ++i)
  {
    others += OnNet(own[i], 12) != normals[i] ? 1 : 0;
  }
  std::printf("%zu of %zu have another place by arc tangents\n", others, own.size());
  EXPECT_LT(others, own.size() / 10);
}

// One of two seams' normals are split, the other's are not: sums of wedges, or of points.
TEST(NormalCodec, TakesSumsOfPointsWhereSeamsAreOfOtherArrays)
{
  Random random(3);
  vtkMTPatch patch = MakePatches(random)[2];
  ASSERT_FALSE(patch.WedgePoints.empty());
  patch.Ids.clear();
  std::size_t sizes[2];
  for (const bool ofPoints : { false, true })
  {
    std::vector<vtkMTMadeNormals::Sum> sums;
    vtkMTMadeNormals::GetSums(patch, ofPoints, sums);
    std::vector<Normal> normals;
    for (std::uint32_t w = 0; w < patch.WedgePoints.size(); ++w)
    {
      const vtkMTMadeNormals::Sum& sum = sums[ofPoints ? patch.WedgePoints[w] : w];
      normals.push_back(vtkMTMadeNormals::GetNormal(vtkMTMadeNormals::GetPlace(sum, 12), 12));
    }
    Bytes bytes;
    vtkMTNormalCodec::Encode(ToColumn(normals), patch, 12, bytes);
    sizes[ofPoints ? 1 : 0] = bytes.size();
    EXPECT_EQ(bytes[1], ofPoints ? 1 : 0);
    vtkMTColumn column;
    ASSERT_TRUE(Decode(bytes, patch, column));
    EXPECT_EQ(column, ToColumn(normals));
  }
  EXPECT_EQ(sizes[0], 8 + (patch.WedgePoints.size() + 63) / 64);
  EXPECT_EQ(sizes[1], sizes[0]);
}

TEST(NormalCodec, DamagedSectionsAreRefusedOrAreNormals)
{
  Random random(4);
  const vtkMTPatch patch = MakeSheet(random, 12, 1000);
  const std::size_t wedges = patch.GetNumberOfWedges();
  Bytes good;
  vtkMTNormalCodec::Encode(ToColumn(DrawNormals(random, wedges)), patch, 12, good);
  std::size_t refused = 0;
  constexpr std::size_t rounds = 20000;
  for (std::size_t round = 0; round < rounds; ++round)
  {
    Bytes bytes = good;
    for (std::size_t i = 0; i <= random.Below(4); ++i)
    {
      const std::size_t place = random.Below(2) ? random.Below(16) : random.Below(bytes.size());
      bytes[place] = static_cast<unsigned char>(random.Below(256));
    }
    bytes.resize(random.Below(3) ? bytes.size() : random.Below(bytes.size() + 1));
    vtkMTColumn column;
    const bool isDone = Decode(bytes, patch, column);
    refused += isDone ? 0 : 1;
    for (std::size_t w = 0; isDone && w < wedges; ++w)
    {
      Normal normal;
      ASSERT_EQ(column.size(), wedges * sizeof(normal));
      std::memcpy(normal.data(), column.data() + w * sizeof(normal), sizeof(normal));
      const float length2 = normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2];
      ASSERT_TRUE(length2 == 0.0f || std::abs(length2 - 1.0f) < 1e-5f) << length2;
    }
  }
  std::printf("%zu of %zu refused\n", refused, rounds);
  EXPECT_GT(refused, rounds / 2);
  for (std::size_t size = 0; size < good.size(); ++size)
  {
    vtkMTColumn column;
    EXPECT_FALSE(Decode(Bytes(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(size)), patch, column)) << size;
  }
  Bytes longer = good;
  longer.push_back(0);
  vtkMTColumn column;
  EXPECT_FALSE(Decode(longer, patch, column)) << "a byte too many";
  for (std::size_t place = 0; place < 4; ++place) // bits, sums and what is reserved
  {
    Bytes bytes = good;
    bytes[place] = 17;
    EXPECT_FALSE(Decode(bytes, patch, column)) << place;
  }
}
