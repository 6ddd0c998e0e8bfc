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

// In whole steps.
std::uint64_t GetLength(const vtkMTPatch& mesh, std::uint32_t from, std::uint32_t to)
{
  const double length = Norm(GetSide(mesh, from, to));
  const auto whole = static_cast<std::int64_t>(length);
  return static_cast<std::uint64_t>(whole + (length - static_cast<double>(whole) >= 0.5 ? 1 : 0));
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

void vtkMTDihedralAngles::Add(const vtkMTPatch& mesh)
{
  this->Add(mesh, vtkMTHalfedgePairs(mesh));
}

void vtkMTDihedralAngles::Add(const vtkMTPatch& mesh, const vtkMTHalfedgePairs& pairs)
{
  std::vector<std::uint32_t> hardEdges;
  const std::vector<EdgeKind> kinds = this->AddKinds(mesh, pairs, hardEdges);
  const auto isBesideFlat = [&kinds](std::uint32_t h)
  { return kinds[vtkMTHalfedgePairs::Next(h)] == Flat || kinds[vtkMTHalfedgePairs::Previous(h)] == Flat; };
  for (const std::uint32_t h : hardEdges)
  {
    if (isBesideFlat(h) && isBesideFlat(pairs.Partners[h]))
    {
      ++this->Numbers.Creases;
      this->Lengths.Creases += GetLength(mesh, pairs.Corners[h], pairs.Corners[vtkMTHalfedgePairs::Next(h)]);
    }
  }
}

// Gives the kind of each half-edge, None where there is no angle, and one half-edge of each hard edge.
std::vector<vtkMTDihedralAngles::EdgeKind> vtkMTDihedralAngles::AddKinds(
  const vtkMTPatch& mesh, const vtkMTHalfedgePairs& pairs, std::vector<std::uint32_t>& hardEdges)
{
  std::vector<Normal> normals(mesh.Triangles.size());
  for (std::size_t t = 0; t < normals.size(); ++t)
  {
    const std::uint32_t* p = pairs.Corners.data() + 3 * t;
    normals[t].Direction = Cross(GetSide(mesh, p[0], p[1]), GetSide(mesh, p[0], p[2]));
    normals[t].Length = Norm(normals[t].Direction);
  }
  std::vector<EdgeKind> kinds(pairs.Corners.size(), None);
  std::array<std::uint64_t, Sharp + 1> numbers{};
  std::array<std::uint64_t, Sharp + 1> lengths{};
  for (std::uint32_t t = 0; t < normals.size(); ++t)
  {
    const std::uint32_t first = 3 * t;
    for (std::uint32_t h = first; h < first + 3; ++h)
    {
      const std::uint32_t partner = pairs.Partners[h];
      if (partner <= h || !pairs.HasPartner(h) || !pairs.AreOpposite(h, partner))
      {
        continue;
      }
      const EdgeKind kind = GetKind(normals[t], normals[partner / 3]);
      kinds[h] = kinds[partner] = kind;
      ++numbers[kind];
      lengths[kind] += GetLength(mesh, pairs.Corners[h], pairs.Corners[h == first + 2 ? first : h + 1]);
      if (kind >= Hard)
      {
        hardEdges.push_back(h);
      }
    }
  }
  AddKinds(numbers, this->Numbers);
  AddKinds(lengths, this->Lengths);
  return kinds;
}

void vtkMTDihedralAngles::AddKinds(const std::array<std::uint64_t, Sharp + 1>& weights, Sum& sum)
{
  sum.Edges += weights[Flat] + weights[Soft] + weights[Hard] + weights[Sharp];
  sum.Flat += weights[Flat];
  sum.Hard += weights[Hard] + weights[Sharp];
  sum.Sharp += weights[Sharp];
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
