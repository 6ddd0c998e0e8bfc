// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTPlacedGraph
 * @brief the DAG of a vtkMultiTriangulation, with boxes and errors in the object's coordinates
 */
#ifndef vtkMTPlacedGraph_h
#define vtkMTPlacedGraph_h

#include "vtkMTPlacement.h"

#include <cstdint>

class vtkMTGraph;
class vtkMultiTriangulation;
struct vtkMTView;

struct vtkMTPlacedGraph
{
  const vtkMTGraph* Graph = nullptr;
  vtkMTPlacement Placement;
  double Stretch = 1.0;

  vtkMTPlacedGraph() = default;
  /// The object must have patches, and outlive this.
  explicit vtkMTPlacedGraph(vtkMultiTriangulation& model);

  /// Of an arc's patch: no point of it is farther from the input.
  double GetError(std::uint32_t arc) const;
  /// The same by what is known of the patch alone; never more.
  double GetDistanceToInput(std::uint32_t arc) const;
  /// The box of an arc's patch.
  void GetBox(std::uint32_t arc, double box[6]) const;
  /// The box, grown by the error: what the patch stands for is inside.
  void GetReach(std::uint32_t arc, double box[6]) const;
  /// False only when nothing of what the patch stands for can be seen.
  bool CanBeSeen(const vtkMTView& view, std::uint32_t arc) const;
};

#endif
