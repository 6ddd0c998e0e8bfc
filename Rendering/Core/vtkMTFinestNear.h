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
 * Places that lie around one are served by one such walk (Neighbourhood): what is within d of a place that is a from
 * the middle is within d + a of the middle.
 *
 * The graph must be whole. Use one object per thread; it keeps scratch memory between places.
 */
#ifndef vtkMTFinestNear_h
#define vtkMTFinestNear_h

#include "vtkMTRenderingCoreModule.h" // For export macro

#include <array>
#include <cmath>
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
  struct Found
  {
    double Distance = 0.0; ///< of the box of the arc's patch, in steps of the lattice
    std::uint32_t Arc = 0;
  };
  /// The next one; false when none is left whose box is nearer than so many steps (rounding apart).
  bool Next(double farthest, Found& found);

  /// Those that have been found near the place that was begun with, for places around it.
  class Neighbourhood
  {
  public:
    /// x: model units.
    Neighbourhood(vtkMTFinestNear& near, const Place& x);
    /**
     * Calls visit with each arc whose box is no farther from x (in steps) than getFarthest2 gives the square of, which
     * may become less meanwhile; with some of them that are farther, too.
     */
    template <class Farthest2, class Visit>
    void ForAll(const Place& x, Farthest2&& getFarthest2, Visit&& visit);

  private:
    vtkMTFinestNear& Near;
    std::vector<Found> List; // the nearest to the middle first
  };

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

template <class Farthest2, class Visit>
void vtkMTFinestNear::Neighbourhood::ForAll(const Place& x, Farthest2&& getFarthest2, Visit&& visit)
{
  constexpr double slack = 1.0 + 1e-9;
  const Place& middle = this->Near.Steps;
  const double aside = slack * std::hypot(x[0] - middle[0], x[1] - middle[1], x[2] - middle[2]);
  for (std::size_t i = 0;; ++i)
  {
    const double farthest = aside + slack * std::sqrt(getFarthest2());
    Found found;
    if (i == this->List.size() && this->Near.Next(farthest, found))
    {
      this->List.push_back(found);
    }
    if (i == this->List.size() || this->List[i].Distance > farthest)
    {
      return;
    }
    visit(this->List[i].Arc);
  }
}

#endif
