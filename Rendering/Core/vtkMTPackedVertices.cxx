// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPackedVertices.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

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
  const int bits = this->GetNormalBits();
  const float half = static_cast<float>((1 << (bits - 1)) - 1);
  const float sum = std::abs(normal[0]) + std::abs(normal[1]) + std::abs(normal[2]);
  float x = 0.0f;
  float y = 0.0f;
  if (sum > 0.0f && std::isfinite(sum))
  {
    x = normal[0] / sum;
    y = normal[1] / sum;
    if (normal[2] < 0.0f)
    {
      const float folded = std::copysign(1.0f - std::abs(y), x);
      y = std::copysign(1.0f - std::abs(x), y);
      x = folded;
    }
  }
  const auto toGrid = [half](float value) { return static_cast<std::uint32_t>(half * value + half + 0.5f); };
  return toGrid(x) | toGrid(y) << bits;
}

//------------------------------------------------------------------------------
std::array<float, 3> vtkMTPackedVertices::DecodeNormal(std::uint32_t code) const
{
  const int bits = this->GetNormalBits();
  const float half = static_cast<float>((1 << (bits - 1)) - 1);
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
std::vector<std::uint32_t> vtkMTPackedVertices::Pack(const vtkMTPatch& patch, const std::vector<float>& normals) const
{
  const std::size_t wedges = patch.GetNumberOfWedges();
  const std::uint32_t mask = (1u << this->Shift) - 1;
  std::vector<std::uint32_t> words(3 * wedges);
  std::uint64_t seen = 0; // all bits of all positions; a negative one has the highest
  for (std::size_t wedge = 0; wedge < wedges; ++wedge)
  {
    const vtkMTPoint& point = patch.Points[patch.GetPointOfWedge(static_cast<std::uint32_t>(wedge))];
    const std::uint32_t code = this->EncodeNormal(&normals[3 * wedge]);
    for (std::size_t i = 0; i < 3; ++i)
    {
      const auto above = static_cast<std::uint64_t>(std::int64_t(point[i]) - this->Corner[i]);
      seen |= above;
      words[3 * wedge + i] =
        static_cast<std::uint32_t>(above << this->Shift) | (code >> (i * static_cast<std::size_t>(this->Shift)) & mask);
    }
  }
  return seen >> (32 - this->Shift) == 0 ? words : std::vector<std::uint32_t>();
}
