// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTSampledSurface.h"

#include "vtkMTGraph.h"
#include "vtkMTTriangleStream.h"

#include <algorithm>
#include <cmath>

void vtkMTSampledSurface::LeaveOutFar(const vtkMTGraph& graph)
{
  if (graph.InputReport.count("dropped_far_outlier") == 0)
  {
    return;
  }
  double box[6];
  graph.GetBounds(box);
  const double margin = std::max({ box[1] - box[0], box[3] - box[2], box[5] - box[4] });
  const auto isFar = [&](std::uint32_t p)
  {
    const vtkMTRealPoint& x = this->Points[p];
    return x[0] < box[0] - margin || x[0] > box[1] + margin || x[1] < box[2] - margin || x[1] > box[3] + margin ||
      x[2] < box[4] - margin || x[2] > box[5] + margin;
  };
  std::size_t kept = 0;
  const std::size_t count = this->Triangles.size();
  for (std::size_t t = 0; t < count; ++t)
  {
    if (std::none_of(this->Triangles[t].begin(), this->Triangles[t].end(), isFar))
    {
      this->Triangles[kept] = this->Triangles[t];
      if (!this->Cells.empty())
      {
        this->Cells[kept] = this->Cells[t];
        this->Slack[kept] = this->Slack[t];
        this->Mixed[kept] = this->Mixed[t];
      }
      ++kept;
    }
  }
  this->FarOutliers += static_cast<std::int64_t>(count - kept);
  this->Triangles.resize(kept);
  this->Cells.resize(std::min(kept, this->Cells.size()));
  this->Slack.resize(std::min(kept, this->Slack.size()));
  this->Mixed.resize(std::min(kept, this->Mixed.size()));
}

void vtkMTSampledSurface::Append(const vtkMTPatch& patch, const vtkMTLattice& lattice, const vtkMTMeasuringFrame& frame)
{
  const auto first = static_cast<std::uint32_t>(this->Points.size());
  for (const vtkMTPoint& point : patch.Points)
  {
    this->Points.push_back(frame.ToLocal(lattice.ToWorld(point)));
  }
  for (std::size_t i = 0; i < patch.Triangles.size(); ++i)
  {
    const vtkMTTriangle t = patch.GetPointsOfTriangle(i);
    this->Triangles.push_back({ first + t[0], first + t[1], first + t[2] });
  }
}

vtkMTRealBounds vtkMTSampledSurface::GetBounds() const
{
  vtkMTRealBounds bounds;
  for (const vtkMTTriangle& triangle : this->Triangles)
  {
    for (std::uint32_t point : triangle)
    {
      bounds.Add(this->Points[point]);
    }
  }
  return bounds;
}

void vtkMTSampledSurface::Transform(const vtkMTMeasuringFrame& frame)
{
  for (vtkMTRealPoint& point : this->Points)
  {
    point = frame.ToLocal(point);
  }
  for (double& slack : this->Slack)
  {
    slack *= frame.Scale;
  }
}

std::vector<vtkMTRealPoint> vtkMTSampledSurface::GetUsedPoints() const
{
  std::vector<unsigned char> used(this->Points.size(), 0);
  for (const vtkMTTriangle& triangle : this->Triangles)
  {
    for (std::uint32_t point : triangle)
    {
      used[point] = 1;
    }
  }
  std::vector<vtkMTRealPoint> points;
  for (std::size_t i = 0; i < used.size(); ++i)
  {
    if (used[i])
    {
      points.push_back(this->Points[i]);
    }
  }
  return points;
}

double vtkMTSampledSurface::GetArea(std::size_t triangle) const
{
  const vtkMTTriangle& t = this->Triangles[triangle];
  const vtkMTRealPoint& a = this->Points[t[0]];
  vtkMTRealPoint u, v;
  for (int axis = 0; axis < 3; ++axis)
  {
    u[axis] = this->Points[t[1]][axis] - a[axis];
    v[axis] = this->Points[t[2]][axis] - a[axis];
  }
  return 0.5 * std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
}

namespace
{
bool IsFinite(const vtkMTRealPoint& x)
{
  return std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]);
}

void AddTriangle(vtkMTSampledSurface& surface, const std::array<std::uint64_t, 3>& triangle)
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

bool vtkMTSampledSurface::Read(vtkMTTriangleStream& stream, const std::function<bool()>& goOn, std::string& error)
{
  *this = vtkMTSampledSurface();
  constexpr std::uint64_t limit = 0xfffffffe;
  bool good = stream.Rewind();
  if (good && (stream.GetNumberOfPoints() > limit || stream.GetNumberOfTriangles() > limit))
  {
    error = "has more than 4 billion points or triangles; compare smaller parts of it";
    return false;
  }
  this->Points.reserve(good ? stream.GetNumberOfPoints() : 0);
  this->Triangles.reserve(good ? stream.GetNumberOfTriangles() : 0);
  vtkMTTriangleStream::PointBlock points;
  vtkMTTriangleStream::TriangleBlock triangles;
  while ((good = good && stream.NextPoints(points)) && !points.Points.empty())
  {
    this->Points.insert(this->Points.end(), points.Points.begin(), points.Points.end());
    if (!goOn())
    {
      return false;
    }
  }
  while ((good = good && stream.NextTriangles(triangles)) && !triangles.Triangles.empty())
  {
    for (const std::array<std::uint64_t, 3>& triangle : triangles.Triangles)
    {
      AddTriangle(*this, triangle);
    }
    if (!goOn())
    {
      return false;
    }
  }
  if (!good)
  {
    error = stream.GetError();
    return false;
  }
  if (this->Triangles.empty())
  {
    error = "has no triangle with three finite, different corners; name a mesh that has some";
    return false;
  }
  return true;
}
