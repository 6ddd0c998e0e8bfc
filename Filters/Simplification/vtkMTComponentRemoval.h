// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTComponentRemoval
 * @brief leaves out whole small components of a fragment that cannot be simplified any further
 *
 * A mesh of many small components (leaves, bolts, triangle soup) stops shrinking when each of them is a tetrahedron or
 * a single triangle. From there on the only way to fewer triangles is to leave components out. Triangles that share a
 * point are of one component. Those without a locked point may go, smallest bounding-box diagonal first, ties by index,
 * until the target is reached; never the last one, and none whose diagonal is above MaximumDiagonal: a component that
 * is left out costs an error of at least about its own size, so only tiny ones are worth it.
 */
#ifndef vtkMTComponentRemoval_h
#define vtkMTComponentRemoval_h

#include "vtkMTSimplificationModule.h" // For export macro
#include "vtkMTSimplifier.h"

#include <cstddef>
#include <vector>

class VTKMTSIMPLIFICATION_EXPORT vtkMTComponentRemoval
{
public:
  double MaximumDiagonal =
    0.0; ///< lattice steps; 0 (the default) lets only components that are one place go, below 0 none

  /**
   * locked has one entry per point of the floor that the result was made from. Fills RemovedComponents and
   * Blocked["component_triangles"]; the result keeps its order and only points and wedges in use.
   */
  void Remove(const std::vector<unsigned char>& locked, std::size_t target, vtkMTSimplification& result) const;
};

#endif
