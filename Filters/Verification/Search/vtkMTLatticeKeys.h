// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTLatticeKeys
 * @brief which triangles a surface has, by the lattice points at their corners
 *
 * A corner's key is a hash of 64 bits of the lattice point to which its place is rounded, a triangle's the sum of those
 * of its corners: what is found is to be looked at before it is believed. Triangles are sorted by their keys and by
 * their turn, so a lookup takes O(log n) however many of them coincide.
 *
 * Places may be off by a reach. Where it is 0 a corner is found at its own lattice point only; else at all lattice
 * points of the surface's corners in the cube of the reach around it, which a grid of cells finds.
 */
#ifndef vtkMTLatticeKeys_h
#define vtkMTLatticeKeys_h

#include "vtkMTLattice.h"
#include "vtkMTSampledSurface.h"
#include "vtkMTVerificationModule.h" // For export macro

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

class VTKMTVERIFICATION_EXPORT vtkMTLatticeKeys
{
public:
  using Key = std::uint64_t;

  struct Entry
  {
    Key Corners; // the sum of the corners' keys
    std::uint32_t Turn;
    std::uint32_t Triangle;
  };

  /// Triangles with the same corners in the same turn, in order of their indices.
  struct Copies
  {
    const Entry* First = nullptr;
    const Entry* Last = nullptr; ///< one behind the last
    std::size_t GetCount() const { return static_cast<std::size_t>(this->Last - this->First); }
    const Entry* begin() const { return this->First; }
    const Entry* end() const { return this->Last; }
  };

  /// Of a surface in model units: its triangles without slack that lie within the bounds. reach: model units, 0 or
  /// more.
  vtkMTLatticeKeys(
    const vtkMTLattice& lattice, const double bounds[6], double reach, const vtkMTSampledSurface& surface);

  /// Of the lattice point at a place; false beyond the bounds.
  bool GetKey(const vtkMTRealPoint& x, Key& key) const;
  /// Of all lattice points at which the surface may have a corner within the reach of x.
  std::vector<Key> FindCorners(const vtkMTRealPoint& x) const;
  /// The surface's triangles with these corners: in the turn a, b, c, and in the opposite one.
  std::array<Copies, 2> FindTriangles(Key a, Key b, Key c) const;
  /// How many there are within the reach in the turn a, b, c.
  std::size_t CountTriangles(const vtkMTRealPoint& a, const vtkMTRealPoint& b, const vtkMTRealPoint& c) const;

private:
  struct Place
  {
    Key Cell;
    vtkMTPoint Point;
  };

  bool IsWithin(const vtkMTRealPoint& x) const;
  void AddPlaces(const vtkMTSampledSurface& surface);

  const vtkMTLattice Lattice;
  vtkMTRealBounds Bounds;     // with a margin
  std::int64_t Reach = 0;     // in steps
  std::int64_t CellSize = 1;  // in steps
  std::vector<Place> Places;  // by cell, each once; none where the reach is 0
  std::vector<Entry> Entries; // by corners, turn and index
};

#endif
