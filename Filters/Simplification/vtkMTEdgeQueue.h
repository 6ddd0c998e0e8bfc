// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTEdgeQueue
 * @brief edges waiting to be collapsed, the cheapest first
 *
 * Costs are sorted into buckets that are wider by 1/32 each (the leading bits of a floating-point number, which order
 * as the number does), so putting in and taking out take constant time. Within a bucket the edge that came last is
 * taken first: nothing but the order of calls decides. An edge that is put in again or withdrawn leaves its old entry
 * behind, which is passed over.
 */
#ifndef vtkMTEdgeQueue_h
#define vtkMTEdgeQueue_h

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

class vtkMTEdgeQueue
{
public:
  static constexpr std::uint32_t None = ~std::uint32_t(0);

  explicit vtkMTEdgeQueue(std::uint32_t edges)
    : Heads(GetBucket(std::numeric_limits<float>::infinity()) + 1, None)
    , Lowest(static_cast<std::uint32_t>(this->Heads.size()))
    , Newest(edges, None)
  {
    this->Entries.reserve(3 * static_cast<std::size_t>(edges));
  }

  /// 0 for what is below zero or no number.
  static std::uint32_t GetBucket(double cost)
  {
    const float rounded = cost > 0.0 ? static_cast<float>(cost) : 0.0f;
    std::uint32_t bits;
    std::memcpy(&bits, &rounded, sizeof(bits));
    return bits >> 18;
  }

  void Put(std::uint32_t edge, double cost)
  {
    const std::uint32_t bucket = GetBucket(cost);
    const auto entry = static_cast<std::uint32_t>(this->Entries.size());
    this->Entries.push_back({ edge, this->Heads[bucket] });
    this->Heads[bucket] = entry;
    this->Newest[edge] = entry;
    this->Lowest = std::min(this->Lowest, bucket);
  }

  void Withdraw(std::uint32_t edge) { this->Newest[edge] = None; }

  /// Takes the cheapest edge out; None when there is none.
  std::uint32_t Take()
  {
    while (this->Settle())
    {
      const std::uint32_t entry = this->Heads[this->Lowest];
      const std::uint32_t edge = this->Entries[entry].Edge;
      this->Heads[this->Lowest] = this->Entries[entry].Next;
      if (this->Newest[edge] == entry)
      {
        this->Newest[edge] = None;
        return edge;
      }
    }
    return None;
  }

  /// Whether an edge of this cost would be taken before those that wait, or with them.
  bool IsNext(double cost)
  {
    const std::uint32_t bucket = GetBucket(cost);
    while (this->Settle() && this->Lowest < bucket)
    {
      const std::uint32_t entry = this->Heads[this->Lowest];
      if (this->Newest[this->Entries[entry].Edge] == entry)
      {
        return false;
      }
      this->Heads[this->Lowest] = this->Entries[entry].Next;
    }
    return true;
  }

private:
  struct Entry
  {
    std::uint32_t Edge;
    std::uint32_t Next; // in the bucket
  };

  // Finds the lowest bucket with entries.
  bool Settle()
  {
    while (this->Lowest < this->Heads.size() && this->Heads[this->Lowest] == None)
    {
      ++this->Lowest;
    }
    return this->Lowest < this->Heads.size();
  }

  std::vector<std::uint32_t> Heads;  // [buckets] the entry that came last
  std::uint32_t Lowest;              // no bucket below has entries
  std::vector<std::uint32_t> Newest; // [edges] the entry that counts
  std::vector<Entry> Entries;
};

#endif
