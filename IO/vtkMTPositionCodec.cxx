// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPositionCodec.h"

#include "vtkMTNumberCode.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace
{
using vtkMTNumberCode::FromZigzag;
using vtkMTNumberCode::ToZigzag;
using vtkMTTriangleCodec::None;

// Rounded to a multiple of 2^shift and counted in these, as signed numbers are shifted.
std::uint32_t Coarsen(std::uint32_t x, unsigned shift)
{
  return static_cast<std::uint32_t>(static_cast<std::int32_t>(x + (1u << (shift - 1))) >> shift);
}

// Three known points; the next one is expected at A + B - C.
struct Expectation
{
  const vtkMTPoint* A;
  const vtkMTPoint* B;
  const vtkMTPoint* C;

  Expectation(const std::vector<vtkMTPoint>& points, const vtkMTPositionCodec::Bases& bases, std::size_t i,
    const vtkMTPoint& corner)
  {
    const bool isBased = i < bases.size() && bases[i].A != None;
    this->A = isBased ? &points[bases[i].A] : (i > 0 ? &points[i - 1] : &corner);
    const bool hasThree = isBased && bases[i].C != None;
    this->B = hasThree ? &points[bases[i].B] : this->A;
    this->C = hasThree ? &points[bases[i].C] : this->A;
  }
  std::uint32_t Get(std::size_t axis) const
  {
    return static_cast<std::uint32_t>((*this->A)[axis]) + static_cast<std::uint32_t>((*this->B)[axis]) -
      static_cast<std::uint32_t>((*this->C)[axis]);
  }
};

// How many low bits are zero in all three coordinates.
unsigned CountZeros(const vtkMTPoint& p)
{
  const std::uint32_t bits = static_cast<std::uint32_t>(p[0]) | static_cast<std::uint32_t>(p[1]) |
    static_cast<std::uint32_t>(p[2]) | (1u << vtkMTPositionCodec::MaximumShift);
  return static_cast<unsigned>(__builtin_ctz(bits));
}

// The shift that saves most bits, each point's own one counted.
unsigned ChooseShift(const std::vector<vtkMTPoint>& points)
{
  std::array<std::size_t, vtkMTPositionCodec::MaximumShift + 1> counts{};
  for (const vtkMTPoint& p : points)
  {
    ++counts[CountZeros(p)];
  }
  unsigned best = 0;
  std::size_t mostSaved = points.size();
  std::size_t coarse = 0;
  for (unsigned shift = vtkMTPositionCodec::MaximumShift; shift > 0; --shift)
  {
    coarse += counts[shift];
    if (3 * shift * coarse > mostSaved)
    {
      mostSaved = 3 * shift * coarse;
      best = shift;
    }
  }
  return best;
}

bool GetBit(const unsigned char* bits, std::size_t i)
{
  return (bits[i / 8] >> (i % 8) & 1) != 0;
}

class BitWriter
{
public:
  explicit BitWriter(std::vector<unsigned char>& bytes)
    : Bytes(bytes)
  {
  }
  void Put(std::uint32_t value, unsigned width)
  {
    this->Pending |= std::uint64_t(value) << this->Count;
    for (this->Count += width; this->Count >= 8; this->Count -= 8)
    {
      this->Bytes.push_back(static_cast<unsigned char>(this->Pending));
      this->Pending >>= 8;
    }
  }
  void Finish()
  {
    if (this->Count > 0)
    {
      this->Bytes.push_back(static_cast<unsigned char>(this->Pending));
    }
  }

private:
  std::vector<unsigned char>& Bytes;
  std::uint64_t Pending = 0;
  unsigned Count = 0;
};

unsigned GetWidth(const std::uint32_t* values, std::size_t count)
{
  std::uint32_t all = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    all |= values[i];
  }
  return all == 0 ? 0 : 32 - static_cast<unsigned>(__builtin_clz(all));
}

// The numbers of one block after the other, x's, y's and z's.
template <class Use>
void ForBlocks(std::size_t points, Use&& use)
{
  std::size_t block = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (std::size_t begin = 0; begin < points; begin += vtkMTPositionCodec::BlockSize)
    {
      use(block++, axis, begin, std::min(vtkMTPositionCodec::BlockSize, points - begin));
    }
  }
}

class BitReader
{
public:
  BitReader(const unsigned char* bytes, std::size_t size)
    : Bytes(bytes)
    , Size(size)
  {
  }
  // The caller has made sure that the bits are there.
  void Get(std::uint32_t* values, std::size_t count, unsigned width)
  {
    const std::uint64_t mask = (std::uint64_t(1) << width) - 1;
    for (std::size_t i = 0; i < count; ++i, this->Position += width)
    {
      const std::size_t byte = this->Position / 8;
      std::uint64_t word = 0;
      std::memcpy(&word, this->Bytes + byte, byte + 8 <= this->Size ? 8 : this->Size - byte);
      values[i] = static_cast<std::uint32_t>(word >> (this->Position % 8) & mask);
    }
  }

private:
  const unsigned char* Bytes;
  std::size_t Size;
  std::size_t Position = 0;
};
}

namespace vtkMTPositionCodec
{
Packed Encode(const std::vector<vtkMTPoint>& points, const Bases& bases, const vtkMTPoint& corner)
{
  Packed packed;
  packed.Shift = ChooseShift(points);
  packed.Coarse.assign(packed.Shift > 0 ? (points.size() + 7) / 8 : 0, 0);
  std::array<std::vector<std::uint32_t>, 3> codes;
  for (auto& axis : codes)
  {
    axis.resize(points.size());
  }
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Expectation expected(points, bases, i, corner);
    const bool isCoarse = packed.Shift > 0 && CountZeros(points[i]) >= packed.Shift;
    if (isCoarse)
    {
      packed.Coarse[i / 8] |= static_cast<unsigned char>(1u << (i % 8));
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      const std::uint32_t x = static_cast<std::uint32_t>(points[i][axis]);
      codes[axis][i] = ToZigzag(isCoarse
          ? static_cast<std::uint32_t>(points[i][axis] >> packed.Shift) - Coarsen(expected.Get(axis), packed.Shift)
          : x - expected.Get(axis));
    }
  }
  BitWriter writer(packed.Bits);
  ForBlocks(points.size(),
    [&](std::size_t, int axis, std::size_t begin, std::size_t count)
    {
      const unsigned width = GetWidth(codes[axis].data() + begin, count);
      packed.Widths.push_back(static_cast<unsigned char>(width));
      for (std::size_t i = begin; i < begin + count; ++i)
      {
        writer.Put(codes[axis][i], width);
      }
    });
  writer.Finish();
  return packed;
}

bool Decode(const Source& source, const Bases& bases, const vtkMTPoint& corner, std::vector<vtkMTPoint>& points)
{
  std::size_t bits = 0;
  bool areWidthsRight = true;
  ForBlocks(points.size(),
    [&](std::size_t block, int, std::size_t, std::size_t count)
    {
      bits += source.Widths[block] * count;
      areWidthsRight = areWidthsRight && source.Widths[block] <= 32;
    });
  if (!areWidthsRight || source.BitsSize != (bits + 7) / 8)
  {
    return false;
  }
  const std::size_t stride = points.size();
  std::vector<std::uint32_t> codes(3 * stride);
  BitReader reader(source.Bits, source.BitsSize);
  ForBlocks(stride,
    [&](std::size_t block, int axis, std::size_t begin, std::size_t count)
    { reader.Get(codes.data() + static_cast<std::size_t>(axis) * stride + begin, count, source.Widths[block]); });
  for (std::size_t i = 0; i < stride; ++i)
  {
    const Expectation expected(points, bases, i, corner);
    const bool isCoarse = source.Shift > 0 && GetBit(source.Coarse, i);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const std::uint32_t difference = FromZigzag(codes[axis * stride + i]);
      points[i][axis] =
        static_cast<std::int32_t>(isCoarse ? (Coarsen(expected.Get(axis), source.Shift) + difference) << source.Shift
                                           : expected.Get(axis) + difference);
    }
  }
  return true;
}
}
