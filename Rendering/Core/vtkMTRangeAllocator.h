// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTRangeAllocator
 * @brief hands out ranges of a large buffer and takes them back
 *
 * First fit over free ranges that are kept apart by at least one element in use: ranges that are given back are joined
 * with their free neighbours at once. Offsets and sizes are counted in elements; what they are is the caller's matter.
 */
#ifndef vtkMTRangeAllocator_h
#define vtkMTRangeAllocator_h

#include "vtkMTRenderingCoreModule.h" // For export macro

#include <cstdint>
#include <map>

class VTKMTRENDERINGCORE_EXPORT vtkMTRangeAllocator
{
public:
  static constexpr std::uint64_t Nowhere = ~std::uint64_t(0);

  /// Everything is free again.
  void Reset(std::uint64_t capacity);
  /// Adds free elements at the end; a smaller capacity than now is ignored.
  void Grow(std::uint64_t capacity);

  /// The offset of the lowest free range that holds `size` elements, or Nowhere. Size 0 takes nothing and gives 0.
  std::uint64_t Allocate(std::uint64_t size);
  /// Takes back what Allocate gave, with the same size.
  void Free(std::uint64_t offset, std::uint64_t size);

  std::uint64_t GetCapacity() const { return this->Capacity; }
  std::uint64_t GetUsed() const { return this->Used; }
  std::uint64_t GetLargestFree() const;

private:
  std::map<std::uint64_t, std::uint64_t> FreeRanges; // offset to size
  std::uint64_t Capacity = 0;
  std::uint64_t Used = 0;
};

#endif
