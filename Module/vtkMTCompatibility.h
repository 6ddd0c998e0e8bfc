// SPDX-License-Identifier: BSD-3-Clause
// What differs between the versions of VTK that the toolkit builds against (9.1 and ParaView's 9.2), and whether a
// filter is to stop.
#ifndef vtkMTCompatibility_h
#define vtkMTCompatibility_h

#include "Interpreter/vtkMTLongWork.h"
#include "vtkAlgorithm.h"
#include "vtkVersion.h"

/// Whether the algorithm was asked to stop, by AbortExecute or by an interrupt. Older pipelines take AbortExecute back
/// before the next execution; in newer ones the user does, so that an interrupt must not set it there.
inline bool vtkMTIsAborted(vtkAlgorithm* algorithm)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20220816)
  if (vtkMTLongWork::IsInterrupted())
  {
    algorithm->SetAbortOutput(true);
    return true;
  }
  return algorithm->CheckAbort();
#else
  if (vtkMTLongWork::IsInterrupted())
  {
    algorithm->AbortExecuteOn();
  }
  return algorithm->GetAbortExecute() != 0;
#endif
}

/// Work that is asked for anew, outside of a pipeline's execution, knows nothing of an abort of before.
inline void vtkMTForgetAbort(vtkAlgorithm* algorithm)
{
  algorithm->AbortExecuteOff();
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20220816)
  algorithm->SetAbortOutput(false);
#endif
}

#endif
