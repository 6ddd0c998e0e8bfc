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

// Every border edge twice, from either end, sorted.
std::vector<std::uint64_t> FindBorderEdges(const vtkMTPatch& mesh, const std::vector<std::uint32_t>& triangles)
{
  std::vector<std::uint64_t> edges;
  std::vector<std::uint64_t> scratch;
  edges.reserve(3 * triangles.size());
  for (const std::uint32_t t : triangles)
  {
    const vtkMTTriangle p = mesh.GetPointsOfTriangle(t);
    for (int c = 0; c < 3; ++c)
    {
      const auto [low, high] = std::minmax(p[c], p[(c + 1) % 3]);
      edges.push_back(Join(low, high));
    }
  }
  vtkMTRadixSort::Sort(edges, scratch);
  std::vector<std::uint64_t> border;
  for (std::size_t i = 0; i < edges.size();)
  {
    const std::size_t begin = i;
    while (i < edges.size() && edges[i] == edges[begin])
    {
      ++i;
    }
    const auto low = static_cast<std::uint32_t>(edges[begin] >> 32);
    const auto high = static_cast<std::uint32_t>(edges[begin]);
    if ((i - begin) % 2 != 0 && low != high)
    {
      border.push_back(Join(low, high));
      border.push_back(Join(high, low));
    }
  }
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
