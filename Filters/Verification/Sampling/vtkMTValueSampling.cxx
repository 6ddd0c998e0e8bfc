// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTValueSampling.h"

#include "vtkMTGraph.h"
#include "vtkMTPatchSource.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace
{
constexpr double RelativeTolerance = 1e-12;

// A corner of a convex polygon, with the value there.
struct Corner
{
  vtkMTRealPoint X;
  double Value;
};
using Polygon = std::vector<Corner>;

// Halves, because a difference of two values may be beyond the largest number.
Corner Cross(const Corner& a, const Corner& b, double bound)
{
  const double t = std::clamp((0.5 * bound - 0.5 * a.Value) / (0.5 * b.Value - 0.5 * a.Value), 0.0, 1.0);
  Corner corner{ a.X, bound };
  for (int i = 0; i < 3; ++i)
  {
    corner.X[i] = (1.0 - t) * a.X[i] + t * b.X[i];
  }
  return corner;
}

// The part of a polygon where the value is at most the bound, or at least, where sign is -1.
void Clip(Polygon& polygon, double bound, double sign)
{
  const auto isInside = [&](const Corner& corner) { return sign * corner.Value <= sign * bound; };
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Corner& corner = polygon[i];
    const Corner& next = polygon[(i + 1) % polygon.size()];
    if (isInside(corner))
    {
      kept.push_back(corner);
    }
    if (isInside(corner) != isInside(next))
    {
      kept.push_back(Cross(corner, next, bound));
    }
  }
  polygon.swap(kept);
}

// A fan of triangles; the first and, of a point, all have no area.
double GetDistance2(const vtkMTRealPoint& x, const Polygon& polygon)
{
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const vtkMTRealPoint& next = polygon[std::min(i + 1, polygon.size() - 1)].X;
    least = std::min(least, vtkMTClosestPoint::GetDistance2(x, polygon[0].X, polygon[i].X, next));
  }
  return least;
}
}

vtkMTValueSampling::vtkMTValueSampling(const vtkMTPatchSource& source, std::size_t samples, std::uint64_t seed)
  : vtkMTJointSampling(source, samples, seed, "values")
{
  const vtkMTGraph& graph = source.GetGraph();
  for (std::size_t i = 0; i < graph.Arrays.size(); ++i)
  {
    const vtkMTArrayInfo& array = graph.Arrays[i];
    const vtkMTMeasure* measure = graph.FindMeasure(vtkMTMeasure::GetValueDeviationName(array.Name));
    if (measure && array.Components == 1)
    {
      this->Parts.push_back({ measure, this->AddColumn(i), array.Name, 0.0 });
    }
  }
  this->SetWidth(this->Parts.size());
}

vtkMTValueSampling::~vtkMTValueSampling() = default;

void vtkMTValueSampling::AddData(const vtkMTPatch& patch, std::size_t triangle, Side& side)
{
  for (std::size_t corner = 0; corner < 3; ++corner)
  {
    for (Part& part : this->Parts)
    {
      double value = 0.0;
      this->GetTuple(part.Values, patch, triangle, corner, &value);
      part.Largest = std::isfinite(value) ? std::max(part.Largest, std::abs(value)) : part.Largest;
      side.Data.push_back(value);
    }
  }
}

bool vtkMTValueSampling::Take(const Side& from, const Place& place, Wanted& wanted) const
{
  const auto& [u, v] = place.Weights;
  const auto get = [&](std::size_t corner) { return from.GetData(place.Triangle, corner)[wanted.Part]; };
  // What is constant is not to be rounded.
  const bool isConstant = get(0) == get(1) && get(0) == get(2);
  wanted.Data[0] = isConstant ? get(0) : (1.0 - u - v) * get(0) + u * get(1) + v * get(2);
  return std::isfinite(wanted.Data[0]);
}

bool vtkMTValueSampling::HasPoint(
  const Side& to, std::uint32_t triangle, const Wanted& wanted, std::uint32_t node, double reach) const
{
  const Part& part = this->Parts[wanted.Part];
  const double deviation = part.Measure->Values[node];
  const Corners corners = to.GetCorners(triangle);
  const auto isNear = [&]
  { return vtkMTClosestPoint::GetDistance2(wanted.X, corners[0], corners[1], corners[2]) <= reach * reach; };
  if (!(deviation < std::numeric_limits<double>::max()))
  {
    return isNear();
  }
  const double* data = to.GetData(triangle, 0) + wanted.Part;
  const std::array<double, 3> values{ data[0], data[to.Width], data[2 * to.Width] };
  if (!std::isfinite(values[0]) || !std::isfinite(values[1]) || !std::isfinite(values[2]))
  {
    return false;
  }
  const double allowed = deviation + RelativeTolerance * part.Largest;
  const double low = wanted.Data[0] - allowed;
  const double high = wanted.Data[0] + allowed;
  const auto [least, largest] = std::minmax_element(values.begin(), values.end());
  if (*least > high || *largest < low)
  {
    return false;
  }
  if (*least >= low && *largest <= high)
  {
    return isNear();
  }
  Polygon polygon{ { corners[0], values[0] }, { corners[1], values[1] }, { corners[2], values[2] } };
  Clip(polygon, high, 1.0);
  Clip(polygon, low, -1.0);
  return !polygon.empty() && GetDistance2(wanted.X, polygon) <= reach * reach;
}

std::string vtkMTValueSampling::Describe(const Wanted& wanted, std::uint32_t node) const
{
  const Part& part = this->Parts[wanted.Part];
  std::ostringstream text;
  text.precision(9);
  text << "a value of '" << part.Name << "' within " << part.Measure->Values[node] << " of " << wanted.Data[0];
  return text.str();
}
