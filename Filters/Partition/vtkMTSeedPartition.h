// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTSeedPartition
 * @brief a V-partition: the Voronoi regions of a set of seeds
 *
 * BMT section 4.2: a point lies in the region of the nearest seed. "Nearest" is
 * exact with respect to the squared distance computed in double precision, (dx
 * dx + dy dy) + dz dz; ties go to the smaller index. Seeds are found through a
 * balanced k-d tree with leaves of at most eight seeds. A branch is left out
 * only when its bound, computed by the same sum from the same rounded
 * differences, is above the best distance; rounding is monotone, so nothing
 * nearer, and no tie, is ever lost.
 *
 * Immutable; Locate takes no memory and may be called from any number of
 * threads. A point that is not finite, or so far away that all squared
 * distances overflow, is in region 0.
 */
#ifndef vtkMTSeedPartition_h
#define vtkMTSeedPartition_h

#include "vtkMTPartition.h"
#include "vtkMTPartitionModule.h" // For export macro

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

class VTKMTPARTITION_EXPORT vtkMTSeedPartition : public vtkMTPartition
{
public:
  /// Region i is that of seeds[i]. There must be at least one seed, and seeds
  /// must be finite.
  explicit vtkMTSeedPartition(std::vector<std::array<double, 3>> seeds);
  ~vtkMTSeedPartition() override;

  std::uint32_t GetNumberOfRegions() const override;
  std::uint32_t Locate(const std::array<double, 3>& x) const override;
  void LocateAll(const std::array<double, 3>* points, std::size_t count, std::uint32_t* regions) const override;
  std::array<double, 3> GetSeed(std::uint32_t region) const override;

  const std::vector<std::array<double, 3>>& GetSeeds() const { return this->Seeds; }

private:
  static constexpr std::size_t LeafSize = 8;

  struct Branch
  {
    double Split;
    std::uint32_t Axis;
  };

  struct Leaf
  {
    double X[LeafSize];
    double Y[LeafSize];
    double Z[LeafSize];
    std::uint32_t Region[LeafSize];
  };

  struct Best
  {
    double Distance;
    std::uint32_t Region;
  };

  void BuildBranch(std::vector<std::uint32_t>& order, std::size_t branch, std::size_t firstLeaf, std::size_t leaves);
  void FillLeaf(std::vector<std::uint32_t>& order, std::size_t leaf);
  std::size_t GetLeafBegin(std::size_t leaf) const;
  std::uint32_t GetWidestAxis(const std::uint32_t* begin, const std::uint32_t* end) const;
  template <typename Look>
  Best Search(const std::array<double, 3>& x, Best best, Look&& look) const;
  void FindNeighbours(std::uint32_t region);
  double GetDistance2(const std::array<double, 3>& x, std::uint32_t region) const;
  std::uint32_t Walk(const std::array<double, 3>& x, Best best) const;
  static void SearchLeaf(const Leaf& leaf, const std::array<double, 3>& x, Best& best);

  std::vector<std::array<double, 3>> Seeds;
  // A complete binary tree without pointers: the children of branch b are 2 b +
  // 1 and 2 b + 2, and the leaves follow the branches in the same numbering.
  std::vector<Branch> Branches;
  std::vector<Leaf> Leaves;
  // Another seed: a point whose squared distance to the first one is less than
  // Reach2 is nearer to that.
  struct Neighbour
  {
    double Reach2;
    std::uint32_t Region;
  };
  static constexpr std::size_t NeighbourCount = 12;
  static constexpr std::uint32_t NoRegion = ~std::uint32_t(0);
  // By region: the nearest other seeds in order of distance, and what says that
  // there may be more.
  std::vector<std::array<Neighbour, NeighbourCount + 1>> Neighbours;
};

#endif
