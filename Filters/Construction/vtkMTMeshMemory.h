// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTMeshMemory
 * @brief how much memory, and room for spools, the construction takes for a mesh
 *
 * The wanted patch sets the size of regions, as a rule; the input's counts and arrays set the rest. The figures per
 * triangle were measured and rounded up (Testing/Applications measures them again, from outside).
 */
#ifndef vtkMTMeshMemory_h
#define vtkMTMeshMemory_h

#include "vtkMTConstructionModule.h" // For export macro
#include "vtkMTMemoryPlan.h"

class vtkMTTriangleStream;
struct vtkMTBuildSettings;

struct VTKMTCONSTRUCTION_EXPORT vtkMTMeshMemory
{
  vtkMTMeshMemory(const vtkMTTriangleStream& input, const vtkMTBuildSettings& settings);

  vtkMTMemoryPlan::Needs Needs;
  ///@{
  /// Bytes that simplifying a region, or splitting a fragment, takes per byte of its records.
  double PerByteSimplified = 0.0;
  double PerByteSplit = 0.0;
  ///@}
};

#endif
