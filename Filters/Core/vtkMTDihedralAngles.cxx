// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTDihedralAngles.h"

#include "vtkMTHalfedgePairs.h"
#include "vtkMTVector.h"

#include "vtkMath.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

using namespace vtkMTVector;

namespace
{
constexpr double NoAngle = -1.0;

Vector GetSide(const vtkMTPatch& mesh, std::uint32_t from, std::uint32_t to)
{
  Vector side;
  for (std::size_t i = 0; i < 3; ++i)
  {
    side[i] = static_cast<double>(mesh.Points[to][i]) - static_cast<double>(mesh.Points[from][i]);
  }
  return side;
}

double Share(std::uint64_t part, std::uint64_t whole)
{
  return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0.0;
}

double GetProduct(const vtkMTDihedralAngles::Sum& sum)
{
  return Share(sum.Flat, sum.Edges) * Share(sum.Sharp, sum.Edges);
}
}

// [half-edges], NoAngle where there is none; both sides of an edge have its angle.
std::vector<double> vtkMTDihedralAngles::GetAngles(const vtkMTPatch& mesh, std::vector<std::uint32_t>& opposites)
{
  std::vector<std::uint32_t> corners;
  std::vector<Vector> normals;
  corners.reserve(3 * mesh.Triangles.size());
  normals.reserve(mesh.Triangles.size());
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    const vtkMTTriangle p = mesh.GetPointsOfTriangle(t);
    corners.insert(corners.end(), p.begin(), p.end());
    normals.push_back(Cross(GetSide(mesh, p[0], p[1]), GetSide(mesh, p[0], p[2])));
  }
  opposites = vtkMTHalfedgePairs::Find(corners);
  std::vector<double> angles(corners.size(), NoAngle);
  for (std::uint32_t h = 0; h < opposites.size(); ++h)
  {
    if (opposites[h] == vtkMTHalfedgePairs::None || opposites[h] < h)
    {
      continue;
    }
    const Vector& a = normals[h / 3];
    const Vector& b = normals[opposites[h] / 3];
    if (Norm(a) > 0.0 && Norm(b) > 0.0)
    {
      angles[h] = vtkMath::DegreesFromRadians(std::atan2(Norm(Cross(a, b)), Dot(a, b)));
      angles[opposites[h]] = angles[h];
    }
  }
  return angles;
}

void vtkMTDihedralAngles::AddEdge(double angle, bool isBetweenFlat, std::uint64_t weight, Sum& sum)
{
  sum.Edges += weight;
  sum.Flat += angle < LargestFlat ? weight : 0;
  sum.Hard += angle >= LeastHard ? weight : 0;
  sum.Sharp += angle >= LeastSharp ? weight : 0;
  sum.Creases += angle >= LeastHard && isBetweenFlat ? weight : 0;
}

void vtkMTDihedralAngles::Add(const vtkMTPatch& mesh)
{
  std::vector<std::uint32_t> opposites;
  const std::vector<double> angles = GetAngles(mesh, opposites);
  const auto isFlat = [&angles](std::uint32_t h) { return angles[h] != NoAngle && angles[h] < LargestFlat; };
  const auto isBesideFlat = [&](std::uint32_t h)
  { return isFlat(vtkMTHalfedgePairs::Next(h)) || isFlat(vtkMTHalfedgePairs::Previous(h)); };
  for (std::uint32_t h = 0; h < angles.size(); ++h)
  {
    if (angles[h] == NoAngle || opposites[h] < h)
    {
      continue;
    }
    const bool isBetweenFlat = isBesideFlat(h) && isBesideFlat(opposites[h]);
    const vtkMTTriangle p = mesh.GetPointsOfTriangle(h / 3);
    const double length = Norm(GetSide(mesh, p[h % 3], p[(h + 1) % 3]));
    AddEdge(angles[h], isBetweenFlat, 1, this->Numbers);
    AddEdge(angles[h], isBetweenFlat, static_cast<std::uint64_t>(std::llround(length)), this->Lengths);
  }
}

void vtkMTDihedralAngles::Add(const vtkMTDihedralAngles& other)
{
  const auto add = [](Sum& to, const Sum& from)
  {
    to.Edges += from.Edges;
    to.Flat += from.Flat;
    to.Hard += from.Hard;
    to.Sharp += from.Sharp;
    to.Creases += from.Creases;
  };
  add(this->Numbers, other.Numbers);
  add(this->Lengths, other.Lengths);
}

bool vtkMTDihedralAngles::IsCad() const
{
  const Sum& n = this->Numbers;
  const bool hasCreases = n.Creases > 0 && 2 * n.Creases >= n.Hard && 10000 * n.Creases >= n.Edges;
  const double product = std::max(GetProduct(n), GetProduct(this->Lengths));
  const bool isFlatAndSharp = product >= (20 * n.Creases >= n.Hard ? LeastProduct : LeastProductWithoutCreases);
  return hasCreases || isFlatAndSharp || (n.Edges > 0 && 2 * n.Sharp >= n.Edges);
}

std::string vtkMTDihedralAngles::Describe() const
{
  const Sum& n = this->Numbers;
  const Sum& l = this->Lengths;
  std::array<char, 160> text;
  std::snprintf(text.data(), text.size(), "flat %.2f sharp %.2f hard %.2f creases %.2f by length flat %.2f sharp %.2f",
    100.0 * Share(n.Flat, n.Edges), 100.0 * Share(n.Sharp, n.Edges), 100.0 * Share(n.Hard, n.Edges),
    100.0 * Share(n.Creases, n.Edges), 100.0 * Share(l.Flat, l.Edges), 100.0 * Share(l.Sharp, l.Edges));
  return text.data();
}
