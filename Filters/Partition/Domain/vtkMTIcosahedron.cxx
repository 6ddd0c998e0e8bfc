// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTIcosahedron.h"

#include <algorithm>
#include <cmath>

namespace
{
using Point = vtkMTIcosahedron::Point;

double Dot(const Point& a, const Point& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Point Cross(const Point& a, const Point& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

std::array<Point, 12> MakeCorners()
{
  const double golden = 0.5 + 0.5 * std::sqrt(5.0);
  std::array<Point, 12> corners{};
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const std::size_t axis = i / 4;
    corners[i][axis] = 0.0;
    corners[i][(axis + 1) % 3] = i % 2 != 0 ? 1.0 : -1.0;
    corners[i][(axis + 2) % 3] = i % 4 >= 2 ? golden : -golden;
  }
  return corners;
}

// The edges are 2 long; everything else is farther away.
bool AreJoined(const Point& a, const Point& b)
{
  const Point d{ a[0] - b[0], a[1] - b[1], a[2] - b[2] };
  return Dot(d, d) < 5.0;
}
}

vtkMTIcosahedron::vtkMTIcosahedron()
{
  const std::array<Point, 12> corners = MakeCorners();
  for (int a = 0; a < 12; ++a)
  {
    for (int b = a + 1; b < 12; ++b)
    {
      for (int c = b + 1; c < 12; ++c)
      {
        const Point& p = corners[static_cast<std::size_t>(a)];
        const Point& q = corners[static_cast<std::size_t>(b)];
        const Point& r = corners[static_cast<std::size_t>(c)];
        if (!AreJoined(p, q) || !AreJoined(q, r) || !AreJoined(r, p))
        {
          continue;
        }
        Triangle triangle{ { a, b, c }, { p[0] + q[0] + r[0], p[1] + q[1] + r[1], p[2] + q[2] + r[2] },
          { Cross(q, r), Cross(r, p), Cross(p, q) } };
        const double volume = Dot(p, triangle.Planes[0]);
        for (Point& plane : triangle.Planes)
        {
          plane = { plane[0] / volume, plane[1] / volume, plane[2] / volume };
        }
        this->Triangles.push_back(triangle);
      }
    }
  }
}

const vtkMTIcosahedron& vtkMTIcosahedron::Get()
{
  static const vtkMTIcosahedron icosahedron;
  return icosahedron;
}

vtkMTIcosahedron::Place vtkMTIcosahedron::Find(const Point& direction) const
{
  const Triangle* nearest = this->Triangles.data();
  double most = Dot(nearest->Middle, direction);
  for (const Triangle& triangle : this->Triangles)
  {
    const double along = Dot(triangle.Middle, direction);
    nearest = along > most ? &triangle : nearest;
    most = std::max(most, along);
  }
  Place place{ nearest->Corners, {} };
  double sum = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    place.Weights[i] = std::max(Dot(nearest->Planes[i], direction), 0.0);
    sum += place.Weights[i];
  }
  for (double& weight : place.Weights)
  {
    weight /= sum;
  }
  return place;
}
