// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTOrientation
 * @brief finds the triangles that run the other way round than their neighbours
 *
 * Files mix windings; a simplifier that needs oriented manifolds finds a border at every edge that both of its
 * triangles run along in the same direction. Here every part of the mesh that hangs together over edges of exactly two
 * triangles is walked from its first triangle on. Where it holds such an edge and can be oriented, the smaller number
 * of its triangles is to be turned round (on a tie the first triangle stays). A part that cannot be oriented, such as a
 * Moebius strip, stays as it is. Edges with more than two triangles connect nothing.
 */
#ifndef vtkMTOrientation_h
#define vtkMTOrientation_h

#include "vtkMTConstructionModule.h" // For export macro
#include "vtkMTPatch.h"

#include <cstdint>
#include <vector>

struct VTKMTCONSTRUCTION_EXPORT vtkMTOrientation
{
  std::vector<std::uint32_t> Reversed;    ///< triangles to turn round, in increasing order
  std::size_t NonOrientableTriangles = 0; ///< in parts that cannot be oriented

  static vtkMTOrientation Run(const vtkMTPatch& mesh);
};

#endif
