// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTRandomCut.h"

#include "vtkMTGraph.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
constexpr std::uint32_t WideSpan = 3; // levels
constexpr int Attempts = 16;

//------------------------------------------------------------------------------
// SplitMix64 (Steele, Lea and Flood 2014): the standard library's distributions differ between implementations.
class Random
{
public:
  Random(std::uint32_t seed, std::size_t index)
    : State((static_cast<std::uint64_t>(seed) << 32) ^ (static_cast<std::uint64_t>(index) * 0xD1342543DE82EF95ull))
  {
  }

  std::uint64_t Next()
  {
    std::uint64_t z = (this->State += 0x9E3779B97F4A7C15ull);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
    return z ^ (z >> 31);
  }

  std::uint32_t Below(std::uint32_t limit) { return static_cast<std::uint32_t>(this->Next() % limit); }
  double Uniform() { return static_cast<double>(this->Next() >> 11) * 0x1p-53; }

private:
  std::uint64_t State;
};

//------------------------------------------------------------------------------
// The arc of the cut that a random path from source to sink passes: every path passes exactly one.
const vtkMTArc& FindArc(const vtkMTGraph& graph, Random& random, const vtkMTCut& cut)
{
  std::uint32_t node = graph.GetSource();
  while (true)
  {
    const vtkMTNode& n = graph.Nodes[node];
    const std::uint32_t arc = n.FirstOut + random.Below(n.OutCount);
    node = graph.Arcs[arc].To;
    if (!cut.IsRefined(node))
    {
      return graph.Arcs[arc];
    }
  }
}

//------------------------------------------------------------------------------
void Walk(const vtkMTGraph& graph, Random& random, std::uint32_t steps, vtkMTCut& cut)
{
  const double coarsening = 0.5 * random.Uniform();
  for (std::uint32_t i = 0; i < steps; ++i)
  {
    const vtkMTArc& arc = FindArc(graph, random, cut);
    if (random.Uniform() < coarsening)
    {
      cut.Coarsen(arc.From);
    }
    else
    {
      cut.RefineWithDependencies(arc.To);
    }
  }
}

//------------------------------------------------------------------------------
// One or two, for with many leaves nothing coarse remains; a few steps more give variety.
void RefineLeaves(const vtkMTGraph& graph, Random& random, vtkMTCut& cut)
{
  const vtkMTNode& sink = graph.Nodes.back();
  const std::uint32_t leaves = 1 + random.Below(2);
  for (std::uint32_t i = 0; i < leaves; ++i)
  {
    const std::uint32_t arc = graph.Entering[sink.FirstIn + random.Below(sink.InCount)];
    cut.RefineWithDependencies(graph.Arcs[arc].From);
  }
  Walk(graph, random, random.Below(8), cut);
}

//------------------------------------------------------------------------------
// In a small model all that a leaf depends on may be everything: then single nodes are tried.
void RefineAcrossLevels(const vtkMTGraph& graph, Random& random, vtkMTCut& cut)
{
  RefineLeaves(graph, random, cut);
  for (int i = 0; i < Attempts && vtkMTRandomCut::GetLevelSpan(graph, cut) < WideSpan; ++i)
  {
    cut = vtkMTCut(graph);
    cut.RefineWithDependencies(random.Below(graph.GetSink()));
  }
}

//------------------------------------------------------------------------------
void RefineAboveThreshold(const vtkMTGraph& graph, Random& random, vtkMTCut& cut)
{
  std::vector<double> errors;
  for (const vtkMTNode& node : graph.Nodes)
  {
    errors.push_back(node.Error);
  }
  std::sort(errors.begin(), errors.end());
  // Half of the nodes are of the finest step, so the number of nodes above the threshold is drawn by its logarithm.
  const double rank = 1.0 - std::exp2(-random.Uniform() * std::log2(static_cast<double>(errors.size())));
  const double threshold = errors[static_cast<std::size_t>(rank * (errors.size() - 1))];
  for (std::uint32_t node = 0; node < graph.Nodes.size(); ++node)
  {
    if (graph.Nodes[node].Error > threshold)
    {
      cut.RefineWithDependencies(node);
    }
  }
}

}

//------------------------------------------------------------------------------
vtkMTCut vtkMTRandomCut::Make(const vtkMTGraph& graph, std::uint32_t seed, std::size_t index)
{
  vtkMTCut cut(graph);
  Random random(seed, index);
  if (graph.IsEmpty())
  {
    return cut;
  }
  if (index % 2 == 0)
  {
    RefineAcrossLevels(graph, random, cut);
  }
  else if (index % 4 == 1)
  {
    RefineAboveThreshold(graph, random, cut);
  }
  else
  {
    Walk(graph, random, 1 + random.Below(static_cast<std::uint32_t>(graph.Nodes.size())), cut);
  }
  return cut;
}

//------------------------------------------------------------------------------
std::uint32_t vtkMTRandomCut::GetLevelSpan(const vtkMTGraph& graph, const vtkMTCut& cut)
{
  std::uint32_t finest = ~std::uint32_t(0);
  std::uint32_t coarsest = 0;
  for (std::uint32_t arc : cut.GetArcs())
  {
    finest = std::min(finest, graph.GetLevelOfArc(arc));
    coarsest = std::max(coarsest, graph.GetLevelOfArc(arc));
  }
  return finest > coarsest ? 0 : coarsest - finest + 1;
}
