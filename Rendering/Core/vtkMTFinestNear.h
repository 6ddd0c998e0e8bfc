// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTFinestNear
 * @brief the patches of the finest level near a place, the nearest first
 *
 * Goes down the graph from the source, best first: a node by the distance to its saturated sphere, which holds
 * everything below it; an arc that enters the sink by the distance to its patch's box. Reads no patch. What it takes
 * depends on how many spheres reach the place, not on the model's size: a node is expanded only when everything that is
 * nearer has been given.
 *
 * The graph must be whole. Use one object per thread; it keeps scratch memory between places.
 */
#ifndef vtkMTFinestNear_h
#define vtkMTFinestNear_h

#include "vtkMTRenderingCoreModule.h" // For export macro

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

class vtkMTGraph;

class VTKMTRENDERINGCORE_EXPORT vtkMTFinestNear
{
public:
  using Place = std::array<double, 3>;

  explicit vtkMTFinestNear(const vtkMTGraph& graph);

  /// x: model units.
  void Begin(const Place& x);
  /// The next arc; false when no arc is left whose box is nearer than so many steps of the lattice (rounding apart).
  bool Next(double farthest, std::uint32_t& arc);

  /// The place in steps of the lattice, from its origin.
  static Place ToSteps(const vtkMTGraph& graph, const Place& x);
  /// The square of a place's distance to a box, both in steps.
  static double GetDistance2(const std::array<std::int32_t, 6>& box, const Place& x);

  /// Nodes that were expanded since construction.
  std::uint64_t GetNumberOfNodes() const { return this->Nodes; }

private:
  struct Entry
  {
    double Bound = 0.0; // steps
    std::uint32_t Index = 0;
    bool IsArc = false;
  };
  static bool IsBehind(const Entry& a, const Entry& b) { return a.Bound > b.Bound; }

  void Push(double bound, std::uint32_t index, bool isArc);
  void Expand(std::uint32_t node);

  const vtkMTGraph& Graph;
  Place X{};
  Place Steps{};
  std::vector<Entry> Heap;
  std::vector<std::uint32_t> Seen; // per node: for which place
  std::uint32_t Turn = 0;
  std::uint64_t Nodes = 0;
};

#endif
