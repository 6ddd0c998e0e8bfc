// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTColumnCodec.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace
{
constexpr float HalfNet = 2047.0f;
constexpr std::uint16_t NoDirection = 4095;

// Made normals are packed as two numbers of two bytes.
bool IsDirection(const vtkMTArrayInfo& array)
{
  return array.Role == vtkMTArrayInfo::MadeNormals && array.GetTupleSize() == 3 * sizeof(float);
}

// Residuals have nothing to do with the ones before them.
bool IsResidual(const vtkMTArrayInfo& array)
{
  return array.Role == vtkMTArrayInfo::ExactPoints;
}

// What a tuple is made of, and whether differences to the tuple before are packed.
struct Layout
{
  std::size_t Tuples;
  std::size_t Components;
  std::size_t Size; // of a component
  bool HasDifferences;
};

template <class Number>
void PackNumbers(const unsigned char* values, const Layout& layout, unsigned char* packed)
{
  constexpr unsigned bits = 8 * sizeof(Number);
  const auto [tuples, components, size, hasDifferences] = layout;
  const std::size_t plane = tuples * components;
  for (std::size_t c = 0; c < components; ++c)
  {
    Number before = 0;
    for (std::size_t i = 0; i < tuples; ++i)
    {
      Number value;
      std::memcpy(&value, values + (i * components + c) * sizeof(Number), sizeof(Number));
      const Number difference = static_cast<Number>(value - before);
      const Number sign = static_cast<Number>(difference >> (bits - 1));
      const Number code = static_cast<Number>(static_cast<Number>(difference << 1) ^ static_cast<Number>(0 - sign));
      before = hasDifferences ? value : before;
      for (std::size_t byte = 0; byte < sizeof(Number); ++byte)
      {
        packed[byte * plane + c * tuples + i] = static_cast<unsigned char>(code >> (8 * byte));
      }
    }
  }
}

template <class Number>
void UnpackNumbers(const unsigned char* packed, const Layout& layout, unsigned char* values)
{
  const auto [tuples, components, size, hasDifferences] = layout;
  const Number mask = static_cast<Number>(hasDifferences ? ~Number(0) : 0);
  const std::size_t plane = tuples * components;
  for (std::size_t c = 0; c < components; ++c)
  {
    Number before = 0;
    for (std::size_t i = 0; i < tuples; ++i)
    {
      Number code = 0;
      for (std::size_t byte = 0; byte < sizeof(Number); ++byte)
      {
        code =
          static_cast<Number>(code | static_cast<Number>(Number(packed[byte * plane + c * tuples + i]) << (8 * byte)));
      }
      const Number sign = static_cast<Number>(code & 1);
      const Number value = static_cast<Number>(
        before + static_cast<Number>(static_cast<Number>(code >> 1) ^ static_cast<Number>(0 - sign)));
      std::memcpy(values + (i * components + c) * sizeof(Number), &value, sizeof(Number));
      before = static_cast<Number>(value & mask);
    }
  }
}

template <class Run1, class Run2, class Run4, class Run8>
void ForSize(std::size_t size, Run1&& run1, Run2&& run2, Run4&& run4, Run8&& run8)
{
  switch (size)
  {
    case 1:
      return run1();
    case 2:
      return run2();
    case 4:
      return run4();
    default:
      return run8();
  }
}

void PackPlain(const unsigned char* values, const Layout& layout, unsigned char* packed)
{
  ForSize(
    layout.Size, [&] { PackNumbers<std::uint8_t>(values, layout, packed); },
    [&] { PackNumbers<std::uint16_t>(values, layout, packed); },
    [&] { PackNumbers<std::uint32_t>(values, layout, packed); },
    [&] { PackNumbers<std::uint64_t>(values, layout, packed); });
}

void UnpackPlain(const unsigned char* packed, const Layout& layout, unsigned char* values)
{
  ForSize(
    layout.Size, [&] { UnpackNumbers<std::uint8_t>(packed, layout, values); },
    [&] { UnpackNumbers<std::uint16_t>(packed, layout, values); },
    [&] { UnpackNumbers<std::uint32_t>(packed, layout, values); },
    [&] { UnpackNumbers<std::uint64_t>(packed, layout, values); });
}

Layout GetLayout(const vtkMTArrayInfo& array, std::size_t tuples)
{
  const auto components = static_cast<std::size_t>(array.Components);
  return { tuples, components, array.GetTupleSize() / components, !IsResidual(array) };
}

Layout GetNetLayout(std::size_t tuples)
{
  return { tuples, 2, sizeof(std::uint16_t), true };
}

std::uint16_t ToNet(float x)
{
  return static_cast<std::uint16_t>(std::lround(std::clamp(x, -1.0f, 1.0f) * HalfNet) + 2047);
}
}

namespace vtkMTColumnCodec
{
std::array<std::uint16_t, 2> EncodeDirection(const std::array<float, 3>& d)
{
  const float sum = std::abs(d[0]) + std::abs(d[1]) + std::abs(d[2]);
  if (!(sum > 0.0f) || !std::isfinite(sum))
  {
    return { NoDirection, NoDirection };
  }
  float x = d[0] / sum;
  float y = d[1] / sum;
  if (d[2] < 0.0f)
  {
    const float folded = (1.0f - std::abs(y)) * (x < 0.0f ? -1.0f : 1.0f);
    y = (1.0f - std::abs(x)) * (y < 0.0f ? -1.0f : 1.0f);
    x = folded;
  }
  return { ToNet(x), ToNet(y) };
}

std::array<float, 3> DecodeDirection(const std::array<std::uint16_t, 2>& place)
{
  if (place[0] >= NoDirection || place[1] >= NoDirection)
  {
    return { 0.0f, 0.0f, 0.0f };
  }
  float x = (static_cast<float>(place[0]) - HalfNet) / HalfNet;
  float y = (static_cast<float>(place[1]) - HalfNet) / HalfNet;
  const float z = 1.0f - std::abs(x) - std::abs(y);
  if (z < 0.0f)
  {
    const float unfolded = (1.0f - std::abs(y)) * (x < 0.0f ? -1.0f : 1.0f);
    y = (1.0f - std::abs(x)) * (y < 0.0f ? -1.0f : 1.0f);
    x = unfolded;
  }
  const float length = std::sqrt(x * x + y * y + z * z);
  return { x / length, y / length, z / length };
}

std::uint64_t GetPackedSize(const vtkMTArrayInfo& array, std::uint64_t tuples)
{
  return tuples * (IsDirection(array) ? 2 * sizeof(std::uint16_t) : array.GetTupleSize());
}

std::vector<unsigned char> Pack(const vtkMTArrayInfo& array, const vtkMTColumn& column)
{
  const std::size_t tuples = column.size() / array.GetTupleSize();
  std::vector<unsigned char> packed(static_cast<std::size_t>(GetPackedSize(array, tuples)));
  if (!IsDirection(array))
  {
    PackPlain(column.data(), GetLayout(array, tuples), packed.data());
    return packed;
  }
  std::vector<std::array<std::uint16_t, 2>> places(tuples);
  for (std::size_t i = 0; i < tuples; ++i)
  {
    std::array<float, 3> direction;
    std::memcpy(direction.data(), column.data() + i * sizeof(direction), sizeof(direction));
    places[i] = EncodeDirection(direction);
  }
  PackPlain(reinterpret_cast<const unsigned char*>(places.data()), GetNetLayout(tuples), packed.data());
  return packed;
}

void Unpack(
  const vtkMTArrayInfo& array, const std::vector<unsigned char>& packed, std::size_t tuples, vtkMTColumn& column)
{
  column.resize(tuples * array.GetTupleSize());
  if (!IsDirection(array))
  {
    UnpackPlain(packed.data(), GetLayout(array, tuples), column.data());
    return;
  }
  std::vector<std::array<std::uint16_t, 2>> places(tuples);
  UnpackPlain(packed.data(), GetNetLayout(tuples), reinterpret_cast<unsigned char*>(places.data()));
  for (std::size_t i = 0; i < tuples; ++i)
  {
    const std::array<float, 3> direction = DecodeDirection(places[i]);
    std::memcpy(column.data() + i * sizeof(direction), direction.data(), sizeof(direction));
  }
}
}
