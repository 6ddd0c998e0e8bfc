// SPDX-License-Identifier: BSD-3-Clause
/**
 * The points of a patch as differences to what their neighbours let expect. Not installed.
 *
 * A point is expected where it completes a parallelogram with the triangle across the gate at which it is met (Touma
 * and Gotsman, "Triangle mesh compression", 1998). The differences of each axis are Rice codes (Rice and Plaunt,
 * "Adaptive variable-length coding", 1971) in a bit list of its own, with the best parameter for each block of 32: a
 * code of parameter k is its value above the k lowest bits as so many ones and a zero, then these k bits. Where most
 * points of a patch lie on a multiple of
 * a power of two, as the builder leaves them on coarse levels, a bit per point says so and its differences are that
 * much shorter. All arithmetic is modulo 2^32, so every sequence of bytes means some points.
 */
#ifndef vtkMTPositionCodec_h
#define vtkMTPositionCodec_h

#include "vtkMTPatch.h"
#include "vtkMTTriangleCodec.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vtkMTPositionCodec
{
constexpr std::size_t BlockSize = 32;
constexpr unsigned MaximumShift = 24;

constexpr unsigned MostOnes = 24; // and 32 bits behind them: a code is in 57 bits, which one unaligned load gives

struct Packed
{
  unsigned Shift = 0;                             ///< coarse points are multiples of 2^Shift
  std::vector<unsigned char> Coarse;              ///< a bit per point, lowest first; empty when Shift is 0
  std::vector<unsigned char> Parameters;          ///< of each block: x's blocks, y's, z's
  std::array<std::vector<unsigned char>, 3> Bits; ///< the differences of each axis, zigzag, as Rice codes
};

inline std::size_t GetNumberOfBlocks(std::size_t points)
{
  return 3 * ((points + BlockSize - 1) / BlockSize);
}

using Bases = std::vector<vtkMTTriangleCodec::Basis>;

/// points in stream order; a basis of earlier points for each, as far as there are bases; without one a point is
/// expected where the one before it is, the first one at the corner.
Packed Encode(const std::vector<vtkMTPoint>& points, const Bases& bases, const vtkMTPoint& corner);

/// What Decode reads, checked by the caller to be as long as the number of points makes it.
struct Source
{
  unsigned Shift;
  const unsigned char* Coarse;
  const unsigned char* Parameters;
  std::array<const unsigned char*, 3> Bits;
  std::array<std::size_t, 3> BitsSize;
};

/// Fills points, whose number is given. False when the bits are not such codes of that many points.
bool Decode(const Source& source, const Bases& bases, const vtkMTPoint& corner, std::vector<vtkMTPoint>& points);
}

#endif
