// SPDX-License-Identifier: BSD-3-Clause
#include "MTRandomGraph.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

namespace
{
constexpr int Width = 1 << 16; // lattice steps, both ways

struct Seed
{
  int X;
  int Y;
};

// The region that a place belongs to: that of the nearest seed. Seeds are sorted by X.
std::size_t GetNearest(const std::vector<Seed>& seeds, double x, double y)
{
  const auto middle = static_cast<std::size_t>(
    std::lower_bound(seeds.begin(), seeds.end(), x, [](const Seed& s, double at) { return s.X < at; }) - seeds.begin());
  std::size_t nearest = seeds.size();
  double least = 1e300;
  const auto look = [&](std::size_t i)
  {
    const double dx = seeds[i].X - x;
    const double dy = seeds[i].Y - y;
    const double d = dx * dx + dy * dy;
    if (d < least || (d == least && i < nearest))
    {
      least = d;
      nearest = i;
    }
    return dx * dx <= least;
  };
  for (std::size_t i = middle; i < seeds.size() && look(i); ++i)
  {
  }
  for (std::size_t i = middle; i-- > 0 && look(i);)
  {
  }
  return nearest;
}
}

vtkMTGraph MTRandomGraph::Make(std::uint32_t seed, int finestNodes, bool planar)
{
  std::mt19937 random(seed);
  // Not std::uniform_int_distribution: that is another one in every library.
  const auto draw = [&random](std::uint32_t below) { return static_cast<int>(random() % below); };

  // Partitions Psi_0 (patches of the finest level begin there), Psi_1 ..., the last one of one region.
  std::vector<std::vector<Seed>> partitions;
  for (int regions = 2 * finestNodes; true; regions = std::max(1, regions / 2))
  {
    std::vector<Seed> seeds;
    for (int i = 0; i < regions; ++i)
    {
      seeds.push_back({ draw(Width), draw(Width) });
    }
    std::sort(
      seeds.begin(), seeds.end(), [](const Seed& a, const Seed& b) { return a.X != b.X ? a.X < b.X : a.Y < b.Y; });
    partitions.push_back(seeds);
    if (regions == 1)
    {
      break;
    }
  }

  vtkMTGraph graph;
  graph.Lattice.Step = 1.0 / Width;
  const auto steps = partitions.size(); // nodes are the regions of partitions 1 .. steps - 1, coarsest first
  std::vector<std::uint32_t> first(steps, 0);
  graph.Nodes.resize(1);
  for (std::size_t step = steps; step-- > 1;)
  {
    first[step] = static_cast<std::uint32_t>(graph.Nodes.size());
    for (std::size_t region = 0; region < partitions[step].size(); ++region)
    {
      vtkMTNode node;
      node.Level = static_cast<std::uint32_t>(step);
      node.Region = static_cast<std::uint32_t>(region);
      const double scale = std::pow(2.0, static_cast<double>(step)) * 1e-4;
      node.OwnError = draw(8) == 0 ? 0.0 : scale * (1 + draw(1000)) / 1000.0;
      node.EdgeLength = scale * 10.0 * (500 + draw(1000)) / 1000.0;
      graph.Nodes.push_back(node);
    }
  }
  graph.Nodes.emplace_back();
  const auto sink = static_cast<std::uint32_t>(graph.Nodes.size() - 1);

  // Elements of the crossings, sampled on a raster: the patches of level i belong to Psi_i x Psi_{i+1}.
  const int raster = std::max(16, static_cast<int>(4.0 * std::sqrt(2.0 * finestNodes)));
  const double cell = double(Width) / raster;
  struct Element
  {
    vtkMTBox Box{ Width, 0, Width, 0, 0, 0 };
    int Cells = 0;
  };
  for (std::size_t level = 0; level < steps; ++level)
  {
    std::map<std::pair<std::size_t, std::size_t>, Element> elements;
    for (int j = 0; j < raster; ++j)
    {
      for (int i = 0; i < raster; ++i)
      {
        const double x = (i + 0.5) * cell;
        const double y = (j + 0.5) * cell;
        const std::size_t finer = GetNearest(partitions[level], x, y);
        const std::size_t coarser = level + 1 < steps ? GetNearest(partitions[level + 1], x, y) : 0;
        Element& element = elements[{ finer, coarser }];
        element.Box[0] = std::min(element.Box[0], static_cast<int>(i * cell));
        element.Box[1] = std::max(element.Box[1], static_cast<int>((i + 1) * cell));
        element.Box[2] = std::min(element.Box[2], static_cast<int>(j * cell));
        element.Box[3] = std::max(element.Box[3], static_cast<int>((j + 1) * cell));
        ++element.Cells;
      }
    }
    for (auto& entry : elements)
    {
      vtkMTArc arc;
      // Enters the node that made it (level 0: nobody did), leaves the one whose floor it belongs to.
      arc.To = level == 0 ? sink : first[level] + static_cast<std::uint32_t>(entry.first.first);
      arc.From = level + 1 < steps ? first[level + 1] + static_cast<std::uint32_t>(entry.first.second) : 0;
      arc.Box = entry.second.Box;
      if (!planar)
      {
        arc.Box[4] = draw(200);
        arc.Box[5] = arc.Box[4] + draw(Width / 20);
      }
      const double share = std::pow(0.5, static_cast<double>(level)) * 60.0;
      arc.Triangles = std::max(1u, static_cast<std::uint32_t>(entry.second.Cells * share + draw(20)));
      arc.Points = arc.Wedges = arc.Triangles / 2 + 2;
      graph.Arcs.push_back(arc);
    }
  }
  graph.Index();
  graph.Saturate(1.0 / Width);
  graph.InputCounts.Triangles = graph.GetNumberOfFinestTriangles();
  return graph;
}

std::vector<vtkMTCut> MTRandomGraph::EnumerateCuts(const vtkMTGraph& graph)
{
  std::vector<vtkMTCut> cuts{ vtkMTCut(graph) };
  // Nodes in ascending order: what a node depends on has been decided before it.
  for (std::uint32_t node = 1; node < graph.GetSink(); ++node)
  {
    const std::size_t count = cuts.size();
    for (std::size_t i = 0; i < count; ++i)
    {
      if (cuts[i].CanRefine(node))
      {
        vtkMTCut refined = cuts[i];
        refined.Refine(node);
        cuts.push_back(refined);
      }
    }
  }
  return cuts;
}

bool MTRandomGraph::IsClosed(const vtkMTGraph& graph, const vtkMTCut& cut)
{
  return cut.IsRefined(graph.GetSource()) && !cut.IsRefined(graph.GetSink()) &&
    std::none_of(graph.Arcs.begin(), graph.Arcs.end(),
      [&cut](const vtkMTArc& arc) { return cut.IsRefined(arc.To) && !cut.IsRefined(arc.From); });
}
