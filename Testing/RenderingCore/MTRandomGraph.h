// SPDX-License-Identifier: BSD-3-Clause
// Random graphs of the shape that BMT's section 4 gives: levels of nodes, each halving the one below it, an arc where
// regions of neighbouring levels overlap, saturated errors, boxes in the plane. No patches: extraction needs none.
#ifndef MTRandomGraph_h
#define MTRandomGraph_h

#include "vtkMTCut.h"
#include "vtkMTGraph.h"

#include <cstdint>
#include <set>
#include <vector>

struct MTRandomGraph
{
  // Nodes of the finest step; each step above it has about half as many.
  static vtkMTGraph Make(std::uint32_t seed, int finestNodes, bool planar = false);

  // Every closed set of refined nodes of a graph of at most 20 or so nodes.
  static std::vector<vtkMTCut> EnumerateCuts(const vtkMTGraph& graph);

  // Whether the cut is closed: what a refined node depends on is refined, and each path carries one arc of the cut.
  static bool IsClosed(const vtkMTGraph& graph, const vtkMTCut& cut);
};

#endif
