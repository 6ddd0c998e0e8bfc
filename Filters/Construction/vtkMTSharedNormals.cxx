// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTSharedNormals.h"

#include "vtkMTOrientation.h"
#include "vtkMTPointNormals.h"

#include <cstring>

namespace
{
struct NormalRecord
{
  std::uint64_t Key; // region above, point below
  std::array<float, 3> Normal;
  std::uint32_t Padding;
};
}

vtkMTSharedNormals::vtkMTSharedNormals(vtkMTSpoolStore& store, std::size_t memory)
  : Terms(store, sizeof(Term), memory / 2)
  , Normals(store, sizeof(NormalRecord), memory / 2)
{
}

void vtkMTSharedNormals::FindTerms(const vtkMTPatch& fragment, const std::vector<std::uint32_t>& numbers,
  const std::vector<std::uint32_t>& componentOf, const std::vector<unsigned char>& isTurned, std::uint32_t region,
  std::vector<Term>& terms)
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
        terms.push_back({ getKey(p[c], numbers[t]), componentOf[t], isTurned[t], sums[c] });
      }
    }
  }
  for (std::uint32_t point = 0; point < fragment.Ids.size(); ++point)
  {
    // Instead of a component: the region that has the point.
    terms.push_back({ getKey(point, AllTriangles), region, 0, {} });
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

bool vtkMTSharedNormals::Solve(const vtkMTOrientation& orientation)
{
  std::array<double, 3> sum{ 0.0, 0.0, 0.0 };
  std::uint64_t point = ~std::uint64_t(0);
  bool good = this->Terms.Finish();
  while (const unsigned char* bytes = good ? this->Terms.Next() : nullptr)
  {
    Term term;
    std::memcpy(&term, bytes, sizeof(term));
    if (term.Key >> 32 != point)
    {
      point = term.Key >> 32;
      sum = { 0.0, 0.0, 0.0 };
    }
    if (static_cast<std::uint32_t>(term.Key) == AllTriangles)
    {
      const NormalRecord normal{ (std::uint64_t(term.Component) << 32) | point, vtkMTPointNormals::GetDirection(sum),
        0 };
      good = this->Normals.Add(&normal);
      continue;
    }
    const bool isReversed = orientation.IsReversed(term.Component, term.IsTurned != 0);
    for (int i = 0; i < 3; ++i)
    {
      sum[i] += isReversed ? -term.Sum[i] : term.Sum[i];
    }
  }
  good = good && !this->Terms.HasFailed() && this->Normals.Finish();
  this->Next = good ? this->Normals.Next() : nullptr;
  this->Error = this->Terms.GetError() + this->Normals.GetError();
  return good && this->Error.empty();
}

bool vtkMTSharedNormals::Take(
  std::uint32_t region, const vtkMTPatch& fragment, std::vector<std::array<float, 3>>& normals)
{
  // Shared points are in increasing order of their identities, and so are the records.
  for (std::size_t p = 0; p < fragment.Ids.size(); ++p)
  {
    const std::uint64_t key = (std::uint64_t(region) << 32) | static_cast<std::uint32_t>(fragment.Ids[p]);
    if (!this->Next || vtkMTRecordSort::GetKey(this->Next) != key)
    {
      this->Error =
        this->Normals.HasFailed() ? this->Normals.GetError() : "the normals of shared points are incomplete";
      return false;
    }
    NormalRecord record;
    std::memcpy(&record, this->Next, sizeof(record));
    normals[p] = record.Normal;
    this->Next = this->Normals.Next();
  }
  return true;
}
