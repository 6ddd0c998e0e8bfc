// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPositionCodec.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>

namespace
{
using vtkMTTriangleCodec::Basis;
using vtkMTTriangleCodec::None;

// A point with a fourth coordinate that is not used, so that a point is one register.
using Wide = vtkMTPositionCodec::Wide;
using SignedWide __attribute__((vector_size(16))) = std::int32_t;

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

// Three points, counted from one: 0 is the corner. The next one is expected at A + B - C.
Basis GetBasis(const std::vector<Basis>& bases, std::size_t i)
{
  const auto before = static_cast<std::uint32_t>(i);
  if (i >= bases.size() || bases[i].A == None)
  {
    return { before, before, before };
  }
  const Basis& basis = bases[i];
  return basis.C == None ? Basis{ basis.A + 1, basis.A + 1, basis.A + 1 }
                         : Basis{ basis.A + 1, basis.B + 1, basis.C + 1 };
}

// near: all bits where points are expected nearer to the gate, by a quarter of what lies between C and the far corner
// of the parallelogram.
Wide Expect(const Wide* points, const Basis& basis, const Wide& near)
{
  const Wide& c = points[basis.C];
  const Wide far = points[basis.A] + points[basis.B] - c;
  const auto quarter = reinterpret_cast<SignedWide>(far - c) >> 2;
  return far - (reinterpret_cast<Wide>(quarter) & near);
}

Wide GetNear(bool isNear)
{
  return Wide{} - (isNear ? 1u : 0u);
}

Wide FromZigzags(const Wide& codes)
{
  return (codes >> 1) ^ (0 - (codes & 1));
}

Wide Widen(const vtkMTPoint& p)
{
  return Wide{ static_cast<std::uint32_t>(p[0]), static_cast<std::uint32_t>(p[1]), static_cast<std::uint32_t>(p[2]),
    0 };
}

constexpr std::size_t BlockSize = vtkMTRiceCode::BlockSize;
constexpr std::size_t GroupSize = vtkMTRiceCode::Reader::GroupSize;

using Readers = std::array<vtkMTRiceCode::Reader, 3>;

// One for each axis, with the codes of block after block.
bool MakeReaders(const vtkMTPositionCodec::Source& source, std::size_t points, Readers& readers)
{
  const std::size_t blocks = vtkMTRiceCode::GetNumberOfBlocks(points);
  std::array<std::size_t, 3> lowSizes{};
  for (std::size_t i = 0; i < 3 * blocks; ++i)
  {
    if (source.Parameters[i] > vtkMTRiceCode::MostBits)
    {
      return false;
    }
    const std::size_t count = std::min(vtkMTRiceCode::BlockSize, points - i % blocks * vtkMTRiceCode::BlockSize);
    lowSizes[i / blocks] += vtkMTRiceCode::GetLowSize(count, source.Parameters[i]);
  }
  const std::size_t before = lowSizes[0] + lowSizes[1] + lowSizes[2] + source.UnarySizes[0] + source.UnarySizes[1];
  if (source.UnarySizes[0] > source.BitsSize || source.UnarySizes[1] > source.BitsSize || before > source.BitsSize)
  {
    return false;
  }
  const std::size_t unarySizes[3] = { source.UnarySizes[0], source.UnarySizes[1], source.BitsSize - before };
  const unsigned char* low = source.Bits;
  const unsigned char* unary = source.Bits + lowSizes[0] + lowSizes[1] + lowSizes[2];
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    readers[axis] = vtkMTRiceCode::Reader(low, unary, unarySizes[axis]);
    low += lowSizes[axis];
    unary += unarySizes[axis];
  }
  return true;
}

// Differences are in multiples of 2^shift where the point is coarse; the same steps either way, as which it is cannot
// be predicted.
struct Rounding
{
  Wide Half;
  Wide Kept;
  unsigned Shift;

  explicit Rounding(unsigned shift)
    : Half(Wide{} + ((1u << shift) >> 1))
    , Kept(Wide{} + (~std::uint32_t(0) << shift))
    , Shift(shift)
  {
  }
};

using Group = std::uint32_t[vtkMTRiceCode::Reader::GroupSize][4];

// From codes to places. Each waits for the one at the rear of its gate, which is mostly the last one: what does not
// need that comes first.
template <bool IsNear, bool IsShifted>
void Place(const vtkMTPositionCodec::Source& source, const std::vector<Basis>& bases, const Rounding* roundings,
  std::size_t begin, std::size_t count, const Group& codes, Wide* places)
{
  for (std::size_t i = begin; i < begin + count; ++i)
  {
    Wide code;
    std::memcpy(&code, codes[i - begin], sizeof(code));
    const Basis basis = GetBasis(bases, i);
    const Rounding& rounding = roundings[IsShifted && GetBit(source.Coarse, i) ? 1 : 0];
    const Wide difference = FromZigzags(code) << rounding.Shift;
    const Wide known = IsShifted ? rounding.Half : difference;
    Wide place;
    if (IsNear)
    {
      place = Expect(places, basis, GetNear(true)) + known;
    }
    else
    {
      place = places[basis.A] + (places[basis.B] - places[basis.C] + known);
    }
    if (IsShifted)
    {
      place = (place & rounding.Kept) + difference;
    }
    places[i + 1] = place;
  }
}

// The codes of all points, as they are where points are expected at the end of the parallelogram, and nearer.
struct Codes
{
  std::unique_ptr<Wide[]> Far;
  std::unique_ptr<Wide[]> Near;
  Wide FarBits{}; // that they have above their leading zeros: how long Rice codes are, but for a constant
  Wide NearBits{};
};

// In multiples of 2^shift; half is half of one.
Wide GetDifference(const Wide& place, const Wide& expected, unsigned shift, std::uint32_t half)
{
  const auto coarse = reinterpret_cast<SignedWide>(expected + half) >> static_cast<std::int32_t>(shift);
  const auto here = reinterpret_cast<SignedWide>(place) >> static_cast<std::int32_t>(shift);
  return reinterpret_cast<Wide>(here) - reinterpret_cast<Wide>(coarse);
}

Wide ToZigzags(const Wide& differences)
{
  return (differences << 1) ^ (0 - (differences >> 31));
}

// By the exponents of what is left of the codes when their second bit is cleared, so that nothing is rounded up.
Wide CountBits(const Wide& codes)
{
  const Wide some = codes | 1;
  using Floats __attribute__((vector_size(16))) = float;
  const Floats numbers = __builtin_convertvector(reinterpret_cast<SignedWide>(some & ~(some >> 1)), Floats);
  return (reinterpret_cast<Wide>(numbers) << 1 >> 24) - 127;
}

std::uint64_t Sum(const Wide& counts)
{
  return std::uint64_t(counts[0]) + counts[1] + counts[2];
}

void GetCodes(const std::vector<vtkMTPoint>& points, const std::vector<Basis>& bases, const vtkMTPoint& corner,
  const vtkMTPositionCodec::Packed& packed, Codes& codes)
{
  const std::unique_ptr<Wide[]> places(new Wide[points.size() + 1]);
  codes.Far.reset(new Wide[points.size()]);
  codes.Near.reset(new Wide[points.size()]);
  places[0] = Widen(corner);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Basis basis = GetBasis(bases, i);
    const unsigned shift = packed.Shift > 0 && GetBit(packed.Coarse.data(), i) ? packed.Shift : 0;
    const std::uint32_t half = (1u << shift) >> 1;
    places[i + 1] = Widen(points[i]);
    const Wide far = Expect(places.get(), basis, GetNear(false));
    const Wide near = Expect(places.get(), basis, GetNear(true));
    codes.Far[i] = ToZigzags(GetDifference(places[i + 1], far, shift, half));
    codes.Near[i] = ToZigzags(GetDifference(places[i + 1], near, shift, half));
    codes.FarBits += CountBits(codes.Far[i]);
    codes.NearBits += CountBits(codes.Near[i]);
  }
}
}

namespace vtkMTPositionCodec
{
Packed Encode(const std::vector<vtkMTPoint>& points, const std::vector<Basis>& bases, const vtkMTPoint& corner)
{
  Packed packed;
  packed.Shift = ChooseShift(points);
  packed.Coarse.assign(packed.Shift > 0 ? (points.size() + 7) / 8 : 0, 0);
  for (std::size_t i = 0; i < points.size() && packed.Shift > 0; ++i)
  {
    packed.Coarse[i / 8] |= static_cast<unsigned char>((CountZeros(points[i]) >= packed.Shift ? 1u : 0u) << (i % 8));
  }
  Codes codes;
  GetCodes(points, bases, corner, packed, codes);
  packed.IsNear = Sum(codes.NearBits) < Sum(codes.FarBits);
  const Wide* const used = packed.IsNear ? codes.Near.get() : codes.Far.get();
  std::vector<std::uint32_t> ofAxis(points.size());
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      ofAxis[i] = used[i][axis];
    }
    packed.Axes[axis] = vtkMTRiceCode::Encode(ofAxis);
  }
  return packed;
}

bool Decode(const Source& source, const std::vector<Basis>& bases, const vtkMTPoint& corner, std::size_t points,
  std::vector<Wide>& places)
{
  Readers readers;
  if (!MakeReaders(source, points, readers))
  {
    return false;
  }
  if (places.size() < points + 1)
  {
    places.resize(points + 1);
  }
  const Rounding roundings[2] = { Rounding(0), Rounding(source.Shift) };
  places[0] = Widen(corner);
  const auto place = source.IsNear ? (source.Shift > 0 ? Place<true, true> : Place<true, false>)
                                   : (source.Shift > 0 ? Place<false, true> : Place<false, false>);
  // One group of codes is read before the one before is placed, so that there is something to do while places wait for
  // each other.
  alignas(Wide) Group codes[2] = {};
  const std::size_t blocks = vtkMTRiceCode::GetNumberOfBlocks(points);
  std::size_t placed = 0;
  for (std::size_t begin = 0; begin < points; begin += GroupSize)
  {
    const std::size_t block = begin / BlockSize;
    const unsigned char* const parameters = source.Parameters + block;
    if (!vtkMTRiceCode::ReadGroup(readers, { parameters[0], parameters[blocks], parameters[2 * blocks] },
          begin % BlockSize, std::min(BlockSize, points - block * BlockSize), codes[begin / GroupSize % 2],
          std::make_index_sequence<3>()))
    {
      return false;
    }
    if (begin > 0)
    {
      place(source, bases, roundings, placed, GroupSize, codes[placed / GroupSize % 2], places.data());
      placed = begin;
    }
  }
  place(source, bases, roundings, placed, points - placed, codes[placed / GroupSize % 2], places.data());
  return readers[0].IsAtEnd() && readers[1].IsAtEnd() && readers[2].IsAtEnd();
}
}
