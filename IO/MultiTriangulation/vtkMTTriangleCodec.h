// SPDX-License-Identifier: BSD-3-Clause
/**
 * The triangles of a patch as steps of a growing front, about two bits each. Not installed.
 *
 * Cut-border coding (Gumhold and Strasser, "Real time compression of triangle mesh connectivity", 1998) in an order
 * like Edgebreaker's (Rossignac, "Edgebreaker: connectivity compression for triangle meshes", 1999), made to take every
 * set of triangles. The front is a ring of *gates*, directed edges of triangles that are known, each asked once for the
 * triangle behind it. That is encoded by how its third vertex is found: it is new, it is the far end of the next gate
 * in the direction in which the front is followed, or of the one after that, or of the one before, or one that was met
 * earlier and is named; or there is none. Triangles are laid about one end of the gate until the next gate is joined,
 * then about its far end, and so on along the front. Two gates that run back and forth between the same vertices are
 * done with when they come to lie beside each other, so nothing has to be known of the front but the gates on both
 * sides: these are two stacks, and there are no links. When no gate is left, a triangle starts with three vertices that
 * are named. Vertices are numbered as they are met (the *order of use*), so nothing else has to be stored, and every
 * new vertex comes with the triangle across its gate, from which its place can be expected.
 *
 * After a few joined gates the front turns, and goes back over what it has just laid. So it grows in narrow bands, and
 * the triangles, which are kept in this order, find most of their vertices in the GPU's vertex cache
 * (Testing/Benchmarks/vertex_cache). Why so: Documentation/decisions/0027-triangles-in-sweeps.md.
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

/// For a vertex in order of use, the gate at which it was met, its rear and its hinge, and the vertex across: its place
/// is expected at a + b - c. With c None it is at a alone; with a None too, nothing is known.
struct Basis
{
  std::uint32_t A = None;
  std::uint32_t B = None;
  std::uint32_t C = None;
};

struct Coded
{
  std::vector<unsigned char> Steps;    ///< a prefix code, lowest bit first
  std::vector<unsigned char> Names;    ///< Rice codes: of vertices that are named
  std::vector<std::uint32_t> Order;    ///< which of the caller's triangles each one is; equal ones keep their order
  std::vector<std::uint32_t> Vertices; ///< the caller's vertices in order of use, then those that are not used
};

/// A gate that waits beside the present one, or several that are closed.
struct Gate
{
  /// As bits of what decides how the next step is encoded.
  enum StateType : std::uint32_t
  {
    Open = 0,
    Closed = 1 << 3 | 1 << 4,
    End = 1 << 3 | 1 << 4 | 1 << 5 ///< behind the last gate
  };
  std::uint32_t Vertex; ///< its end that is farther from the present one
  std::uint32_t Across; ///< the third vertex of the gate's triangle
  std::uint32_t Owner;  ///< that triangle
  std::uint32_t State;
};
struct BorderGate
{
  std::uint32_t From;
  std::uint32_t To;
};

/// Memory that is worth keeping from one patch to the next.
struct Workspace
{
  std::vector<Gate> Gates;
  std::vector<BorderGate> BorderGates; ///< as they became that, then those that are still open
  std::vector<std::uint32_t> BorderFrom;
};

/// Triangles in the order of their codes, of vertices in order of use. The vectors only grow from call to call; what
/// counts is at their beginning.
struct Decoded
{
  std::uint32_t NumberOfTriangles = 0;
  std::uint32_t NumberOfVertices = 0;
  /// Three vertices, and the triangle across the gate behind which this one was found; None at a start.
  std::vector<std::array<std::uint32_t, 4>> Triangles;
  std::vector<Basis> Bases; ///< of the vertices
  /// The vertices from which the gates start behind which nothing was found, loop by loop, which are the border of the
  /// triangles; one may be there more than once, and so may both ends of an edge inside that was asked from both sides.
  std::vector<std::uint32_t> Border;
  Workspace Work;
};

/// Every triangle's indices are below `vertices`. Replaces what `decoded` holds by what will be decoded.
Coded Encode(const std::vector<vtkMTTriangle>& triangles, std::size_t vertices, Decoded& decoded);

/// Replaces what `decoded` holds by so many triangles of at most so many vertices. False when the bytes are no such
/// steps. Eight bytes behind the steps and behind the names can be read.
bool Decode(const unsigned char* steps, std::size_t stepsSize, const unsigned char* names, std::size_t namesSize,
  std::size_t triangles, std::size_t vertices, Decoded& decoded);
}

#endif
