// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTNormalSampling.h"

#include "vtkMTGraph.h"
#include "vtkMTPatchSource.h"
#include "vtkMTVector.h"

#include "vtkDataSetAttributes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <sstream>

using namespace vtkMTVector;

namespace
{
// Normals are stored in single precision.
constexpr double AngleTolerance = 1e-6;
constexpr double RightAngle = 1.5707963267948966;
constexpr double Straight = 2.0 * RightAngle;

// The least value of a convex function of a number from 0 to 1, or any that is at most zero.
double Minimise(const std::function<double(double)>& f)
{
  constexpr int steps = 40;
  constexpr double golden = 0.6180339887498949;
  double low = 0.0;
  double high = 1.0;
  double least = std::min(f(low), f(high));
  double a = high - golden * (high - low);
  double b = low + golden * (high - low);
  double fa = f(a);
  double fb = f(b);
  for (int i = 0; i < steps && least > 0.0; ++i)
  {
    least = std::min({ least, fa, fb });
    if (fa < fb)
    {
      high = b;
      b = a;
      fb = fa;
      a = high - golden * (high - low);
      fa = f(a);
    }
    else
    {
      low = a;
      a = b;
      fa = fb;
      b = low + golden * (high - low);
      fb = f(b);
    }
  }
  return least;
}

// Of the second and third corner, where x lies over the triangle; else of a point of it.
std::array<double, 2> GetWeights(const std::array<vtkMTRealPoint, 3>& corners, const vtkMTRealPoint& x)
{
  const vtkMTRealPoint e = Subtract(corners[1], corners[0]);
  const vtkMTRealPoint f = Subtract(corners[2], corners[0]);
  const vtkMTRealPoint p = Subtract(x, corners[0]);
  const vtkMTRealPoint across = Cross(e, f);
  const double area2 = Dot(across, across);
  const double u = area2 > 0.0 ? std::clamp(Dot(Cross(p, f), across) / area2, 0.0, 1.0) : 0.0;
  const double v = area2 > 0.0 ? std::clamp(Dot(Cross(e, p), across) / area2, 0.0, 1.0 - u) : 0.0;
  return { u, v };
}
}

vtkMTNormalSampling::vtkMTNormalSampling(const vtkMTPatchSource& source, std::size_t samples, std::uint64_t seed)
  : vtkMTJointSampling(source, samples, seed, "normals")
  , Measure(source.GetGraph().FindMeasure(vtkMTMeasure::NormalDeviation))
{
  this->SetWidth(3);
  // As pictures are shaded: normals of points, else of cells, else of the triangles themselves.
  const std::vector<vtkMTArrayInfo>& arrays = source.GetGraph().Arrays;
  int found = -1;
  for (const auto association : { vtkMTArrayInfo::Cell, vtkMTArrayInfo::Point })
  {
    for (std::size_t i = 0; i < arrays.size(); ++i)
    {
      const bool isIt = arrays[i].Association == association && arrays[i].Attribute == vtkDataSetAttributes::NORMALS &&
        arrays[i].Components == 3;
      found = isIt ? static_cast<int>(i) : found;
    }
  }
  this->Normals = found >= 0 ? this->AddColumn(found) : Column();
}

vtkMTNormalSampling::~vtkMTNormalSampling() = default;

void vtkMTNormalSampling::AddData(const vtkMTPatch& patch, std::size_t triangle, Side& side)
{
  const std::size_t first = side.Data.size();
  side.Data.resize(first + 9, 0.0);
  if (this->Normals.Array >= 0)
  {
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      this->GetTuple(this->Normals, patch, triangle, corner, side.Data.data() + first + 3 * corner);
    }
    return;
  }
  const Corners x = side.GetCorners(static_cast<std::uint32_t>(first / 9));
  const vtkMTRealPoint across = Cross(Subtract(x[1], x[0]), Subtract(x[2], x[0]));
  const double length = Norm(across);
  for (std::size_t i = 0; i < 9; ++i)
  {
    side.Data[first + i] = length > 0.0 ? across[i % 3] / length : 0.0;
  }
}

vtkMTNormalSampling::Corners vtkMTNormalSampling::GetNormals(const Side& side, std::uint32_t triangle)
{
  const double* n = side.GetData(triangle, 0);
  return { { { n[0], n[1], n[2] }, { n[3], n[4], n[5] }, { n[6], n[7], n[8] } } };
}

// The interpolated normal, of length 1.
bool vtkMTNormalSampling::Take(const Side& from, const Place& place, Wanted& wanted) const
{
  wanted.Data = Blend(GetNormals(from, place.Triangle), place.Weights[0], place.Weights[1]);
  const double length = Norm(wanted.Data);
  for (double& n : wanted.Data)
  {
    n = length > 0.0 ? n / length : 0.0;
  }
  return true;
}

double vtkMTNormalSampling::GetAngle(std::uint32_t node) const
{
  return this->Measure->Values[node] + AngleTolerance;
}

bool vtkMTNormalSampling::HasPoint(
  const Side& to, std::uint32_t triangle, const Wanted& wanted, std::uint32_t node, double reach) const
{
  const double angle = this->GetAngle(node);
  const double cosine = angle < Straight ? std::cos(angle) : -1.0;
  const vtkMTRealPoint& x = wanted.X;
  const Corners corners = to.GetCorners(triangle);
  if (angle >= Straight)
  {
    return vtkMTClosestPoint::GetDistance2(x, corners[0], corners[1], corners[2]) <= reach * reach;
  }
  const Corners normals = GetNormals(to, triangle);
  const auto excess = [&](double u, double v)
  {
    const vtkMTRealPoint n = Blend(normals, u, v);
    const double turned = Norm(n) * cosine - Dot(n, wanted.Data);
    return std::max(turned, Norm(Subtract(Blend(corners, u, v), x)) / reach - 1.0);
  };
  // Most often the place below will do.
  const std::array<double, 2> below = GetWeights(corners, x);
  if (excess(below[0], below[1]) <= 0.0)
  {
    return true;
  }
  if (angle < RightAngle)
  {
    return Minimise([&](double u) { return Minimise([&](double share) { return excess(u, share * (1.0 - u)); }); }) <=
      0.0;
  }
  // Nothing is convex here, but little of a triangle can be so far off: a grid will do.
  constexpr int cells = 24;
  for (int i = 0; i <= cells; ++i)
  {
    for (int j = 0; i + j <= cells; ++j)
    {
      if (excess(double(i) / cells, double(j) / cells) <= 0.0)
      {
        return true;
      }
    }
  }
  return false;
}

std::string vtkMTNormalSampling::Describe(const Wanted&, std::uint32_t node) const
{
  std::ostringstream text;
  text.precision(9);
  text << "a normal within " << this->GetAngle(node) << " radians of the one there";
  return text.str();
}
