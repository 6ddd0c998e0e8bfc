// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPointNormals.h"

#include "vtkMTVector.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

using namespace vtkMTVector;

namespace
{
Vector Difference(const vtkMTPoint& a, const vtkMTPoint& b)
{
  return { static_cast<double>(a[0]) - static_cast<double>(b[0]), static_cast<double>(a[1]) - static_cast<double>(b[1]),
    static_cast<double>(a[2]) - static_cast<double>(b[2]) };
}
}

bool vtkMTPointNormals::GetTerms(
  const vtkMTPatch& mesh, std::size_t triangle, std::array<std::array<double, 3>, 3>& terms)
{
  const vtkMTTriangle p = mesh.GetPointsOfTriangle(triangle);
  const std::array<const vtkMTPoint*, 3> x{ &mesh.Points[p[0]], &mesh.Points[p[1]], &mesh.Points[p[2]] };
  const Vector normal = Cross(Difference(*x[1], *x[0]), Difference(*x[2], *x[0]));
  const double twiceArea = Norm(normal);
  if (!(twiceArea > 0.0))
  {
    return false;
  }
  for (int c = 0; c < 3; ++c)
  {
    const Vector u = Difference(*x[(c + 1) % 3], *x[c]);
    const Vector v = Difference(*x[(c + 2) % 3], *x[c]);
    const double angle = std::atan2(twiceArea, Dot(u, v));
    terms[c] = Scale(normal, angle / twiceArea);
  }
  return true;
}

std::array<float, 3> vtkMTPointNormals::GetDirection(const std::array<double, 3>& sum)
{
  const double length = Norm(sum);
  const Vector unit = length > 0.0 ? Scale(sum, 1.0 / length) : Vector{ 0.0, 0.0, 1.0 };
  return { static_cast<float>(unit[0]), static_cast<float>(unit[1]), static_cast<float>(unit[2]) };
}

std::vector<std::array<float, 3>> vtkMTPointNormals::Compute(const vtkMTPatch& mesh)
{
  std::vector<Vector> sums(mesh.Points.size(), Vector{ 0.0, 0.0, 0.0 });
  std::array<Vector, 3> terms;
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    const vtkMTTriangle p = mesh.GetPointsOfTriangle(t);
    const bool hasTerms = GetTerms(mesh, t, terms);
    for (std::size_t c = 0; hasTerms && c < 3; ++c)
    {
      sums[p[c]] = Add(sums[p[c]], terms[c]);
    }
  }
  std::vector<std::array<float, 3>> normals(sums.size());
  for (std::size_t i = 0; i < sums.size(); ++i)
  {
    normals[i] = GetDirection(sums[i]);
  }
  return normals;
}

//------------------------------------------------------------------------------
double vtkMTPointNormals::GetCosine(double featureAngle)
{
  return std::cos(vtkMath::RadiansFromDegrees(std::min(featureAngle + 0.5, 180.0)));
}

std::vector<std::uint32_t> vtkMTPointNormals::FindGroups(const std::vector<Corner>& corners, double cosine)
{
  using Edge = std::pair<std::uint32_t, std::uint32_t>; // its other end; twice the corner, and 1 where it is the last
  std::vector<Edge> edges;
  for (std::uint32_t i = 0; i < corners.size(); ++i)
  {
    edges.emplace_back(corners[i].Next, 2 * i);
    edges.emplace_back(corners[i].Previous, 2 * i + 1);
  }
  std::sort(edges.begin(), edges.end());
  std::vector<std::uint32_t> parents(corners.size());
  std::iota(parents.begin(), parents.end(), 0u);
  const auto find = [&parents](std::uint32_t i)
  {
    for (; parents[i] != i; i = parents[i])
    {
      parents[i] = parents[parents[i]];
    }
    return i;
  };
  for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end)
  {
    while (end < edges.size() && edges[end].first == edges[begin].first)
    {
      ++end;
    }
    const std::uint32_t a = edges[begin].second;
    const std::uint32_t b = edges[end - 1].second;
    if (end - begin != 2 || a % 2 == b % 2)
    {
      continue;
    }
    const Vector& n = corners[a / 2].Term;
    const Vector& m = corners[b / 2].Term;
    if (Dot(n, m) >= cosine * (Norm(n) * Norm(m)))
    {
      const auto [low, high] = std::minmax({ find(a / 2), find(b / 2) });
      parents[high] = low;
    }
  }
  for (std::uint32_t i = 0; i < parents.size(); ++i)
  {
    parents[i] = find(i);
  }
  return parents;
}

std::vector<std::array<float, 3>> vtkMTPointNormals::GetNormalsOfGroups(
  const std::vector<Corner>& corners, double cosine)
{
  const std::vector<std::uint32_t> groups = FindGroups(corners, cosine);
  std::vector<Vector> sums(corners.size(), Vector{ 0.0, 0.0, 0.0 });
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    sums[groups[i]] = Add(sums[groups[i]], corners[i].Term);
  }
  std::vector<std::array<float, 3>> normals(corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    normals[i] = groups[i] == i ? GetDirection(sums[i]) : normals[groups[i]];
  }
  return normals;
}

std::vector<std::array<float, 3>> vtkMTPointNormals::ComputeByCorner(const vtkMTPatch& mesh, double featureAngle)
{
  std::vector<std::uint32_t> order(3 * mesh.Triangles.size()); // of the corners: by point, then by triangle
  std::iota(order.begin(), order.end(), 0u);
  const auto getPoint = [&mesh](std::uint32_t h) { return mesh.GetPointOfWedge(mesh.Triangles[h / 3][h % 3]); };
  std::stable_sort(
    order.begin(), order.end(), [&getPoint](std::uint32_t a, std::uint32_t b) { return getPoint(a) < getPoint(b); });
  const double cosine = GetCosine(featureAngle);
  std::vector<std::array<float, 3>> normals(order.size(), GetDirection({ 0.0, 0.0, 0.0 }));
  std::array<Vector, 3> terms;
  std::vector<Corner> corners;
  std::vector<std::uint32_t> halfedges; // of the corners
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end)
  {
    corners.clear();
    halfedges.clear();
    for (; end < order.size() && getPoint(order[end]) == getPoint(order[begin]); ++end)
    {
      const std::uint32_t t = order[end] / 3;
      const std::uint32_t c = order[end] % 3;
      if (GetTerms(mesh, t, terms))
      {
        corners.push_back({ getPoint(3 * t + (c + 1) % 3), getPoint(3 * t + (c + 2) % 3), terms[c] });
        halfedges.push_back(order[end]);
      }
    }
    const std::vector<std::array<float, 3>> found = GetNormalsOfGroups(corners, cosine);
    for (std::size_t i = begin; i < end && !found.empty(); ++i)
    {
      normals[order[i]] = found[0];
    }
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      normals[halfedges[i]] = found[i];
    }
  }
  return normals;
}
