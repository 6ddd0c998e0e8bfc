// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTDeviation
 * @brief certified two-sided distance between a floor and its fragment
 *
 * The distance from a point to one fixed triangle s is convex, so over a convex piece of the plane it is largest at the
 * piece's corners. For every triangle of one mesh the least, over a few triangles s of the other one, of the largest
 * corner distance to s is therefore an upper bound of how far any of its points is from the other mesh. Where that
 * bound is above the largest true distance seen so far (a lower bound of the result, from points), the triangle is cut
 * into pieces and these are bounded one by one: first along the edges of the triangle nearest to the piece's middle,
 * seen along that triangle's normal, so that pieces come to lie over one triangle each, else in halves. Pieces are cut
 * until their bound is within Looseness of the lower bound, or the budget of pieces is used up; the result is then
 * still an upper bound. Where a piece lies in the plane of s, which is decided in exact integers, and over s, its
 * distance is exactly zero.
 *
 * Distances are in steps of the lattice. Rounding: coordinates are integers below 2^32, so a computed distance is off
 * by less than 2^-44 of the extent; 2^-40 of the extent is added to every bound that is not zero exactly.
 */
#ifndef vtkMTDeviation_h
#define vtkMTDeviation_h

#include "vtkMTConstructionModule.h" // For export macro
#include "vtkMTPatch.h"

#include <cstdint>

class vtkMTTriangleTree;

struct VTKMTCONSTRUCTION_EXPORT vtkMTDeviation
{
  double UpperBound = 0.0; ///< no point of either mesh is farther from the other than this, steps
  double LowerBound = 0.0; ///< some point of one of them is at least this far from the other, steps
  std::size_t Pieces = 0;  ///< pieces that were looked at beyond whole triangles
  bool BudgetUsedUp = false;

  /// How far above the lower bound a piece's bound may stay: 1.1 times.
  static constexpr double Looseness = 1.1;
  /// Pieces allowed per triangle of the two meshes together.
  static constexpr std::size_t PiecesPerTriangle = 40;

  /// Two-sided, of two meshes of which both trees were made with the same origin. Both must have triangles.
  static vtkMTDeviation Between(const vtkMTPatch& a, const vtkMTTriangleTree& treeOfA, const vtkMTPatch& b,
    const vtkMTTriangleTree& treeOfB, const vtkMTPoint& origin);
};

#endif
