// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTTrimHeap
 * @brief gives what was freed back to the system when it goes out of scope
 *
 * What threads have freed stays with their heaps, and counts as the process's, otherwise. To be made before what is
 * freed, so that it goes after that.
 */
#ifndef vtkMTTrimHeap_h
#define vtkMTTrimHeap_h

#include <cstdlib> // for __GLIBC__

#ifdef __GLIBC__
#include <malloc.h>
#endif

class vtkMTTrimHeap
{
public:
  vtkMTTrimHeap() = default;
  ~vtkMTTrimHeap()
  {
#ifdef __GLIBC__
    malloc_trim(0);
#endif
  }
  vtkMTTrimHeap(const vtkMTTrimHeap&) = delete;
  void operator=(const vtkMTTrimHeap&) = delete;
};

#endif
