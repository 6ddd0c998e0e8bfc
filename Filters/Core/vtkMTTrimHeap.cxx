// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTTrimHeap.h"

#include <cstdlib> // for __GLIBC__
#include <fstream>

#ifdef __GLIBC__
#include <malloc.h>
#endif
#include <unistd.h>

std::uint64_t vtkMTTrimHeap::GetResidentSize()
{
  std::ifstream file("/proc/self/statm");
  std::uint64_t size = 0;
  std::uint64_t resident = 0;
  file >> size >> resident;
  return file ? resident * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)) : 0;
}

vtkMTTrimHeap::~vtkMTTrimHeap()
{
#ifdef __GLIBC__
  if (this->Limit > 0 && GetResidentSize() > this->Limit / 2)
  {
    malloc_trim(0);
  }
#endif
}
