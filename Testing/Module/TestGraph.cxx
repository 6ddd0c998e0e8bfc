// SPDX-License-Identifier: BSD-3-Clause
#include "MTTestMeshes.h"
#include "MTTestModel.h"
#include "vtkMTGraph.h"
#include "vtkMTValidate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace
{
using MTTestMeshes::Random;

// A layered graph with random arcs, boxes and errors, arcs in random order; every node lies on a path.
vtkMTGraph RandomGraph(std::uint64_t seed, const double bounds[6])
{
  Random random(seed);
  vtkMTGraph graph;
  graph.Lattice = vtkMTLattice::FromBounds(bounds);
  std::vector<std::uint32_t> coarser{ 0 };
  graph.Nodes.resize(1);
  const int levels = 5;
  for (int level = levels; level >= 0; --level)
  {
    std::vector<std::uint32_t> present;
    const int count = level == 0 ? 1 : 2 << (levels - level);
    for (int i = 0; i < count; ++i)
    {
      present.push_back(static_cast<std::uint32_t>(graph.Nodes.size()));
      vtkMTNode node;
      node.Level = level;
      node.OwnError = level == 0 ? 0.0 : random.Uniform() * graph.Lattice.Step * 1000.0;
      node.EdgeLength = random.Uniform();
      graph.Nodes.push_back(node);
    }
    const std::size_t arcs = 3 * std::max(coarser.size(), present.size());
    for (std::size_t i = 0; i < arcs; ++i)
    {
      vtkMTArc arc;
      arc.From = coarser[i < coarser.size() ? i : random.Below(coarser.size())];
      arc.To = present[i < present.size() ? i : random.Below(present.size())];
      arc.Triangles = arc.Points = arc.Wedges = 1 + static_cast<std::uint32_t>(random.Below(1000));
      for (int j = 0; j < 3; ++j)
      {
        double low[3] = { bounds[0], bounds[2], bounds[4] };
        double high[3] = { bounds[0], bounds[2], bounds[4] };
        const double a = random.Uniform();
        const double b = a + 0.1 * (1.0 - a) * random.Uniform();
        low[j] += a * (bounds[2 * j + 1] - bounds[2 * j]);
        high[j] += b * (bounds[2 * j + 1] - bounds[2 * j]);
        arc.Box[2 * j] = graph.Lattice.Snap(low)[j];
        arc.Box[2 * j + 1] = graph.Lattice.Snap(high)[j];
      }
      graph.Arcs.push_back(arc);
    }
    coarser = present;
  }
  for (std::size_t i = graph.Arcs.size(); i > 1; --i)
  {
    std::swap(graph.Arcs[i - 1], graph.Arcs[random.Below(i)]);
  }
  graph.InputCounts.Triangles = 1ull << 40;
  return graph;
}

const double Unit[6] = { 0, 1, 0, 1, 0, 1 };
}

TEST(Graph, IndexSortsArcsAndGivesThePermutation)
{
  vtkMTGraph graph = RandomGraph(1, Unit);
  const std::vector<vtkMTArc> before = graph.Arcs;
  const std::vector<std::uint32_t> order = graph.Index();
  ASSERT_EQ(order.size(), before.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    EXPECT_EQ(graph.Arcs[i].From, before[order[i]].From);
    EXPECT_EQ(graph.Arcs[i].To, before[order[i]].To);
    EXPECT_EQ(graph.Arcs[i].Triangles, before[order[i]].Triangles);
    const bool same = i > 0 && graph.Arcs[i].From == graph.Arcs[i - 1].From && graph.Arcs[i].To == graph.Arcs[i - 1].To;
    EXPECT_TRUE(!same || order[i - 1] < order[i]) << "equal arcs keep their order";
  }
  std::vector<std::uint32_t> again = graph.Index();
  EXPECT_TRUE(std::is_sorted(again.begin(), again.end())) << "indexing twice changes nothing";
  graph.Saturate(0.0);
  const vtkMTValidate::Result result = vtkMTValidate::Graph(graph);
  EXPECT_EQ(result.Violations, 0u) << (result.Findings.empty() ? "" : result.Findings[0].What);
}

TEST(Graph, SaturatedErrorsNestAndNeverRoundDownAtAnyScale)
{
  const double scenes[][6] = { { 0, 1, 0, 1, 0, 1 }, { 500000, 501000, 5400000, 5402000, 100, 900 },
    { 0, 1e-30, 0, 1e-30, 0, 1e-30 }, { -1e30, 1e30, 0, 1e30, 0, 1e30 }, { 1e-3, 1.1e-3, 1e9, 1e9 + 1, 0, 0 },
    { 0, 1e200, 0, 1e200, 0, 1e200 }, { 0, 1e-200, 0, 1e-200, 0, 1e-200 } };
  for (const auto& bounds : scenes)
  {
    for (std::uint64_t seed = 0; seed < 20; ++seed)
    {
      vtkMTGraph graph = RandomGraph(seed, bounds);
      graph.Index();
      graph.Saturate(graph.Lattice.MaximumShift);
      // Nesting of spheres, boxes in spheres and saturation are the validator's checks, made without tolerance.
      const vtkMTValidate::Result result = vtkMTValidate::Graph(graph);
      ASSERT_EQ(result.Violations, 0u) << result.Findings[0].What;
      EXPECT_EQ(graph.Nodes.back().Error, graph.Lattice.MaximumShift);
      EXPECT_EQ(graph.Nodes.front().Level, graph.GetNumberOfLevels());
      double worstRoot = 0.0;
      for (std::uint32_t i = 0; i < graph.Nodes.front().OutCount; ++i)
      {
        worstRoot = std::max(worstRoot, graph.Nodes[graph.Arcs[i].To].Error);
      }
      EXPECT_EQ(graph.Nodes.front().Error, worstRoot);
      for (const vtkMTArc& arc : graph.Arcs)
      {
        ASSERT_GE(graph.Nodes[arc.From].Error, graph.Nodes[arc.To].Error);
      }
      for (std::uint32_t i = 1; i < graph.Nodes.size(); ++i)
      {
        const long double sum = static_cast<long double>(graph.Nodes[i].OwnError) + graph.Lattice.MaximumShift;
        ASSERT_GE(static_cast<long double>(graph.Nodes[i].Error), sum);
      }
    }
  }
}

TEST(Graph, SpheresAreTight)
{
  const auto tube = MTTestModel::MakeTube({ 1024, 8, 64 });
  const vtkMTGraph& graph = tube->GetGraph();
  double sum = 0.0;
  double worst = 0.0;
  std::size_t count = 0;
  for (std::uint32_t i = 1; i < graph.GetSink(); ++i)
  {
    const vtkMTNode& node = graph.Nodes[i];
    // No sphere around the boxes can be smaller than half of the largest distance between two of their corners.
    std::vector<std::array<double, 3>> corners;
    for (std::uint32_t a = 0; a < node.OutCount + node.InCount; ++a)
    {
      const bool out = a < node.OutCount;
      double b[6];
      const std::uint32_t arc = out ? node.FirstOut + a : graph.Entering[node.FirstIn + a - node.OutCount];
      graph.Lattice.ToWorld(graph.Arcs[arc].Box, b);
      for (int c = 0; c < 8; ++c)
      {
        corners.push_back({ b[c & 1], b[2 + (c >> 1 & 1)], b[4 + (c >> 2)] });
      }
    }
    double farthest = 0.0;
    for (const auto& p : corners)
    {
      for (const auto& q : corners)
      {
        farthest = std::max(farthest, std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
      }
    }
    sum += node.Radius / (0.5 * farthest);
    worst = std::max(worst, node.Radius / (0.5 * farthest));
    ++count;
  }
  std::cout << "radius over half of the largest extent: mean " << sum / count << ", worst " << worst << "\n";
  EXPECT_LT(sum / count, 1.6);
  EXPECT_LT(worst, 3.0);
}

TEST(Graph, FiguresAreThoseOfTheTube)
{
  const auto tube = MTTestModel::MakeTube({ 256, 8, 16 });
  const vtkMTGraph& graph = tube->GetGraph();
  EXPECT_EQ(graph.GetNumberOfLevels(), 6u);
  EXPECT_EQ(graph.GetNumberOfFinestTriangles(), 256u * 16u);
  EXPECT_LT(graph.GetNumberOfRootTriangles(), 256u * 16u / 16);
  const vtkMTGraph::Conditioning conditioning = graph.GetConditioning();
  std::cout << "depth " << conditioning.Depth << ", diameter ratio " << conditioning.DiameterRatio << "\n";
  EXPECT_EQ(conditioning.Depth, 5u);
  EXPECT_GT(conditioning.DiameterRatio, 1.2);
  EXPECT_LT(conditioning.DiameterRatio, 2.2);
  double bounds[6];
  graph.GetBounds(bounds);
  EXPECT_NEAR(bounds[1], 1.3, 0.15);
  EXPECT_NEAR(bounds[4], -0.4, 0.1);
}

TEST(Graph, EmptyGraphHasFiguresToo)
{
  vtkMTGraph graph;
  EXPECT_TRUE(graph.IsEmpty());
  EXPECT_EQ(graph.GetNumberOfLevels(), 0u);
  EXPECT_EQ(graph.GetNumberOfRootTriangles(), 0u);
  EXPECT_EQ(graph.GetNumberOfFinestTriangles(), 0u);
  EXPECT_TRUE(graph.Index().empty());
  graph.Saturate(1.0);
  EXPECT_EQ(graph.GetConditioning().Depth, 0u);
  double bounds[6];
  graph.GetBounds(bounds);
  EXPECT_FALSE(vtkMath::AreBoundsInitialized(bounds));
}
