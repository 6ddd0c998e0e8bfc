// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTHalfedgePairs.h"

#include "vtkMTRadixSort.h"

#include <algorithm>
#include <cstring>
#include <memory>
#include <utility>

namespace
{
constexpr std::uint32_t None = vtkMTHalfedgePairs::None;
constexpr std::uint32_t Odd = vtkMTHalfedgePairs::Odd;
constexpr std::uint32_t Other = vtkMTHalfedgePairs::Other;

// Half-edge h is one more at the edge of half-edge first.
void Meet(std::uint32_t first, std::uint32_t h, std::uint32_t* partners)
{
  const std::uint32_t partner = partners[first];
  if (partner == None)
  {
    partners[first] = h;
    partners[h] = first;
    return;
  }
  partners[h] = Other;
  if (partner < Other)
  {
    partners[partner] = Other;
  }
  partners[first] = partner == Odd ? Other : Odd;
}

// Whether two half-edges of one edge run in opposite directions and have different third points.
bool AreOpposite(const std::uint32_t* corners, std::uint32_t g, std::uint32_t h)
{
  // Of triangles with two points in common: their third ones differ as the sums of all three do.
  const std::uint32_t* s = corners + g / 3 * 3;
  const std::uint32_t* t = corners + h / 3 * 3;
  return corners[g] != corners[h] && s[0] + s[1] + s[2] != t[0] + t[1] + t[2];
}

// The first half-edge of every edge, chained by its lower point. OnlyOpposites: others are no partners.
template <bool OnlyOpposites>
class Chains
{
public:
  Chains(const std::vector<std::uint32_t>& corners, std::size_t points, std::uint32_t* partners)
    : Corners(corners.data())
    , First(points, None)
    , Links(new Link[corners.size()])
    , Partners(partners)
  {
  }

  // Gives how many others were looked at.
  std::size_t Take(std::uint32_t h, std::uint32_t from, std::uint32_t to)
  {
    const std::uint32_t low = std::min(from, to);
    const std::uint32_t high = std::max(from, to);
    std::size_t steps = 0;
    for (std::uint32_t g = this->First[low]; g != None; g = this->Links[g].Next)
    {
      if (this->Links[g].High == high)
      {
        this->Join(g, h);
        return steps;
      }
      ++steps;
    }
    this->Links[h] = { high, this->First[low] };
    this->First[low] = h;
    this->Partners[h] = None;
    return steps;
  }

  // Whether there are half-edges with others that are no partners.
  bool HasOthers() const { return this->Others; }

private:
  void Join(std::uint32_t first, std::uint32_t h)
  {
    const bool isSecond = this->Partners[first] == None;
    this->Others = this->Others || !isSecond;
    if (OnlyOpposites && isSecond && !AreOpposite(this->Corners, first, h))
    {
      this->Partners[first] = this->Partners[h] = Other;
      this->Others = true;
      return;
    }
    Meet(first, h, this->Partners);
  }

  struct Link
  {
    std::uint32_t High;
    std::uint32_t Next;
  };
  const std::uint32_t* Corners;
  std::vector<std::uint32_t> First; // by point
  std::unique_ptr<Link[]> Links;    // of first half-edges; not cleared
  std::uint32_t* Partners;
  bool Others = false;
};

enum class Found
{
  All,        // and every half-edge has a partner, or is alone
  WithOthers, // there are half-edges with others that are no partners
  NotAll      // chains are long: walks along them take more steps than sorting
};

template <bool OnlyOpposites>
Found FindByChains(const std::vector<std::uint32_t>& corners, std::size_t points, std::uint32_t* partners)
{
  constexpr std::size_t manySteps = 16;
  const auto count = static_cast<std::uint32_t>(corners.size());
  Chains<OnlyOpposites> chains(corners, points, partners);
  std::size_t steps = 0;
  for (std::uint32_t h = 0; h + 2 < count; h += 3)
  {
    const std::uint32_t a = corners[h];
    const std::uint32_t b = corners[h + 1];
    const std::uint32_t c = corners[h + 2];
    steps += chains.Take(h, a, b);
    steps += chains.Take(h + 1, b, c);
    steps += chains.Take(h + 2, c, a);
    if (steps > manySteps * count)
    {
      return Found::NotAll;
    }
  }
  return chains.HasOthers() ? Found::WithOthers : Found::All;
}

void FindBySorting(const std::vector<std::uint32_t>& corners, std::uint32_t* partners)
{
  using Use = std::pair<std::uint64_t, std::uint32_t>; // an edge by its points, and the half-edge
  std::vector<Use> uses;
  std::vector<Use> scratch;
  uses.reserve(corners.size());
  for (std::uint32_t h = 0; h < corners.size(); ++h)
  {
    const auto [low, high] = std::minmax(corners[h], corners[vtkMTHalfedgePairs::Next(h)]);
    uses.emplace_back((std::uint64_t(low) << 32) | high, h);
  }
  vtkMTRadixSort::Sort(uses, scratch, [](const Use& use) { return use.first; });
  for (std::size_t i = 0, first = 0; i < uses.size(); ++i)
  {
    const bool isFirst = i == 0 || uses[i].first != uses[first].first;
    first = isFirst ? i : first;
    if (isFirst)
    {
      partners[uses[i].second] = None;
    }
    else
    {
      Meet(uses[first].second, uses[i].second, partners);
    }
  }
}

std::vector<std::uint32_t> FindPartners(const std::vector<std::uint32_t>& corners, std::size_t points)
{
  std::vector<std::uint32_t> partners(corners.size());
  if (FindByChains<false>(corners, points, partners.data()) == Found::NotAll)
  {
    FindBySorting(corners, partners.data());
  }
  return partners;
}
}

//------------------------------------------------------------------------------
vtkMTHalfedgePairs::vtkMTHalfedgePairs(const vtkMTPatch& mesh)
{
  this->Corners.resize(3 * mesh.Triangles.size());
  std::uint32_t* corner = this->Corners.data();
  for (const vtkMTTriangle& wedges : mesh.Triangles)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      *corner++ = mesh.WedgePoints.empty() ? wedges[c] : mesh.WedgePoints[wedges[c]];
    }
  }
  this->Partners = FindPartners(this->Corners, mesh.Points.size());
}

vtkMTHalfedgePairs::vtkMTHalfedgePairs(const std::vector<vtkMTTriangle>& triangles, std::size_t points)
  : Corners(3 * triangles.size())
{
  static_assert(sizeof(vtkMTTriangle) == 3 * sizeof(std::uint32_t), "triangles must be their corners");
  if (!triangles.empty())
  {
    std::memcpy(this->Corners.data(), triangles.data(), triangles.size() * sizeof(vtkMTTriangle));
  }
  this->Partners = FindPartners(this->Corners, points);
}

std::vector<std::uint32_t> vtkMTHalfedgePairs::Find(const std::vector<std::uint32_t>& corners)
{
  std::uint32_t largest = 0;
  for (const std::uint32_t corner : corners)
  {
    largest = std::max(largest, corner);
  }
  return vtkMTHalfedgePairs::Find(corners, largest + std::size_t(1));
}

std::vector<std::uint32_t> vtkMTHalfedgePairs::Find(const std::vector<std::uint32_t>& corners, std::size_t points)
{
  std::vector<std::uint32_t> opposites(corners.size());
  const Found found = FindByChains<true>(corners, points, opposites.data());
  if (found == Found::NotAll)
  {
    FindBySorting(corners, opposites.data());
  }
  for (std::uint32_t h = 0; h < opposites.size() && found != Found::All; ++h)
  {
    const std::uint32_t partner = opposites[h];
    if (partner >= Other)
    {
      opposites[h] = None;
    }
    else if (h < partner && !::AreOpposite(corners.data(), h, partner))
    {
      opposites[h] = opposites[partner] = None;
    }
  }
  return opposites;
}
