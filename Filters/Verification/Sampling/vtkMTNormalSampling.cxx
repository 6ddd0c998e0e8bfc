// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTNormalSampling.h"

#include "vtkMTCut.h"
#include "vtkMTGraph.h"
#include "vtkMTPatchSource.h"
#include "vtkMTSurfaceSampler.h"
#include "vtkMTVector.h"

#include "vtkDataSetAttributes.h"
#include "vtkSetGet.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <sstream>

using namespace vtkMTVector;

namespace
{
// Normals are stored in single precision.
constexpr double AngleTolerance = 1e-6;
constexpr double RightAngle = 1.5707963267948966;
constexpr double Straight = 2.0 * RightAngle;

vtkMTRealPoint Blend(const std::array<vtkMTRealPoint, 3>& corners, double u, double v)
{
  vtkMTRealPoint x;
  for (int i = 0; i < 3; ++i)
  {
    x[i] = corners[0][i] * (1.0 - u - v) + corners[1][i] * u + corners[2][i] * v;
  }
  return x;
}

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

template <class Value>
vtkMTRealPoint Get(const vtkMTColumn& column, std::size_t tuple)
{
  std::array<Value, 3> value;
  std::memcpy(value.data(), column.data() + tuple * sizeof(value), sizeof(value));
  return { static_cast<double>(value[0]), static_cast<double>(value[1]), static_cast<double>(value[2]) };
}

vtkMTRealPoint GetTuple(int type, const vtkMTColumn& column, std::size_t tuple)
{
  switch (type)
  {
    vtkTemplateMacro(return Get<VTK_TT>(column, tuple));
  }
  return { 0.0, 0.0, 0.0 };
}
}

vtkMTRealPoint vtkMTNormalSampling::Shaded::GetNormal(std::uint32_t triangle, const vtkMTRealPoint& x) const
{
  const std::array<double, 2> weights = this->GetWeights(triangle, x);
  vtkMTRealPoint normal = Blend(this->Normals[triangle], weights[0], weights[1]);
  const double length = Norm(normal);
  for (double& n : normal)
  {
    n = length > 0.0 ? n / length : 0.0;
  }
  return normal;
}

std::array<double, 2> vtkMTNormalSampling::Shaded::GetWeights(std::uint32_t triangle, const vtkMTRealPoint& x) const
{
  const Corners corners = this->GetCorners(triangle);
  const vtkMTRealPoint e = Subtract(corners[1], corners[0]);
  const vtkMTRealPoint f = Subtract(corners[2], corners[0]);
  const vtkMTRealPoint p = Subtract(x, corners[0]);
  const vtkMTRealPoint across = Cross(e, f);
  const double area2 = Dot(across, across);
  const double u = area2 > 0.0 ? std::clamp(Dot(Cross(p, f), across) / area2, 0.0, 1.0) : 0.0;
  const double v = area2 > 0.0 ? std::clamp(Dot(Cross(e, p), across) / area2, 0.0, 1.0 - u) : 0.0;
  return { u, v };
}

vtkMTNormalSampling::Corners vtkMTNormalSampling::Shaded::GetCorners(std::uint32_t triangle) const
{
  const vtkMTTriangle& t = this->Surface.Triangles[triangle];
  return { this->Surface.Points[t[0]], this->Surface.Points[t[1]], this->Surface.Points[t[2]] };
}

//------------------------------------------------------------------------------
vtkMTNormalSampling::vtkMTNormalSampling(const vtkMTPatchSource& source, std::size_t samples, std::uint64_t seed)
  : Source(source)
  , Measure(source.GetGraph().FindMeasure(vtkMTMeasure::NormalDeviation))
  , Samples(samples)
  , Seed(seed)
  , Check("certified_normals")
{
  const vtkMTGraph& graph = source.GetGraph();
  double bounds[6];
  graph.GetBounds(bounds);
  vtkMTRealBounds box;
  box.Add({ bounds[0], bounds[2], bounds[4] });
  box.Add({ bounds[1], bounds[3], bounds[5] });
  this->Frame = vtkMTMeasuringFrame::FromBounds(box);
  // As pictures are shaded: normals of points, else of cells, else of the triangles themselves.
  for (const auto association : { vtkMTArrayInfo::Cell, vtkMTArrayInfo::Point })
  {
    std::size_t column = 0;
    for (std::size_t i = 0; i < graph.Arrays.size(); ++i)
    {
      const vtkMTArrayInfo& array = graph.Arrays[i];
      if (array.Association == association)
      {
        const bool isIt = array.Attribute == vtkDataSetAttributes::NORMALS && array.Components == 3;
        this->Column = isIt ? column : this->Column;
        this->Array = isIt ? static_cast<int>(i) : this->Array;
        ++column;
      }
    }
  }
}

vtkMTNormalSampling::~vtkMTNormalSampling() = default;

bool vtkMTNormalSampling::Begin(const vtkMTVerificationProgress& progress, std::string& error)
{
  const vtkMTGraph& graph = this->Source.GetGraph();
  std::vector<std::uint32_t> arcs;
  for (std::uint32_t arc = 0; arc < graph.Arcs.size(); ++arc)
  {
    if (graph.IsFinest(arc))
    {
      arcs.push_back(arc);
    }
  }
  return this->Read(arcs, progress, this->Finest, error);
}

bool vtkMTNormalSampling::Read(const std::vector<std::uint32_t>& arcs, const vtkMTVerificationProgress& progress,
  Shaded& shaded, std::string& error) const
{
  const vtkMTGraph& graph = this->Source.GetGraph();
  std::vector<unsigned char> arrays(graph.Arrays.size(), 0);
  if (this->Array >= 0)
  {
    arrays[this->Array] = 1;
  }
  vtkMTPatch patch;
  for (const std::uint32_t arc : arcs)
  {
    if (!progress("reading patches", 0.0) || !this->Source.ReadPatch(arc, &arrays, patch, error))
    {
      return false;
    }
    shaded.Surface.Append(patch, graph.Lattice, this->Frame);
    for (std::size_t i = 0; i < patch.Triangles.size(); ++i)
    {
      this->AddNormals(patch, i, shaded);
    }
    shaded.Nodes.resize(shaded.Surface.Triangles.size(), graph.Arcs[arc].To);
  }
  return true;
}

void vtkMTNormalSampling::AddNormals(const vtkMTPatch& patch, std::size_t triangle, Shaded& shaded) const
{
  Corners normals;
  if (this->Array < 0)
  {
    const Corners x = shaded.GetCorners(static_cast<std::uint32_t>(shaded.Normals.size()));
    const vtkMTRealPoint across = Cross(Subtract(x[1], x[0]), Subtract(x[2], x[0]));
    const double length = Norm(across);
    for (int i = 0; i < 3; ++i)
    {
      normals[0][i] = length > 0.0 ? across[i] / length : 0.0;
    }
    normals[1] = normals[2] = normals[0];
  }
  else
  {
    const vtkMTArrayInfo& array = this->Source.GetGraph().Arrays[this->Array];
    const bool ofPoints = array.Association == vtkMTArrayInfo::Point;
    const vtkMTColumn& column = ofPoints ? patch.PointColumns[this->Column] : patch.CellColumns[this->Column];
    for (int c = 0; c < 3; ++c)
    {
      normals[c] = GetTuple(array.Type, column, ofPoints ? patch.Triangles[triangle][c] : triangle);
    }
  }
  shaded.Normals.push_back(normals);
}

vtkMTNormalSampling::Allowed vtkMTNormalSampling::GetAllowed(std::uint32_t node) const
{
  const double angle = this->Measure->Values[node] + AngleTolerance;
  const double error = this->Source.GetGraph().Nodes[node].Error;
  return { error / this->Frame.ToModel(1.0) + vtkMTMeasuringFrame::Tolerance, angle < Straight ? std::cos(angle) : -1.0,
    angle };
}

// Whether the triangle has a point within the distance of x whose normal is within the angle of the given one.
bool vtkMTNormalSampling::HasPoint(const Shaded& to, std::uint32_t triangle, const vtkMTRealPoint& x,
  const vtkMTRealPoint& normal, const Allowed& allowed)
{
  const Corners corners = to.GetCorners(triangle);
  const Corners& normals = to.Normals[triangle];
  const auto excess = [&](double u, double v)
  {
    const vtkMTRealPoint n = Blend(normals, u, v);
    const double turned = Norm(n) * allowed.Cosine - Dot(n, normal);
    return std::max(turned, Norm(Subtract(Blend(corners, u, v), x)) / allowed.Distance - 1.0);
  };
  if (allowed.Angle >= Straight)
  {
    return vtkMTClosestPoint::GetDistance2(x, corners[0], corners[1], corners[2]) <=
      allowed.Distance * allowed.Distance;
  }
  // Most often the place below will do.
  const std::array<double, 2> below = to.GetWeights(triangle, x);
  if (excess(below[0], below[1]) <= 0.0)
  {
    return true;
  }
  if (allowed.Angle < RightAngle)
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

// ofFrom: whether error and angle are those of the surface that samples are taken of.
bool vtkMTNormalSampling::Test(const Shaded& from, const Shaded& to, bool ofFrom, const std::string& name,
  std::uint64_t seed, const vtkMTVerificationProgress& progress)
{
  const vtkMTSurfaceSampler::Samples samples =
    vtkMTSurfaceSampler(from.Surface, this->Samples, seed).Take(0, this->Samples);
  const vtkMTClosestPoint search(to.Surface);
  double reach = 0.0;
  for (const std::uint32_t node : (ofFrom ? from : to).Nodes)
  {
    reach = std::max(reach, this->GetAllowed(node).Distance);
  }
  std::uint32_t hint = vtkMTClosestPoint::NoTriangle;
  for (std::size_t i = 0; i < samples.Points.size(); ++i)
  {
    if (i % 1024 == 0 && !progress(name, double(i) / double(samples.Points.size())))
    {
      return false;
    }
    const vtkMTRealPoint& x = samples.Points[i];
    const std::uint32_t own = samples.Triangles[i];
    const vtkMTRealPoint normal = from.GetNormal(own, x);
    const auto getAllowed = [&](std::uint32_t triangle)
    { return this->GetAllowed(ofFrom ? from.Nodes[own] : to.Nodes[triangle]); };
    hint = search.Find(x, hint).Triangle;
    ++this->Check.Tested;
    const Allowed near = getAllowed(hint);
    bool found = HasPoint(to, hint, x, normal, near);
    if (!found)
    {
      search.VisitWithin(x, reach,
        [&](std::uint32_t triangle)
        {
          found = HasPoint(to, triangle, x, normal, getAllowed(triangle));
          return !found;
        });
    }
    if (!found)
    {
      std::ostringstream text;
      text.precision(9);
      const vtkMTRealPoint at = this->Frame.ToModelPoint(x);
      text << name << ", near (" << at[0] << ", " << at[1] << ", " << at[2] << "): no point within the error has a "
           << "normal within " << near.Angle << " radians of the one there";
      this->Check.Fail(text.str());
    }
  }
  return true;
}

bool vtkMTNormalSampling::TestCut(
  const vtkMTCut& cut, const std::string& name, const vtkMTVerificationProgress& progress, std::string& error)
{
  Shaded shaded;
  return this->Read(cut.GetArcs(), progress, shaded, error) &&
    this->Test(shaded, this->Finest, true, name + " to the finest level's normals", this->Seed, progress) &&
    this->Test(this->Finest, shaded, false, "the finest level's normals to " + name, this->Seed + 1, progress);
}
