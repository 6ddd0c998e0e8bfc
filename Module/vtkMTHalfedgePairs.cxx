// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTHalfedgePairs.h"

#include <algorithm>

namespace
{
// A half-edge met so far, one of each pair, in a list of those with the same hash value.
struct Entry
{
  std::uint32_t Low; // the two points
  std::uint32_t High;
  std::uint32_t Next; // in the list
  bool IsOver;        // they cannot be paired: there is a third one, or the two do not fit
};

std::uint32_t Hash(std::uint32_t low, std::uint32_t high)
{
  const std::uint32_t mixed = low * 0x9E3779B1u ^ (high - low) * 0x85EBCA77u;
  return mixed ^ (mixed >> 15);
}
}

//------------------------------------------------------------------------------
std::vector<std::uint32_t> vtkMTHalfedgePairs::Find(const std::vector<std::uint32_t>& corners)
{
  const auto count = static_cast<std::uint32_t>(corners.size());
  std::vector<std::uint32_t> opposites(count, None);
  std::size_t lists = 16;
  while (lists < corners.size())
  {
    lists *= 2;
  }
  std::vector<std::uint32_t> first(lists, None);
  std::vector<Entry> entries(count);
  for (std::uint32_t h = 0; h < count; ++h)
  {
    const std::uint32_t low = std::min(corners[h], corners[Next(h)]);
    const std::uint32_t high = std::max(corners[h], corners[Next(h)]);
    std::uint32_t& list = first[Hash(low, high) & (lists - 1)];
    std::uint32_t known = list;
    while (known != None && (entries[known].High != high || entries[known].Low != low))
    {
      known = entries[known].Next;
    }
    if (known == None)
    {
      entries[h] = { low, high, list, false };
      list = h;
      continue;
    }
    std::uint32_t& opposite = opposites[known];
    if (opposite != None)
    {
      opposites[opposite] = None;
      opposite = None;
      entries[known].IsOver = true;
    }
    else if (corners[known] == corners[h] || corners[Previous(known)] == corners[Previous(h)])
    {
      entries[known].IsOver = true;
    }
    else if (!entries[known].IsOver)
    {
      opposite = h;
      opposites[h] = known;
    }
  }
  return opposites;
}
