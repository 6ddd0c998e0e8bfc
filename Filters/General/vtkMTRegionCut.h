// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTRegionCut
 * @brief the coarsest cut in which no arc wants to be refined, where what an arc wants is anybody's choice
 *
 * Refinements that are wanted wait in a heap, the largest want first, ties by node index; each takes along the coarser
 * nodes that it depends on (Cignoni et al., "Batched Multi Triangulation", 2005, section 3.1), so the cut stays closed
 * and its patches conform. With a limit of triangles, a refinement that does not fit is put aside and tried again when
 * the cut has changed. This is vtkMTTargetCut without views, budgets of bytes and residency, and with a want per arc.
 */
#ifndef vtkMTRegionCut_h
#define vtkMTRegionCut_h

#include "vtkMTCut.h"
#include "vtkMTFiltersModule.h" // For export macro

#include <cstdint>
#include <functional>
#include <queue>
#include <vector>

class vtkMTGraph;

class VTKMTFILTERS_EXPORT vtkMTRegionCut
{
public:
  /// What refining the node that an arc enters would remedy; negative: the arc is fine as it is.
  using Want = std::function<double(std::uint32_t arc)>;

  /// triangleLimit 0 is no limit; the coarsest cut is given even where it has more.
  static vtkMTCut Find(const vtkMTGraph& graph, const Want& want, std::uint64_t triangleLimit = 0);

private:
  struct Candidate
  {
    double Want;
    std::uint32_t Node;
    bool operator<(const Candidate& other) const
    {
      return this->Want != other.Want ? this->Want < other.Want : this->Node > other.Node;
    }
  };

  vtkMTRegionCut(const vtkMTGraph& graph, const Want& want, std::uint64_t triangleLimit);
  void Run();
  void Enter(std::uint32_t node);
  void FindClosure(std::uint32_t node);
  bool Fits() const;

  const vtkMTGraph& Graph;
  const Want& GetWant;
  std::uint64_t TriangleLimit;
  vtkMTCut Cut;
  std::priority_queue<Candidate> Heap;
  std::vector<Candidate> Postponed;
  std::vector<std::uint32_t> Closure; // ascending, which is an order in which they can be refined
  std::vector<unsigned char> Marks;   // nodes of the closure
};

#endif
