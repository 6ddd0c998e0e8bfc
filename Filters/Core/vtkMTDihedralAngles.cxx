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
Vector GetSide(const vtkMTPatch& mesh, std::uint32_t from, std::uint32_t to)
{
  Vector side;
  for (std::size_t i = 0; i < 3; ++i)
  {
    side[i] = static_cast<double>(mesh.Points[to][i]) - static_cast<double>(mesh.Points[from][i]);
  }
  return side;
}

double GetCosine(double degrees)
{
  return std::cos(vtkMath::RadiansFromDegrees(degrees));
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

// By the cosine, which falls with the angle.
vtkMTDihedralAngles::EdgeKind vtkMTDihedralAngles::GetKind(const Normal& a, const Normal& b)
{
  static const double flat = GetCosine(LargestFlat);
  static const double hard = GetCosine(LeastHard);
  static const double sharp = GetCosine(LeastSharp);
  const double product = a.Length * b.Length;
  if (!(product > 0.0))
  {
    return None;
  }
  const double dot = Dot(a.Direction, b.Direction);
  return dot > flat * product ? Flat : dot > hard * product ? Soft : dot > sharp * product ? Hard : Sharp;
}

// Kinds: [half-edges], None where there is no angle; both sides of an edge have its kind.
vtkMTDihedralAngles::Edges vtkMTDihedralAngles::FindEdges(const vtkMTPatch& mesh)
{
  Edges edges;
  edges.Corners.reserve(3 * mesh.Triangles.size());
  std::vector<Normal> normals;
  normals.reserve(mesh.Triangles.size());
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    const vtkMTTriangle p = mesh.GetPointsOfTriangle(t);
    edges.Corners.insert(edges.Corners.end(), p.begin(), p.end());
    const Vector normal = Cross(GetSide(mesh, p[0], p[1]), GetSide(mesh, p[0], p[2]));
    normals.push_back({ normal, Norm(normal) });
  }
  edges.Opposites = vtkMTHalfedgePairs::Find(edges.Corners);
  edges.Kinds.assign(edges.Corners.size(), None);
  for (std::uint32_t h = 0; h < edges.Opposites.size(); ++h)
  {
    const std::uint32_t opposite = edges.Opposites[h];
    if (opposite != vtkMTHalfedgePairs::None && opposite > h)
    {
      edges.Kinds[h] = edges.Kinds[opposite] = GetKind(normals[h / 3], normals[opposite / 3]);
    }
  }
  return edges;
}

void vtkMTDihedralAngles::AddEdge(EdgeKind kind, bool isBetweenFlat, std::uint64_t weight, Sum& sum)
{
  sum.Edges += weight;
  sum.Flat += kind == Flat ? weight : 0;
  sum.Hard += kind >= Hard ? weight : 0;
  sum.Sharp += kind == Sharp ? weight : 0;
  sum.Creases += kind >= Hard && isBetweenFlat ? weight : 0;
}

void vtkMTDihedralAngles::Add(const vtkMTPatch& mesh)
{
  const Edges edges = FindEdges(mesh);
  const auto isBesideFlat = [&edges](std::uint32_t h)
  { return edges.Kinds[vtkMTHalfedgePairs::Next(h)] == Flat || edges.Kinds[vtkMTHalfedgePairs::Previous(h)] == Flat; };
  for (std::uint32_t h = 0; h < edges.Kinds.size(); ++h)
  {
    const EdgeKind kind = edges.Kinds[h];
    if (kind == None || edges.Opposites[h] < h)
    {
      continue;
    }
    const bool isBetweenFlat = kind >= Hard && isBesideFlat(h) && isBesideFlat(edges.Opposites[h]);
    const double length = Norm(GetSide(mesh, edges.Corners[h], edges.Corners[vtkMTHalfedgePairs::Next(h)]));
    AddEdge(kind, isBetweenFlat, 1, this->Numbers);
    AddEdge(kind, isBetweenFlat, static_cast<std::uint64_t>(std::llround(length)), this->Lengths);
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
