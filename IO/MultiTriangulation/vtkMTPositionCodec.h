// SPDX-License-Identifier: BSD-3-Clause
/**
 * The points of a patch as differences to what their neighbours let expect. Not installed.
 *
 * A point is expected where it completes a parallelogram with the triangle across the gate at which it is met (Touma
 * and Gotsman, "Triangle mesh compression", 1998), or, where that suits a patch better because its triangles are as
 * long as noise is high, three quarters of the way there. The differences of each axis are Rice codes (vtkMTRiceCode).
 * Where most points of a patch lie on a multiple of a power of two, as the builder leaves them on coarse levels, a bit
 * per point says so and its differences are that much shorter. All arithmetic is modulo 2^32, so every sequence of
 * bytes means some points.
 */
#ifndef vtkMTPositionCodec_h
#define vtkMTPositionCodec_h

#include "vtkMTPatch.h"
#include "vtkMTRiceCode.h"
#include "vtkMTTriangleCodec.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vtkMTPositionCodec
{
constexpr unsigned MaximumShift = 24;

struct Packed
{
  unsigned Shift = 0;                         ///< coarse points are multiples of 2^Shift
  bool IsNear = false;                        ///< expected nearer to the gate than the parallelogram ends
  std::vector<unsigned char> Coarse;          ///< a bit per point, lowest first; empty when Shift is 0
  std::array<vtkMTRiceCode::Coded, 3> Axes{}; ///< the differences of each axis, zigzag
};

/// x, y, z and a number that is not looked at: one register (an extension of GCC and Clang).
using Wide __attribute__((vector_size(16))) = std::uint32_t;

/// points in order of use; a basis of earlier points for each, as far as there are bases; without one a point is
/// expected where the one before it is, the first one at the corner.
Packed Encode(
  const std::vector<vtkMTPoint>& points, const std::vector<vtkMTTriangleCodec::Basis>& bases, const vtkMTPoint& corner);

/// What Decode reads. Coarse and Parameters are as long as the number of points makes them.
struct Source
{
  unsigned Shift;
  bool IsNear;
  const unsigned char* Coarse;
  const unsigned char* Parameters;       ///< x's blocks, y's, z's
  std::array<std::size_t, 2> UnarySizes; ///< x's, y's; z's is what is left
  const unsigned char* Bits;             ///< low bits of x, y and z, unary codes of x, y and z; with
                                         ///< vtkMTRiceCode::Reader::Slack bytes behind the end that can be read
  std::size_t BitsSize;
};

/// Fills places[1] to places[points]. False when the bits are not such codes of that many points.
bool Decode(const Source& source, const std::vector<vtkMTTriangleCodec::Basis>& bases, const vtkMTPoint& corner,
  std::size_t points, std::vector<Wide>& places);
}

#endif
