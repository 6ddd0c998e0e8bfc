// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTSeedPartition.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

vtkMTSeedPartition::vtkMTSeedPartition(std::vector<std::array<double, 3>> seeds)
  : Seeds(std::move(seeds))
{
  std::size_t leaves = 1;
  while (leaves * LeafSize < this->Seeds.size())
  {
    leaves *= 2;
  }
  this->Branches.resize(leaves - 1);
  this->Leaves.resize(leaves);
  std::vector<std::uint32_t> order(this->Seeds.size());
  std::iota(order.begin(), order.end(), 0u);
  this->BuildBranch(order, 0, 0, leaves);
  this->Neighbours.resize(this->Seeds.size());
  for (std::uint32_t region = 0; region < this->Neighbours.size(); ++region)
  {
    this->FindNeighbours(region);
  }
}

vtkMTSeedPartition::~vtkMTSeedPartition() = default;

std::uint32_t vtkMTSeedPartition::GetNumberOfRegions() const
{
  return static_cast<std::uint32_t>(this->Seeds.size());
}

std::array<double, 3> vtkMTSeedPartition::GetSeed(std::uint32_t region) const
{
  return this->Seeds[region];
}

std::size_t vtkMTSeedPartition::GetLeafBegin(std::size_t leaf) const
{
  return this->Seeds.size() * leaf / this->Leaves.size();
}

std::uint32_t vtkMTSeedPartition::GetWidestAxis(const std::uint32_t* begin, const std::uint32_t* end) const
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<double, 3> lo = { infinity, infinity, infinity };
  std::array<double, 3> hi = { -infinity, -infinity, -infinity };
  for (const std::uint32_t* i = begin; i != end; ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      lo[axis] = std::min(lo[axis], this->Seeds[*i][axis]);
      hi[axis] = std::max(hi[axis], this->Seeds[*i][axis]);
    }
  }
  std::uint32_t widest = 0;
  for (std::uint32_t axis = 1; axis < 3; ++axis)
  {
    widest = hi[axis] - lo[axis] > hi[widest] - lo[widest] ? axis : widest;
  }
  return widest;
}

void vtkMTSeedPartition::BuildBranch(
  std::vector<std::uint32_t>& order, std::size_t branch, std::size_t firstLeaf, std::size_t leaves)
{
  if (leaves == 1)
  {
    this->FillLeaf(order, firstLeaf);
    return;
  }
  std::uint32_t* begin = order.data() + this->GetLeafBegin(firstLeaf);
  std::uint32_t* middle = order.data() + this->GetLeafBegin(firstLeaf + leaves / 2);
  std::uint32_t* end = order.data() + this->GetLeafBegin(firstLeaf + leaves);
  const std::uint32_t axis = this->GetWidestAxis(begin, end);
  std::nth_element(begin, middle, end,
    [this, axis](std::uint32_t a, std::uint32_t b)
    {
      const double xa = this->Seeds[a][axis];
      const double xb = this->Seeds[b][axis];
      return xa != xb ? xa < xb : a < b;
    });
  this->Branches[branch] = { this->Seeds[*middle][axis], axis };
  this->BuildBranch(order, 2 * branch + 1, firstLeaf, leaves / 2);
  this->BuildBranch(order, 2 * branch + 2, firstLeaf + leaves / 2, leaves / 2);
}

void vtkMTSeedPartition::FillLeaf(std::vector<std::uint32_t>& order, std::size_t leaf)
{
  // Unused places hold infinity: their distance is never less than another's,
  // so the search needs no count.
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Leaf& target = this->Leaves[leaf];
  std::fill_n(target.X, LeafSize, infinity);
  std::fill_n(target.Y, LeafSize, infinity);
  std::fill_n(target.Z, LeafSize, infinity);
  std::fill_n(target.Region, LeafSize, std::numeric_limits<std::uint32_t>::max());
  const std::size_t begin = this->GetLeafBegin(leaf);
  const std::size_t end = this->GetLeafBegin(leaf + 1);
  std::sort(order.begin() + begin, order.begin() + end);
  for (std::size_t i = begin; i < end; ++i)
  {
    const std::array<double, 3>& seed = this->Seeds[order[i]];
    target.X[i - begin] = seed[0];
    target.Y[i - begin] = seed[1];
    target.Z[i - begin] = seed[2];
    target.Region[i - begin] = order[i];
  }
}

void vtkMTSeedPartition::SearchLeaf(const Leaf& leaf, const std::array<double, 3>& x, Best& best)
{
  // No branches up to the first test, so that the compiler makes vector
  // instructions of it; most leaves end there.
  double distance[LeafSize];
  for (std::size_t i = 0; i < LeafSize; ++i)
  {
    const double dx = leaf.X[i] - x[0];
    const double dy = leaf.Y[i] - x[1];
    const double dz = leaf.Z[i] - x[2];
    distance[i] = dx * dx + dy * dy + dz * dz;
  }
  double half[LeafSize / 2];
  for (std::size_t i = 0; i < LeafSize / 2; ++i)
  {
    half[i] = std::min(distance[i], distance[i + LeafSize / 2]);
  }
  const double least = std::min(std::min(half[0], half[1]), std::min(half[2], half[3]));
  if (!(least <= best.Distance))
  {
    return;
  }
  for (std::size_t i = 0; i < LeafSize; ++i)
  {
    if (distance[i] == least && (least < best.Distance || leaf.Region[i] < best.Region))
    {
      best = { least, leaf.Region[i] };
    }
  }
}

std::uint32_t vtkMTSeedPartition::Locate(const std::array<double, 3>& x) const
{
  return this->Search(x, { std::numeric_limits<double>::infinity(), 0 }, SearchLeaf).Region;
}

void vtkMTSeedPartition::LocateAll(const std::array<double, 3>* points, std::size_t count, std::uint32_t* regions) const
{
  // The search begins with the region of the point before: where that is the
  // right one, it ends at once or nearly so. What is found does not depend on
  // where the search began.
  Best best{ 0.0, 0 };
  for (std::size_t i = 0; i < count; ++i)
  {
    best.Distance = this->GetDistance2(points[i], best.Region);
    if (!(best.Distance < this->Neighbours[best.Region][0].Reach2))
    {
      best.Region =
        best.Distance < std::numeric_limits<double>::infinity() ? this->Walk(points[i], best) : this->Locate(points[i]);
    }
    regions[i] = best.Region;
  }
}

double vtkMTSeedPartition::GetDistance2(const std::array<double, 3>& x, std::uint32_t region) const
{
  const std::array<double, 3>& seed = this->Seeds[region];
  const double dx = seed[0] - x[0];
  const double dy = seed[1] - x[1];
  const double dz = seed[2] - x[2];
  return dx * dx + dy * dy + dz * dz;
}

// From seed to nearer neighbour, as long as there is one: what lies beyond the
// last one's reach is farther away than it.
std::uint32_t vtkMTSeedPartition::Walk(const std::array<double, 3>& x, Best best) const
{
  const Neighbour* next = this->Neighbours[best.Region].data();
  while (!(best.Distance < next->Reach2))
  {
    if (next->Region == NoRegion)
    {
      return this->Search(x, best, SearchLeaf).Region;
    }
    const double distance = this->GetDistance2(x, next->Region);
    if (distance < best.Distance || (distance == best.Distance && next->Region < best.Region))
    {
      best = { distance, next->Region };
      next = this->Neighbours[best.Region].data();
      continue;
    }
    ++next;
  }
  return best.Region;
}

void vtkMTSeedPartition::FindNeighbours(std::uint32_t region)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<Best, NeighbourCount> nearest; // in order of distance
  nearest.fill({ infinity, NoRegion });
  const auto look = [region, &nearest](const Leaf& leaf, const std::array<double, 3>& x, Best& best)
  {
    for (std::size_t i = 0; i < LeafSize; ++i)
    {
      const double dx = leaf.X[i] - x[0];
      const double dy = leaf.Y[i] - x[1];
      const double dz = leaf.Z[i] - x[2];
      const Best other{ dx * dx + dy * dy + dz * dz, leaf.Region[i] };
      if (other.Region != region && other.Distance < nearest.back().Distance)
      {
        const auto place = std::upper_bound(
          nearest.begin(), nearest.end(), other, [](const Best& a, const Best& b) { return a.Distance < b.Distance; });
        std::move_backward(place, nearest.end() - 1, nearest.end());
        *place = other;
      }
    }
    best.Distance = nearest.back().Distance;
  };
  this->Search(this->Seeds[region], { infinity, 0 }, look);
  std::array<Neighbour, NeighbourCount + 1>& neighbours = this->Neighbours[region];
  std::size_t found = 0;
  for (; found < NeighbourCount && nearest[found].Region != NoRegion; ++found)
  {
    // Half the way to the other seed, less more than all roundings together; nothing where squares underflow.
    const double distance = nearest[found].Distance;
    neighbours[found] = { distance > 1e-280 ? 0.25 * (1.0 - 1e-12) * distance : 0.0, nearest[found].Region };
  }
  // Where all are in the list there is nothing beyond it.
  neighbours[found] = { found + 1 == this->Seeds.size() ? infinity : 0.0, NoRegion };
}

template <typename Look>
vtkMTSeedPartition::Best vtkMTSeedPartition::Search(const std::array<double, 3>& x, Best best, Look&& look) const
{
  // A subtree that may hold something nearer: its squared distance and, by
  // axis, how far x is outside its cell.
  struct Pending
  {
    double Bound;
    std::array<double, 3> Outside;
    std::size_t Node;
  };
  Pending stack[32]; // more than the depth of a tree of 2^32 seeds
  int pending = 0;
  std::array<double, 3> outside = { 0.0, 0.0, 0.0 };
  std::size_t node = 0;
  for (;;)
  {
    while (node < this->Branches.size())
    {
      const Branch branch = this->Branches[node];
      const double difference = x[branch.Axis] - branch.Split;
      const bool upper = difference >= 0.0;
      std::array<double, 3> far = outside;
      far[branch.Axis] = std::abs(difference);
      const double bound = far[0] * far[0] + far[1] * far[1] + far[2] * far[2];
      if (bound <= best.Distance)
      {
        stack[pending++] = { bound, far, 2 * node + (upper ? 1 : 2) };
      }
      node = 2 * node + (upper ? 2 : 1);
    }
    look(this->Leaves[node - this->Branches.size()], x, best);
    do
    {
      if (pending == 0)
      {
        return best;
      }
      --pending;
    } while (stack[pending].Bound > best.Distance);
    outside = stack[pending].Outside;
    node = stack[pending].Node;
  }
}
