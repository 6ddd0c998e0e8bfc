// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTLatticeKeys
 * @brief which edges and triangles a surface has, by the lattice points at their corners
 *
 * A place is put on the lattice first, so places that differ by less than its rounding are found as well, unless they
 * lie on both sides of the middle between two lattice points. Keys are hashes of 64 bits: what is found is to be looked
 * at before it is believed.
 */
#ifndef vtkMTLatticeKeys_h
#define vtkMTLatticeKeys_h

#include "vtkMTLattice.h"
#include "vtkMTSampledSurface.h"
#include "vtkMTVerificationModule.h" // For export macro

#include <cstdint>
#include <unordered_map>
#include <unordered_set>
#include <vector>

class VTKMTVERIFICATION_EXPORT vtkMTLatticeKeys
{
public:
  /// Of a surface in model units, as far as it lies within the bounds.
  vtkMTLatticeKeys(const vtkMTLattice& lattice, const double bounds[6], const vtkMTSampledSurface& surface);

  bool HasEdge(const vtkMTRealPoint& a, const vtkMTRealPoint& b) const;
  /// The surface's triangles with these corners, in any order.
  std::vector<std::uint32_t> FindTriangles(
    const vtkMTRealPoint& a, const vtkMTRealPoint& b, const vtkMTRealPoint& c) const;

private:
  bool IsWithin(const vtkMTRealPoint& x) const;
  std::uint64_t GetKey(const vtkMTRealPoint& x) const;

  const vtkMTLattice Lattice;
  vtkMTRealBounds Bounds; // with a margin of a step
  std::unordered_set<std::uint64_t> Edges;
  std::unordered_multimap<std::uint64_t, std::uint32_t> Triangles;
};

#endif
