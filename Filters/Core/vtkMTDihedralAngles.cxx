// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTDihedralAngles.h"

#include "vtkMTHalfedgePairs.h"
#include "vtkMTVector.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

using namespace vtkMTVector;

namespace
{
Vector GetNormal(const vtkMTPatch& mesh, const vtkMTTriangle& p)
{
  std::array<Vector, 2> sides;
  for (std::size_t s = 0; s < 2; ++s)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      sides[s][i] = static_cast<double>(mesh.Points[p[s + 1]][i]) - static_cast<double>(mesh.Points[p[0]][i]);
    }
  }
  return Cross(sides[0], sides[1]);
}
}

void vtkMTDihedralAngles::Add(const vtkMTPatch& mesh)
{
  std::vector<std::uint32_t> corners;
  std::vector<Vector> normals;
  corners.reserve(3 * mesh.Triangles.size());
  normals.reserve(mesh.Triangles.size());
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    const vtkMTTriangle p = mesh.GetPointsOfTriangle(t);
    corners.insert(corners.end(), p.begin(), p.end());
    normals.push_back(GetNormal(mesh, p));
  }
  const std::vector<std::uint32_t> opposites = vtkMTHalfedgePairs::Find(corners);
  for (std::uint32_t h = 0; h < opposites.size(); ++h)
  {
    if (opposites[h] <= h || opposites[h] == ~std::uint32_t(0))
    {
      continue;
    }
    const Vector& a = normals[h / 3];
    const Vector& b = normals[opposites[h] / 3];
    if (Norm(a) > 0.0 && Norm(b) > 0.0)
    {
      const double angle = vtkMath::DegreesFromRadians(std::atan2(Norm(Cross(a, b)), Dot(a, b)));
      ++this->Edges[std::min(static_cast<std::size_t>(angle), this->Edges.size() - 1)];
    }
  }
}

void vtkMTDihedralAngles::Add(const vtkMTDihedralAngles& other)
{
  for (std::size_t i = 0; i < this->Edges.size(); ++i)
  {
    this->Edges[i] += other.Edges[i];
  }
}

std::uint64_t vtkMTDihedralAngles::Count(std::size_t from, std::size_t to) const
{
  const auto begin = this->Edges.begin();
  return std::accumulate(
    begin + static_cast<std::ptrdiff_t>(from), begin + static_cast<std::ptrdiff_t>(to), std::uint64_t(0));
}

bool vtkMTDihedralAngles::IsCad() const
{
  const std::uint64_t hard = this->Count(LeastHardAngle, this->Edges.size());
  return hard > 0 && 50 * hard >= this->Count(0, this->Edges.size()) &&
    hard > this->Count(LeastHardAngle / 2, LeastHardAngle);
}
