// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTLineHit.h"

#include "vtkDataArray.h"
#include "vtkMTGraph.h"
#include "vtkMTInputIdFinder.h"
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
    const double one = low / way[i];
    const double other = high / way[i];
    from = std::max(from, std::min(one, other));
    to = std::min(to, std::max(one, other));
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

// With the ids of input cells and no other array.
std::shared_ptr<const vtkMTPatch> Read(const vtkMTPatchSource& source, std::uint32_t arc, std::string& error)
{
  const vtkMTGraph& graph = source.GetGraph();
  std::vector<unsigned char> arrays(graph.Arrays.size(), 0);
  const int ids = vtkMTPatchAttributes::FindRole(graph, vtkMTArrayInfo::InputCellIds);
  if (ids >= 0)
  {
    arrays[ids] = 1;
  }
  auto patch = std::make_shared<vtkMTPatch>();
  return source.ReadPatch(arc, &arrays, *patch, error) ? patch : nullptr;
}
}

bool vtkMTLineHit::Find(const vtkMTPatchSource& source, const std::vector<std::uint32_t>& arcs, const Place& begin,
  const Place& end, const Resident& resident, std::string& error)
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
  for (const auto& entry : entries)
  {
    if (this->Found && entry.first > this->T)
    {
      break;
    }
    std::shared_ptr<const vtkMTPatch> patch = resident(entry.second);
    if (!patch)
    {
      patch = Read(source, entry.second, error);
    }
    if (patch)
    {
      this->FindInPatch(source, entry.second, patch, begin, way);
    }
  }
  if (!this->Found)
  {
    return false;
  }
  const Place x{ begin[0] + this->T * way[0], begin[1] + this->T * way[1], begin[2] + this->T * way[2] };
  const int ids = vtkMTPatchAttributes::FindRole(graph, vtkMTArrayInfo::InputCellIds);
  if (ids >= 0 && graph.Arrays[ids].IsFinestOnly() && !graph.IsFinest(this->Arc))
  {
    this->FindNearestInput(source, vtkMTArrayInfo::InputCellIds, x, resident, this->InputCell, error);
  }
  else if (ids >= 0)
  {
    this->FindInputCell(source, error);
  }
  if (vtkMTPatchAttributes::FindRole(graph, vtkMTArrayInfo::InputPointIds) >= 0)
  {
    this->FindNearestInput(source, vtkMTArrayInfo::InputPointIds, x, resident, this->InputPoint, error);
  }
  return true;
}

void vtkMTLineHit::FindInPatch(const vtkMTPatchSource& source, std::uint32_t arc,
  const std::shared_ptr<const vtkMTPatch>& patch, const Place& begin, const Place& way)
{
  const vtkMTLattice& lattice = source.GetGraph().Lattice;
  for (std::size_t i = 0; i < patch->Triangles.size(); ++i)
  {
    const vtkMTTriangle points = patch->GetPointsOfTriangle(i);
    std::array<Place, 3> triangle;
    std::transform(points.begin(), points.end(), triangle.begin(),
      [&](std::uint32_t point) { return lattice.ToWorld(patch->Points[point]); });
    double t;
    std::array<double, 2> weights;
    if (Meet(triangle, begin, way, t, weights) && (!this->Found || t < this->T))
    {
      this->Found = true;
      this->T = t;
      this->Weights = weights;
      this->Triangle = triangle;
      this->Patch = patch;
      this->Arc = arc;
      this->Index = i;
    }
  }
}

// What is drawn need not have the ids: then they are read, for this one patch.
void vtkMTLineHit::FindInputCell(const vtkMTPatchSource& source, std::string& error)
{
  const vtkMTGraph& graph = source.GetGraph();
  const int ids = vtkMTPatchAttributes::FindRole(graph, vtkMTArrayInfo::InputCellIds);
  if (vtkMTPatchAttributes::GetColumn(graph, ids, *this->Patch).empty())
  {
    this->Patch = Read(source, this->Arc, error);
  }
  if (this->Patch)
  {
    const auto values = vtkMTPatchAttributes::GetArray(graph, ids, *this->Patch);
    this->InputCell = static_cast<vtkIdType>(values->GetComponent(static_cast<vtkIdType>(this->Index), 0));
  }
}

// Below a coarse patch. The id stays what it is where none can be found.
void vtkMTLineHit::FindNearestInput(const vtkMTPatchSource& source, vtkMTArrayInfo::RoleType role, const Place& x,
  const Resident& resident, vtkIdType& id, std::string& error) const
{
  vtkMTInputIdFinder finder(source, role);
  finder.SetResident(resident);
  vtkMTInputIdFinder::Query query;
  query.Arc = this->Arc;
  query.X = x;
  query.Direction =
    Cross(Subtract(this->Triangle[1], this->Triangle[0]), Subtract(this->Triangle[2], this->Triangle[0]));
  std::vector<vtkIdType> ids;
  std::string reason;
  if (finder.Find({ query }, ids, reason))
  {
    id = ids[0];
  }
  error = reason.empty() ? error : reason;
}
