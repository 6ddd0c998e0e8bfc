// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTCounterparts.h"

#include "vtkMTVector.h"

#include <algorithm>
#include <cmath>

namespace
{
double GetDistance(const vtkMTRealPoint& a, const vtkMTRealPoint& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}
}

bool vtkMTCounterparts::Match(std::uint32_t input, std::uint32_t model, Counterpart& counterpart) const
{
  const vtkMTTriangle& a = this->Input.Triangles[input];
  const vtkMTTriangle& b = this->Model.Triangles[model];
  std::array<bool, 3> taken{ false, false, false };
  counterpart.Triangle = model;
  for (int i = 0; i < 3; ++i)
  {
    int best = -1;
    double least = this->Allowed;
    for (int j = 0; j < 3; ++j)
    {
      const double distance = GetDistance(this->Input.Points[a[i]], this->Model.Points[b[j]]);
      if (!taken[j] && distance <= least)
      {
        best = j;
        least = distance;
      }
    }
    if (best < 0)
    {
      return false;
    }
    taken[best] = true;
    counterpart.Corners[i] = best;
  }
  return true;
}

// All copies have their corners at the same lattice points, so the first one speaks for them.
void vtkMTCounterparts::Add(std::uint32_t input, const vtkMTLatticeKeys::Copies& copies, Found& found) const
{
  Counterpart counterpart;
  if (copies.GetCount() == 0 || !this->Match(input, copies.First->Triangle, counterpart))
  {
    return;
  }
  const bool isTurned = counterpart.IsTurned();
  std::vector<Counterpart>& list = isTurned ? found.Turned : found.Same;
  (isTurned ? found.TurnedCount : found.SameCount) += copies.GetCount();
  for (const vtkMTLatticeKeys::Entry& entry : copies)
  {
    if (list.size() == CopiesLimit)
    {
      break;
    }
    if (this->Match(input, entry.Triangle, counterpart))
    {
      list.push_back(counterpart);
    }
  }
}

void vtkMTCounterparts::Count(std::uint32_t input, Found& found) const
{
  vtkMTLatticeKeys::Key keys[3];
  for (int i = 0; i < 3; ++i)
  {
    if (!this->InputKeys.GetKey(this->InputPlaces[this->Input.Triangles[input][i]], keys[i]))
    {
      return;
    }
  }
  const auto [same, turned] = this->InputKeys.FindTriangles(keys[0], keys[1], keys[2]);
  found.InputSame = same.GetCount();
  found.InputTurned = turned.GetCount();
  const auto* const own = std::lower_bound(same.begin(), same.end(), input,
    [](const vtkMTLatticeKeys::Entry& entry, std::uint32_t triangle) { return entry.Triangle < triangle; });
  found.Rank = static_cast<std::size_t>(own - same.begin());
}

vtkMTCounterparts::Found vtkMTCounterparts::Find(std::uint32_t triangle) const
{
  Found found;
  std::array<std::vector<vtkMTLatticeKeys::Key>, 3> corners;
  for (int i = 0; i < 3; ++i)
  {
    corners[i] = this->ModelKeys.FindCorners(this->InputPlaces[this->Input.Triangles[triangle][i]]);
  }
  for (vtkMTLatticeKeys::Key a : corners[0])
  {
    for (vtkMTLatticeKeys::Key b : corners[1])
    {
      for (vtkMTLatticeKeys::Key c : corners[2])
      {
        for (const vtkMTLatticeKeys::Copies& copies : this->ModelKeys.FindTriangles(a, b, c))
        {
          this->Add(triangle, copies, found);
        }
      }
    }
  }
  this->Count(triangle, found);
  return found;
}
