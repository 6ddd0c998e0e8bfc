// SPDX-License-Identifier: BSD-3-Clause
/**
 * Normals that the builder made, as differences to what the triangles of their patch say. Not installed.
 *
 * Of a point whose triangles are all in the patch the normal is known when these are (vtkMTMadeNormals); of one that is
 * shared it is expected from those triangles that are here. What differs is kept, in places on the net, as Rice codes;
 * blocks of 64 wedges without a difference are one byte. Shared points have blocks of their own, so most others are
 * such. Where what is expected is on the net's outer half, whose rim is where it ends, the difference is taken on the
 * net of the opposite pole, where that half is in the middle. No wedge depends on another one.
 */
#ifndef vtkMTNormalCodec_h
#define vtkMTNormalCodec_h

#include "vtkMTPatch.h"

#include <cstddef>
#include <vector>

namespace vtkMTNormalCodec
{
/// Appends the section of a column of normals (three floats for each wedge), which are put on the net of so many bits
/// where they are not on it; patch has the geometry as it will be decoded.
void Encode(const vtkMTColumn& column, const vtkMTPatch& patch, int bits, std::vector<unsigned char>& bytes);

/// False when the bytes are no such section. Eight bytes behind them can be read.
bool Decode(const unsigned char* data, std::size_t size, const vtkMTPatch& patch, vtkMTColumn& column);
}

#endif
