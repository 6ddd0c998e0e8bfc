// SPDX-License-Identifier: BSD-3-Clause
// The triangle budget: a limit that holds, and that is used.
#include "MTRandomGraph.h"

#include "vtkMTTargetCut.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

namespace
{
double GetMeanPatch(const vtkMTGraph& graph)
{
  double sum = 0.0;
  for (const vtkMTArc& arc : graph.Arcs)
  {
    sum += arc.Triangles;
  }
  return sum / static_cast<double>(graph.Arcs.size());
}

TEST(ExtractionBudget, IsNeverExceeded)
{
  vtkMTTargetCut extraction;
  for (std::uint32_t seed = 0; seed < 40; ++seed)
  {
    const vtkMTGraph graph = MTRandomGraph::Make(seed, 10 + static_cast<int>(seed));
    const std::uint64_t root = graph.GetNumberOfRootTriangles();
    for (const double factor : { 1.0, 1.01, 1.3, 2.0, 3.7, 9.0, 30.0 })
    {
      const auto budget = static_cast<std::uint64_t>(factor * static_cast<double>(root));
      vtkMTCut cut(graph);
      std::string message;
      ASSERT_TRUE(extraction.ByTriangles(graph, budget, cut, message)) << message;
      EXPECT_LE(cut.GetNumberOfTriangles(), budget);
      EXPECT_TRUE(MTRandomGraph::IsClosed(graph, cut));
    }
  }
}

TEST(ExtractionBudget, IsUsedToNineTenthsFromFiftyMeanPatchesOn)
{
  vtkMTTargetCut extraction;
  double least = 1.0;
  int tested = 0;
  for (std::uint32_t seed = 0; seed < 60; ++seed)
  {
    const vtkMTGraph graph = MTRandomGraph::Make(seed, 60 + 10 * static_cast<int>(seed));
    const double mean = GetMeanPatch(graph);
    for (const double patches : { 50.0, 57.0, 80.0, 123.0, 200.0, 500.0, 1000.0 })
    {
      const auto budget = static_cast<std::uint64_t>(patches * mean) + 1;
      if (budget >= graph.GetNumberOfFinestTriangles())
      {
        continue;
      }
      vtkMTCut cut(graph);
      std::string message;
      ASSERT_TRUE(extraction.ByTriangles(graph, budget, cut, message)) << message;
      const double used = static_cast<double>(cut.GetNumberOfTriangles()) / static_cast<double>(budget);
      least = std::min(least, used);
      ++tested;
      EXPECT_GE(used, 0.9) << "seed " << seed << ", " << patches << " mean patches";
    }
  }
  std::cout << tested << " budgets, the least use is " << least << "\n";
  EXPECT_GT(tested, 200);
}

// No single refinement that is wanted still fits, of all that could be done: compared with every cut of small graphs.
TEST(ExtractionBudget, LeavesNothingUndoneThatFits)
{
  vtkMTTargetCut extraction;
  for (std::uint32_t seed = 0; seed < 30; ++seed)
  {
    const vtkMTGraph graph = MTRandomGraph::Make(seed, 40);
    vtkMTTargetCut::Settings settings;
    settings.ModelError = 2e-4;
    settings.TriangleLimit = 2 * graph.GetNumberOfRootTriangles() + 1000;
    vtkMTTargetCut::Input input;
    input.Graph = &graph;
    const auto result = extraction.Extract(input, settings);
    for (const std::uint32_t arc : result.Arcs)
    {
      const std::uint32_t node = graph.Arcs[arc].To;
      if (node != graph.GetSink() && graph.Nodes[node].Error > settings.ModelError)
      {
        vtkMTCut more = result.Cut;
        more.RefineWithDependencies(node);
        EXPECT_GT(more.GetNumberOfTriangles(), settings.TriangleLimit);
      }
    }
  }
}

// Greedy by error: no cut of a small graph that fits the budget has a smaller error.
TEST(ExtractionBudget, ErrorIsTheLeastOfAllCuts)
{
  vtkMTTargetCut extraction;
  int cases = 0;
  int best = 0;
  for (std::uint32_t seed = 0; seed < 40; ++seed)
  {
    const vtkMTGraph graph = MTRandomGraph::Make(seed, 6);
    const std::vector<vtkMTCut> all = MTRandomGraph::EnumerateCuts(graph);
    for (const double share : { 0.2, 0.4, 0.6, 0.8 })
    {
      const auto budget = static_cast<std::uint64_t>(static_cast<double>(graph.GetNumberOfRootTriangles()) +
        share * static_cast<double>(graph.GetNumberOfFinestTriangles() - graph.GetNumberOfRootTriangles()));
      vtkMTCut cut(graph);
      std::string message;
      ASSERT_TRUE(extraction.ByTriangles(graph, budget, cut, message));
      double least = cut.GetError();
      for (const vtkMTCut& other : all)
      {
        if (other.GetNumberOfTriangles() <= budget)
        {
          least = std::min(least, other.GetError());
        }
      }
      ++cases;
      best += cut.GetError() <= least;
    }
  }
  std::cout << "the best possible error in " << best << " of " << cases << " cases\n";
  // Refining the largest error first reaches the least possible largest error: whatever has less must refine the same
  // nodes.
  EXPECT_EQ(best, cases);
}

TEST(ExtractionBudget, BelowTheRootIsAnErrorWithAMessage)
{
  const vtkMTGraph graph = MTRandomGraph::Make(1, 20);
  vtkMTTargetCut extraction;
  vtkMTCut cut(graph);
  std::string message;
  EXPECT_FALSE(extraction.ByTriangles(graph, graph.GetNumberOfRootTriangles() - 1, cut, message));
  std::cout << message << "\n";
  EXPECT_NE(message.find(std::to_string(graph.GetNumberOfRootTriangles())), std::string::npos);
  vtkMTTargetCut::Settings settings;
  settings.TriangleLimit = graph.GetNumberOfRootTriangles() - 1;
  vtkMTTargetCut::Input input;
  input.Graph = &graph;
  const auto result = extraction.Extract(input, settings);
  EXPECT_FALSE(result.WithinLimits);
  EXPECT_EQ(result.Triangles, graph.GetNumberOfRootTriangles());
}

TEST(ExtractionBudget, LargeEnoughGivesTheFinestLevel)
{
  const vtkMTGraph graph = MTRandomGraph::Make(1, 100);
  vtkMTTargetCut extraction;
  vtkMTCut cut(graph);
  std::string message;
  ASSERT_TRUE(extraction.ByTriangles(graph, graph.GetNumberOfFinestTriangles(), cut, message));
  EXPECT_EQ(cut.GetNumberOfTriangles(), graph.GetNumberOfFinestTriangles());
}
}
