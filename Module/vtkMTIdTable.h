// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTIdTable
 * @brief hash table from 64-bit keys to 32-bit indices, open addressing with linear probing (private to this module)
 *
 * Two patches' points are matched by id millions of times while a model is built and verified; a table of pairs without
 * pointers takes a quarter of std::unordered_map's time.
 */
#ifndef vtkMTIdTable_h
#define vtkMTIdTable_h

#include <cstddef>
#include <cstdint>
#include <vector>

class vtkMTIdTable
{
public:
  static constexpr std::uint32_t None = ~std::uint32_t(0);

  /// The value of the key, to be read and changed; None when the key is new. Valid until the next call; a value must be
  /// given before that to a key that was new.
  std::uint32_t& operator[](std::uint64_t key)
  {
    if (2 * (this->Count + 1) > this->Slots.size())
    {
      this->Grow();
    }
    Slot& slot = this->Find(key);
    if (slot.Value == None)
    {
      slot.Key = key;
      ++this->Count;
    }
    return slot.Value;
  }

private:
  struct Slot
  {
    std::uint64_t Key = 0;
    std::uint32_t Value = None;
  };

  Slot& Find(std::uint64_t key)
  {
    const std::size_t mask = this->Slots.size() - 1;
    // Fibonacci hashing after folding: ids are often consecutive, or differ in their high halves only.
    std::size_t i = (((key ^ (key >> 29)) * 0x9E3779B97F4A7C15ull) >> 24) & mask;
    while (this->Slots[i].Value != None && this->Slots[i].Key != key)
    {
      i = (i + 1) & mask;
    }
    return this->Slots[i];
  }

  void Grow()
  {
    std::vector<Slot> old(this->Slots.empty() ? 256 : 2 * this->Slots.size());
    old.swap(this->Slots);
    for (const Slot& slot : old)
    {
      if (slot.Value != None)
      {
        this->Find(slot.Key) = slot;
      }
    }
  }

  std::vector<Slot> Slots;
  std::size_t Count = 0;
};

#endif
