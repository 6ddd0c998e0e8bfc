// SPDX-License-Identifier: BSD-3-Clause
/**
 * What is counted on a mesh on the lattice, by identity of points and exact predicates: components, Euler number,
 * borders, triangles that meet others where they share no point.
 */
#ifndef MTStiffTopology_h
#define MTStiffTopology_h

#include "MTExactPredicates.h"

#include <cstddef>
#include <cstdint>
#include <vector>

struct MTStiffTopology
{
  struct Mesh
  {
    std::vector<MTExactPredicates::Point> Points;
    std::vector<std::array<std::uint32_t, 3>> Triangles;

    MTExactPredicates::Triangle GetTriangle(std::size_t t) const
    {
      const auto& corners = this->Triangles[t];
      return { this->Points[corners[0]], this->Points[corners[1]], this->Points[corners[2]] };
    }
  };

  std::int64_t Components = 0; ///< of triangles that share points
  std::int64_t Euler = 0;      ///< points that are used - edges + triangles
  std::int64_t BorderEdges = 0;
  std::int64_t Degenerate = 0;     ///< triangles whose corners lie on a line
  std::int64_t Intersections = -1; ///< pairs of triangles; -1: not counted

  /// Components, Euler number and edges.
  static MTStiffTopology Count(const Mesh& mesh);

  /**
   * Pairs of triangles, degenerate ones left out, that have points in common beyond the corners and edges that they
   * share; also those that merely touch. -1 where more than `limit` pairs of boxes overlap.
   */
  static std::int64_t CountIntersections(const Mesh& mesh, std::size_t limit);
};

#endif
