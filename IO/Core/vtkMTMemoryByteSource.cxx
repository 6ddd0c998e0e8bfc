// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTMemoryByteSource.h"

#include <cstring>
#include <utility>

vtkMTMemoryByteSource::vtkMTMemoryByteSource(std::vector<unsigned char> bytes)
  : Bytes(std::move(bytes))
{
}

vtkMTMemoryByteSource::~vtkMTMemoryByteSource() = default;

bool vtkMTMemoryByteSource::Read(std::uint64_t offset, std::size_t count, void* destination, std::string& error) const
{
  if (offset > this->Bytes.size() || count > this->Bytes.size() - offset)
  {
    error = "memory: bytes " + std::to_string(offset) + " to " + std::to_string(offset + count) +
      " lie beyond the end at " + std::to_string(this->Bytes.size());
    return false;
  }
  if (count > 0)
  {
    std::memcpy(destination, this->Bytes.data() + offset, count);
  }
  return true;
}
