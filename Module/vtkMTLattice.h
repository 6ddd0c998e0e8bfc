// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTLattice
 * @brief the one lattice on which the points of all patches of all levels lie
 *
 * A point is three 32-bit integers k; its place in model units is Step * (Origin + k), where Step is a power of two
 * and Origin is counted in steps. Because Step is a power of two and Origin + k stays below 2^53, that product is exact
 * in double precision: two patches that hold the same integers hold the same point, bit for bit, on every machine.
 *
 * Positions are snapped (rounded to nearest) once, before partition, simplification and certification, so that all
 * certified distances are those of the points as they are drawn. The distance between an input point and its snapped
 * place is at most MaximumShift.
 *
 * Shapes: a lattice point is std::array<std::int32_t, 3>; a box is six integers, xmin, xmax, ymin, ymax, zmin, zmax.
 */
#ifndef vtkMTLattice_h
#define vtkMTLattice_h

#include "vtkMTCoreModule.h" // For export macro

#include <array>
#include <cstdint>

using vtkMTPoint = std::array<std::int32_t, 3>;
using vtkMTBox = std::array<std::int32_t, 6>;

struct VTKMTCORE_EXPORT vtkMTLattice
{
  /// Bits of the extent's longest side when nothing else is asked for: 2^24 steps, so that every coordinate
  /// relative to a patch's corner is exact in single precision, on the GPU too.
  static constexpr int DefaultBits = 24;
  static constexpr int MinimumBits = 10;
  static constexpr int MaximumBits = 31;

  double Step = 1.0;                             ///< model units, a power of two
  std::array<std::int64_t, 3> Origin{ 0, 0, 0 }; ///< in steps
  double MaximumShift = 0.0; ///< model units: no snapped point lies farther from its input point than this

  /**
   * The lattice for a bounding box (xmin, xmax, ymin, ymax, zmin, zmax; finite): the finest power-of-two step that
   * divides the longest side into at most 2^bits. bits outside [MinimumBits, MaximumBits] is clamped. The step is
   * never finer than what double precision resolves at the box's farthest coordinate. A box that is one point gets a
   * step that resolves that point's own coordinates.
   */
  static vtkMTLattice FromBounds(const double bounds[6], int bits = DefaultBits);

  /// Round to nearest; x must lie in the box that the lattice was made for.
  vtkMTPoint Snap(const double x[3]) const;

  /// Exact.
  std::array<double, 3> ToWorld(const vtkMTPoint& k) const
  {
    return { this->Step * static_cast<double>(this->Origin[0] + k[0]),
      this->Step * static_cast<double>(this->Origin[1] + k[1]),
      this->Step * static_cast<double>(this->Origin[2] + k[2]) };
  }

  /// Of a place given in steps, such as a barycentre; rounded as double arithmetic does.
  std::array<double, 3> ToWorld(const std::array<double, 3>& k) const
  {
    return { this->Step * (static_cast<double>(this->Origin[0]) + k[0]),
      this->Step * (static_cast<double>(this->Origin[1]) + k[1]),
      this->Step * (static_cast<double>(this->Origin[2]) + k[2]) };
  }

  /// The box in model units; an empty box (xmin > xmax) gives VTK's uninitialised bounds.
  void ToWorld(const vtkMTBox& box, double bounds[6]) const;
};

#endif
