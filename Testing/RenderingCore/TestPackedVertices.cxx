// SPDX-License-Identifier: BSD-3-Clause
// Packed vertices keep positions exactly and normals nearly.
#include "MTTestMeshes.h"

#include "vtkMTPackedVertices.h"
#include "vtkMTPatch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <limits>
#include <vector>

namespace
{
using Normal = std::array<float, 3>;

// A lattice's box that is so many steps wide, away from zero.
vtkMTBox MakeBox(std::int32_t widest)
{
  return { -7, widest - 7, 1000, 1010, -widest / 2, 0 };
}

double GetDegrees(const Normal& a, const Normal& b)
{
  const double x = double(a[1]) * b[2] - double(a[2]) * b[1];
  const double y = double(a[2]) * b[0] - double(a[0]) * b[2];
  const double z = double(a[0]) * b[1] - double(a[1]) * b[0];
  const double along = double(a[0]) * b[0] + double(a[1]) * b[1] + double(a[2]) * b[2];
  return std::atan2(std::sqrt(x * x + y * y + z * z), along) * 57.29577951308232;
}

Normal MakeNormal(MTTestMeshes::Random& random)
{
  const double z = 2.0 * random.Uniform() - 1.0;
  const double angle = 6.283185307179586 * random.Uniform();
  const double length = std::exp(20.0 * random.Uniform() - 10.0);
  const double r = std::sqrt(1.0 - z * z);
  return { static_cast<float>(length * r * std::cos(angle)), static_cast<float>(length * r * std::sin(angle)),
    static_cast<float>(length * z) };
}
}

TEST(PackedVertices, BoxesOfTwentyFiveBitsAreTheWidest)
{
  EXPECT_EQ(vtkMTPackedVertices::ForBox(MakeBox(1000)).Shift, vtkMTPackedVertices::MostShift);
  EXPECT_EQ(vtkMTPackedVertices::ForBox(MakeBox((1 << 24) - 1)).Shift, 8);
  EXPECT_EQ(vtkMTPackedVertices::ForBox(MakeBox(1 << 24)).Shift, 7);
  EXPECT_EQ(vtkMTPackedVertices::ForBox(MakeBox((1 << 25) - 1)).Shift, 7);
  EXPECT_EQ(vtkMTPackedVertices::ForBox(MakeBox(1 << 25)).Shift, 0);
  constexpr std::int32_t least = std::numeric_limits<std::int32_t>::min();
  constexpr std::int32_t most = std::numeric_limits<std::int32_t>::max();
  EXPECT_EQ(vtkMTPackedVertices::ForBox({ least, most, 0, 0, 0, 0 }).Shift, 0);
}

TEST(PackedVertices, NormalsAreOffByNoMoreThanIsSaid)
{
  // Half the diagonal of the grid's cell, where the octahedron's face is seen most aslant.
  const std::vector<std::pair<std::int32_t, double>> cases = { { (1 << 24) - 1, 0.06 }, { 1 << 24, 0.24 },
    { 1000, 0.0075 } };
  for (const auto& [widest, most] : cases)
  {
    const auto packing = vtkMTPackedVertices::ForBox(MakeBox(widest));
    MTTestMeshes::Random random(7);
    double largest = 0.0;
    for (int i = 0; i < 200000; ++i)
    {
      const Normal normal = MakeNormal(random);
      const std::uint32_t code = packing.EncodeNormal(normal.data());
      ASSERT_EQ(std::uint64_t(code) >> (2 * packing.GetNormalBits()), 0u);
      largest = std::max(largest, GetDegrees(normal, packing.DecodeNormal(code)));
    }
    std::cout << packing.GetNormalBits() << " bits: " << largest << " degrees at most\n";
    EXPECT_LE(largest, most);
    EXPECT_GT(largest, most / 3.0);
  }
}

TEST(PackedVertices, TheSmallestNormalsHaveDirectionsToo)
{
  const auto packing = vtkMTPackedVertices::ForBox(MakeBox(1000));
  const float tiny = std::numeric_limits<float>::denorm_min();
  const Normal normal{ 0.0f, 3.0f * tiny, -4.0f * tiny };
  EXPECT_LT(GetDegrees({ 0.0f, 3.0f, -4.0f }, packing.DecodeNormal(packing.EncodeNormal(normal.data()))), 0.01);
  const Normal largest{ 0.0f, 0.0f, -std::numeric_limits<float>::max() };
  EXPECT_EQ(packing.DecodeNormal(packing.EncodeNormal(largest.data())), (Normal{ 0.0f, 0.0f, -1.0f }));
}

TEST(PackedVertices, DirectionsAlongTheAxesAreExactAndNothingElseIsNoNumber)
{
  const auto packing = vtkMTPackedVertices::ForBox(MakeBox((1 << 24) - 1));
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    for (const float sign : { -1.0f, 1.0f })
    {
      Normal normal{ 0.0f, 0.0f, 0.0f };
      normal[axis] = sign * 3.0f;
      const Normal decoded = packing.DecodeNormal(packing.EncodeNormal(normal.data()));
      normal[axis] = sign;
      EXPECT_EQ(decoded, normal);
    }
  }
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinite = std::numeric_limits<float>::infinity();
  for (const Normal& normal : { Normal{ 0.0f, 0.0f, 0.0f }, Normal{ nan, 0.0f, 1.0f }, Normal{ infinite, 1.0f, 0.0f } })
  {
    EXPECT_EQ(packing.DecodeNormal(packing.EncodeNormal(normal.data())), (Normal{ 0.0f, 0.0f, 1.0f }));
  }
}

// What the shader does with the words.
TEST(PackedVertices, PositionsComeBackAndPlacesOutsideAreRefused)
{
  for (const std::int32_t widest : { 1000, (1 << 24) - 1, 1 << 24 })
  {
    const vtkMTBox box = MakeBox(widest);
    const auto packing = vtkMTPackedVertices::ForBox(box);
    MTTestMeshes::Random random(11);
    vtkMTPatch patch;
    std::vector<float> normals;
    for (int i = 0; i < 1000; ++i)
    {
      vtkMTPoint point;
      for (std::size_t k = 0; k < 3; ++k)
      {
        const auto width = static_cast<std::size_t>(box[2 * k + 1] - box[2 * k]);
        point[k] =
          box[2 * k] + static_cast<std::int32_t>(i < 2 ? width * static_cast<std::size_t>(i) : random.Below(width + 1));
      }
      patch.Points.push_back(point);
      const Normal normal = MakeNormal(random);
      normals.insert(normals.end(), normal.begin(), normal.end());
    }
    std::vector<std::uint32_t> words(3 * patch.Points.size());
    auto* bytes = reinterpret_cast<unsigned char*>(words.data());
    ASSERT_TRUE(packing.Pack(patch, normals.data(), bytes));
    const std::uint32_t mask = (1u << packing.Shift) - 1;
    for (std::size_t i = 0; i < patch.Points.size(); ++i)
    {
      std::uint32_t code = 0;
      for (std::size_t k = 0; k < 3; ++k)
      {
        const std::uint32_t word = words[3 * i + k];
        EXPECT_EQ(static_cast<std::int32_t>(word >> packing.Shift) + packing.Corner[k], patch.Points[i][k]);
        code |= (word & mask) << (k * static_cast<std::size_t>(packing.Shift));
      }
      EXPECT_EQ(code, packing.EncodeNormal(&normals[3 * i]));
    }
    patch.Points.back()[1] = box[2] - 1;
    EXPECT_FALSE(packing.Pack(patch, normals.data(), bytes));
  }
}
