// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTChecksum.h"

#include <xxhash.h>

std::uint64_t vtkMTChecksum(const void* data, std::size_t size)
{
  return XXH3_64bits(data, size);
}
