// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTBorderOrder.h"

#include "vtkMTHalfedgePairs.h"

#include <algorithm>
#include <numeric>

namespace
{
std::uint64_t Join(std::uint32_t a, std::uint32_t b)
{
  return (std::uint64_t(std::min(a, b)) << 32) | std::max(a, b);
}

// The finaliser of SplitMix64.
std::uint64_t Hash(std::uint64_t number)
{
  std::uint64_t hash = (number + 1) * 0x9e3779b97f4a7c15u;
  hash = (hash ^ (hash >> 30)) * 0xbf58476d1ce4e5b9u;
  hash = (hash ^ (hash >> 27)) * 0x94d049bb133111ebu;
  return hash ^ (hash >> 31);
}

// Leaves those that are there an odd number of times, once.
void KeepOdd(std::vector<std::uint64_t>& edges)
{
  std::sort(edges.begin(), edges.end());
  std::size_t kept = 0;
  for (std::size_t i = 0, end = 0; i < edges.size(); i = end)
  {
    while (end < edges.size() && edges[end] == edges[i])
    {
      ++end;
    }
    edges[kept] = edges[i];
    kept += (end - i) % 2;
  }
  edges.resize(kept);
}

// Walks along edges, each given once.
std::vector<std::uint32_t> Walk(std::vector<std::uint64_t>& edges)
{
  const std::size_t count = edges.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    edges.push_back((edges[i] << 32) | (edges[i] >> 32));
  }
  std::sort(edges.begin(), edges.end()); // from either end
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
}

std::vector<std::uint32_t> vtkMTBorderOrder::Find(const vtkMTPatch& mesh, const vtkMTHalfedgePairs& pairs)
{
  std::vector<std::uint64_t> edges;
  for (std::uint32_t h = 0; h < pairs.Partners.size(); ++h)
  {
    if (pairs.Partners[h] >= vtkMTHalfedgePairs::Odd)
    {
      const std::uint32_t from = pairs.Corners[h];
      const std::uint32_t to = pairs.Corners[vtkMTHalfedgePairs::Next(h)];
      if (from != to && std::max(from, to) < mesh.Points.size())
      {
        edges.push_back(Join(from, to));
      }
    }
  }
  return Walk(edges);
}

std::vector<std::uint32_t> vtkMTBorderOrder::Find(const vtkMTPatch& mesh)
{
  return Find(mesh, vtkMTHalfedgePairs(mesh));
}

//------------------------------------------------------------------------------
vtkMTBorderOrder::vtkMTBorderOrder(const vtkMTPatch& mesh)
  : Mesh(mesh)
  , Hashes(mesh.Points.size())
  , Left(mesh.Points.size(), 0)
{
  for (std::size_t p = 0; p < this->Hashes.size(); ++p)
  {
    this->Hashes[p] = Hash(p);
  }
}

void vtkMTBorderOrder::FindOddEdges(const std::vector<std::uint32_t>& triangles, std::vector<std::uint64_t>& edges)
{
  for (const std::uint32_t t : triangles)
  {
    const vtkMTTriangle p = this->Mesh.GetPointsOfTriangle(t);
    const std::uint64_t hashes[3] = { this->Hashes[p[0]], this->Hashes[p[1]], this->Hashes[p[2]] };
    this->Left[p[0]] ^= hashes[1] ^ hashes[2];
    this->Left[p[1]] ^= hashes[2] ^ hashes[0];
    this->Left[p[2]] ^= hashes[0] ^ hashes[1];
  }
  for (const std::uint32_t t : triangles)
  {
    const vtkMTTriangle p = this->Mesh.GetPointsOfTriangle(t);
    const bool isLeft[3] = { this->Left[p[0]] != 0, this->Left[p[1]] != 0, this->Left[p[2]] != 0 };
    if (isLeft[0] && isLeft[1] && p[0] != p[1])
    {
      edges.push_back(Join(p[0], p[1]));
    }
    if (isLeft[1] && isLeft[2] && p[1] != p[2])
    {
      edges.push_back(Join(p[1], p[2]));
    }
    if (isLeft[2] && isLeft[0] && p[2] != p[0])
    {
      edges.push_back(Join(p[2], p[0]));
    }
  }
  for (const std::uint32_t t : triangles)
  {
    for (const std::uint32_t p : this->Mesh.GetPointsOfTriangle(t))
    {
      this->Left[p] = 0;
    }
  }
  KeepOdd(edges);
}

std::vector<std::uint32_t> vtkMTBorderOrder::Find(const std::vector<std::uint32_t>& triangles)
{
  std::vector<std::uint64_t> edges;
  this->FindOddEdges(triangles, edges);
  return Walk(edges);
}
