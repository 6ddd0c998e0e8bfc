// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPointNormals.h"

#include "vtkMTVector.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <utility>

using namespace vtkMTVector;

namespace
{
using Normal = std::array<float, 3>;
}

bool vtkMTPointNormals::GetTerms(
  const vtkMTPatch& mesh, std::size_t triangle, std::array<std::array<double, 3>, 3>& terms)
{
  const vtkMTTriangle p = mesh.GetPointsOfTriangle(triangle);
  return vtkMTMadeNormals::GetTerms({ &mesh.Points[p[0]], &mesh.Points[p[1]], &mesh.Points[p[2]] }, terms);
}

void vtkMTPointNormals::Add(const std::array<double, 3>& term, vtkMTMadeNormals::Sum& sum)
{
  for (std::size_t i = 0; i < 3; ++i)
  {
    sum[i] += static_cast<std::int64_t>(term[i]);
  }
}

std::array<float, 3> vtkMTPointNormals::GetDirection(const vtkMTMadeNormals::Sum& sum, int bits)
{
  return vtkMTMadeNormals::GetNormal(vtkMTMadeNormals::GetPlace(sum, bits), bits);
}

std::vector<std::array<float, 3>> vtkMTPointNormals::Compute(const vtkMTPatch& mesh, int bits)
{
  std::vector<vtkMTMadeNormals::Sum> sums;
  vtkMTMadeNormals::GetSums(mesh, true, sums);
  std::vector<Normal> normals(sums.size());
  for (std::size_t i = 0; i < sums.size(); ++i)
  {
    normals[i] = GetDirection(sums[i], bits);
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
  const std::vector<Corner>& corners, double cosine, int bits)
{
  const std::vector<std::uint32_t> groups = FindGroups(corners, cosine);
  std::vector<vtkMTMadeNormals::Sum> sums(corners.size(), vtkMTMadeNormals::Sum{ 0, 0, 0 });
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    Add(corners[i].Term, sums[groups[i]]);
  }
  std::vector<Normal> normals(corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    normals[i] = groups[i] == i ? GetDirection(sums[i], bits) : normals[groups[i]];
  }
  return normals;
}

std::vector<std::array<float, 3>> vtkMTPointNormals::ComputeByCorner(
  const vtkMTPatch& mesh, double featureAngle, int bits)
{
  std::vector<std::uint32_t> order(3 * mesh.Triangles.size()); // of the corners: by point, then by triangle
  std::iota(order.begin(), order.end(), 0u);
  const auto getPoint = [&mesh](std::uint32_t h) { return mesh.GetPointOfWedge(mesh.Triangles[h / 3][h % 3]); };
  std::stable_sort(
    order.begin(), order.end(), [&getPoint](std::uint32_t a, std::uint32_t b) { return getPoint(a) < getPoint(b); });
  const double cosine = GetCosine(featureAngle);
  std::vector<Normal> normals(order.size(), GetDirection({ 0, 0, 0 }, bits));
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
    const std::vector<Normal> found = GetNormalsOfGroups(corners, cosine, bits);
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

//------------------------------------------------------------------------------
void vtkMTPointNormals::Renew(const vtkMTPatch& mesh, bool isSmooth, int bits, vtkMTColumn& column)
{
  std::vector<vtkMTMadeNormals::Sum> sums;
  vtkMTMadeNormals::GetSums(mesh, false, sums);
  const std::size_t wedges = mesh.GetNumberOfWedges();
  std::vector<Normal> normals(wedges);
  std::memcpy(normals.data(), column.data(), column.size());
  std::vector<Normal> renewed(wedges);
  for (std::size_t begin = 0, end = 0; begin < wedges; begin = end)
  {
    const std::uint32_t point = mesh.GetPointOfWedge(static_cast<std::uint32_t>(begin));
    while (end < wedges && mesh.GetPointOfWedge(static_cast<std::uint32_t>(end)) == point)
    {
      ++end;
    }
    for (std::size_t w = begin; w < end; ++w)
    {
      vtkMTMadeNormals::Sum sum{ 0, 0, 0 };
      for (std::size_t other = begin; other < end && point >= mesh.Ids.size(); ++other)
      {
        const bool isOfGroup = isSmooth || normals[other] == normals[w];
        for (std::size_t i = 0; i < 3 && isOfGroup; ++i)
        {
          sum[i] += sums[other][i];
        }
      }
      const bool hasSum = sum != vtkMTMadeNormals::Sum{ 0, 0, 0 };
      renewed[w] = vtkMTMadeNormals::GetNormal(
        hasSum ? vtkMTMadeNormals::GetPlace(sum, bits) : vtkMTMadeNormals::GetPlace(normals[w], bits), bits);
    }
  }
  std::memcpy(column.data(), renewed.data(), column.size());
}
