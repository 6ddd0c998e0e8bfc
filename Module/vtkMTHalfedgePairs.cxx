// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTHalfedgePairs.h"

#include <algorithm>
#include <memory>

namespace
{
constexpr std::uint32_t None = vtkMTHalfedgePairs::None;

// An edge in the list of those of its lower point.
struct Edge
{
  std::uint32_t High;     // its other point
  std::uint32_t Halfedge; // the first one that runs along it
  std::uint32_t Count;    // of these
  std::uint32_t Next;     // in the list
};

// In lists that are longer, as at hubs, no edge is looked for.
constexpr int MostEdges = 32;

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

// Pairs half-edges as they come. False where some list has become too long.
class Lists
{
public:
  Lists(const std::vector<std::uint32_t>& corners, std::size_t points, std::uint32_t* opposites)
    : Corners(corners)
    , Opposites(opposites)
    , Heads(points, None)
    , Edges(new Edge[corners.size()])
  {
  }

  bool PairAll()
  {
    bool isDone = true;
    for (std::uint32_t h = 0; isDone && h + 2 < this->Corners.size(); h += 3)
    {
      const std::uint32_t a = this->Corners[h];
      const std::uint32_t b = this->Corners[h + 1];
      const std::uint32_t c = this->Corners[h + 2];
      isDone = this->Put(h, std::min(a, b), std::max(a, b)) && this->Put(h + 1, std::min(b, c), std::max(b, c)) &&
        this->Put(h + 2, std::min(c, a), std::max(c, a));
    }
    return isDone;
  }

private:
  bool Put(std::uint32_t h, std::uint32_t low, std::uint32_t high)
  {
    int looks = 0;
    for (std::uint32_t e = this->Heads[low]; e != None; e = this->Edges[e].Next)
    {
      if (this->Edges[e].High == high)
      {
        this->Join(this->Edges[e], h);
        return true;
      }
      if (++looks > MostEdges)
      {
        return false;
      }
    }
    this->Edges[this->Used] = { high, h, 1, this->Heads[low] };
    this->Heads[low] = this->Used++;
    return true;
  }

  void Join(Edge& edge, std::uint32_t h)
  {
    if (++edge.Count == 2)
    {
      Pair(this->Corners, edge.Halfedge, h, this->Opposites);
    }
    else if (this->Opposites[edge.Halfedge] != None)
    {
      this->Opposites[this->Opposites[edge.Halfedge]] = None;
      this->Opposites[edge.Halfedge] = None;
    }
  }

  const std::vector<std::uint32_t>& Corners;
  std::uint32_t* Opposites;
  std::vector<std::uint32_t> Heads; // [points] the edge that came last
  std::unique_ptr<Edge[]> Edges;
  std::uint32_t Used = 0;
};

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

// The same for any mesh.
void PairInBuckets(const std::vector<std::uint32_t>& corners, std::size_t points, std::uint32_t* opposites)
{
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
    last - first > Few ? PairMany(corners, first, last, opposites) : PairFew(corners, first, last, opposites);
    begin = next[p];
  }
}
}

//------------------------------------------------------------------------------
std::vector<std::uint32_t> vtkMTHalfedgePairs::Find(const std::vector<std::uint32_t>& corners)
{
  std::vector<std::uint32_t> opposites(corners.size(), None);
  std::uint32_t highest = 0;
  for (const std::uint32_t point : corners)
  {
    highest = std::max(highest, point);
  }
  const std::size_t points = corners.empty() ? 0 : highest + std::size_t(1);
  if (!Lists(corners, points, opposites.data()).PairAll())
  {
    std::fill(opposites.begin(), opposites.end(), None);
    PairInBuckets(corners, points, opposites.data());
  }
  return opposites;
}
