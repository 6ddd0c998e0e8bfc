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
 * which its place can be expected. How a step is said depends on
 * whether the gates beside are open and how the gate was made; gates know both, so the decoder waits for nothing else.
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
  std::vector<unsigned char> Names;     ///< Rice codes: of vertices that are named
  std::vector<vtkMTTriangle> Triangles; ///< as they will be decoded, of the caller's vertices
  std::vector<std::uint32_t> Order;     ///< which of the caller's triangles each one is; equal ones keep their order
};

/// Every triangle's indices are below `vertices`.
Coded Encode(const std::vector<vtkMTTriangle>& triangles, std::size_t vertices);

/// An edge of the front.
struct Gate
{
  std::uint32_t From;
  std::uint32_t To;
  std::uint32_t Across; ///< the third vertex of the gate's triangle
  std::uint32_t Owner;  ///< that triangle
  std::uint32_t Previous;
  std::uint32_t Next;
  std::uint32_t State;
  std::uint32_t Beside; ///< bits: what decides how the next step is said
};
struct GateRange
{
  std::uint32_t Begin;
  std::uint32_t End;
};

/// Memory that is worth keeping from one patch to the next.
struct Workspace
{
  std::vector<Gate> Gates;
  std::vector<std::uint32_t> GateFrom;
  std::vector<GateRange> Waiting;
  std::vector<std::uint32_t> BorderGates; ///< as they became that, then those that are still open
};

/// Triangles in the order of their codes, of vertices in stream order. The vectors only grow from call to call; what
/// counts is at their beginning.
struct Decoded
{
  std::uint32_t NumberOfTriangles = 0;
  std::uint32_t NumberOfVertices = 0;
  /// Three vertices, and the triangle across the gate behind which this one was found; None at a start.
  std::vector<std::array<std::uint32_t, 4>> Triangles;
  std::vector<Basis> Bases; ///< of the vertices
  /// The vertices from which the gates start that are left in the end, loop by loop, which are the border of the
  /// triangles; one may be there more than once.
  std::vector<std::uint32_t> Border;
  Workspace Work;
};

/// Replaces what `decoded` holds by so many triangles of at most so many vertices. False when the bytes are no such
/// steps. Eight bytes behind the steps and behind the names can be read.
bool Decode(const unsigned char* steps, std::size_t stepsSize, const unsigned char* names, std::size_t namesSize,
  std::size_t triangles, std::size_t vertices, Decoded& decoded);
}

#endif
