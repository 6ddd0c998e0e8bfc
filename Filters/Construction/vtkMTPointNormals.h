// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTPointNormals
 * @brief smooth normals of a mesh, one per point
 *
 * The sum of the normals of the triangles around a point, weighted by their angle there (Thuermer and Wuethrich,
 * "Computing vertex normals from polygonal facets", 1998), so that the triangulation of a flat part has no influence. A
 * point with degenerate triangles only gets the normal (0, 0, 1). The order of summation is that of the triangles.
 */
#ifndef vtkMTPointNormals_h
#define vtkMTPointNormals_h

#include "vtkMTConstructionModule.h" // For export macro
#include "vtkMTPatch.h"

#include <array>
#include <vector>

struct VTKMTCONSTRUCTION_EXPORT vtkMTPointNormals
{
  static std::vector<std::array<float, 3>> Compute(const vtkMTPatch& mesh);

  ///@{
  /// The parts of it, for meshes in fragments: what a triangle adds at each of its corners (false when it is
  /// degenerate), and the direction of a sum. A reversed triangle adds exactly the opposite.
  static bool GetTerms(const vtkMTPatch& mesh, std::size_t triangle, std::array<std::array<double, 3>, 3>& terms);
  static std::array<float, 3> GetDirection(const std::array<double, 3>& sum);
  ///@}
};

#endif
