// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTBorderOrder.h"

#include "vtkMTRadixSort.h"

#include <algorithm>
#include <numeric>

namespace
{
std::uint64_t Join(std::uint32_t high, std::uint32_t low)
{
  return (std::uint64_t(high) << 32) | low;
}

// Edges that were met an odd number of times, in a table with open addressing.
class OddEdges
{
public:
  explicit OddEdges(std::size_t edges)
  {
    while ((std::size_t(1) << this->Bits) < 2 * edges)
    {
      ++this->Bits;
    }
    this->Keys.assign(std::size_t(1) << this->Bits, None);
    this->IsOdd.assign(this->Keys.size(), 0);
  }

  void Meet(std::uint64_t edge)
  {
    std::size_t at = static_cast<std::size_t>((edge * 0x9E3779B97F4A7C15u) >> (64 - this->Bits));
    while (this->Keys[at] != edge && this->Keys[at] != None)
    {
      at = (at + 1) & (this->Keys.size() - 1);
    }
    this->Keys[at] = edge;
    this->IsOdd[at] ^= 1;
  }

  template <typename Function>
  void ForAll(Function&& function) const
  {
    for (std::size_t i = 0; i < this->Keys.size(); ++i)
    {
      if (this->IsOdd[i] != 0)
      {
        function(this->Keys[i]);
      }
    }
  }

private:
  static constexpr std::uint64_t None = ~std::uint64_t(0); // no edge: its ends would be equal
  unsigned Bits = 4;
  std::vector<std::uint64_t> Keys;
  std::vector<unsigned char> IsOdd;
};

// Every border edge twice, from either end, sorted.
std::vector<std::uint64_t> FindBorderEdges(const vtkMTPatch& mesh, const std::vector<std::uint32_t>& triangles)
{
  OddEdges edges(3 * triangles.size());
  for (const std::uint32_t t : triangles)
  {
    const vtkMTTriangle p = mesh.GetPointsOfTriangle(t);
    for (int c = 0; c < 3; ++c)
    {
      const auto [low, high] = std::minmax(p[c], p[(c + 1) % 3]);
      if (low != high)
      {
        edges.Meet(Join(low, high));
      }
    }
  }
  std::vector<std::uint64_t> border;
  edges.ForAll(
    [&border](std::uint64_t edge)
    {
      border.push_back(edge);
      border.push_back((edge << 32) | (edge >> 32));
    });
  std::vector<std::uint64_t> scratch;
  vtkMTRadixSort::Sort(border, scratch);
  return border;
}
}

std::vector<std::uint32_t> vtkMTBorderOrder::Find(const vtkMTPatch& mesh, const std::vector<std::uint32_t>& triangles)
{
  const std::vector<std::uint64_t> edges = FindBorderEdges(mesh, triangles);
  const auto getFrom = [&edges](std::size_t i) { return static_cast<std::uint32_t>(edges[i] >> 32); };
  const auto findFirst = [&edges](std::uint32_t point)
  {
    return static_cast<std::size_t>(
      std::lower_bound(edges.begin(), edges.end(), std::uint64_t(point) << 32) - edges.begin());
  };
  std::vector<unsigned char> isMet(edges.size(), 0); // by the first edge that leaves the point
  std::vector<std::uint32_t> order;
  constexpr std::size_t none = ~std::size_t(0);
  for (std::size_t start = 0; start < edges.size(); ++start)
  {
    const bool isFirst = start == 0 || getFrom(start - 1) != getFrom(start);
    for (std::size_t at = isFirst && !isMet[start] ? start : none; at != none;)
    {
      const std::uint32_t point = getFrom(at);
      isMet[at] = 1;
      order.push_back(point);
      std::size_t next = none;
      for (; next == none && at < edges.size() && getFrom(at) == point; ++at)
      {
        const std::size_t to = findFirst(static_cast<std::uint32_t>(edges[at]));
        next = isMet[to] ? none : to;
      }
      at = next;
    }
  }
  return order;
}

std::vector<std::uint32_t> vtkMTBorderOrder::Find(const vtkMTPatch& mesh)
{
  std::vector<std::uint32_t> all(mesh.Triangles.size());
  std::iota(all.begin(), all.end(), 0u);
  return Find(mesh, all);
}
