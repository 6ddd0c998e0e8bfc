// SPDX-License-Identifier: BSD-3-Clause
/**
 * The points of a patch as differences to what their neighbours let expect. Not installed.
 *
 * A point is expected where it completes a parallelogram with the triangle across the gate at which it is met (Touma
 * and Gotsman, "Triangle mesh compression", 1998). The differences of each axis are packed
 * in blocks of 16 with as many bits as the block's largest one needs. Where most points of a patch lie on a multiple of
 * a power of two, as the builder leaves them on coarse levels, a bit per point says so and its differences are that
 * much shorter. All arithmetic is modulo 2^32, so every sequence of bytes means some points.
 */
#ifndef vtkMTPositionCodec_h
#define vtkMTPositionCodec_h

#include "vtkMTPatch.h"
#include "vtkMTTriangleCodec.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vtkMTPositionCodec
{
constexpr std::size_t BlockSize = 16;
constexpr unsigned MaximumShift = 24;

struct Packed
{
  unsigned Shift = 0;                ///< coarse points are multiples of 2^Shift
  std::vector<unsigned char> Coarse; ///< a bit per point, lowest first; empty when Shift is 0
  std::vector<unsigned char> Widths; ///< bits per difference of each block: x's blocks, y's, z's
  std::vector<unsigned char> Bits;   ///< the differences, zigzag, lowest bit first
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
  const unsigned char* Widths;
  const unsigned char* Bits;
  std::size_t BitsSize;
};

/// Fills points, whose number is given. False when the bits are not as many as the widths say.
bool Decode(const Source& source, const Bases& bases, const vtkMTPoint& corner, std::vector<vtkMTPoint>& points);
}

#endif
