// SPDX-License-Identifier: BSD-3-Clause
// What differs between the versions of VTK that the toolkit builds against (9.1 and ParaView's 9.2), and nothing else.
#ifndef vtkMTCompatibility_h
#define vtkMTCompatibility_h

#include "vtkAlgorithm.h"
#include "vtkVersion.h"

/// Whether the algorithm was asked to stop.
inline bool vtkMTIsAborted(vtkAlgorithm* algorithm)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20220816)
  return algorithm->CheckAbort();
#else
  return algorithm->GetAbortExecute() != 0;
#endif
}

#endif
