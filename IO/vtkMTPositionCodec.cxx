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

// Adds a difference to what is expected, in multiples of 2^shift where the point is coarse; the same steps either way,
// as nobody can guess which.
struct Rounding
{
  unsigned Shift;
  std::uint32_t Half;
  std::uint32_t Kept;

  Rounding(unsigned shift, bool isCoarse)
    : Shift(isCoarse ? shift : 0)
    , Half((1u << this->Shift) >> 1)
    , Kept(~std::uint32_t(0) << this->Shift)
  {
  }
  std::uint32_t Apply(std::uint32_t expected, std::uint32_t difference) const
  {
    return ((expected + this->Half) & this->Kept) + (difference << this->Shift);
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
  void Put(std::uint64_t value, unsigned width)
  {
    this->Pending |= value << this->Count;
    for (this->Count += width; this->Count >= 8; this->Count -= 8)
    {
      this->Bytes.push_back(static_cast<unsigned char>(this->Pending));
      this->Pending >>= 8;
    }
  }
  void PutCode(std::uint32_t code, unsigned parameter)
  {
    const unsigned ones = static_cast<unsigned>(std::uint64_t(code) >> parameter);
    this->Put((std::uint64_t(1) << ones) - 1, ones + 1);
    this->Put(code & ((std::uint64_t(1) << parameter) - 1), parameter);
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

// With which the codes take the fewest bits.
unsigned ChooseParameter(const std::uint32_t* codes, std::size_t count)
{
  const std::uint32_t largest = *std::max_element(codes, codes + count);
  unsigned best = 0;
  std::uint64_t fewest = ~std::uint64_t(0);
  for (unsigned k = 0; k <= 32; ++k)
  {
    if (std::uint64_t(largest) >> k > vtkMTPositionCodec::MostOnes)
    {
      continue;
    }
    std::uint64_t bits = std::uint64_t(k) * count;
    for (std::size_t i = 0; i < count; ++i)
    {
      bits += std::uint64_t(codes[i]) >> k;
    }
    best = bits < fewest ? k : best;
    fewest = std::min(bits, fewest);
  }
  return best;
}

class CodeReader
{
public:
  CodeReader(const unsigned char* bytes, std::size_t size)
    : Bytes(bytes)
    , Size(size)
  {
  }
  // Whether so many codes can be loaded without a look at the end, however long they are.
  bool HasCodes(std::size_t count) const { return this->Position / 8 + 8 * count + 8 <= this->Size; }
  std::uint32_t GetInside(unsigned parameter)
  {
    std::uint64_t word;
    std::memcpy(&word, this->Bytes + this->Position / 8, sizeof(word));
    return this->Cut(word, parameter);
  }
  // Behind the end there are zeros; IsAtEnd tells.
  std::uint32_t Get(unsigned parameter)
  {
    const std::size_t byte = this->Position / 8;
    std::uint64_t word = 0;
    if (byte < this->Size)
    {
      std::memcpy(&word, this->Bytes + byte, std::min(sizeof(word), this->Size - byte));
    }
    return this->Cut(word, parameter);
  }
  // Whether so many bits were there, and nothing but the zeros that fill the last byte are left.
  bool IsAtEnd() const
  {
    return this->Size == (this->Position + 7) / 8 && !this->HasTooMany &&
      (this->Position % 8 == 0 || this->Bytes[this->Size - 1] >> (this->Position % 8) == 0);
  }

private:
  // A bit that ends every run of ones.
  static constexpr std::uint64_t TooManyOnes = std::uint64_t(1) << (vtkMTPositionCodec::MostOnes + 1);

  std::uint32_t Cut(std::uint64_t word, unsigned parameter)
  {
    word >>= this->Position % 8;
    const auto ones = static_cast<unsigned>(__builtin_ctzll(~word | TooManyOnes));
    const std::uint64_t low = (word >> (ones + 1)) & ((std::uint64_t(1) << parameter) - 1);
    this->HasTooMany |= ones > vtkMTPositionCodec::MostOnes;
    this->Position += ones + 1 + parameter;
    return static_cast<std::uint32_t>((std::uint64_t(ones) << parameter) | low);
  }

  const unsigned char* Bytes;
  std::size_t Size;
  std::size_t Position = 0;
  bool HasTooMany = false;
};

using Codes = std::array<std::array<std::uint32_t, 3>, vtkMTPositionCodec::BlockSize>;

// The three lists side by side, as no code is known to begin before the one before it is read.
void ReadBlock(
  CodeReader (&readers)[3], const unsigned char* parameters, std::size_t blocks, std::size_t count, Codes& codes)
{
  CodeReader x = readers[0];
  CodeReader y = readers[1];
  CodeReader z = readers[2];
  const unsigned k[3] = { parameters[0], parameters[blocks], parameters[2 * blocks] };
  if (x.HasCodes(count) && y.HasCodes(count) && z.HasCodes(count))
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      codes[i] = { x.GetInside(k[0]), y.GetInside(k[1]), z.GetInside(k[2]) };
    }
  }
  else
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      codes[i] = { x.Get(k[0]), y.Get(k[1]), z.Get(k[2]) };
    }
  }
  readers[0] = x;
  readers[1] = y;
  readers[2] = z;
}
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
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    BitWriter writer(packed.Bits[axis]);
    for (std::size_t begin = 0; begin < points.size(); begin += BlockSize)
    {
      const std::size_t count = std::min(BlockSize, points.size() - begin);
      const unsigned parameter = ChooseParameter(codes[axis].data() + begin, count);
      packed.Parameters.push_back(static_cast<unsigned char>(parameter));
      for (std::size_t i = begin; i < begin + count; ++i)
      {
        writer.PutCode(codes[axis][i], parameter);
      }
    }
    writer.Finish();
  }
  return packed;
}

bool Decode(const Source& source, const Bases& bases, const vtkMTPoint& corner, std::vector<vtkMTPoint>& points)
{
  const std::size_t blocks = GetNumberOfBlocks(points.size()) / 3;
  if (std::any_of(source.Parameters, source.Parameters + 3 * blocks, [](unsigned char k) { return k > 32; }))
  {
    return false;
  }
  CodeReader readers[3] = { { source.Bits[0], source.BitsSize[0] }, { source.Bits[1], source.BitsSize[1] },
    { source.Bits[2], source.BitsSize[2] } };
  Codes codes;
  for (std::size_t block = 0; block < blocks; ++block)
  {
    const std::size_t begin = block * BlockSize;
    const std::size_t count = std::min(BlockSize, points.size() - begin);
    ReadBlock(readers, source.Parameters + block, blocks, count, codes);
    for (std::size_t i = begin; i < begin + count; ++i)
    {
      const Expectation expected(points, bases, i, corner);
      const Rounding rounding(source.Shift, source.Shift > 0 && GetBit(source.Coarse, i));
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        points[i][axis] =
          static_cast<std::int32_t>(rounding.Apply(expected.Get(axis), FromZigzag(codes[i - begin][axis])));
      }
    }
  }
  return readers[0].IsAtEnd() && readers[1].IsAtEnd() && readers[2].IsAtEnd();
}
}
