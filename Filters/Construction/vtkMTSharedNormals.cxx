// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTSharedNormals.h"

#include "vtkMTDihedralAngles.h"
#include "vtkMTOrientation.h"
#include "vtkMTPointNormals.h"

#include <cstring>

namespace
{
struct NormalRecord
{
  std::uint64_t Key; // region above, point below
  std::array<float, 3> Value;
  std::uint32_t Triangle;
};
}

vtkMTSharedNormals::vtkMTSharedNormals(vtkMTSpoolStore& store, std::size_t memory)
  : Terms(store, sizeof(Term), memory / 2)
  , Normals(store, sizeof(NormalRecord), memory / 2)
{
}

void vtkMTSharedNormals::FindTerms(const vtkMTPatch& fragment, const std::vector<std::uint32_t>& numbers,
  const std::vector<std::uint32_t>& identities, const std::vector<std::uint32_t>& componentOf,
  const std::vector<unsigned char>& isTurned, std::uint32_t region, std::vector<Term>& terms)
{
  const auto getKey = [&fragment](std::uint32_t point, std::uint32_t triangle)
  { return (std::uint64_t(static_cast<std::uint32_t>(fragment.Ids[point])) << 32) | triangle; };
  for (std::size_t t = 0; t < fragment.Triangles.size(); ++t)
  {
    const vtkMTTriangle p = fragment.GetPointsOfTriangle(t);
    const auto isShared = [&](int c) { return p[c] < fragment.Ids.size(); };
    std::array<std::array<double, 3>, 3> sums;
    if (!(isShared(0) || isShared(1) || isShared(2)) || !vtkMTPointNormals::GetTerms(fragment, t, sums))
    {
      continue;
    }
    for (int c = 0; c < 3; ++c)
    {
      if (isShared(c))
      {
        terms.push_back({ getKey(p[c], numbers[t]), componentOf[t], isTurned[t], identities[p[(c + 1) % 3]],
          identities[p[(c + 2) % 3]], region, static_cast<std::uint32_t>(t), sums[c] });
      }
    }
  }
  for (std::uint32_t point = 0; point < fragment.Ids.size(); ++point)
  {
    terms.push_back({ getKey(point, AllTriangles), 0, 0, 0, 0, region, AllTriangles, {} });
  }
}

bool vtkMTSharedNormals::Add(const std::vector<Term>& terms, const std::vector<std::uint32_t>& components)
{
  for (Term term : terms)
  {
    if (static_cast<std::uint32_t>(term.Key) != AllTriangles)
    {
      term.Component = components[term.Component];
    }
    if (!this->Terms.Add(&term))
    {
      this->Error = this->Terms.GetError();
      return false;
    }
  }
  return true;
}

bool vtkMTSharedNormals::Solve(const vtkMTOrientation& orientation, const Settings& settings)
{
  std::vector<Term> terms; // of one point
  bool good = this->Terms.Finish();
  while (const unsigned char* bytes = good ? this->Terms.Next() : nullptr)
  {
    Term term;
    std::memcpy(&term, bytes, sizeof(term));
    good = terms.empty() || terms[0].Key >> 32 == term.Key >> 32 || this->SolvePoint(terms, orientation, settings);
    terms.push_back(term);
  }
  good = good && !this->Terms.HasFailed() && this->SolvePoint(terms, orientation, settings);
  good = good && this->Normals.Finish();
  this->Next = good ? this->Normals.Next() : nullptr;
  this->Error = this->Terms.GetError() + this->Normals.GetError();
  return good && this->Error.empty();
}

// Empties the list, whose last entries name regions.
bool vtkMTSharedNormals::SolvePoint(
  std::vector<Term>& terms, const vtkMTOrientation& orientation, const Settings& settings)
{
  std::vector<vtkMTPointNormals::Corner> corners;
  corners.reserve(terms.size());
  vtkMTMadeNormals::Sum sum{ 0, 0, 0 };
  for (const Term& term : terms)
  {
    if (term.Triangle == AllTriangles)
    {
      break;
    }
    const bool isReversed = orientation.IsReversed(term.Component, term.IsTurned != 0);
    corners.push_back({ isReversed ? term.Previous : term.Next, isReversed ? term.Next : term.Previous, term.Sum });
    for (std::size_t i = 0; i < 3; ++i)
    {
      corners.back().Term[i] = isReversed ? -term.Sum[i] : term.Sum[i];
    }
    vtkMTPointNormals::Add(corners.back().Term, sum);
  }
  std::vector<std::array<float, 3>> normals;
  if (settings.FeatureAngle < vtkMTDihedralAngles::Smooth)
  {
    normals = vtkMTPointNormals::GetNormalsOfGroups(
      corners, vtkMTPointNormals::GetCosine(settings.FeatureAngle), settings.Bits);
  }
  const std::array<float, 3> first = normals.empty() ? vtkMTPointNormals::GetDirection(sum, settings.Bits) : normals[0];
  bool added = true;
  for (std::size_t i = corners.size(); added && i < terms.size(); ++i)
  {
    added = this->AddNormal(terms[i].Region, { static_cast<std::uint32_t>(terms[i].Key >> 32), AllTriangles, first });
  }
  for (std::size_t i = 0; added && i < normals.size(); ++i)
  {
    added = normals[i] == first ||
      this->AddNormal(
        terms[i].Region, { static_cast<std::uint32_t>(terms[i].Key >> 32), terms[i].Triangle, normals[i] });
  }
  terms.clear();
  return added;
}

bool vtkMTSharedNormals::AddNormal(std::uint32_t region, const Normal& normal)
{
  const NormalRecord record{ (std::uint64_t(region) << 32) | normal.Point, normal.Value, normal.Triangle };
  return this->Normals.Add(&record);
}

bool vtkMTSharedNormals::Take(std::uint32_t region, const vtkMTPatch& fragment, std::vector<Normal>& normals)
{
  // Shared points are in increasing order of their identities, and so are the records.
  normals.clear();
  for (std::uint32_t p = 0; p < fragment.Ids.size(); ++p)
  {
    const std::uint64_t key = (std::uint64_t(region) << 32) | static_cast<std::uint32_t>(fragment.Ids[p]);
    if (!this->Next || vtkMTRecordSort::GetKey(this->Next) != key)
    {
      this->Error =
        this->Normals.HasFailed() ? this->Normals.GetError() : "the normals of shared points are incomplete";
      return false;
    }
    for (; this->Next && vtkMTRecordSort::GetKey(this->Next) == key; this->Next = this->Normals.Next())
    {
      NormalRecord record;
      std::memcpy(&record, this->Next, sizeof(record));
      normals.push_back({ p, record.Triangle, record.Value });
    }
  }
  return true;
}
