// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTValueDeviation.h"

#include "vtkMTPiece.h"
#include "vtkMTSurface.h"
#include "vtkMTVector.h"

#include "vtkSetGet.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

using namespace vtkMTVector;

namespace
{
using Values = vtkMTValueDeviation::Values;
using Mesh = vtkMTValueDeviation::Mesh;
constexpr double Infinity = std::numeric_limits<double>::infinity();

// Many times what a few dozen operations in double precision are off by.
constexpr double Rounding = 1e-13;

template <class Value>
void Copy(const vtkMTColumn& column, const vtkMTPatch& mesh, bool ofPoints, std::vector<Values>& values)
{
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      Value value;
      std::memcpy(&value, column.data() + (ofPoints ? mesh.Triangles[t][c] : t) * sizeof(Value), sizeof(Value));
      values[t][c] = static_cast<double>(value);
    }
  }
}

// Of any two points of the two triangles. Infinity where a value is no number, or infinite and not everywhere the same.
double GetLargestDifference(const Values& a, const Values& b)
{
  const auto [leastA, mostA] = std::minmax({ a[0], a[1], a[2] });
  const auto [leastB, mostB] = std::minmax({ b[0], b[1], b[2] });
  if (a == b && leastA == mostA)
  {
    return 0.0;
  }
  const double difference = std::max(mostA - leastB, mostB - leastA);
  const bool isFinite = std::all_of(a.begin(), a.end(), [](double x) { return std::isfinite(x); }) &&
    std::all_of(b.begin(), b.end(), [](double x) { return std::isfinite(x); });
  return isFinite ? difference : Infinity;
}

double GetLargest(const Values& values)
{
  return std::max({ std::abs(values[0]), std::abs(values[1]), std::abs(values[2]) });
}

// A triangle's values as a linear function of the place, which goes on over its plane.
struct Field
{
  Vector Origin;
  double AtOrigin;
  Vector Slope{ 0.0, 0.0, 0.0 };
  double Steepness = 0.0;
  double Slack = 0.0; // of slope, rounding

  Field(const vtkMTSurface& surface, std::uint32_t triangle, const Values& values)
    : Origin(surface.GetCorner(triangle, 0))
    , AtOrigin(values[0])
  {
    const double alongU = values[1] - values[0];
    const double alongV = values[2] - values[0];
    if (alongU == 0.0 && alongV == 0.0)
    {
      return;
    }
    const Vector u = Subtract(surface.GetCorner(triangle, 1), this->Origin);
    const Vector v = Subtract(surface.GetCorner(triangle, 2), this->Origin);
    const Vector& normal = surface.GetNormal(triangle);
    const double twiceArea = Dot(Cross(normal, u), v);
    if (!(twiceArea > 0.0))
    {
      this->Steepness = Infinity;
      return;
    }
    this->Slope = Add(Scale(Cross(v, normal), alongU / twiceArea), Scale(Cross(normal, u), alongV / twiceArea));
    this->Slack = Rounding * (std::abs(alongU) * Norm(v) + std::abs(alongV) * Norm(u)) / twiceArea;
    this->Steepness = Norm(this->Slope) * (1.0 + Rounding) + this->Slack;
  }
};

// What of triangle t is within the distance of triangle s, and a little more. The whole where that is not found out.
vtkMTPiece Clip(const vtkMTSurface& from, std::uint32_t t, const vtkMTSurface& to, std::uint32_t s, double distance)
{
  vtkMTPiece piece;
  for (int c = 0; c < 3; ++c)
  {
    piece.Append(from.GetCorner(t, c));
  }
  const Vector& normal = to.GetNormal(s);
  for (int e = 0; e < 3; ++e)
  {
    const Vector& a = to.GetCorner(s, e);
    const Vector way = Cross(normal, Subtract(to.GetCorner(s, (e + 1) % 3), a));
    const double length = Norm(way);
    vtkMTPiece inside;
    vtkMTPiece outside;
    if (length > 0.0)
    {
      const Vector inward = Scale(way, 1.0 / length);
      const double beyond = distance * (1.0 + Rounding) + Rounding * (from.GetExtent() + to.GetExtent());
      piece = piece.Split(Subtract(a, Scale(inward, beyond)), inward, 0.0, inside, outside) ? inside : piece;
    }
  }
  return piece;
}

// The values of a triangle at its corners as a linear function of places on it, by weights.
double Interpolate(const vtkMTSurface::Hit& hit, const Values& values)
{
  return hit.Weights[0] * values[0] + hit.Weights[1] * values[1] + hit.Weights[2] * values[2];
}
}

//------------------------------------------------------------------------------
std::vector<Values> vtkMTValueDeviation::Get(
  const vtkMTPatch& mesh, const std::vector<vtkMTArrayInfo>& arrays, std::size_t array)
{
  const vtkMTArrayInfo& info = arrays[array];
  const auto column =
    static_cast<std::size_t>(std::count_if(arrays.begin(), arrays.begin() + static_cast<std::ptrdiff_t>(array),
      [&](const vtkMTArrayInfo& other) { return other.Association == info.Association; }));
  const bool ofPoints = info.Association == vtkMTArrayInfo::Point;
  const vtkMTColumn& values = ofPoints ? mesh.PointColumns[column] : mesh.CellColumns[column];
  std::vector<Values> corners(mesh.Triangles.size());
  switch (info.Type)
  {
    vtkTemplateMacro(Copy<VTK_TT>(values, mesh, ofPoints, corners));
    default:
      break;
  }
  return corners;
}

//------------------------------------------------------------------------------
double vtkMTValueDeviation::GetDifference(
  const Mesh& from, std::uint32_t t, const Mesh& to, std::uint32_t s, double distance)
{
  const Values& valuesOfT = from.Corners[t];
  const Values& valuesOfS = to.Corners[s];
  const double ofCorners = GetLargestDifference(valuesOfT, valuesOfS);
  const Field field(to.Surface, s, valuesOfS);
  const double steepness = field.Steepness + Field(from.Surface, t, valuesOfT).Steepness;
  if (!(ofCorners > 0.0) || !std::isfinite(ofCorners) || !std::isfinite(steepness))
  {
    return ofCorners;
  }
  const vtkMTPiece piece = Clip(from.Surface, t, to.Surface, s, distance);
  double largest = 0.0;
  double largestWithin = 0.0;
  double farthest = 0.0;
  for (int i = 0; i < piece.Count; ++i)
  {
    const Vector& x = piece.Corners[i];
    const Vector way = Subtract(x, field.Origin);
    const double atFoot = field.AtOrigin + Dot(field.Slope, way);
    const double difference = std::abs(Interpolate(from.Surface.Project(x, t), valuesOfT) - atFoot);
    const Vector& normal = to.Surface.GetNormal(s);
    const Vector foot = Subtract(x, Scale(normal, Dot(way, normal)));
    const double outside = std::sqrt(to.Surface.GetDistance2(foot, s, Infinity));
    largest = std::max(largest, difference + field.Steepness * outside);
    largestWithin = std::max(largestWithin, difference);
    farthest = std::max(farthest, Norm(way));
  }
  const double extent = from.Surface.GetExtent() + to.Surface.GetExtent();
  const double slack =
    Rounding * (GetLargest(valuesOfT) + GetLargest(valuesOfS)) + field.Slack * farthest + Rounding * steepness * extent;
  return std::min(ofCorners, std::min(largest, largestWithin + field.Steepness * distance) + slack);
}

//------------------------------------------------------------------------------
std::vector<vtkMTValueDeviation> vtkMTValueDeviation::Add(const Mesh& floor, const Mesh& fragment,
  const std::vector<vtkMTValueDeviation>& floorKnown, const std::vector<vtkMTDeviation::Pair>& pairs)
{
  std::vector<vtkMTValueDeviation> found(fragment.Corners.size());
  for (const vtkMTDeviation::Pair& pair : pairs)
  {
    const vtkMTValueDeviation before = floorKnown.empty() ? vtkMTValueDeviation() : floorKnown[pair.Floor];
    vtkMTValueDeviation& after = found[pair.Fragment];
    const double most = GetLargestDifference(floor.Corners[pair.Floor], fragment.Corners[pair.Fragment]);
    // A bound matters where it raises what is known by other pairs.
    const auto raise = [&](double& known, double knownBefore, const auto& getDifference)
    {
      if (knownBefore + most > known)
      {
        const double sum = knownBefore + getDifference();
        known = std::max(known, sum > 0.0 ? std::nextafter(sum, Infinity) : 0.0);
      }
    };
    if (pair.IsUp)
    {
      raise(after.ToInput, before.ToInput,
        [&] { return GetDifference(fragment, pair.Fragment, floor, pair.Floor, pair.Distance); });
    }
    if (pair.IsDown)
    {
      raise(after.FromInput, before.FromInput,
        [&] { return GetDifference(floor, pair.Floor, fragment, pair.Fragment, pair.Distance); });
    }
  }
  return found;
}
