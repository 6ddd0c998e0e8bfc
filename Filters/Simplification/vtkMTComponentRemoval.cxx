// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTComponentRemoval.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace
{
struct Component
{
  std::array<std::int64_t, 3> Low;
  std::array<std::int64_t, 3> High;
  std::size_t Triangles = 0;
  bool Locked = false;

  double GetSquaredDiagonal() const
  {
    double sum = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      const auto side = static_cast<double>(this->High[i] - this->Low[i]);
      sum += side * side;
    }
    return sum;
  }
};

std::uint32_t FindRoot(std::vector<std::uint32_t>& parents, std::uint32_t i)
{
  while (parents[i] != i)
  {
    parents[i] = parents[parents[i]];
    i = parents[i];
  }
  return i;
}

// For each point the smallest point of its component.
std::vector<std::uint32_t> LabelPoints(const vtkMTSimplification& mesh)
{
  std::vector<std::uint32_t> parents(mesh.Points.size());
  std::iota(parents.begin(), parents.end(), 0u);
  for (const vtkMTTriangle& t : mesh.Triangles)
  {
    const std::uint32_t a = FindRoot(parents, mesh.WedgePoints[t[0]]);
    const std::uint32_t b = FindRoot(parents, mesh.WedgePoints[t[1]]);
    const std::uint32_t c = FindRoot(parents, mesh.WedgePoints[t[2]]);
    const std::uint32_t least = std::min({ a, b, c });
    parents[a] = parents[b] = parents[c] = least;
  }
  for (std::uint32_t i = 0; i < parents.size(); ++i)
  {
    parents[i] = parents[parents[i]];
  }
  return parents;
}

std::vector<Component> Measure(
  const std::vector<std::uint32_t>& labels, const std::vector<unsigned char>& locked, const vtkMTSimplification& mesh)
{
  std::vector<Component> components(mesh.Points.size());
  for (std::size_t p = 0; p < labels.size(); ++p)
  {
    Component& c = components[labels[p]];
    for (int i = 0; i < 3; ++i)
    {
      const std::int64_t k = mesh.Points[p][i];
      c.Low[i] = labels[p] == p ? k : std::min(c.Low[i], k);
      c.High[i] = labels[p] == p ? k : std::max(c.High[i], k);
    }
    c.Locked = c.Locked || locked[mesh.PointOrigin[p]];
  }
  for (const vtkMTTriangle& t : mesh.Triangles)
  {
    ++components[labels[mesh.WedgePoints[t[0]]]].Triangles;
  }
  return components;
}

// Keeps the points and wedges that the triangles use, in their order.
void Compact(vtkMTSimplification& mesh)
{
  std::vector<std::uint32_t> pointMap(mesh.Points.size(), 0);
  std::vector<std::uint32_t> wedgeMap(mesh.WedgePoints.size(), 0);
  for (const vtkMTTriangle& t : mesh.Triangles)
  {
    for (const std::uint32_t w : t)
    {
      wedgeMap[w] = 1;
      pointMap[mesh.WedgePoints[w]] = 1;
    }
  }
  std::uint32_t points = 0;
  for (std::size_t p = 0; p < pointMap.size(); ++p)
  {
    if (!pointMap[p])
    {
      pointMap[p] = vtkMTSimplification::NoHeir;
    }
    else
    {
      mesh.Points[points] = mesh.Points[p];
      mesh.PointOrigin[points] = mesh.PointOrigin[p];
      mesh.Moved[points] = mesh.Moved[p];
      pointMap[p] = points++;
    }
  }
  mesh.Points.resize(points);
  mesh.PointOrigin.resize(points);
  mesh.Moved.resize(points);
  for (std::uint32_t& heir : mesh.Heirs)
  {
    heir = heir == vtkMTSimplification::NoHeir ? heir : pointMap[heir];
  }
  std::uint32_t wedges = 0;
  for (std::size_t w = 0; w < wedgeMap.size(); ++w)
  {
    if (wedgeMap[w])
    {
      mesh.WedgePoints[wedges] = pointMap[mesh.WedgePoints[w]];
      mesh.WedgeOrigin[wedges] = mesh.WedgeOrigin[w];
      wedgeMap[w] = wedges++;
    }
  }
  mesh.WedgePoints.resize(wedges);
  mesh.WedgeOrigin.resize(wedges);
  for (vtkMTTriangle& t : mesh.Triangles)
  {
    t = { wedgeMap[t[0]], wedgeMap[t[1]], wedgeMap[t[2]] };
  }
}
}

void vtkMTComponentRemoval::Remove(
  const std::vector<unsigned char>& locked, std::size_t target, vtkMTSimplification& result) const
{
  if (result.Triangles.size() <= target || this->MaximumDiagonal < 0.0)
  {
    return;
  }
  const std::vector<std::uint32_t> labels = LabelPoints(result);
  std::vector<Component> components = Measure(labels, locked, result);
  std::vector<std::uint32_t> candidates;
  std::size_t remaining = 0;
  for (std::uint32_t c = 0; c < components.size(); ++c)
  {
    remaining += components[c].Triangles > 0 ? 1 : 0;
    if (components[c].Triangles > 0 && !components[c].Locked &&
      std::sqrt(components[c].GetSquaredDiagonal()) <= this->MaximumDiagonal)
    {
      candidates.push_back(c);
    }
  }
  std::stable_sort(candidates.begin(), candidates.end(),
    [&](std::uint32_t a, std::uint32_t b)
    { return components[a].GetSquaredDiagonal() < components[b].GetSquaredDiagonal(); });

  std::size_t left = result.Triangles.size();
  std::int64_t removed = 0;
  for (std::size_t i = 0; i < candidates.size() && left > target && remaining > 1; ++i, --remaining)
  {
    left -= components[candidates[i]].Triangles;
    components[candidates[i]].Triangles = 0;
    ++removed;
  }
  if (removed == 0)
  {
    return;
  }
  result.Blocked["component_triangles"] += static_cast<std::int64_t>(result.Triangles.size() - left);
  result.RemovedComponents += removed;
  const auto isGone = [&](const vtkMTTriangle& t)
  { return components[labels[result.WedgePoints[t[0]]]].Triangles == 0; };
  result.Triangles.erase(
    std::remove_if(result.Triangles.begin(), result.Triangles.end(), isGone), result.Triangles.end());
  Compact(result);
}
