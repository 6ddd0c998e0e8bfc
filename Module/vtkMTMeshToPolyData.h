// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTMeshToPolyData
 * @brief a patch or an assembled mesh as vtkPolyData
 *
 * One VTK point per wedge (VTK's points carry one set of attribute values), in double precision: Step * (Origin + k) is
 * exact there. Arrays get back their names, types, component names and active attributes. Where the mesh has exact
 * points (vtkMTExactPoints), the points are these, in single precision if the input's were floats.
 */
#ifndef vtkMTMeshToPolyData_h
#define vtkMTMeshToPolyData_h

#include "vtkMTCoreModule.h" // For export macro
#include "vtkMTPatch.h"

#include <vector>

class vtkPolyData;
struct vtkMTLattice;

struct VTKMTCORE_EXPORT vtkMTMeshToPolyData
{
  /// False, with an empty output, when the exact points are not those of this lattice.
  static bool Convert(const vtkMTPatch& mesh, const vtkMTLattice& lattice, const std::vector<vtkMTArrayInfo>& arrays,
    vtkPolyData* output);
};

#endif
