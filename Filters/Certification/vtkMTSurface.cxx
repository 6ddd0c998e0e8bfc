// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTSurface.h"

#include "vtkMTVector.h"

#include <algorithm>

using namespace vtkMTVector;

namespace
{
// Corners are integers, so the cross product is exact until it is rounded once, however thin the triangle.
Vector MakeLongNormal(const std::array<Vector, 3>& corners)
{
  using Integer = __int128;
  std::array<Integer, 3> u;
  std::array<Integer, 3> v;
  for (int i = 0; i < 3; ++i)
  {
    u[i] = static_cast<std::int64_t>(corners[1][i] - corners[0][i]);
    v[i] = static_cast<std::int64_t>(corners[2][i] - corners[0][i]);
  }
  return { static_cast<double>(u[1] * v[2] - u[2] * v[1]), static_cast<double>(u[2] * v[0] - u[0] * v[2]),
    static_cast<double>(u[0] * v[1] - u[1] * v[0]) };
}
}

vtkMTSurface::vtkMTSurface(const vtkMTPatch& mesh, const vtkMTPoint& origin, Planes planes)
  : Places(mesh.Points.size())
{
  const std::size_t count = mesh.Triangles.size();
  for (std::size_t p = 0; p < this->Places.size(); ++p)
  {
    for (int i = 0; i < 3; ++i)
    {
      const double x = static_cast<double>(mesh.Points[p][i]) - static_cast<double>(origin[i]);
      this->Places[p][i] = x;
      this->Extent = std::max(this->Extent, std::abs(x));
    }
  }
  // Below this all products and sums of products are integers below 2^53, so that double precision is exact as well.
  this->IsSmall = this->Extent <= double(1 << 24);
  this->Points.reserve(3 * count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const vtkMTTriangle points = mesh.GetPointsOfTriangle(i);
    this->Points.insert(this->Points.end(), points.begin(), points.end());
  }
  if (planes == Planes::Kept)
  {
    std::vector<Triangle> triangles(count);
    for (std::uint32_t t = 0; t < count; ++t)
    {
      this->Make(t, triangles[t]);
    }
    this->Triangles = std::move(triangles);
  }
  this->Opposites = vtkMTHalfedgePairs::Find(this->Points, mesh.Points.size());
  this->FindHalfedges(mesh.Points.size());
}

void vtkMTSurface::Make(std::uint32_t triangle, Triangle& made) const
{
  made.Corners = { this->GetCorner(triangle, 0), this->GetCorner(triangle, 1), this->GetCorner(triangle, 2) };
  const Vector u = Subtract(made.Corners[1], made.Corners[0]);
  const Vector v = Subtract(made.Corners[2], made.Corners[0]);
  const Vector normal = this->IsSmall ? Cross(u, v) : MakeLongNormal(made.Corners);
  made.TwiceArea = Norm(normal);
  made.Normal = made.TwiceArea > 0.0 ? Scale(normal, 1.0 / made.TwiceArea) : Vector{ 0.0, 0.0, 0.0 };
  made.Inward0 = Cross(made.Normal, u);
  made.Inward2 = Cross(v, made.Normal);
}

void vtkMTSurface::FindHalfedges(std::size_t points)
{
  this->Halfedges.assign(points, None);
  std::vector<std::uint32_t> triangles(points, 0);
  const auto count = static_cast<std::uint32_t>(this->Points.size());
  for (std::uint32_t h = count; h > 0; --h)
  {
    const std::uint32_t p = this->Points[h - 1];
    ++triangles[p];
    this->Halfedges[p] = h - 1;
  }
  for (std::uint32_t h = 0; h < count; ++h)
  {
    if (this->Opposites[h] == None)
    {
      this->Halfedges[this->Points[h]] = h;
    }
  }
  const std::uint32_t most = points > 0 ? *std::max_element(triangles.begin(), triangles.end()) : 0;
  for (std::size_t p = 0; p < points && most > HubTriangles; ++p)
  {
    this->Hubs.push_back(triangles[p] > HubTriangles);
  }
}

// The nearest point of a triangle is below x or on an edge that x is outside of.
inline vtkMTSurface::Foot vtkMTSurface::FindFoot(const Vector& x, const Triangle& t, double limit)
{
  const Vector from0 = Subtract(x, t.Corners[0]);
  const double height = Dot(from0, t.Normal);
  Foot foot{ std::numeric_limits<double>::infinity(), -1, 0.0 };
  if (height * height >= limit)
  {
    return foot; // the plane alone is too far
  }
  const double area0 = Dot(from0, t.Inward0);
  const double area2 = Dot(from0, t.Inward2);
  const std::array<double, 3> areas{ area0, t.TwiceArea - area0 - area2, area2 };
  if (t.TwiceArea > 0.0 && areas[0] >= 0.0 && areas[1] >= 0.0 && areas[2] >= 0.0)
  {
    foot.Distance2 = height * height;
    return foot;
  }
  for (int e = 0; e < 3; ++e)
  {
    if (areas[e] >= 0.0 && t.TwiceArea > 0.0)
    {
      continue;
    }
    const Vector along = Subtract(t.Corners[e == 2 ? 0 : e + 1], t.Corners[e]);
    const Vector from = Subtract(x, t.Corners[e]);
    const double length2 = Dot(along, along);
    const double parameter = length2 > 0.0 ? std::clamp(Dot(from, along) / length2, 0.0, 1.0) : 0.0;
    const Vector difference = Subtract(from, Scale(along, parameter));
    const double distance2 = Dot(difference, difference);
    if (distance2 < foot.Distance2)
    {
      foot = { distance2, e, parameter };
    }
  }
  return foot;
}

vtkMTSurface::Hit vtkMTSurface::Project(const Vector& x, std::uint32_t triangle) const
{
  Triangle made;
  const Triangle& t = this->GetTriangle(triangle, made);
  const Foot foot = FindFoot(x, t, std::numeric_limits<double>::infinity());
  Hit hit;
  hit.Triangle = triangle;
  hit.Distance2 = foot.Distance2;
  if (foot.Edge < 0)
  {
    const Vector from0 = Subtract(x, t.Corners[0]);
    const double area0 = Dot(from0, t.Inward0);
    const double area2 = Dot(from0, t.Inward2);
    hit.Weights = { (t.TwiceArea - area0 - area2) / t.TwiceArea, area2 / t.TwiceArea, area0 / t.TwiceArea };
    hit.Place = Subtract(x, Scale(t.Normal, Dot(from0, t.Normal)));
    return hit;
  }
  const int end = foot.Edge == 2 ? 0 : foot.Edge + 1;
  hit.Place = foot.Parameter == 1.0 ? t.Corners[end] : Lerp(t.Corners[foot.Edge], t.Corners[end], foot.Parameter);
  hit.Weights = { 0.0, 0.0, 0.0 };
  hit.Weights[foot.Edge] = 1.0 - foot.Parameter;
  hit.Weights[end] = foot.Parameter;
  return hit;
}

double vtkMTSurface::GetDistance2(const Vector& x, std::uint32_t triangle, double limit) const
{
  Triangle made;
  return FindFoot(x, this->GetTriangle(triangle, made), limit).Distance2;
}

double vtkMTSurface::GetDistance2(const Vector& x, const Triangle& triangle, double limit)
{
  return FindFoot(x, triangle, limit).Distance2;
}

// All triangles of h's fan but its own; none of a hub's.
void vtkMTSurface::LookAround(const Vector& x, std::uint32_t h, Hit& hit) const
{
  if (this->IsHub(this->Points[h]))
  {
    return;
  }
  std::uint32_t best = None;
  double best2 = hit.Distance2;
  const auto look = [&](std::uint32_t out)
  {
    const double distance2 = this->GetDistance2(x, out / 3, best2);
    if (distance2 < best2)
    {
      best2 = distance2;
      best = out / 3;
    }
  };
  std::uint32_t out = this->TurnLeft(h);
  for (; out != None && out != h; out = this->TurnLeft(out))
  {
    look(out);
  }
  if (out == None)
  {
    for (out = this->TurnRight(h); out != None; out = this->TurnRight(out))
    {
      look(out);
    }
  }
  if (best != None)
  {
    hit = this->Project(x, best);
  }
}

vtkMTSurface::Hit vtkMTSurface::FindAround(const Vector& x, std::uint32_t h) const
{
  Hit hit = this->Project(x, h / 3);
  this->LookAround(x, h, hit);
  this->Descend(x, hit);
  return hit;
}

void vtkMTSurface::Descend(const Vector& x, Hit& hit) const
{
  double before = std::numeric_limits<double>::infinity();
  for (int step = 0; step < MostSteps && hit.Distance2 < before; ++step)
  {
    before = hit.Distance2;
    const Vector& w = hit.Weights;
    for (std::uint32_t c = 0; c < 3; ++c)
    {
      if (w[c] == 0.0) // on the edge opposite to the corner
      {
        const std::uint32_t opposite = this->Opposites[3 * hit.Triangle + (c == 2 ? 0 : c + 1)];
        if (w[0] == 1.0 || w[1] == 1.0 || w[2] == 1.0)
        {
          const std::uint32_t corner = w[0] == 1.0 ? 0 : (w[1] == 1.0 ? 1 : 2);
          this->LookAround(x, 3 * hit.Triangle + corner, hit);
        }
        else if (opposite != None && this->GetDistance2(x, opposite / 3, hit.Distance2) < hit.Distance2)
        {
          hit = this->Project(x, opposite / 3);
        }
        break;
      }
    }
  }
}
