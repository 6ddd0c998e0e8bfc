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

vtkMTSurface::vtkMTSurface(const vtkMTPatch& mesh, const vtkMTPoint& origin)
{
  const std::size_t count = mesh.Triangles.size();
  std::vector<Vector> places(mesh.Points.size());
  for (std::size_t p = 0; p < places.size(); ++p)
  {
    for (int i = 0; i < 3; ++i)
    {
      places[p][i] = static_cast<double>(mesh.Points[p][i]) - static_cast<double>(origin[i]);
      this->Extent = std::max(this->Extent, std::abs(places[p][i]));
    }
  }
  this->Triangles.reserve(count);
  this->Points.resize(3 * count);
  // Below this all products and sums of products are integers below 2^53, so that double precision is exact as well.
  const bool isSmall = this->Extent <= double(1 << 24);
  for (std::size_t i = 0; i < count; ++i)
  {
    const vtkMTTriangle points = mesh.GetPointsOfTriangle(i);
    std::copy(points.begin(), points.end(), this->Points.begin() + static_cast<std::ptrdiff_t>(3 * i));
    Triangle t;
    t.Corners = { places[points[0]], places[points[1]], places[points[2]] };
    const Vector u = Subtract(t.Corners[1], t.Corners[0]);
    const Vector v = Subtract(t.Corners[2], t.Corners[0]);
    const Vector normal = isSmall ? Cross(u, v) : MakeLongNormal(t.Corners);
    t.TwiceArea = Norm(normal);
    t.Normal = t.TwiceArea > 0.0 ? Scale(normal, 1.0 / t.TwiceArea) : Vector{ 0.0, 0.0, 0.0 };
    t.Inward0 = Cross(t.Normal, u);
    t.Inward2 = Cross(v, t.Normal);
    this->Triangles.push_back(t);
  }
  this->Opposites = vtkMTHalfedgePairs::Find(this->Points);
  this->FindHalfedges(mesh.Points.size());
}

void vtkMTSurface::FindHalfedges(std::size_t points)
{
  this->Halfedges.assign(points, None);
  std::vector<std::uint32_t> triangles(points, 0);
  for (std::uint32_t h = 0; h < this->Points.size(); ++h)
  {
    ++triangles[this->Points[h]];
    std::uint32_t& out = this->Halfedges[this->Points[h]];
    if (out == None || this->Opposites[h] == None)
    {
      out = h;
    }
  }
  this->Hubs.resize(points);
  for (std::size_t p = 0; p < points; ++p)
  {
    this->Hubs[p] = triangles[p] > HubTriangles;
  }
}

// The nearest point of a triangle is below x or on an edge that x is outside of.
inline vtkMTSurface::Foot vtkMTSurface::FindFoot(const Vector& x, const Triangle& t, double limit) const
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
  const Triangle& t = this->Triangles[triangle];
  const Foot foot = this->FindFoot(x, t, std::numeric_limits<double>::infinity());
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
  return this->FindFoot(x, this->Triangles[triangle], limit).Distance2;
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
