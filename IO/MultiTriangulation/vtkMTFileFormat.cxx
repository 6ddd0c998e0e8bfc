// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTFileFormat.h"

#include <xxhash.h>

namespace vtkMTFileFormat
{
std::uint64_t Checksum(const void* data, std::size_t size)
{
  return XXH3_64bits(data, size);
}
}
