// SPDX-License-Identifier: BSD-3-Clause
/**
 * Predicates on lattice points, exact: the points of every model are integers of at most 32 bits, so determinants fit
 * into 128 bits, and products of two normals into two of these. No tolerance decides anything here.
 */
#ifndef MTExactPredicates_h
#define MTExactPredicates_h

#include <array>
#include <cstdint>

namespace MTExactPredicates
{
using Point = std::array<std::int64_t, 3>; // differences of at most 33 bits
using Triangle = std::array<Point, 3>;

/// The sign of the volume of the tetrahedron a, b, c, d: 1 where d sees a, b, c counter-clockwise from behind.
int GetOrientation(const Point& a, const Point& b, const Point& c, const Point& d);

/// Whether the corners lie on a line.
bool IsDegenerate(const Triangle& t);

/// The sign of the product of two triangles' normals: -1 where they face away from each other.
int GetNormalProductSign(const Triangle& s, const Triangle& t);

/// Whether a closed segment and a closed triangle, not degenerate, have a point in common.
bool SegmentMeetsTriangle(const Point& p, const Point& q, const Triangle& t);

/// Whether two closed triangles, not degenerate, have a point in common.
bool TrianglesMeet(const Triangle& s, const Triangle& t);

/// The same for triangles whose corners 0 are one point: whether they meet anywhere else.
bool TrianglesMeetBeyondCorner(const Triangle& s, const Triangle& t);

/// The same for triangles that share the edge of corners 0 and 1: whether they lie on each other.
bool TrianglesFold(const Triangle& s, const Triangle& t);
}

#endif
