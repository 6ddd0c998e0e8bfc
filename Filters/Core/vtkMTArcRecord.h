// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTArcRecord
 * @brief what the DAG keeps of a patch: counts, tight box, normal cone, mean edge length
 */
#ifndef vtkMTArcRecord_h
#define vtkMTArcRecord_h

#include "vtkMTFiltersCoreModule.h" // For export macro
#include "vtkMTGraph.h"

struct vtkMTPatch;

/// step: of the lattice, model units. From and To are left 0.
VTKMTFILTERSCORE_EXPORT vtkMTArc vtkMTMakeArcRecord(const vtkMTPatch& patch, double step);

#endif
