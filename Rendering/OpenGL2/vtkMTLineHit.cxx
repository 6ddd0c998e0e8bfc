// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTLineHit.h"

#include "vtkDataArray.h"
#include "vtkMTGraph.h"
#include "vtkMTPatch.h"
#include "vtkMTPatchAttributes.h"
#include "vtkMTPatchSource.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace
{
using Place = vtkMTLineHit::Place;

// Shares of a triangle or a box: a hit on an edge must not be missed by both of its triangles.
constexpr double Rounding = 1e-12;

Place Subtract(const Place& a, const Place& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

Place Cross(const Place& a, const Place& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

double Dot(const Place& a, const Place& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Where the line enters the box; false when it does not.
bool Enter(const double bounds[6], const Place& begin, const Place& way, double& t)
{
  double from = 0.0;
  double to = 1.0;
  for (int i = 0; i < 3; ++i)
  {
    const double slack = Rounding * (std::abs(bounds[2 * i]) + std::abs(bounds[2 * i + 1]) + std::abs(begin[i]));
    const double low = bounds[2 * i] - slack - begin[i];
    const double high = bounds[2 * i + 1] + slack - begin[i];
    if (way[i] == 0.0)
    {
      if (low > 0.0 || high < 0.0)
      {
        return false;
      }
      continue;
    }
    const auto cuts = std::minmax(low / way[i], high / way[i]);
    from = std::max(from, cuts.first);
    to = std::min(to, cuts.second);
  }
  t = from;
  return from <= to;
}

// Moeller and Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", 1997; either side counts.
bool Meet(
  const std::array<Place, 3>& triangle, const Place& begin, const Place& way, double& t, std::array<double, 2>& weights)
{
  const Place a = Subtract(triangle[1], triangle[0]);
  const Place b = Subtract(triangle[2], triangle[0]);
  const Place p = Cross(way, b);
  const double volume = Dot(a, p);
  if (volume == 0.0)
  {
    return false;
  }
  const Place from = Subtract(begin, triangle[0]);
  const Place q = Cross(from, a);
  weights = { Dot(from, p) / volume, Dot(way, q) / volume };
  t = Dot(b, q) / volume;
  return weights[0] >= -Rounding && weights[1] >= -Rounding && weights[0] + weights[1] <= 1.0 + Rounding && t >= 0.0 &&
    t <= 1.0;
}
}

bool vtkMTLineHit::Find(const vtkMTPatchSource& source, const std::vector<std::uint32_t>& arcs, const Place& begin,
  const Place& end, std::string& error)
{
  const vtkMTGraph& graph = source.GetGraph();
  const Place way = Subtract(end, begin);
  std::vector<std::pair<double, std::uint32_t>> entries;
  for (const std::uint32_t arc : arcs)
  {
    double bounds[6];
    double t;
    graph.Lattice.ToWorld(graph.Arcs[arc].Box, bounds);
    if (Enter(bounds, begin, way, t))
    {
      entries.emplace_back(t, arc);
    }
  }
  std::sort(entries.begin(), entries.end());

  const int ids = vtkMTPatchAttributes::FindRole(graph, vtkMTArrayInfo::InputCellIds);
  std::vector<unsigned char> arrays(graph.Arrays.size(), 0);
  if (ids >= 0)
  {
    arrays[ids] = 1;
  }
  bool found = false;
  for (const auto& entry : entries)
  {
    if (found && entry.first > this->T)
    {
      break;
    }
    vtkMTPatch patch;
    if (!source.ReadPatch(entry.second, &arrays, patch, error))
    {
      continue;
    }
    for (std::size_t i = 0; i < patch.Triangles.size(); ++i)
    {
      const vtkMTTriangle points = patch.GetPointsOfTriangle(i);
      std::array<Place, 3> triangle;
      std::transform(points.begin(), points.end(), triangle.begin(),
        [&](std::uint32_t point) { return graph.Lattice.ToWorld(patch.Points[point]); });
      double t;
      std::array<double, 2> weights;
      if (Meet(triangle, begin, way, t, weights) && (!found || t < this->T))
      {
        found = true;
        this->T = t;
        this->Weights = weights;
        this->Triangle = triangle;
        this->InputCell = ids >= 0
          ? static_cast<vtkIdType>(
              vtkMTPatchAttributes::GetArray(graph, ids, patch)->GetComponent(static_cast<vtkIdType>(i), 0))
          : 0;
      }
    }
  }
  return found;
}
