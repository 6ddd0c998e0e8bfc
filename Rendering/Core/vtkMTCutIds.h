// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTCutIds
 * @brief the input's ids of a cut's mesh, also where its patches are coarse
 *
 * vtkMTCutMesh gives triangles and points of coarse patches the id -1 where a model keeps the input's ids on its finest
 * level alone. This puts in their place the id of the input's cell that is nearest to a triangle's barycentre, and of
 * the point that is nearest to a point (vtkMTInputIdFinder).
 */
#ifndef vtkMTCutIds_h
#define vtkMTCutIds_h

#include "vtkMTInputIdFinder.h"
#include "vtkMTRenderingCoreModule.h" // For export macro

#include <cstdint>
#include <string>
#include <vector>

class vtkMTPatchSource;
class vtkPolyData;
struct vtkMTPlacement;

struct VTKMTRENDERINGCORE_EXPORT vtkMTCutIds
{
  /// mesh: what vtkMTCutMesh made of these arcs, with that placement (null: none), with or without the arrays. False
  /// where ids could not be found, with the reason in error; without one, progress stopped it.
  static bool Fill(const vtkMTPatchSource& source, const std::vector<std::uint32_t>& arcs,
    const vtkMTPlacement* placement, vtkPolyData* mesh, const vtkMTInputIdFinder::Progress& progress,
    std::string& error);
};

#endif
