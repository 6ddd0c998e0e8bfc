// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTLatticeKeys.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace
{
using Key = vtkMTLatticeKeys::Key;

// Cells as large as several reaches: a query mostly looks at one to four of them.
constexpr std::int64_t ReachesInCell = 4;
// Beyond it everything is near everything; it keeps sums of lattice points within their type.
constexpr double LargestReach = 1 << 28;

Key Mix(Key x)
{
  x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9u;
  x = (x ^ x >> 27) * 0x94d049bb133111ebu;
  return x ^ x >> 31;
}

Key Hash(const vtkMTPoint& point)
{
  Key key = 0;
  for (std::int32_t c : point)
  {
    key = Mix(key + 0x9e3779b97f4a7c15u + static_cast<std::uint32_t>(c));
  }
  return key;
}

std::int32_t DivideDown(std::int64_t a, std::int64_t b)
{
  return static_cast<std::int32_t>(a >= 0 ? a / b : -((b - 1 - a) / b));
}

// 0 or 1: whether the order of the corners is that of their keys, up to a rotation.
std::uint32_t GetTurn(Key a, Key b, Key c)
{
  return static_cast<std::uint32_t>(a > b) ^ static_cast<std::uint32_t>(b > c) ^ static_cast<std::uint32_t>(a > c);
}

bool IsBefore(const vtkMTLatticeKeys::Entry& a, const vtkMTLatticeKeys::Entry& b)
{
  return std::tie(a.Corners, a.Turn, a.Triangle) < std::tie(b.Corners, b.Turn, b.Triangle);
}
}

vtkMTLatticeKeys::vtkMTLatticeKeys(
  const vtkMTLattice& lattice, const double bounds[6], double reach, const vtkMTSampledSurface& surface)
  : Lattice(lattice)
{
  const double margin = lattice.Step + reach;
  this->Bounds.Add({ bounds[0] - margin, bounds[2] - margin, bounds[4] - margin });
  this->Bounds.Add({ bounds[1] + margin, bounds[3] + margin, bounds[5] + margin });
  if (reach > 0.0)
  {
    this->Reach = 1 + static_cast<std::int64_t>(std::min(std::ceil(reach / lattice.Step), LargestReach));
    this->CellSize = ReachesInCell * this->Reach;
    this->AddPlaces(surface);
  }
  this->Entries.reserve(surface.Triangles.size());
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    Key keys[3];
    bool isHeld = surface.Slack.empty() || surface.Slack[t] == 0.0;
    for (int i = 0; i < 3; ++i)
    {
      isHeld = isHeld && this->GetKey(surface.Points[surface.Triangles[t][i]], keys[i]);
    }
    if (isHeld)
    {
      this->Entries.push_back(
        { keys[0] + keys[1] + keys[2], GetTurn(keys[0], keys[1], keys[2]), static_cast<std::uint32_t>(t) });
    }
  }
  std::sort(this->Entries.begin(), this->Entries.end(), IsBefore);
}

void vtkMTLatticeKeys::AddPlaces(const vtkMTSampledSurface& surface)
{
  for (const vtkMTRealPoint& x : surface.GetUsedPoints())
  {
    if (this->IsWithin(x))
    {
      const vtkMTPoint point = this->Lattice.Snap(x.data());
      vtkMTPoint cell;
      std::transform(
        point.begin(), point.end(), cell.begin(), [this](std::int32_t c) { return DivideDown(c, this->CellSize); });
      this->Places.push_back({ Hash(cell), point });
    }
  }
  const auto get = [](const Place& place) { return std::tie(place.Cell, place.Point); };
  std::sort(this->Places.begin(), this->Places.end(), [&](const Place& a, const Place& b) { return get(a) < get(b); });
  this->Places.erase(std::unique(this->Places.begin(), this->Places.end(),
                       [&](const Place& a, const Place& b) { return get(a) == get(b); }),
    this->Places.end());
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

bool vtkMTLatticeKeys::GetKey(const vtkMTRealPoint& x, Key& key) const
{
  if (!this->IsWithin(x))
  {
    return false;
  }
  key = Hash(this->Lattice.Snap(x.data()));
  return true;
}

std::vector<Key> vtkMTLatticeKeys::FindCorners(const vtkMTRealPoint& x) const
{
  std::vector<Key> found;
  Key own = 0;
  if (!this->GetKey(x, own))
  {
    return found;
  }
  if (this->Reach == 0)
  {
    return { own };
  }
  const vtkMTPoint middle = this->Lattice.Snap(x.data());
  vtkMTPoint low, high;
  for (int axis = 0; axis < 3; ++axis)
  {
    low[axis] = DivideDown(middle[axis] - this->Reach, this->CellSize);
    high[axis] = DivideDown(middle[axis] + this->Reach, this->CellSize);
  }
  const auto isNear = [&](const vtkMTPoint& point)
  {
    return std::equal(point.begin(), point.end(), middle.begin(),
      [this](std::int64_t a, std::int64_t b) { return std::abs(a - b) <= this->Reach; });
  };
  vtkMTPoint cell;
  for (cell[0] = low[0]; cell[0] <= high[0]; ++cell[0])
  {
    for (cell[1] = low[1]; cell[1] <= high[1]; ++cell[1])
    {
      for (cell[2] = low[2]; cell[2] <= high[2]; ++cell[2])
      {
        const Key key = Hash(cell);
        auto place = std::lower_bound(
          this->Places.begin(), this->Places.end(), key, [](const Place& a, Key b) { return a.Cell < b; });
        for (; place != this->Places.end() && place->Cell == key; ++place)
        {
          if (isNear(place->Point))
          {
            found.push_back(Hash(place->Point));
          }
        }
      }
    }
  }
  return found;
}

std::array<vtkMTLatticeKeys::Copies, 2> vtkMTLatticeKeys::FindTriangles(Key a, Key b, Key c) const
{
  std::array<Copies, 2> found;
  const std::uint32_t turn = GetTurn(a, b, c);
  const auto isBefore = [](const Entry& x, const Entry& y)
  { return std::tie(x.Corners, x.Turn) < std::tie(y.Corners, y.Turn); };
  for (std::uint32_t isTurned = 0; isTurned < 2; ++isTurned)
  {
    const Entry wanted{ a + b + c, turn ^ isTurned, 0 };
    const auto range = std::equal_range(this->Entries.begin(), this->Entries.end(), wanted, isBefore);
    found[isTurned] = { this->Entries.data() + (range.first - this->Entries.begin()),
      this->Entries.data() + (range.second - this->Entries.begin()) };
  }
  return found;
}

std::size_t vtkMTLatticeKeys::CountTriangles(
  const vtkMTRealPoint& a, const vtkMTRealPoint& b, const vtkMTRealPoint& c) const
{
  const std::vector<Key> second = this->FindCorners(b);
  const std::vector<Key> third = this->FindCorners(c);
  std::size_t count = 0;
  for (Key x : this->FindCorners(a))
  {
    for (Key y : second)
    {
      for (Key z : third)
      {
        count += this->FindTriangles(x, y, z)[0].GetCount();
      }
    }
  }
  return count;
}
