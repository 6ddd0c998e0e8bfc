// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTKdRegions
 * @brief the partition that vtkMTKdPartition makes: the leaves of a k-d tree into which points are inserted
 *
 * A leaf holds its points until there are more than its capacity. Then it is divided across the longest side of their
 * box, with a share of them below the plane, and both parts are leaves of their own. Where many points are at one place
 * the plane goes beside them; points that are all at one place stay together.
 */
#ifndef vtkMTKdRegions_h
#define vtkMTKdRegions_h

#include "vtkMTPartition.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

class vtkMTKdRegions : public vtkMTPartition
{
public:
  using Point = std::array<double, 3>;

  /// lowerShare: of a leaf's points, those below the plane that divides it, between 0 and 1.
  vtkMTKdRegions(std::size_t capacity, double lowerShare);
  ~vtkMTKdRegions() override;

  /// Of finite points, at least one.
  void Insert(const Point& x);

  /**
   * After the last point. Counts all barycentres, and halves the boxes of what regions of more than `most` of them
   * hold, until no region does but those whose barycentres are at one place; then regions have their numbers, from one
   * end of the tree to the other. False when the scan failed.
   */
  bool Finish(vtkMTBarycentreScan& scan, std::size_t most);

  std::uint32_t GetNumberOfRegions() const override { return static_cast<std::uint32_t>(this->Seeds.size()); }
  std::uint32_t Locate(const Point& x) const override;
  Point GetSeed(std::uint32_t region) const override { return this->Seeds[region]; }

private:
  static constexpr std::uint32_t Leaf = 3;

  // Of two children, which lie side by side: below the plane, and not below it. Or a leaf.
  struct Node
  {
    double Plane = 0.0;
    std::uint32_t Axis = Leaf;
    std::uint32_t Index = 0; // of the first child; of a leaf: its region, until Finish that of its points
  };

  struct Points
  {
    std::vector<Point> All;
    std::size_t Capacity = 0;
  };

  struct Box
  {
    Point Lo{ 0.0, 0.0, 0.0 };
    Point Hi{ 0.0, 0.0, 0.0 };
    std::size_t Count = 0;
    void Add(const Point& x);
    std::size_t GetLongestAxis() const;
  };

  std::uint32_t FindLeaf(const Point& x) const;
  std::uint32_t Divide(std::uint32_t leaf, std::size_t axis, double plane);
  void DividePoints(std::uint32_t leaf);
  void Number();

  std::size_t Capacity;
  double LowerShare;
  std::vector<Node> Nodes;
  std::vector<Points> Contents;
  std::vector<Point> Seeds;
};

#endif
