// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTPointNormals
 * @brief normals of a mesh: smooth, one per point, or split along hard edges, one per corner
 *
 * The sum of the normals of the triangles around a point, weighted by their angle there (vtkMTMadeNormals), on the net
 * of so many bits. A point with degenerate triangles only gets the normal (0, 0, 1).
 *
 * Where normals are split, the triangles around a point fall into groups that are connected over edges of exactly two
 * triangles, of opposite directions, whose normals are within the feature angle of each other; every group has a sum of
 * its own. A degenerate triangle has the normal of the point's first group.
 */
#ifndef vtkMTPointNormals_h
#define vtkMTPointNormals_h

#include "vtkMTConstructionModule.h" // For export macro
#include "vtkMTMadeNormals.h"
#include "vtkMTPatch.h"

#include <array>
#include <cstdint>
#include <vector>

struct VTKMTCONSTRUCTION_EXPORT vtkMTPointNormals
{
  static std::vector<std::array<float, 3>> Compute(const vtkMTPatch& mesh, int bits);

  ///@{
  /// The parts of it, for meshes in fragments: what a triangle adds at each of its corners (false when it is
  /// degenerate), how that is added, and the direction of a sum. A reversed triangle adds exactly the opposite.
  static bool GetTerms(const vtkMTPatch& mesh, std::size_t triangle, std::array<std::array<double, 3>, 3>& terms);
  static void Add(const std::array<double, 3>& term, vtkMTMadeNormals::Sum& sum);
  static std::array<float, 3> GetDirection(const vtkMTMadeNormals::Sum& sum, int bits);
  ///@}

  /// A triangle at a point: its other two corners, in its order, and what it adds.
  struct Corner
  {
    std::uint32_t Next;
    std::uint32_t Previous;
    std::array<double, 3> Term;
  };
  /// Of a feature angle in degrees, for FindGroups: half a degree more, for what the lattice has rounded.
  static double GetCosine(double featureAngle);
  /// For each corner at a point its group: the index of the group's first corner.
  static std::vector<std::uint32_t> FindGroups(const std::vector<Corner>& corners, double cosine);
  /// For each corner at a point the normal of its group.
  static std::vector<std::array<float, 3>> GetNormalsOfGroups(
    const std::vector<Corner>& corners, double cosine, int bits);
  /// For each corner (3 t + c) its normal.
  static std::vector<std::array<float, 3>> ComputeByCorner(const vtkMTPatch& mesh, double featureAngle, int bits);

  /**
   * Of a simplified mesh, whose wedges have been given normals of the finer one: those of points that are not shared
   * (they come behind those with ids) become the mesh's own, all wedges of a point together where the normals are
   * smooth, else those of equal normals. All of them are put on the net. Wedges are in the order of their points.
   */
  static void Renew(const vtkMTPatch& mesh, bool isSmooth, int bits, vtkMTColumn& column);
};

#endif
