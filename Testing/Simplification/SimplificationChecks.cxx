// SPDX-License-Identifier: BSD-3-Clause
#include "SimplificationTesting.h"

#include <algorithm>
#include <set>

namespace SimplificationTesting
{
namespace
{
//------------------------------------------------------------------------------
std::string FindBadIndex(const vtkMTPatch& floor, const vtkMTSimplification& r)
{
  const std::size_t n = r.Points.size();
  if (r.PointOrigin.size() != n || r.Moved.size() != n || r.WedgeOrigin.size() != r.WedgePoints.size())
  {
    return "arrays of different lengths";
  }
  std::set<std::uint32_t> origins;
  for (std::size_t p = 0; p < n; ++p)
  {
    if (r.PointOrigin[p] >= floor.Points.size() || !origins.insert(r.PointOrigin[p]).second)
    {
      return "origin of point " + std::to_string(p) + " out of range or used twice";
    }
    if ((r.Moved[p] != 0) != (r.Points[p] != floor.Points[r.PointOrigin[p]]))
    {
      return "Moved of point " + std::to_string(p);
    }
  }
  for (std::size_t w = 0; w < r.WedgePoints.size(); ++w)
  {
    if (r.WedgePoints[w] >= n || r.WedgeOrigin[w] >= floor.GetNumberOfWedges() ||
      floor.GetPointOfWedge(r.WedgeOrigin[w]) != r.PointOrigin[r.WedgePoints[w]])
    {
      return "wedge " + std::to_string(w) + " is not of its point's origin";
    }
  }
  if (r.Heirs.size() != floor.Points.size())
  {
    return "not an heir for every point of the floor";
  }
  for (const std::uint32_t heir : r.Heirs)
  {
    if (heir >= n && heir != vtkMTSimplification::NoHeir)
    {
      return "heir out of range";
    }
  }
  for (std::uint32_t p = 0; p < n; ++p)
  {
    if (r.Heirs[r.PointOrigin[p]] != p)
    {
      return "the origin of point " + std::to_string(p) + " was merged into another one";
    }
  }
  std::vector<bool> usedWedges(r.WedgePoints.size(), false);
  std::vector<bool> usedPoints(n, false);
  for (const vtkMTTriangle& t : r.Triangles)
  {
    for (const std::uint32_t w : t)
    {
      if (w >= r.WedgePoints.size())
      {
        return "triangle with a wedge out of range";
      }
      usedWedges[w] = true;
      usedPoints[r.WedgePoints[w]] = true;
    }
    const std::uint32_t a = r.WedgePoints[t[0]];
    const std::uint32_t b = r.WedgePoints[t[1]];
    const std::uint32_t c = r.WedgePoints[t[2]];
    if (a == b || b == c || c == a)
    {
      return "triangle with a repeated point";
    }
  }
  const bool allUsed = std::all_of(usedWedges.begin(), usedWedges.end(), [](bool b) { return b; }) &&
    std::all_of(usedPoints.begin(), usedPoints.end(), [](bool b) { return b; });
  return allUsed ? "" : "points or wedges that no triangle uses";
}

// Points of the floor at which an edge is not shared by exactly two opposite triangles, or whose triangles are several
// fans.
std::vector<bool> FindNonManifoldPoints(const vtkMTPatch& floor, const std::map<Edge, int>& edges)
{
  std::vector<bool> bad(floor.Points.size(), false);
  std::map<std::uint32_t, std::vector<Edge>> links; // per point, the opposite edges of its triangles
  for (const auto& e : edges)
  {
    const auto back = edges.find({ e.first.second, e.first.first });
    if (e.second > 1 || (back != edges.end() && back->second > 1))
    {
      bad[e.first.first] = bad[e.first.second] = true;
    }
  }
  for (std::size_t t = 0; t < floor.Triangles.size(); ++t)
  {
    const vtkMTTriangle p = floor.GetPointsOfTriangle(t);
    if (p[0] != p[1] && p[1] != p[2] && p[2] != p[0])
    {
      for (int i = 0; i < 3; ++i)
      {
        links[p[i]].push_back({ p[(i + 1) % 3], p[(i + 2) % 3] });
      }
    }
  }
  for (const auto& link : links)
  {
    // One path or one circle: every point starts at most one edge and all edges are connected.
    std::map<std::uint32_t, std::uint32_t> next(link.second.begin(), link.second.end());
    std::set<std::uint32_t> ends;
    for (const auto& e : next)
    {
      ends.insert(e.second);
    }
    std::uint32_t start = next.begin()->first;
    for (const auto& e : next)
    {
      start = ends.count(e.first) ? start : e.first;
    }
    std::size_t walked = 0;
    for (std::uint32_t p = start; next.count(p) && walked <= next.size(); ++walked)
    {
      p = next[p];
      if (p == start)
      {
        ++walked;
        break;
      }
    }
    if (next.size() != link.second.size() || walked != next.size())
    {
      bad[link.first] = true;
    }
  }
  return bad;
}
}

//------------------------------------------------------------------------------
std::string FindFault(const vtkMTPatch& floor, const Locks& locked, const vtkMTSimplification& result)
{
  const std::string bad = FindBadIndex(floor, result);
  if (!bad.empty())
  {
    return bad;
  }
  const std::map<Edge, int> before = CountEdges(floor);
  const std::vector<bool> nonManifold = FindNonManifoldPoints(floor, before);
  std::map<std::uint32_t, bool> present; // floor's points in the fragment
  for (std::size_t p = 0; p < result.Points.size(); ++p)
  {
    const std::uint32_t origin = result.PointOrigin[p];
    present[origin] = true;
    if ((locked[origin] || nonManifold[origin]) && result.Moved[p])
    {
      return "fixed point " + std::to_string(origin) + " has moved";
    }
  }
  const bool removal = result.RemovedComponents > 0;
  std::map<Edge, int> after;
  for (const auto& e : CountEdges(ToPatch(result)))
  {
    after[{ result.PointOrigin[e.first.first], result.PointOrigin[e.first.second] }] = e.second;
  }
  const auto count = [](const std::map<Edge, int>& edges, const Edge& e)
  {
    const auto found = edges.find(e);
    return found == edges.end() ? 0 : found->second;
  };
  const auto fixed = [&](std::uint32_t p) { return locked[p] || nonManifold[p]; };
  for (const auto& e : before)
  {
    const Edge edge = e.first;
    const bool outside = locked[edge.first] && locked[edge.second];
    if (locked[edge.first] && !present[edge.first])
    {
      return "locked point " + std::to_string(edge.first) + " is gone";
    }
    if (fixed(edge.first) && fixed(edge.second) && (outside || !removal) && count(after, edge) != e.second)
    {
      return "edge " + std::to_string(edge.first) + " -> " + std::to_string(edge.second) +
        " between fixed points had " + std::to_string(e.second) + " triangles and has " +
        std::to_string(count(after, edge));
    }
  }
  for (const auto& e : after)
  {
    const Edge edge = e.first;
    const int back = count(after, { edge.second, edge.first });
    if (fixed(edge.first) && fixed(edge.second))
    {
      if (count(before, edge) != e.second)
      {
        return "new edge between fixed points " + std::to_string(edge.first) + " and " + std::to_string(edge.second);
      }
      continue;
    }
    if (e.second != 1 || back > 1)
    {
      return "edge " + std::to_string(edge.first) + " -> " + std::to_string(edge.second) + " has " +
        std::to_string(e.second) + " triangles, and " + std::to_string(back) + " the other way; in the floor " +
        std::to_string(count(before, edge)) + " and " + std::to_string(count(before, { edge.second, edge.first }));
    }
  }
  return "";
}
}
