// SPDX-License-Identifier: BSD-3-Clause
// What differs between the versions of VTK that the toolkit builds against (9.1 and ParaView's 9.2), and whether a
// filter is to stop.
#ifndef vtkMTCompatibility_h
#define vtkMTCompatibility_h

#include "Interpreter/vtkMTLongWork.h"
#include "vtkAlgorithm.h"
#include "vtkVersion.h"

/// Whether the algorithm was asked to stop, by AbortExecute or by an interrupt.
inline bool vtkMTIsAborted(vtkAlgorithm* algorithm)
{
  if (vtkMTLongWork::IsInterrupted())
  {
    algorithm->AbortExecuteOn();
  }
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20220816)
  return algorithm->CheckAbort();
#else
  return algorithm->GetAbortExecute() != 0;
#endif
}

#endif
