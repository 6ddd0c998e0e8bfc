// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTFrameHeap
 * @brief has the C library keep what a frame frees for the next one
 *
 * Software OpenGL takes tens of megabytes from the heap for a frame, in small blocks, and frees them after it. glibc
 * gives the top of the heap back to the system when more than 128 KiB of it are free, so that each frame fetches its
 * pages anew: frames take five times as long. It stops doing so, up to 64 MiB, once the process has freed a block of
 * 32 MiB (M_TRIM_THRESHOLD in mallopt(3)), which some programs do by chance. Keep() does it on purpose. No page of that
 * block is touched. A process that has set these thresholds, by mallopt or by its environment, keeps its own.
 */
#ifndef vtkMTFrameHeap_h
#define vtkMTFrameHeap_h

#include "vtkMTRenderingCoreModule.h" // For export macro

class VTKMTRENDERINGCORE_EXPORT vtkMTFrameHeap
{
public:
  static void Keep();
};

#endif
