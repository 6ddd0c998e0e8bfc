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
    std::vector<std::array<std::size_t, 256>> counts(8);
    for (auto& count : counts)
    {
      count.fill(0);
    }
    for (const Item& item : items)
    {
      const std::uint64_t k = key(item);
      for (std::size_t digit = 0; digit < 8; ++digit)
      {
        ++counts[digit][(k >> (8 * digit)) & 255];
      }
    }
    scratch.resize(items.size());
    for (std::size_t digit = 0; digit < 8; ++digit)
    {
      std::array<std::size_t, 256>& places = counts[digit];
      if (places[(key(items[0]) >> (8 * digit)) & 255] == items.size())
      {
        continue;
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
        scratch[places[(key(item) >> (8 * digit)) & 255]++] = item;
      }
      items.swap(scratch);
    }
  }

  static void Sort(std::vector<std::uint64_t>& keys, std::vector<std::uint64_t>& scratch)
  {
    Sort(keys, scratch, [](std::uint64_t key) { return key; });
  }

private:
  static constexpr std::size_t ShortList = 512;
};

#endif
