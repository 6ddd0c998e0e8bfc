// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTDeviation
 * @brief certified two-sided distance between a floor and its fragment, and through it between fragment and input
 *
 * A common subdivision of the two meshes (vtkMTOverlay) bounds nearly all triangles of both at once. Where it does not
 * exist (borders that were simplified, holes that were closed, components that were left out), and where its bound is
 * far above the largest true distance seen so far (a lower bound of the result, from points), a triangle is bounded
 * by itself, by pieces (vtkMTPieceBound).
 *
 * Over levels these bounds add up, triangle by triangle (vtkMTTriangleDeviation): a piece of the fragment over the
 * floor's triangle s is no farther from the input than its bound and what is known of s; the input's points that are
 * near a piece of the floor are no farther from s, a triangle of the fragment, than what is known of that piece's
 * triangle and its bound. So the largest deviations of different levels are added only where they meet.
 *
 * Distances are in steps of the lattice. Rounding: coordinates are integers below 2^32, so a computed distance is off
 * by less than 2^-44 of the extent; 2^-40 of the extent is added to every bound that is not zero exactly. Sums are
 * rounded up to single precision.
 */
#ifndef vtkMTDeviation_h
#define vtkMTDeviation_h

#include "vtkMTCertificationModule.h" // For export macro
#include "vtkMTPatch.h"

#include <cstdint>
#include <vector>

class vtkMTSurface;

/// What is known of one triangle of a level's mesh, in steps: how far it is from the input, and the input from it; and
/// of the same pairs of points the angles between their shading normals (vtkMTNormalDeviation has the units).
struct vtkMTTriangleDeviation
{
  float ToInput = 0.0f;   ///< no point of the triangle is farther than this from the input
  float FromInput = 0.0f; ///< no point of that part of the input which this triangle stands for is farther from it
  std::uint16_t NormalToInput = 0;
  std::uint16_t NormalFromInput = 0;
};

struct VTKMTCERTIFICATION_EXPORT vtkMTDeviation
{
  double UpperBound = 0.0; ///< the largest deviation of the fragment's triangles; the floor's own counted, steps
  double LowerBound = 0.0; ///< about what bounds without any looseness would have given, never above UpperBound, steps
  std::size_t TrianglesByPieces = 0; ///< of both meshes
  std::size_t Pieces = 0;            ///< pieces that were looked at beyond whole triangles
  bool BudgetUsedUp = false;

  /// How far above its own lower bound a piece's bound may stay: 1.1 times.
  static constexpr double Looseness = 1.1;
  /// How much of the lower bound of the whole a piece's bound may be and the piece be left as it is.
  static constexpr double Share = 0.6;
  /// Pieces allowed per triangle of the two meshes together.
  static constexpr std::size_t PiecesPerTriangle = 40;

  /// What a floor and its fragment are to each other, besides two meshes.
  struct Relation
  {
    /// [floor's points] the fragment's point that each was merged into, or None (~0): where to look for it first. Empty
    /// when nothing is known.
    std::vector<std::uint32_t> Heirs;
    std::vector<vtkMTTriangleDeviation> FloorDeviations; ///< [floor's triangles] empty when the floor is the input
  };
  /// A triangle of either mesh that the bounds rest on: parts of them stand for each other, and no point of such a part
  /// is farther from its partner than the distance, steps.
  struct Pair
  {
    std::uint32_t Floor;
    std::uint32_t Fragment;
    float Distance;
    bool IsDown; ///< part of the floor's triangle has come to stand on the fragment's
    bool IsUp;   ///< part of the fragment's triangle stands on the floor's
  };
  /// What is known of the fragment afterwards.
  struct Findings
  {
    bool KeepPairs = false; ///< given: whether Pairs are wanted
    std::vector<Pair> Pairs;
    std::vector<vtkMTTriangleDeviation> Deviations; ///< [fragment's triangles]
    std::vector<std::uint32_t> Places; ///< [floor's points] the fragment's triangle that each was put on, or None
    std::vector<std::uint32_t> FloorTriangle; ///< [fragment's triangles] one of the floor that lies over or near it
  };

  /// Of two meshes with the same origin. Both must have triangles.
  static vtkMTDeviation Between(
    const vtkMTSurface& floor, const vtkMTSurface& fragment, const Relation& relation, Findings& findings);
};

#endif
