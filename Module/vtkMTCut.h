// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTCut
 * @brief a cut of the DAG: a set of arcs, one on every path from source to sink, closed under dependency
 *
 * A cut is kept as the set of refined nodes: an arc is in the cut when the node that it leaves is refined and the node
 * that it enters is not. The source is always refined, the sink never. The set is closed: when a node is refined, all
 * nodes that it depends on (those which the arcs entering it leave) are refined too. The patches of the arcs in the cut
 * form one conforming mesh (BMT section 3.1). In a graph whose refinements add, every arc that leaves a refined node is
 * in the cut. Of a partly known graph only nodes of the known part are refined.
 */
#ifndef vtkMTCut_h
#define vtkMTCut_h

#include "vtkMTCoreModule.h" // For export macro

#include <cstdint>
#include <vector>

class vtkMTGraph;

class VTKMTCORE_EXPORT vtkMTCut
{
public:
  /// The coarsest cut. The graph must outlive the cut.
  explicit vtkMTCut(const vtkMTGraph& graph);

  bool IsRefined(std::uint32_t node) const { return this->Refined[node] != 0; }
  bool Contains(std::uint32_t arc) const;

  /// Whether all that the node depends on is refined and it is not, so that Refine may be called. Never for the sink or
  /// beyond what is known of the graph.
  bool CanRefine(std::uint32_t node) const;
  /// Replaces the arcs that enter the node by those that leave it (or adds these, where the graph's refinements add).
  /// False, and nothing done, unless CanRefine.
  bool Refine(std::uint32_t node);
  /// Refines the node and, before it, all unrefined nodes that it depends on. Gives the number of nodes refined, 0
  /// where the node is refined already or not refinable.
  std::size_t RefineWithDependencies(std::uint32_t node);

  /// Whether the node is refined and none that depends on it is. Never for the source.
  bool CanCoarsen(std::uint32_t node) const;
  bool Coarsen(std::uint32_t node);

  std::vector<std::uint32_t> GetArcs() const;
  std::uint64_t GetNumberOfTriangles() const { return this->Triangles; }
  std::size_t GetNumberOfArcs() const { return this->ArcCount; }
  /// The largest saturated error of an arc in the cut: no input point is farther from the cut than this.
  double GetError() const;
  ///@{
  /// By the patches' own distances (vtkMTGraph::GetDistanceToInput), which are never above GetError: no point of the
  /// cut is farther from the input, and no point of the input from the cut.
  double GetDistanceToInput() const;
  double GetDistanceFromInput() const;
  ///@}

private:
  const vtkMTGraph* Graph;
  std::vector<unsigned char> Refined; // per node
  std::uint64_t Triangles = 0;
  std::size_t ArcCount = 0;
};

#endif
