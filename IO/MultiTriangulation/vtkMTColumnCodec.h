// SPDX-License-Identifier: BSD-3-Clause
/**
 * The values of an array in a patch, made ready for a codec of bytes. Not installed.
 *
 * Every component's values are taken as unsigned integers of their size and replaced by the difference to that of a
 * neighbour that was met before (vtkMTDecodeScratch), zigzag; then the lowest bytes of all differences come first, then
 * the next ones, and so on. Neighbours on the surface are alike, so most high bytes are zero, and a codec of bytes
 * finds them. This keeps every bit. For normals that the builder made there is vtkMTNormalCodec; in files of earlier
 * programs they are places on a net of 12 bits (vtkMTMadeNormals), each expected near the place where it completes a
 * parallelogram with its triangle's neighbour, and the differences are Rice codes.
 */
#ifndef vtkMTColumnCodec_h
#define vtkMTColumnCodec_h

#include "vtkMTArrayInfo.h"

#include <cstddef>
#include <cstdint>
#include <vector>

struct vtkMTDecodeScratch;

namespace vtkMTColumnCodec
{
/// Bytes that a column of so many tuples has once it is made ready.
std::uint64_t GetPackedSize(const vtkMTArrayInfo& array, std::uint64_t tuples);

std::vector<unsigned char> Pack(
  const vtkMTArrayInfo& array, const vtkMTColumn& column, const vtkMTDecodeScratch& traversal);

/// packed has GetPackedSize bytes.
void Unpack(const vtkMTArrayInfo& array, const std::vector<unsigned char>& packed, std::size_t tuples,
  const vtkMTDecodeScratch& traversal, vtkMTColumn& column);

/// Normals that the builder made, as earlier programs kept them. False when the bytes are not such directions of that
/// many wedges.
bool UnpackDirections(const unsigned char* data, std::size_t size, std::size_t tuples,
  const vtkMTDecodeScratch& traversal, vtkMTColumn& column);
}

#endif
