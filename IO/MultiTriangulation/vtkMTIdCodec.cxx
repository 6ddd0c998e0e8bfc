// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTIdCodec.h"

#include <algorithm>

namespace
{
using vtkMTIdCodec::Identity;
using vtkMTNumberCode::FromZigzag;
using vtkMTNumberCode::ToZigzag;

std::uint32_t GetHigh(std::uint64_t id)
{
  return static_cast<std::uint32_t>(id >> 32);
}

// The high halves are few (a level and a region): each is encoded once, as the difference to the one before.
std::vector<std::uint32_t> AppendHighs(const std::vector<Identity>& identities, std::vector<unsigned char>& side)
{
  std::vector<std::uint32_t> highs;
  highs.reserve(identities.size());
  for (const Identity& identity : identities)
  {
    highs.push_back(GetHigh(identity.Id));
  }
  std::sort(highs.begin(), highs.end());
  highs.erase(std::unique(highs.begin(), highs.end()), highs.end());
  vtkMTNumberCode::Append(side, highs.size());
  std::uint32_t before = 0;
  for (const std::uint32_t high : highs)
  {
    vtkMTNumberCode::Append(side, high - before);
    before = high;
  }
  return highs;
}

bool ReadHighs(vtkMTNumberCode::Reader& side, std::uint32_t shared, std::vector<std::uint32_t>& highs)
{
  std::uint64_t count = 0;
  if (!side.Get(count) || count > shared)
  {
    return false;
  }
  highs.resize(static_cast<std::size_t>(count));
  std::uint32_t before = 0;
  for (std::uint32_t& high : highs)
  {
    std::uint64_t difference = 0;
    if (!side.Get(difference) || difference > 0xffffffffu)
    {
      return false;
    }
    high = before += static_cast<std::uint32_t>(difference);
  }
  return true;
}

// Where the run of identities ends that begins at `begin`, and by what they grow. isNext(i): whether the point of
// identity i follows that of the one before in border order.
template <class IsNext>
std::size_t FindEnd(
  const std::vector<Identity>& identities, std::size_t begin, const IsNext& isNext, std::uint64_t& step)
{
  const auto id = [&](std::size_t i) { return identities[i].Id; };
  std::size_t end = begin + 1;
  step = 1;
  if (end < identities.size() && isNext(end) && id(end) == id(begin) - 1)
  {
    step = ~std::uint64_t(0);
  }
  while (
    end < identities.size() && isNext(end) && id(end) == id(end - 1) + step && GetHigh(id(end)) == GetHigh(id(begin)))
  {
    ++end;
  }
  return end;
}
}

namespace vtkMTIdCodec
{
void GetBorderOrder(const std::vector<std::uint32_t>& border, const std::vector<std::uint32_t>& wedgePoints,
  std::size_t points, std::vector<unsigned char>& isMet, std::vector<std::uint32_t>& order)
{
  isMet.assign(points, 0);
  order.clear();
  for (const std::uint32_t vertex : border)
  {
    const std::uint32_t point = wedgePoints.empty() ? vertex : wedgePoints[vertex];
    if (!isMet[point])
    {
      isMet[point] = 1;
      order.push_back(point);
    }
  }
}

void AppendOthers(std::vector<std::uint32_t>& borderOrder, std::size_t points)
{
  std::vector<unsigned char> isMet(points, 0);
  for (const std::uint32_t point : borderOrder)
  {
    isMet[point] = 1;
  }
  borderOrder.reserve(points);
  for (std::uint32_t point = 0; point < points; ++point)
  {
    if (!isMet[point])
    {
      borderOrder.push_back(point);
    }
  }
}

void Append(const std::vector<Identity>& identities, const std::vector<std::uint32_t>& borderOrder,
  std::vector<unsigned char>& side)
{
  const std::vector<std::uint32_t> highs = AppendHighs(identities, side);
  std::vector<std::uint32_t> before(highs.size(), 0);
  std::vector<std::uint32_t> place(borderOrder.size());
  for (std::uint32_t i = 0; i < place.size(); ++i)
  {
    place[borderOrder[i]] = i;
  }
  const auto isNext = [&](std::size_t i) { return place[identities[i].Point] == place[identities[i - 1].Point] + 1; };
  std::uint32_t at = 0;
  for (std::size_t i = 0; i < identities.size();)
  {
    const std::uint32_t here = place[identities[i].Point];
    if (here > at)
    {
      vtkMTNumberCode::Append(side, 0);
      vtkMTNumberCode::Append(side, here - at - 1);
    }
    std::uint64_t step = 0;
    const std::size_t end = FindEnd(identities, i, isNext, step);
    const auto high =
      static_cast<std::size_t>(std::lower_bound(highs.begin(), highs.end(), GetHigh(identities[i].Id)) - highs.begin());
    vtkMTNumberCode::Append(side, 1 + 2 * high + (step == 1 ? 0 : 1));
    vtkMTNumberCode::Append(side, end - i - 1);
    vtkMTNumberCode::Append(side, ToZigzag(static_cast<std::uint32_t>(identities[i].Id) - before[high]));
    before[high] = static_cast<std::uint32_t>(identities[end - 1].Id);
    at = here + static_cast<std::uint32_t>(end - i);
    i = end;
  }
}

bool Read(vtkMTNumberCode::Reader& side, std::vector<std::uint32_t>& borderOrder, std::size_t points,
  std::uint32_t shared, std::vector<Identity>& identities)
{
  std::vector<std::uint32_t> highs;
  if (!ReadHighs(side, shared, highs))
  {
    return false;
  }
  identities.resize(shared);
  Identity* identity = identities.data();
  std::uint32_t left = shared;
  std::vector<std::uint32_t> before(highs.size(), 0);
  std::size_t at = 0;
  while (left > 0)
  {
    std::uint64_t kind = 0;
    std::uint64_t more = 0;
    std::uint64_t code = 0;
    if (!side.Get(kind) || !side.Get(more) || more >= points - at)
    {
      return false;
    }
    const std::size_t end = at + static_cast<std::size_t>(more) + 1;
    if (end > borderOrder.size())
    {
      AppendOthers(borderOrder, points);
    }
    if (kind == 0)
    {
      at = end;
      continue;
    }
    const std::uint64_t high = (kind - 1) / 2;
    if (high >= highs.size() || more >= left || !side.Get(code) || code > 0xffffffffu)
    {
      return false;
    }
    const std::uint32_t step = kind % 2 != 0 ? 1 : ~std::uint32_t(0);
    std::uint32_t low = before[high] + FromZigzag(static_cast<std::uint32_t>(code)) - step;
    const std::uint64_t highBits = std::uint64_t(highs[high]) << 32;
    left -= static_cast<std::uint32_t>(end - at);
    for (; at < end; ++at)
    {
      low += step;
      *identity++ = { borderOrder[at], highBits | low };
    }
    before[high] = low;
  }
  return true;
}
}
