// SPDX-License-Identifier: BSD-3-Clause
/**
 * The triangles of a patch as steps of a growing front, about two bits each. Not installed.
 *
 * Cut-border coding (Gumhold and Strasser, "Real time compression of triangle mesh connectivity", 1998), made to take
 * every set of triangles. The front is made of *gates*, directed edges of triangles that are known. One gate after the
 * other is taken; the triangle behind it is said by how its third vertex is found: it is new, it is the end of the
 * front's next or previous edge, both at once, or one that was met before and is named; or there is none. When no
 * gate is left, a triangle starts with three vertices that are named. Vertices are numbered as they are met (the
 * *stream order*), so nothing else has to be said, and every new vertex comes with the triangle across its gate, from
 * which its place can be expected.
 *
 * Gates are taken in the order in which they were made, cell by cell: after so many, what is left waits on a stack and
 * the next cell grows from one gate of it. Cells are small compact pieces, so the triangles, which are kept in this
 * order, find most of their vertices in the GPU's vertex cache (Testing/Benchmarks/vertex_cache).
 */
#ifndef vtkMTTriangleCodec_h
#define vtkMTTriangleCodec_h

#include "vtkMTPatch.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vtkMTTriangleCodec
{
constexpr std::uint32_t None = ~std::uint32_t(0);
constexpr std::uint32_t CellSize = 96; // gates; smaller cells cost bits, larger ones leave the cache

/// For a vertex in stream order, the gate at which it was met and the vertex across: its place is expected at a + b -
/// c. With c None it is at a alone; with a None too, nothing is known.
struct Basis
{
  std::uint32_t A = None;
  std::uint32_t B = None;
  std::uint32_t C = None;
};

struct Coded
{
  std::vector<unsigned char> Steps;     ///< a prefix code, lowest bit first
  std::vector<unsigned char> Names;     ///< LEB128: of vertices that are named
  std::vector<vtkMTTriangle> Triangles; ///< as they will be decoded, of the caller's vertices
  std::vector<std::uint32_t> Order;     ///< which of the caller's triangles each one is; equal ones keep their order
};

/// Every triangle's indices are below `vertices`.
Coded Encode(const std::vector<vtkMTTriangle>& triangles, std::size_t vertices);

/**
 * Fills triangles, whose number is given, with vertices in stream order, and the bases of those that were met; the
 * latter are at most `vertices`. border: the vertices from which the gates start that are left in the end, loop by
 * loop, which are the border of the triangles; one may be there more than once. False when the bytes are no such steps.
 */
bool Decode(const unsigned char* steps, std::size_t stepsSize, const unsigned char* names, std::size_t namesSize,
  std::size_t vertices, std::vector<vtkMTTriangle>& triangles, std::vector<Basis>& bases,
  std::vector<std::uint32_t>& border);
}

#endif
