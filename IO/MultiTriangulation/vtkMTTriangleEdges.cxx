// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTTriangleEdges.h"

#include <algorithm>
#include <iterator>
#include <numeric>

vtkMTTriangleEdges::vtkMTTriangleEdges(const std::vector<vtkMTTriangle>& triangles, std::size_t vertices)
  : First(vertices + 1, 0)
  , Corners(new Entry[3 * triangles.size()])
  , Ends(new std::uint32_t[3 * triangles.size()])
  , Triangles(triangles)
  , IsDone(triangles.size(), 0)
  , Reverse(triangles.size(), Unknown)
{
  for (const vtkMTTriangle& t : triangles)
  {
    for (std::uint32_t v : t)
    {
      ++this->First[v + std::size_t(1)];
    }
  }
  std::partial_sum(this->First.begin(), this->First.end(), this->First.begin());
  std::vector<std::size_t> next(this->First.begin(), this->First.end() - 1);
  const auto put = [&](std::uint32_t t, std::uint32_t c, std::uint32_t from, std::uint32_t to)
  {
    const std::size_t at = next[from]++;
    this->Corners[at] = { t, c };
    this->Ends[at] = to;
  };
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
  {
    const vtkMTTriangle& v = triangles[t];
    put(t, 0, v[0], v[1]);
    put(t, 1, v[1], v[2]);
    put(t, 2, v[2], v[0]);
  }
  this->GroupHubs();
}

void vtkMTTriangleEdges::GroupHubs()
{
  for (std::size_t v = 0; v + 1 < this->First.size(); ++v)
  {
    if (!this->IsHub(static_cast<std::uint32_t>(v)))
    {
      continue;
    }
    if (this->Skipped.empty())
    {
      this->FindReverses();
      this->Skipped.assign(3 * this->Triangles.size(), 0);
    }
    std::stable_sort(this->Corners.get() + this->First[v], this->Corners.get() + this->First[v + 1],
      [this](const Corner& a, const Corner& b)
      {
        const std::uint32_t ends[2] = { this->Get(a, 1), this->Get(b, 1) };
        const auto isSome = [this](const Corner& c) { return this->Reverse[c.Triangle] == Some; };
        return ends[0] != ends[1] ? ends[0] < ends[1] : isSome(a) && !isSome(b);
      });
  }
}

// Of all triangles: those of the same three vertices are neighbours when sorted.
void vtkMTTriangleEdges::FindReverses()
{
  const auto sorted = [this](std::uint32_t t)
  {
    vtkMTTriangle corners = this->Triangles[t];
    std::sort(corners.begin(), corners.end());
    return corners;
  };
  // Whether it runs through its sorted corners in their order.
  const auto isUp = [this](std::uint32_t t)
  {
    const vtkMTTriangle& c = this->Triangles[t];
    return (c[0] < c[1]) + (c[1] < c[2]) + (c[2] < c[0]) == 2;
  };
  std::vector<std::uint32_t> order(this->Triangles.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return sorted(a) < sorted(b); });
  for (auto first = order.begin(); first != order.end();)
  {
    const vtkMTTriangle corners = sorted(*first);
    const auto last = std::find_if(first, order.end(), [&](std::uint32_t t) { return sorted(t) != corners; });
    const auto ups = std::count_if(first, last, isUp);
    const bool isOwnReverse = corners[0] == corners[1] || corners[1] == corners[2];
    const bool isSome = isOwnReverse || (ups > 0 && ups < std::distance(first, last));
    std::for_each(first, last, [&](std::uint32_t t) { this->Reverse[t] = isSome ? Some : Lone; });
    first = last;
  }
}

// The first one that is not done. What is done stays so, and is passed over once.
vtkMTTriangleEdges::Corner vtkMTTriangleEdges::FindOfHub(std::uint32_t a, std::uint32_t b)
{
  const std::size_t last = this->First[a + std::size_t(1)];
  const Entry* const begin = std::lower_bound(this->Corners.get() + this->First[a], this->Corners.get() + last, b,
    [this](const Corner& corner, std::uint32_t end)
    {
      ++this->Looks;
      return this->Get(corner, 1) < end;
    });
  const auto group = static_cast<std::size_t>(begin - this->Corners.get());
  std::size_t i = group < last ? group + this->Skipped[group] : last;
  while (i < last && this->Get(this->Corners[i], 1) == b && this->IsDone[this->Corners[i].Triangle])
  {
    ++i;
    ++this->Looks;
  }
  ++this->Looks;
  if (group < last)
  {
    this->Skipped[group] = static_cast<std::uint32_t>(i - group);
  }
  return i < last && this->Get(this->Corners[i], 1) == b ? Corner(this->Corners[i]) : Corner();
}

// Done or not; looked for once, as there may be any number of triangles at a vertex.
bool vtkMTTriangleEdges::HasReverse(const Corner& corner)
{
  ReverseType& reverse = this->Reverse[corner.Triangle];
  if (reverse == Unknown)
  {
    reverse = this->FindReverse(corner) ? Some : Lone;
  }
  return reverse == Some;
}

bool vtkMTTriangleEdges::FindReverse(const Corner& corner) const
{
  const std::uint32_t a = this->Get(corner, 0);
  for (std::size_t i = this->First[a]; i < this->First[a + std::size_t(1)]; ++i)
  {
    const Corner other = this->Corners[i];
    if (this->Get(other, 1) == this->Get(corner, 2) && this->Get(other, 2) == this->Get(corner, 1))
    {
      return true;
    }
  }
  return false;
}
