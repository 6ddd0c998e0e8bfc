// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTSpoolQueue.h"

#include <algorithm>

namespace
{
constexpr std::size_t BufferSize = std::size_t(1) << 18;
}

bool vtkMTSpoolQueue::Flush(std::string& error)
{
  if (!this->Spool)
  {
    this->Spool = this->Store.Create(error);
  }
  const bool done = this->Spool && this->Spool->Append(this->Buffer.data(), this->Buffer.size(), error);
  this->Buffer.clear();
  return done;
}

bool vtkMTSpoolQueue::Put(const void* data, std::size_t size, std::string& error)
{
  const unsigned char* from = static_cast<const unsigned char*>(data);
  this->Buffer.insert(this->Buffer.end(), from, from + size);
  this->Size += size;
  return this->Buffer.size() < BufferSize || this->Flush(error);
}

bool vtkMTSpoolQueue::Seal(std::string& error)
{
  const bool done = !this->Spool || this->Flush(error);
  this->Rewind();
  return done;
}

void vtkMTSpoolQueue::Rewind()
{
  this->Place = 0;
  if (this->Spool)
  {
    this->Buffer.clear();
    this->BufferEnd = 0;
  }
}

const unsigned char* vtkMTSpoolQueue::Take(std::size_t size, std::string& error)
{
  if (this->Buffer.size() - this->Place < size && this->Spool)
  {
    const std::size_t kept = this->Buffer.size() - this->Place;
    const std::uint64_t left = this->Size - this->BufferEnd;
    const std::size_t count = static_cast<std::size_t>(std::min<std::uint64_t>(std::max(BufferSize, size), left));
    std::copy(this->Buffer.end() - static_cast<std::ptrdiff_t>(kept), this->Buffer.end(), this->Buffer.begin());
    this->Buffer.resize(kept + count);
    this->Place = 0;
    if (!this->Spool->Read(this->BufferEnd, count, this->Buffer.data() + kept, error))
    {
      return nullptr;
    }
    this->BufferEnd += count;
  }
  if (this->Buffer.size() - this->Place < size)
  {
    error = "temporary data ends early";
    return nullptr;
  }
  const unsigned char* bytes = this->Buffer.data() + this->Place;
  this->Place += size;
  return bytes;
}
