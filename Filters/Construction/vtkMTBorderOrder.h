// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTBorderOrder
 * @brief the points on the border of a part of a mesh, one after the other along it
 *
 * New identities are numbered in this order. A patch of a file stores the identities of its shared points along
 * its border as well: those that were made together follow each other there, and a whole run takes a few bytes. An
 * edge is on the border when an odd number of the part's triangles use it, so every border is made of closed walks,
 * whatever the mesh and its orientation are. A walk begins at its point of the least index and goes on to the neighbour
 * of the least index that was not met yet.
 */
#ifndef vtkMTBorderOrder_h
#define vtkMTBorderOrder_h

#include "vtkMTConstructionModule.h" // For export macro
#include "vtkMTPatch.h"

#include <cstdint>
#include <vector>

struct VTKMTCONSTRUCTION_EXPORT vtkMTBorderOrder
{
  /// The border of the given triangles of the mesh; every point of it once.
  static std::vector<std::uint32_t> Find(const vtkMTPatch& mesh, const std::vector<std::uint32_t>& triangles);
  /// That of all triangles.
  static std::vector<std::uint32_t> Find(const vtkMTPatch& mesh);
};

#endif
