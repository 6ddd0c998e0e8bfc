// SPDX-License-Identifier: BSD-3-Clause
#include "bmtSurface.h"

#include "bmtCommon.h"
#include "bmtInput.h"

#include "vtkMTPolyDataStream.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <limits>

//------------------------------------------------------------------------------
bmtBounds::bmtBounds()
{
  this->Minimum.fill(std::numeric_limits<double>::infinity());
  this->Maximum.fill(-std::numeric_limits<double>::infinity());
}

void bmtBounds::Add(const bmtPoint& x)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Minimum[axis] = std::min(this->Minimum[axis], x[axis]);
    this->Maximum[axis] = std::max(this->Maximum[axis], x[axis]);
  }
}

void bmtBounds::Add(const bmtBounds& other)
{
  this->Add(other.Minimum);
  this->Add(other.Maximum);
}

double bmtBounds::GetDiagonal() const
{
  return this->IsEmpty() ? 0.0
                         : std::hypot(this->Maximum[0] - this->Minimum[0], this->Maximum[1] - this->Minimum[1],
                             this->Maximum[2] - this->Minimum[2]);
}

//------------------------------------------------------------------------------
bmtFrame bmtFrame::FromBounds(const bmtBounds& bounds)
{
  bmtFrame frame;
  if (bounds.IsEmpty())
  {
    return frame;
  }
  double half = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    frame.Center[axis] = 0.5 * bounds.Minimum[axis] + 0.5 * bounds.Maximum[axis];
    half = std::max(half, 0.5 * bounds.Maximum[axis] - 0.5 * bounds.Minimum[axis]);
  }
  if (half > 0.0)
  {
    // A power of two at least as large as half the longest side; clamped so that its inverse is finite.
    frame.Scale = std::ldexp(1.0, std::clamp(-(std::ilogb(half) + 1), -1020, 1020));
  }
  return frame;
}

bmtPoint bmtFrame::ToLocal(const bmtPoint& x) const
{
  return { (x[0] - this->Center[0]) * this->Scale, (x[1] - this->Center[1]) * this->Scale,
    (x[2] - this->Center[2]) * this->Scale };
}

bmtPoint bmtFrame::ToModelPoint(const bmtPoint& local) const
{
  return { local[0] / this->Scale + this->Center[0], local[1] / this->Scale + this->Center[1],
    local[2] / this->Scale + this->Center[2] };
}

//------------------------------------------------------------------------------
bmtBounds bmtSurface::GetBounds() const
{
  bmtBounds bounds;
  for (const bmtTriangle& triangle : this->Triangles)
  {
    for (std::uint32_t point : triangle)
    {
      bounds.Add(this->Points[point]);
    }
  }
  return bounds;
}

void bmtSurface::Transform(const bmtFrame& frame)
{
  for (bmtPoint& point : this->Points)
  {
    point = frame.ToLocal(point);
  }
}

std::vector<bmtPoint> bmtSurface::GetUsedPoints() const
{
  std::vector<unsigned char> used(this->Points.size(), 0);
  for (const bmtTriangle& triangle : this->Triangles)
  {
    for (std::uint32_t point : triangle)
    {
      used[point] = 1;
    }
  }
  std::vector<bmtPoint> points;
  for (std::size_t i = 0; i < used.size(); ++i)
  {
    if (used[i])
    {
      points.push_back(this->Points[i]);
    }
  }
  return points;
}

double bmtSurface::GetArea(std::size_t triangle) const
{
  const bmtTriangle& t = this->Triangles[triangle];
  const bmtPoint& a = this->Points[t[0]];
  bmtPoint u, v;
  for (int axis = 0; axis < 3; ++axis)
  {
    u[axis] = this->Points[t[1]][axis] - a[axis];
    v[axis] = this->Points[t[2]][axis] - a[axis];
  }
  return 0.5 * std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
}

//------------------------------------------------------------------------------
namespace
{
bool IsFinite(const bmtPoint& x)
{
  return std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]);
}

void AddTriangle(bmtSurface& surface, const std::array<std::uint64_t, 3>& triangle)
{
  for (std::uint64_t point : triangle)
  {
    if (point >= surface.Points.size())
    {
      ++surface.OutOfRange;
      return;
    }
  }
  for (std::uint64_t point : triangle)
  {
    if (!IsFinite(surface.Points[point]))
    {
      ++surface.NonFinite;
      return;
    }
  }
  for (int corner = 0; corner < 3; ++corner)
  {
    if (surface.Points[triangle[corner]] == surface.Points[triangle[(corner + 1) % 3]])
    {
      ++surface.Degenerate;
      return;
    }
  }
  surface.Triangles.push_back({ static_cast<std::uint32_t>(triangle[0]), static_cast<std::uint32_t>(triangle[1]),
    static_cast<std::uint32_t>(triangle[2]) });
}

}

bmtSurface bmtMakeSurface(vtkMTTriangleStream& stream, const std::string& path)
{
  bmtSurface surface;
  constexpr std::uint64_t limit = 0xfffffffe;
  if (stream.GetNumberOfPoints() > limit || stream.GetNumberOfTriangles() > limit)
  {
    throw bmtError(path + ": has more than 4 billion points or triangles; compare smaller parts of it");
  }
  surface.Points.reserve(stream.GetNumberOfPoints());
  surface.Triangles.reserve(stream.GetNumberOfTriangles());
  vtkMTTriangleStream::PointBlock points;
  vtkMTTriangleStream::TriangleBlock triangles;
  bool good = stream.Rewind();
  while ((good = good && stream.NextPoints(points)) && !points.Points.empty())
  {
    surface.Points.insert(surface.Points.end(), points.Points.begin(), points.Points.end());
  }
  while ((good = good && stream.NextTriangles(triangles)) && !triangles.Triangles.empty())
  {
    for (const std::array<std::uint64_t, 3>& triangle : triangles.Triangles)
    {
      AddTriangle(surface, triangle);
    }
    bmtThrowIfInterrupted();
  }
  if (!good)
  {
    throw bmtError(path + ": " + stream.GetError());
  }
  return surface;
}

bmtSurface bmtReadSurface(const bmtInput& input)
{
  const std::vector<std::string>& paths = input.Paths;
  vtkNew<vtkPolyData> mesh;
  bmtReadInput(input, mesh);
  vtkMTPolyDataStream stream(mesh);
  bmtSurface surface = bmtMakeSurface(stream, paths.front());
  if (surface.Triangles.empty())
  {
    throw bmtError(paths.front() + ": has no triangle with three finite, different corners; name a mesh that has some");
  }
  return surface;
}
