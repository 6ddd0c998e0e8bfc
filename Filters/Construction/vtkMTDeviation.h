// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTDeviation
 * @brief certified two-sided distance between a floor and its fragment, and through it between fragment and input
 *
 * The distance from a point to one fixed triangle s is convex, so over a convex piece of the plane it is largest at the
 * piece's corners. For every triangle of one mesh the least, over a few triangles s of the other one, of the largest
 * corner distance to s is therefore an upper bound of how far any of its points is from the other mesh. Where that
 * bound is far above the largest true distance seen so far (a lower bound of the result, from points), the triangle is
 * cut into pieces and these are bounded one by one: first along the edges of the triangle nearest to the piece's
 * middle, seen along that triangle's normal, so that pieces come to lie over one triangle each, else in halves. Pieces
 * are cut until their bound is within Share of that lower bound or within Looseness of their own, or the budget of
 * pieces is used up; the result is then still an upper bound. Where a piece lies in the plane of s, which is decided in
 * exact integers, and over s, its distance is exactly zero.
 *
 * Over levels these bounds add up, triangle by triangle (vtkMTReach): a piece of the fragment over the floor's triangle
 * s is no farther from the input than its bound and what is known of s; the input's points that are near a piece of the
 * floor are no farther from s, a triangle of the fragment, than what is known of that piece's triangle and its bound.
 * So the largest deviations of different levels are added only where they meet.
 *
 * Distances are in steps of the lattice. Rounding: coordinates are integers below 2^32, so a computed distance is off
 * by less than 2^-44 of the extent; 2^-40 of the extent is added to every bound that is not zero exactly. Sums are
 * rounded up to single precision.
 */
#ifndef vtkMTDeviation_h
#define vtkMTDeviation_h

#include "vtkMTConstructionModule.h" // For export macro
#include "vtkMTPatch.h"

#include <cstdint>
#include <vector>

class vtkMTTriangleTree;

/// What is known of one triangle of a level's mesh, in steps: how far it is from the input, and the input from it.
struct vtkMTReach
{
  float ToInput = 0.0f;   ///< no point of the triangle is farther than this from the input
  float FromInput = 0.0f; ///< no point of that part of the input which this triangle stands for is farther from it
};

struct VTKMTCONSTRUCTION_EXPORT vtkMTDeviation
{
  double UpperBound = 0.0; ///< the largest reach of the fragment's triangles; the floor's own counted, steps
  double LowerBound = 0.0; ///< about what bounds without any looseness would have given, never above UpperBound, steps
  std::size_t Pieces = 0;  ///< pieces that were looked at beyond whole triangles
  bool BudgetUsedUp = false;

  /// How far above its own lower bound a piece's bound may stay: 1.1 times.
  static constexpr double Looseness = 1.1;
  /// How much of the lower bound of the whole a piece may reach and be left as it is.
  static constexpr double Share = 0.6;
  /// Pieces allowed per triangle of the two meshes together.
  static constexpr std::size_t PiecesPerTriangle = 40;

  /**
   * Two-sided, of two meshes of which both trees were made with the same origin. Both must have triangles. floorReach:
   * per triangle of the floor, or empty when the floor is the input; fragmentReach gets one entry per triangle of the
   * fragment.
   */
  static vtkMTDeviation Between(const vtkMTPatch& floor, const vtkMTTriangleTree& floorTree, const vtkMTPatch& fragment,
    const vtkMTTriangleTree& fragmentTree, const vtkMTPoint& origin, const std::vector<vtkMTReach>& floorReach,
    std::vector<vtkMTReach>& fragmentReach);
};

#endif
