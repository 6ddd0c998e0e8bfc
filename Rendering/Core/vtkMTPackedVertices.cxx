// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPackedVertices.h"

#include "Processor/vtkMTWideProcessors.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>

namespace
{
constexpr std::size_t BlockSize = 128;

// All of them always have a direction.
struct Normals
{
  Normals() { std::fill(std::begin(this->Z), std::end(this->Z), 1.0f); }

  float X[BlockSize] = {};
  float Y[BlockSize] = {};
  float Z[BlockSize];
  std::uint32_t Codes[BlockSize] = {};
};

// What has no direction gets that along z.
inline void Set(Normals& normals, std::size_t i, const float normal[3])
{
  const float sum = std::abs(normal[0]) + std::abs(normal[1]) + std::abs(normal[2]);
  const bool isNormal = sum > 0.0f && sum <= std::numeric_limits<float>::max();
  normals.X[i] = isNormal ? normal[0] : 0.0f;
  normals.Y[i] = isNormal ? normal[1] : 0.0f;
  normals.Z[i] = isNormal ? normal[2] : 1.0f;
}

// On an even grid of 2 half + 1 points for each of two numbers of so many bits. No branches, so that several normals
// are encoded at once.
MT_FOR_WIDE_PROCESSORS void Encode(Normals& normals, float half, int bits)
{
  for (std::size_t i = 0; i < BlockSize; ++i)
  {
    const float sum = std::abs(normals.X[i]) + std::abs(normals.Y[i]) + std::abs(normals.Z[i]);
    float x = normals.X[i] / sum;
    float y = normals.Y[i] / sum;
    const float z = normals.Z[i] / sum;
    // The lower half is folded over the edges of the upper one.
    const float fold = 0.5f * (std::abs(z) - z);
    x += std::copysign(fold, x);
    y += std::copysign(fold, y);
    // NOLINTBEGIN(bugprone-incorrect-roundings): small numbers, none below 0
    const auto first = static_cast<std::int32_t>(half * x + half + 0.5f);
    const auto second = static_cast<std::int32_t>(half * y + half + 0.5f);
    // NOLINTEND(bugprone-incorrect-roundings)
    normals.Codes[i] = static_cast<std::uint32_t>(first) | static_cast<std::uint32_t>(second) << bits;
  }
}
}

//------------------------------------------------------------------------------
vtkMTPackedVertices vtkMTPackedVertices::ForBox(const vtkMTBox& box)
{
  vtkMTPackedVertices packed;
  std::int64_t widest = 0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    packed.Corner[i] = box[2 * i];
    widest = std::max(widest, std::int64_t(box[2 * i + 1]) - box[2 * i]);
  }
  int bits = 0;
  while (widest >> bits != 0)
  {
    ++bits;
  }
  const int left = std::min(32 - bits, MostShift);
  packed.Shift = left >= LeastShift ? left : 0;
  return packed;
}

//------------------------------------------------------------------------------
std::uint32_t vtkMTPackedVertices::EncodeNormal(const float normal[3]) const
{
  Normals one;
  Set(one, 0, normal);
  Encode(one, this->GetHalf(), this->GetNormalBits());
  return one.Codes[0];
}

//------------------------------------------------------------------------------
std::array<float, 3> vtkMTPackedVertices::DecodeNormal(std::uint32_t code) const
{
  const int bits = this->GetNormalBits();
  const float half = this->GetHalf();
  float x = static_cast<float>(code & ((1u << bits) - 1)) / half - 1.0f;
  float y = static_cast<float>(code >> bits) / half - 1.0f;
  const float z = 1.0f - std::abs(x) - std::abs(y);
  const float fold = std::max(-z, 0.0f);
  x -= std::copysign(fold, x);
  y -= std::copysign(fold, y);
  const float length = std::sqrt(x * x + y * y + z * z);
  return { x / length, y / length, z / length };
}

//------------------------------------------------------------------------------
bool vtkMTPackedVertices::Pack(const vtkMTPatch& patch, const float* normals, unsigned char* bytes) const
{
  const std::size_t wedges = patch.GetNumberOfWedges();
  const auto shift = static_cast<std::uint32_t>(this->Shift);
  const std::uint32_t mask = (1u << shift) - 1;
  std::uint32_t seen = 0; // all bits of all positions
  Normals block;
  for (std::size_t first = 0; first < wedges; first += BlockSize)
  {
    const std::size_t count = std::min(BlockSize, wedges - first);
    for (std::size_t i = 0; i < count; ++i)
    {
      Set(block, i, normals + 3 * (first + i));
    }
    Encode(block, this->GetHalf(), this->GetNormalBits());
    for (std::size_t i = 0; i < count; ++i)
    {
      const vtkMTPoint& point = patch.Points[patch.GetPointOfWedge(static_cast<std::uint32_t>(first + i))];
      const std::uint32_t code = block.Codes[i];
      // Unsigned: what lies below the corner becomes large, and so is seen to lie outside.
      const std::uint32_t x = static_cast<std::uint32_t>(point[0]) - static_cast<std::uint32_t>(this->Corner[0]);
      const std::uint32_t y = static_cast<std::uint32_t>(point[1]) - static_cast<std::uint32_t>(this->Corner[1]);
      const std::uint32_t z = static_cast<std::uint32_t>(point[2]) - static_cast<std::uint32_t>(this->Corner[2]);
      seen |= x | y | z;
      const std::uint32_t words[3] = { x << shift | (code & mask), y << shift | (code >> shift & mask),
        z << shift | (code >> 2 * shift & mask) };
      std::memcpy(bytes + Bytes * (first + i), words, Bytes);
    }
  }
  return seen >> (32 - shift) == 0;
}
