// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTFrameHeap.h"

#include <cstdlib>

void vtkMTFrameHeap::Keep()
{
  // glibc follows blocks up to 32 MiB, with what it adds to each.
  constexpr std::size_t largest = (32 << 20) - 8192;
  void* volatile block = std::malloc(largest); // volatile, or the compiler leaves both calls out
  std::free(block);
}
