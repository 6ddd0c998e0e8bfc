// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTLatticeKeys.h"

#include <algorithm>
#include <iterator>

namespace
{
std::uint64_t Mix(std::uint64_t x)
{
  x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9u;
  x = (x ^ x >> 27) * 0x94d049bb133111ebu;
  return x ^ x >> 31;
}
}

vtkMTLatticeKeys::vtkMTLatticeKeys(
  const vtkMTLattice& lattice, const double bounds[6], const vtkMTSampledSurface& surface)
  : Lattice(lattice)
{
  this->Bounds.Add({ bounds[0] - lattice.Step, bounds[2] - lattice.Step, bounds[4] - lattice.Step });
  this->Bounds.Add({ bounds[1] + lattice.Step, bounds[3] + lattice.Step, bounds[5] + lattice.Step });
  this->Triangles.reserve(surface.Triangles.size());
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    const vtkMTTriangle& corners = surface.Triangles[t];
    if (!std::all_of(
          corners.begin(), corners.end(), [&](std::uint32_t p) { return this->IsWithin(surface.Points[p]); }))
    {
      continue; // beyond what the lattice can hold
    }
    std::uint64_t keys[3];
    for (int i = 0; i < 3; ++i)
    {
      keys[i] = this->GetKey(surface.Points[corners[i]]);
    }
    for (int i = 0; i < 3; ++i)
    {
      this->Edges.insert(keys[i] + keys[(i + 1) % 3]);
    }
    this->Triangles.emplace(keys[0] + keys[1] + keys[2], static_cast<std::uint32_t>(t));
  }
}

bool vtkMTLatticeKeys::IsWithin(const vtkMTRealPoint& x) const
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!(x[axis] >= this->Bounds.Minimum[axis] && x[axis] <= this->Bounds.Maximum[axis]))
    {
      return false;
    }
  }
  return true;
}

std::uint64_t vtkMTLatticeKeys::GetKey(const vtkMTRealPoint& x) const
{
  std::uint64_t key = 0;
  for (std::int32_t c : this->Lattice.Snap(x.data()))
  {
    key = Mix(key + 0x9e3779b97f4a7c15u + static_cast<std::uint32_t>(c));
  }
  return key;
}

bool vtkMTLatticeKeys::HasEdge(const vtkMTRealPoint& a, const vtkMTRealPoint& b) const
{
  return this->IsWithin(a) && this->IsWithin(b) && this->Edges.count(this->GetKey(a) + this->GetKey(b)) > 0;
}

std::vector<std::uint32_t> vtkMTLatticeKeys::FindTriangles(
  const vtkMTRealPoint& a, const vtkMTRealPoint& b, const vtkMTRealPoint& c) const
{
  std::vector<std::uint32_t> found;
  if (this->IsWithin(a) && this->IsWithin(b) && this->IsWithin(c))
  {
    const auto range = this->Triangles.equal_range(this->GetKey(a) + this->GetKey(b) + this->GetKey(c));
    std::transform(
      range.first, range.second, std::back_inserter(found), [](const auto& entry) { return entry.second; });
    std::sort(found.begin(), found.end());
  }
  return found;
}
