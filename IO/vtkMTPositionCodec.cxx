// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPositionCodec.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace
{
using Triple = std::array<std::uint32_t, 3>; // coordinates modulo 2^32
constexpr std::uint32_t None = ~std::uint32_t(0);

Triple ToTriple(const vtkMTPoint& p)
{
  return { static_cast<std::uint32_t>(p[0]), static_cast<std::uint32_t>(p[1]), static_cast<std::uint32_t>(p[2]) };
}

std::uint32_t ToZigzag(std::uint32_t difference)
{
  return (difference << 1) ^ (0u - (difference >> 31));
}

std::uint32_t FromZigzag(std::uint32_t code)
{
  return (code >> 1) ^ (0u - (code & 1));
}

// Rounded to a multiple of 2^shift and counted in these, as signed numbers are shifted.
std::uint32_t Coarsen(std::uint32_t x, unsigned shift)
{
  return static_cast<std::uint32_t>(static_cast<std::int32_t>(x + (1u << (shift - 1))) >> shift);
}

// Walks over the points in stream order and says where each is expected. The visitor puts the point into points before
// it returns.
class Predictor
{
public:
  Predictor(const std::vector<vtkMTTriangle>& triangles, const std::vector<vtkMTPoint>& points)
    : Triangles(triangles)
    , Points(points)
    , Latest(points.size(), None)
  {
  }

  template <class Visit>
  void Run(const vtkMTPoint& corner, Visit&& visit)
  {
    std::uint32_t next = 0;
    Triple expected = ToTriple(corner);
    for (std::uint32_t t = 0; t < this->Triangles.size(); ++t)
    {
      const vtkMTTriangle& p = this->Triangles[t];
      for (int c = 0; c < 3; ++c)
      {
        if (p[c] == next)
        {
          visit(next, this->Expect(p[(c + 1) % 3], p[(c + 2) % 3], next, expected));
          expected = ToTriple(this->Points[next]);
          ++next;
        }
      }
      this->Latest[p[0]] = this->Latest[p[1]] = this->Latest[p[2]] = t;
    }
    for (; next < this->Points.size(); ++next) // no triangle uses these
    {
      visit(next, expected);
      expected = ToTriple(this->Points[next]);
    }
  }

private:
  // a and b are the other corners; those below `next` are known.
  Triple Expect(std::uint32_t a, std::uint32_t b, std::uint32_t next, const Triple& last) const
  {
    if (a >= next || b >= next)
    {
      return a < next ? ToTriple(this->Points[a]) : (b < next ? ToTriple(this->Points[b]) : last);
    }
    const Triple x = ToTriple(this->Points[a]);
    const Triple y = ToTriple(this->Points[b]);
    std::uint32_t across = this->FindAcross(this->Latest[a], a, b);
    across = across != None ? across : this->FindAcross(this->Latest[b], a, b);
    if (across == None || across >= next)
    {
      return x;
    }
    const Triple z = ToTriple(this->Points[across]);
    return { x[0] + y[0] - z[0], x[1] + y[1] - z[1], x[2] + y[2] - z[2] };
  }

  // The third corner of a triangle that has both a and b.
  std::uint32_t FindAcross(std::uint32_t triangle, std::uint32_t a, std::uint32_t b) const
  {
    if (triangle == None)
    {
      return None;
    }
    const vtkMTTriangle& t = this->Triangles[triangle];
    const auto has = [&t](std::uint32_t p) { return t[0] == p || t[1] == p || t[2] == p; };
    return has(a) && has(b) ? t[0] ^ t[1] ^ t[2] ^ a ^ b : None;
  }

  const std::vector<vtkMTTriangle>& Triangles;
  const std::vector<vtkMTPoint>& Points;
  std::vector<std::uint32_t> Latest; // the triangle that used a point last
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
Packed Encode(
  const std::vector<vtkMTPoint>& points, const std::vector<vtkMTTriangle>& triangles, const vtkMTPoint& corner)
{
  Packed packed;
  packed.Shift = ChooseShift(points);
  packed.Coarse.assign(packed.Shift > 0 ? (points.size() + 7) / 8 : 0, 0);
  std::array<std::vector<std::uint32_t>, 3> codes;
  for (auto& axis : codes)
  {
    axis.resize(points.size());
  }
  Predictor(triangles, points)
    .Run(corner,
      [&](std::uint32_t i, const Triple& expected)
      {
        const bool isCoarse = packed.Shift > 0 && CountZeros(points[i]) >= packed.Shift;
        if (isCoarse)
        {
          packed.Coarse[i / 8] |= static_cast<unsigned char>(1u << (i % 8));
        }
        for (int axis = 0; axis < 3; ++axis)
        {
          const std::uint32_t x = static_cast<std::uint32_t>(points[i][axis]);
          codes[axis][i] = ToZigzag(isCoarse
              ? static_cast<std::uint32_t>(points[i][axis] >> packed.Shift) - Coarsen(expected[axis], packed.Shift)
              : x - expected[axis]);
        }
      });
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

bool Decode(const Source& source, const std::vector<vtkMTTriangle>& triangles, const vtkMTPoint& corner,
  std::vector<vtkMTPoint>& points)
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
  std::vector<std::uint32_t> codes(3 * points.size());
  BitReader reader(source.Bits, source.BitsSize);
  ForBlocks(points.size(),
    [&](std::size_t block, int axis, std::size_t begin, std::size_t count) {
      reader.Get(codes.data() + static_cast<std::size_t>(axis) * points.size() + begin, count, source.Widths[block]);
    });
  const std::uint32_t* code = codes.data();
  const std::size_t stride = points.size();
  Predictor(triangles, points)
    .Run(corner,
      [&](std::uint32_t i, const Triple& expected)
      {
        const bool isCoarse = source.Shift > 0 && GetBit(source.Coarse, i);
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          const std::uint32_t difference = FromZigzag(code[axis * stride + i]);
          points[i][axis] =
            static_cast<std::int32_t>(isCoarse ? (Coarsen(expected[axis], source.Shift) + difference) << source.Shift
                                               : expected[axis] + difference);
        }
      });
  return true;
}
}
