// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTRangeAllocator.h"

#include <algorithm>
#include <iterator>

void vtkMTRangeAllocator::Reset(std::uint64_t capacity)
{
  this->FreeRanges.clear();
  this->Used = 0;
  this->Capacity = 0;
  this->Grow(capacity);
}

void vtkMTRangeAllocator::Grow(std::uint64_t capacity)
{
  if (capacity <= this->Capacity)
  {
    return;
  }
  const std::uint64_t added = capacity - this->Capacity;
  const std::uint64_t offset = this->Capacity;
  this->Capacity = capacity;
  this->Used += added;
  this->Free(offset, added);
}

std::uint64_t vtkMTRangeAllocator::Allocate(std::uint64_t size)
{
  if (size == 0)
  {
    return 0;
  }
  for (auto range = this->FreeRanges.begin(); range != this->FreeRanges.end(); ++range)
  {
    if (range->second >= size)
    {
      const std::uint64_t offset = range->first;
      const std::uint64_t rest = range->second - size;
      this->FreeRanges.erase(range);
      if (rest > 0)
      {
        this->FreeRanges.emplace(offset + size, rest);
      }
      this->Used += size;
      return offset;
    }
  }
  return Nowhere;
}

void vtkMTRangeAllocator::Free(std::uint64_t offset, std::uint64_t size)
{
  if (size == 0)
  {
    return;
  }
  this->Used -= size;
  auto next = this->FreeRanges.lower_bound(offset);
  if (next != this->FreeRanges.end() && next->first == offset + size)
  {
    size += next->second;
    next = this->FreeRanges.erase(next);
  }
  if (next != this->FreeRanges.begin())
  {
    const auto previous = std::prev(next);
    if (previous->first + previous->second == offset)
    {
      previous->second += size;
      return;
    }
  }
  this->FreeRanges.emplace(offset, size);
}

std::uint64_t vtkMTRangeAllocator::GetLargestFree() const
{
  std::uint64_t largest = 0;
  for (const auto& range : this->FreeRanges)
  {
    largest = std::max(largest, range.second);
  }
  return largest;
}
