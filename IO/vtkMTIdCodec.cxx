// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTIdCodec.h"

#include <algorithm>

namespace
{
using vtkMTIdCodec::Identities;
using vtkMTNumberCode::FromZigzag;
using vtkMTNumberCode::ToZigzag;

std::uint32_t GetHigh(std::uint64_t id)
{
  return static_cast<std::uint32_t>(id >> 32);
}

// The high halves are few (a level and a region): each is said once, as the difference to the one before.
std::vector<std::uint32_t> AppendHighs(
  const Identities& identities, const std::vector<std::uint32_t>& borderOrder, std::vector<unsigned char>& side)
{
  std::vector<std::uint32_t> highs;
  for (const std::uint32_t point : borderOrder)
  {
    if (identities.IsShared[point])
    {
      highs.push_back(GetHigh(identities.Ids[point]));
    }
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

// A run begins at `begin`: where it ends, and by what its identities grow.
struct Run
{
  std::size_t End;
  bool IsShared;
  std::uint64_t Step = 1;

  Run(const Identities& identities, const std::vector<std::uint32_t>& order, std::size_t begin)
    : End(begin + 1)
    , IsShared(identities.IsShared[order[begin]] != 0)
  {
    const auto id = [&](std::size_t i) { return identities.Ids[order[i]]; };
    const auto isGoingOn = [&]
    {
      return (identities.IsShared[order[this->End]] != 0) == this->IsShared &&
        (!this->IsShared ||
          (id(this->End) == id(this->End - 1) + this->Step && GetHigh(id(this->End)) == GetHigh(id(begin))));
    };
    if (this->End < order.size() && this->IsShared && identities.IsShared[order[this->End]] &&
      id(this->End) == id(begin) - 1)
    {
      this->Step = ~std::uint64_t(0);
    }
    while (this->End < order.size() && isGoingOn())
    {
      ++this->End;
    }
  }
};
}

namespace vtkMTIdCodec
{
std::vector<std::uint32_t> GetBorderOrder(
  const std::vector<std::uint32_t>& border, const std::vector<std::uint32_t>& wedgePoints, std::size_t points)
{
  std::vector<unsigned char> isMet(points, 0);
  std::vector<std::uint32_t> order(points);
  std::size_t met = 0;
  for (const std::uint32_t vertex : border)
  {
    const std::uint32_t point = wedgePoints.empty() ? vertex : wedgePoints[vertex];
    order[met] = point;
    met += isMet[point] ? 0 : 1;
    isMet[point] = 1;
    if (met == points)
    {
      return order;
    }
  }
  for (std::uint32_t point = 0; met < points; ++point)
  {
    order[met] = point;
    met += isMet[point] ? 0 : 1;
  }
  return order;
}

void Append(
  const Identities& identities, const std::vector<std::uint32_t>& borderOrder, std::vector<unsigned char>& side)
{
  auto left = std::count(identities.IsShared.begin(), identities.IsShared.end(), 1);
  const std::vector<std::uint32_t> highs = AppendHighs(identities, borderOrder, side);
  std::vector<std::uint32_t> before(highs.size(), 0);
  for (std::size_t i = 0; left > 0;)
  {
    const Run run(identities, borderOrder, i);
    const std::uint64_t id = identities.Ids[borderOrder[i]];
    const auto high = static_cast<std::size_t>(
      std::lower_bound(highs.begin(), highs.end(), run.IsShared ? GetHigh(id) : 0) - highs.begin());
    vtkMTNumberCode::Append(side, run.IsShared ? 1 + 2 * high + (run.Step == 1 ? 0 : 1) : 0);
    vtkMTNumberCode::Append(side, run.End - i - 1);
    if (run.IsShared)
    {
      vtkMTNumberCode::Append(side, ToZigzag(static_cast<std::uint32_t>(id) - before[high]));
      before[high] = static_cast<std::uint32_t>(identities.Ids[borderOrder[run.End - 1]]);
      left -= static_cast<std::ptrdiff_t>(run.End - i);
    }
    i = run.End;
  }
}

bool Read(vtkMTNumberCode::Reader& side, const std::vector<std::uint32_t>& borderOrder, std::uint32_t shared,
  Identities& identities)
{
  std::vector<std::uint32_t> highs;
  if (!ReadHighs(side, shared, highs))
  {
    return false;
  }
  identities.IsShared.assign(borderOrder.size(), 0);
  identities.Ids.resize(borderOrder.size());
  std::vector<std::uint32_t> before(highs.size(), 0);
  std::size_t at = 0;
  while (shared > 0)
  {
    std::uint64_t kind = 0;
    std::uint64_t more = 0;
    std::uint64_t code = 0;
    if (!side.Get(kind) || !side.Get(more) || more >= borderOrder.size() - at)
    {
      return false;
    }
    if (kind == 0)
    {
      at += static_cast<std::size_t>(more) + 1;
      continue;
    }
    const std::uint64_t high = (kind - 1) / 2;
    if (high >= highs.size() || more >= shared || !side.Get(code) || code > 0xffffffffu)
    {
      return false;
    }
    const std::uint32_t step = kind % 2 != 0 ? 1 : ~std::uint32_t(0);
    std::uint32_t low = before[high] + FromZigzag(static_cast<std::uint32_t>(code)) - step;
    for (const std::size_t end = at + static_cast<std::size_t>(more) + 1; at < end; ++at, --shared)
    {
      low += step;
      identities.IsShared[borderOrder[at]] = 1;
      identities.Ids[borderOrder[at]] = (std::uint64_t(highs[high]) << 32) | low;
    }
    before[high] = low;
  }
  return true;
}
}
