// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTStitch.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace
{
using Points = std::vector<std::array<double, 3>>;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

struct DirectedEdge
{
  std::uint32_t From;
  std::uint32_t To;
};

// The edges that one triangle alone uses. Edges are sorted into one bucket per smaller end, as 64-bit keys: larger end
// and direction.
std::vector<DirectedEdge> FindBorderEdges(std::size_t numberOfPoints, const Triangles& triangles)
{
  std::vector<std::size_t> first(numberOfPoints + 1, 0);
  for (const auto& t : triangles)
  {
    for (int c = 0; c < 3; ++c)
    {
      ++first[std::min(t[c], t[(c + 1) % 3]) + std::size_t(1)];
    }
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<std::uint64_t> keys(3 * triangles.size());
  std::vector<std::size_t> next(first.begin(), first.end() - 1);
  for (const auto& t : triangles)
  {
    for (int c = 0; c < 3; ++c)
    {
      const std::uint32_t a = t[c];
      const std::uint32_t b = t[(c + 1) % 3];
      keys[next[std::min(a, b)]++] = (std::uint64_t(std::max(a, b)) << 1) | (a < b ? 0u : 1u);
    }
  }
  std::vector<DirectedEdge> border;
  for (std::uint32_t low = 0; low < numberOfPoints; ++low)
  {
    const auto begin = keys.begin() + static_cast<std::ptrdiff_t>(first[low]);
    const auto end = keys.begin() + static_cast<std::ptrdiff_t>(first[low + std::size_t(1)]);
    std::sort(begin, end);
    for (auto key = begin; key != end;)
    {
      const auto edgeEnd = std::find_if(key, end, [key](std::uint64_t k) { return (k >> 1) != (*key >> 1); });
      if (edgeEnd - key == 1)
      {
        const std::uint32_t high = static_cast<std::uint32_t>(*key >> 1);
        border.push_back((*key & 1) ? DirectedEdge{ high, low } : DirectedEdge{ low, high });
      }
      key = edgeEnd;
    }
  }
  return border;
}

std::vector<std::int32_t> FindPartsOfPoints(
  std::size_t numberOfPoints, const Triangles& triangles, const std::vector<std::int32_t>& parts)
{
  std::vector<std::int32_t> ofPoints(parts.empty() ? 0 : numberOfPoints, std::numeric_limits<std::int32_t>::max());
  for (std::size_t t = 0; t < parts.size(); ++t)
  {
    for (std::uint32_t p : triangles[t])
    {
      ofPoints[p] = std::min(ofPoints[p], parts[t]);
    }
  }
  return ofPoints;
}

// For every end of an edge a number that is the same for points of one part at the same place.
std::vector<std::uint32_t> ClassifyPlaces(
  const Points& points, const std::vector<DirectedEdge>& edges, const std::vector<std::int32_t>& parts)
{
  const auto isBefore = [&](std::uint32_t a, std::uint32_t b)
  {
    const std::int32_t partOfA = parts.empty() ? 0 : parts[a];
    const std::int32_t partOfB = parts.empty() ? 0 : parts[b];
    return partOfA != partOfB ? partOfA < partOfB : points[a] < points[b];
  };
  std::vector<std::uint32_t> ends;
  ends.reserve(2 * edges.size());
  for (const DirectedEdge& e : edges)
  {
    ends.push_back(e.From);
    ends.push_back(e.To);
  }
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  std::sort(ends.begin(), ends.end(),
    [&isBefore](std::uint32_t a, std::uint32_t b) { return isBefore(a, b) || (!isBefore(b, a) && a < b); });
  std::vector<std::uint32_t> place(points.size(), 0);
  for (std::size_t i = 1; i < ends.size(); ++i)
  {
    place[ends[i]] = place[ends[i - 1]] + (isBefore(ends[i - 1], ends[i]) ? 1 : 0);
  }
  return place;
}

class UnionFind
{
public:
  explicit UnionFind(std::size_t size)
    : Parent(size)
  {
    std::iota(this->Parent.begin(), this->Parent.end(), 0u);
  }
  std::uint32_t Find(std::uint32_t x)
  {
    while (this->Parent[x] != x)
    {
      this->Parent[x] = this->Parent[this->Parent[x]];
      x = this->Parent[x];
    }
    return x;
  }
  // The smaller index stays the root, so that the result does not depend on the order of the calls.
  void Unite(std::uint32_t a, std::uint32_t b)
  {
    a = this->Find(a);
    b = this->Find(b);
    this->Parent[std::max(a, b)] = std::min(a, b);
  }

private:
  std::vector<std::uint32_t> Parent;
};

void SortByPlace(std::vector<DirectedEdge>& edges, const std::vector<std::uint32_t>& place)
{
  const auto key = [&place](const DirectedEdge& e)
  {
    const std::uint64_t a = place[e.From];
    const std::uint64_t b = place[e.To];
    return (std::min(a, b) << 32) | std::max(a, b);
  };
  std::sort(edges.begin(), edges.end(),
    [&key](const DirectedEdge& a, const DirectedEdge& b)
    {
      const std::uint64_t keyOfA = key(a);
      const std::uint64_t keyOfB = key(b);
      return keyOfA != keyOfB ? keyOfA < keyOfB : (a.From != b.From ? a.From < b.From : a.To < b.To);
    });
}
}

vtkMTStitch vtkMTStitch::Run(const Points& points, const Triangles& triangles, const std::vector<std::int32_t>& parts)
{
  vtkMTStitch result;
  UnionFind identity(points.size());
  std::vector<DirectedEdge> border = FindBorderEdges(points.size(), triangles);
  if (!border.empty())
  {
    const std::vector<std::uint32_t> place =
      ClassifyPlaces(points, border, FindPartsOfPoints(points.size(), triangles, parts));
    SortByPlace(border, place);
    const auto sameEdge = [&place](const DirectedEdge& a, const DirectedEdge& b)
    {
      return (place[a.From] == place[b.From] && place[a.To] == place[b.To]) ||
        (place[a.From] == place[b.To] && place[a.To] == place[b.From]);
    };
    for (std::size_t i = 0; i < border.size();)
    {
      std::size_t end = i + 1;
      while (end < border.size() && sameEdge(border[i], border[end]))
      {
        ++end;
      }
      if (end - i == 2 && place[border[i].From] == place[border[i + 1].To])
      {
        identity.Unite(border[i].From, border[i + 1].To);
        identity.Unite(border[i].To, border[i + 1].From);
        ++result.StitchedEdges;
      }
      i = end;
    }
  }
  result.Root.resize(points.size());
  for (std::uint32_t p = 0; p < points.size(); ++p)
  {
    result.Root[p] = identity.Find(p);
    result.StitchedPoints += result.Root[p] != p ? 1 : 0;
  }
  return result;
}
