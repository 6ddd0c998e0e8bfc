// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTHalfedgePairs.h"

#include <algorithm>
#include <memory>

namespace
{
// A half-edge in the bucket of its lower point.
struct Entry
{
  std::uint32_t High; // its other point
  std::uint32_t Halfedge;
};

// In buckets that are larger, as at hubs, entries are sorted.
constexpr std::ptrdiff_t Few = 24;

// Runs over the half-edges with their lower and higher point.
template <typename Use>
void ForAll(const std::vector<std::uint32_t>& corners, const Use& use)
{
  for (std::uint32_t h = 0; h + 2 < corners.size(); h += 3)
  {
    const std::uint32_t a = corners[h];
    const std::uint32_t b = corners[h + 1];
    const std::uint32_t c = corners[h + 2];
    use(h, std::min(a, b), std::max(a, b));
    use(h + 1, std::min(b, c), std::max(b, c));
    use(h + 2, std::min(c, a), std::max(c, a));
  }
}

// Two half-edges, the only ones between their points.
void Pair(const std::vector<std::uint32_t>& corners, std::uint32_t g, std::uint32_t h, std::uint32_t* opposites)
{
  const bool isOpposite = corners[g] != corners[h];
  if (isOpposite && corners[vtkMTHalfedgePairs::Previous(g)] != corners[vtkMTHalfedgePairs::Previous(h)])
  {
    opposites[g] = h;
    opposites[h] = g;
  }
}

// What a bucket of few holds: each entry is compared with all behind it, and taken out with those that are like it.
void PairFew(const std::vector<std::uint32_t>& corners, Entry* begin, Entry* end, std::uint32_t* opposites)
{
  while (end - begin > 1)
  {
    const Entry first = *begin++;
    std::uint32_t partner = vtkMTHalfedgePairs::None;
    std::size_t others = 0;
    for (Entry* entry = begin; entry < end;)
    {
      if (entry->High != first.High)
      {
        ++entry;
        continue;
      }
      partner = entry->Halfedge;
      ++others;
      *entry = *--end;
    }
    if (others == 1)
    {
      Pair(corners, first.Halfedge, partner, opposites);
    }
  }
}

void PairMany(const std::vector<std::uint32_t>& corners, Entry* begin, Entry* end, std::uint32_t* opposites)
{
  std::sort(begin, end, [](const Entry& a, const Entry& b) { return a.High < b.High; });
  while (begin < end)
  {
    const Entry* last = std::find_if(begin, end, [&](const Entry& entry) { return entry.High != begin->High; });
    if (last - begin == 2)
    {
      Pair(corners, begin[0].Halfedge, begin[1].Halfedge, opposites);
    }
    begin += last - begin;
  }
}

// From buckets by the lower of the two points: in linear time but for hubs, whose buckets are sorted.
void FindByBuckets(const std::vector<std::uint32_t>& corners, std::size_t points, std::vector<std::uint32_t>& opposites)
{
  opposites.assign(corners.size(), vtkMTHalfedgePairs::None);
  std::vector<std::uint32_t> next(points + 1, 0);
  ForAll(corners, [&](std::uint32_t, std::uint32_t low, std::uint32_t) { ++next[low + 1]; });
  for (std::size_t p = 1; p < next.size(); ++p)
  {
    next[p] += next[p - 1];
  }
  std::vector<Entry> entries(corners.size());
  ForAll(corners, [&](std::uint32_t h, std::uint32_t low, std::uint32_t high) { entries[next[low]++] = { high, h }; });
  std::uint32_t begin = 0; // of each bucket, whose end is where the next entry would have gone
  for (std::size_t p = 0; p + 1 < next.size(); ++p)
  {
    Entry* const first = entries.data() + begin;
    Entry* const last = entries.data() + next[p];
    last - first > Few ? PairMany(corners, first, last, opposites.data())
                       : PairFew(corners, first, last, opposites.data());
    begin = next[p];
  }
}

// An edge in the list of those of its lower point.
struct Edge
{
  std::uint32_t High;
  std::uint32_t Following;
  std::uint32_t First; // its half-edges; Second is Many where there are more than two
  std::uint32_t Second;
  std::uint32_t From;  // where the first one starts
  std::uint32_t Third; // the other point of the first one's triangle
};
constexpr std::uint32_t Many = vtkMTHalfedgePairs::None - 1;

// Edges of a list to look at per half-edge, all together.
constexpr std::size_t MostLooks = 16;

// Lists by the lower of the two points, which are short but at hubs.
class Lists
{
public:
  Lists(std::size_t corners, std::size_t points, std::uint32_t* opposites)
    : First(points, None)
    , Edges(new Edge[corners])
    , Looks(MostLooks * corners)
    , Opposites(opposites)
  {
  }

  void Put(std::uint32_t h, std::uint32_t from, std::uint32_t to, std::uint32_t third)
  {
    const std::uint32_t high = std::max(from, to);
    std::uint32_t& first = this->First[std::min(from, to)];
    std::uint32_t e = first;
    while (e != None && this->Edges[e].High != high && this->Looks > 0)
    {
      e = this->Edges[e].Following;
      --this->Looks;
    }
    if (e == None)
    {
      this->Edges[this->Count] = { high, first, h, None, from, third };
      first = this->Count++;
      return;
    }
    Edge& edge = this->Edges[e];
    if (edge.Second == None)
    {
      edge.Second = h;
      if (edge.From != from && edge.Third != third)
      {
        this->Opposites[edge.First] = h;
        this->Opposites[h] = edge.First;
      }
    }
    else if (edge.Second != Many)
    {
      this->Opposites[edge.First] = this->Opposites[edge.Second] = None;
      edge.Second = Many;
    }
  }
  bool AreTooLong() const { return this->Looks == 0; }

private:
  static constexpr std::uint32_t None = vtkMTHalfedgePairs::None;
  std::vector<std::uint32_t> First; // [points]
  std::unique_ptr<Edge[]> Edges;
  std::uint32_t Count = 0;
  std::size_t Looks;
  std::uint32_t* Opposites;
};
}

//------------------------------------------------------------------------------
std::vector<std::uint32_t> vtkMTHalfedgePairs::Find(const std::vector<std::uint32_t>& corners)
{
  const std::size_t points = corners.empty() ? 0 : *std::max_element(corners.begin(), corners.end()) + std::size_t(1);
  return Find(corners, points);
}

//------------------------------------------------------------------------------
std::vector<std::uint32_t> vtkMTHalfedgePairs::Find(const std::vector<std::uint32_t>& corners, std::size_t points)
{
  std::vector<std::uint32_t> opposites(corners.size(), None);
  Lists lists(corners.size(), points, opposites.data());
  for (std::uint32_t h = 0; h + 2 < corners.size(); h += 3)
  {
    const std::uint32_t a = corners[h];
    const std::uint32_t b = corners[h + 1];
    const std::uint32_t c = corners[h + 2];
    lists.Put(h, a, b, c);
    lists.Put(h + 1, b, c, a);
    lists.Put(h + 2, c, a, b);
  }
  if (lists.AreTooLong())
  {
    FindByBuckets(corners, points, opposites);
  }
  return opposites;
}
