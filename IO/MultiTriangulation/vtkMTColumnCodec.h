// SPDX-License-Identifier: BSD-3-Clause
/**
 * The values of an array in a patch, made ready for a codec of bytes. Not installed.
 *
 * Every component's values are taken as unsigned integers of their size and replaced by the difference to that of a
 * neighbour that was met before (vtkMTDecodeScratch), zigzag; then the lowest bytes of all differences come first, then
 * the next ones, and so on. Neighbours on the surface are alike, so most high bytes are zero, and a codec of bytes
 * finds them. This keeps every bit. Normals that the builder made are not the input's and are kept as points of an
 * octahedron's net of 4095 x 4095 places, within 0.06 degrees (Meyer et al., "On floating-point normal vectors", 2010):
 * equal normals stay equal. Each is expected near the place where it completes a parallelogram with its triangle's
 * neighbour, and the differences are Rice codes.
 */
#ifndef vtkMTColumnCodec_h
#define vtkMTColumnCodec_h

#include "vtkMTArrayInfo.h"

#include <array>
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

/// Whether the column is kept as directions; these are appended as they are stored. False when the bytes are not such
/// directions of that many wedges.
bool IsDirection(const vtkMTArrayInfo& array);
void PackDirections(const vtkMTColumn& column, const vtkMTDecodeScratch& traversal, std::vector<unsigned char>& bytes);
bool UnpackDirections(const unsigned char* data, std::size_t size, std::size_t tuples,
  const vtkMTDecodeScratch& traversal, vtkMTColumn& column);

///@{
/// A unit vector's place on the net and back. What has no direction is the place { 4095, 4095 } and (0, 0, 0).
std::array<std::uint16_t, 2> EncodeDirection(const std::array<float, 3>& direction);
std::array<float, 3> DecodeDirection(const std::array<std::uint16_t, 2>& place);
/// Many: the i-th is put to places[i], 12 bytes each.
void DecodeDirections(const std::uint16_t* u, const std::uint16_t* v, std::size_t count, const std::uint32_t* places,
  unsigned char* directions);
///@}
}

#endif
