// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class VTKMTVERIFICATION_EXPORT vtkMTOrientedBoxes
 * @brief boxes that are turned, for those nodes of a tree that need them
 *
 * Needles side by side, such as a few neighbours of a fan of thousands, fill a box of their own direction, while the
 * straight box of any few of them that run askew holds most of the others: a tree of straight boxes takes time in
 * proportion to the number of needles for every query. Here a node has a second box, along the principal axes of its
 * corners (Gottschalk, Lin and Manocha, "OBBTree", 1996, section 4), where this has less than an eighth of the surface
 * of the straight one: hardly any node of a surface without needles.
 *
 * The axes follow from the moments of the corners, which a node has from its children. Points with the variance v along
 * an axis extend over 2 sqrt(v) of it at least; where such a box is too large already, no corner is looked at again.
 */
#ifndef vtkMTOrientedBoxes_h
#define vtkMTOrientedBoxes_h

#include "vtkMTMeasuringFrame.h"
#include "vtkMTVerificationModule.h" // For export macro

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

class VTKMTVERIFICATION_EXPORT vtkMTOrientedBoxes
{
public:
  /// Calls add for every corner of what is in a node.
  using Corners = std::function<void(std::size_t node, const std::function<void(const vtkMTRealPoint&)>& add)>;

  /// For the nodes of a complete binary tree with these straight boxes, in which node i has the children 2i + 1 and
  /// 2i + 2; corners is called from several threads.
  void Fit(const std::vector<vtkMTRealBounds>& straight, const Corners& corners);

  /// A lower bound of the distance to what is in a node, squared; 0 where the node has no turned box.
  double GetDistance2(std::size_t node, const vtkMTRealPoint& x) const
  {
    return this->Numbers.empty() || this->Numbers[node] == None ? 0.0 : this->Measure(this->Numbers[node], x);
  }
  std::size_t GetNumberOfBoxes() const { return this->Boxes.size(); }

private:
  static constexpr std::uint32_t None = ~std::uint32_t(0);

  struct Box
  {
    std::array<vtkMTRealPoint, 3> Axes;
    vtkMTRealBounds Bounds; // along the axes
  };

  class Moments;

  static bool Make(
    std::size_t node, const vtkMTRealBounds& straight, const Moments& moments, const Corners& corners, Box& box);
  double Measure(std::uint32_t number, const vtkMTRealPoint& x) const;

  std::vector<std::uint32_t> Numbers; // [nodes] of their boxes
  std::vector<Box> Boxes;
};

#endif
