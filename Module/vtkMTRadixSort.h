// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTRadixSort
 * @brief sorts items by a 64-bit key, equal ones in the order in which they were
 *
 * Digits of eight bits, the least first; digits that all keys share cost nothing. Short lists are left to the standard
 * library.
 */
#ifndef vtkMTRadixSort_h
#define vtkMTRadixSort_h

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

class vtkMTRadixSort
{
public:
  /// key(item) gives the key; scratch is overwritten.
  template <typename Item, typename Key>
  static void Sort(std::vector<Item>& items, std::vector<Item>& scratch, Key&& key)
  {
    if (items.size() < ShortList)
    {
      std::stable_sort(items.begin(), items.end(), [&key](const Item& a, const Item& b) { return key(a) < key(b); });
      return;
    }
    std::uint64_t ones = 0;
    std::uint64_t zeros = 0;
    for (const Item& item : items)
    {
      ones |= key(item);
      zeros |= ~key(item);
    }
    const std::uint64_t varying = ones & zeros;
    scratch.resize(items.size());
    for (unsigned shift = 0; shift < 64; shift += 8)
    {
      if (((varying >> shift) & 255) != 0)
      {
        SortByDigit(items, scratch, key, shift);
      }
    }
  }

  static void Sort(std::vector<std::uint64_t>& keys, std::vector<std::uint64_t>& scratch)
  {
    Sort(keys, scratch, [](std::uint64_t key) { return key; });
  }

private:
  template <typename Item, typename Key>
  static void SortByDigit(std::vector<Item>& items, std::vector<Item>& scratch, Key&& key, unsigned shift)
  {
    std::array<std::size_t, 256> places{};
    for (const Item& item : items)
    {
      ++places[(key(item) >> shift) & 255];
    }
    std::size_t sum = 0;
    for (std::size_t& place : places)
    {
      const std::size_t count = place;
      place = sum;
      sum += count;
    }
    for (const Item& item : items)
    {
      scratch[places[(key(item) >> shift) & 255]++] = item;
    }
    items.swap(scratch);
  }

  static constexpr std::size_t ShortList = 512;
};

#endif
