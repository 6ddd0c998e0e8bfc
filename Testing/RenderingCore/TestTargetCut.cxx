// SPDX-License-Identifier: BSD-3-Clause
// Extraction without a view: the error is the node's own.
#include "MTRandomGraph.h"
#include "MTTestModel.h"

#include "vtkMTTargetCut.h"
#include "vtkMTValidate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>

namespace
{
vtkMTTargetCut::Result Extract(const vtkMTGraph& graph, const vtkMTTargetCut::Settings& settings,
  const std::vector<unsigned char>* resident = nullptr)
{
  vtkMTTargetCut extraction;
  vtkMTTargetCut::Input input;
  input.Graph = &graph;
  input.Resident = resident;
  return extraction.Extract(input, settings);
}

TEST(Extraction, RandomGraphsAreValid)
{
  for (std::uint32_t seed = 0; seed < 20; ++seed)
  {
    const auto result = vtkMTValidate::Graph(MTRandomGraph::Make(seed, 4 + static_cast<int>(seed)));
    EXPECT_TRUE(result.IsValid()) << "seed " << seed << ": "
                                  << (result.Findings.empty() ? "" : result.Findings[0].What);
  }
}

TEST(Extraction, ErrorCutIsTheSmallestOfAllCutsWithThatError)
{
  std::size_t cuts = 0;
  for (std::uint32_t seed = 0; seed < 30; ++seed)
  {
    const vtkMTGraph graph = MTRandomGraph::Make(seed, 6);
    const std::vector<vtkMTCut> all = MTRandomGraph::EnumerateCuts(graph);
    cuts += all.size();
    for (const double error : { 5e-5, 1e-4, 3e-4, 1e-3, 3e-3 })
    {
      vtkMTTargetCut::Settings settings;
      settings.ModelError = error;
      const auto result = Extract(graph, settings);
      ASSERT_TRUE(MTRandomGraph::IsClosed(graph, result.Cut));
      EXPECT_LE(result.Cut.GetError(), error);
      EXPECT_DOUBLE_EQ(result.ModelError, result.Cut.GetError());
      EXPECT_TRUE(result.Converged);
      for (const vtkMTCut& cut : all)
      {
        if (cut.GetError() <= error)
        {
          EXPECT_GE(cut.GetNumberOfTriangles(), result.Cut.GetNumberOfTriangles()) << "seed " << seed;
        }
      }
    }
  }
  std::cout << cuts << " cuts enumerated\n";
  EXPECT_GT(cuts, 1000u);
}

TEST(Extraction, ArcsAndFiguresAreThoseOfTheCut)
{
  for (std::uint32_t seed = 0; seed < 20; ++seed)
  {
    const vtkMTGraph graph = MTRandomGraph::Make(seed, 60);
    vtkMTTargetCut::Settings settings;
    settings.ModelError = 1e-3;
    const auto result = Extract(graph, settings);
    std::vector<std::uint32_t> arcs = result.Cut.GetArcs();
    std::sort(arcs.begin(), arcs.end());
    EXPECT_EQ(result.Arcs, arcs);
    EXPECT_EQ(result.Triangles, result.Cut.GetNumberOfTriangles());
    EXPECT_EQ(result.ArcsInCut, result.Cut.GetNumberOfArcs());
    EXPECT_EQ(result.ArcsCulled, 0u);
  }
}

TEST(Extraction, SmallerErrorsRefineTheSameNodesAndMore)
{
  const vtkMTGraph graph = MTRandomGraph::Make(7, 200);
  vtkMTCut last(graph);
  for (const double error : { 1e-1, 1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 0.0 })
  {
    vtkMTTargetCut::Settings settings;
    settings.ModelError = error;
    const auto result = Extract(graph, settings);
    for (std::uint32_t node = 0; node < graph.Nodes.size(); ++node)
    {
      EXPECT_TRUE(!last.IsRefined(node) || result.Cut.IsRefined(node));
    }
    last = result.Cut;
  }
}

TEST(Extraction, EdgeLengthChoiceComparesEdgeLengths)
{
  const vtkMTGraph graph = MTRandomGraph::Make(3, 50);
  vtkMTTargetCut::Settings settings;
  settings.ModelError = 0.01;
  settings.ErrorMetric = vtkMTTargetCut::EdgeLength;
  const auto result = Extract(graph, settings);
  ASSERT_TRUE(MTRandomGraph::IsClosed(graph, result.Cut));
  EXPECT_GT(result.NodesRefined, 0u);
  for (const std::uint32_t arc : result.Arcs)
  {
    const std::uint32_t node = graph.Arcs[arc].To;
    EXPECT_TRUE(node == graph.GetSink() || graph.Nodes[node].EdgeLength <= 0.01);
  }
}

// Gives the nodes angles that grow towards the coarse end, or none.
vtkMTGraph MakeGraphWithNormals(std::uint32_t seed, double angle)
{
  vtkMTGraph graph = MTRandomGraph::Make(seed, 80);
  vtkMTMeasure measure{ vtkMTMeasure::MeanNormalDeviation, {} };
  for (const vtkMTNode& node : graph.Nodes)
  {
    measure.Values.push_back(std::min(3.1, angle * node.Level));
  }
  measure.Values.back() = 0.0;
  graph.Measures.push_back(measure);
  return graph;
}

TEST(Extraction, NormalDeviationCountsDistanceAndEdgesByTheAngle)
{
  vtkMTTargetCut::Settings settings;
  settings.ModelError = 0.002;
  settings.ErrorMetric = vtkMTTargetCut::NormalDeviation;
  for (const double angle : { 0.0, 0.05, 0.3 })
  {
    const vtkMTGraph graph = MakeGraphWithNormals(3, angle);
    const auto result = Extract(graph, settings);
    ASSERT_TRUE(MTRandomGraph::IsClosed(graph, result.Cut));
    std::size_t refined = 0;
    for (std::uint32_t node = 1; node < graph.GetSink(); ++node)
    {
      const double shading = graph.Nodes[node].EdgeLength * std::sin(0.5 * graph.Measures[0].Values[node]);
      refined += std::max(graph.Nodes[node].Error, shading) > 0.002 ? 1 : 0;
    }
    std::printf("angle %.2f: %zu nodes refined\n", angle, result.NodesRefined);
    EXPECT_GE(result.NodesRefined, refined);
    for (const std::uint32_t arc : result.Arcs)
    {
      const std::uint32_t node = graph.Arcs[arc].To;
      const double shading = graph.Nodes[node].EdgeLength * std::sin(0.5 * graph.Measures[0].Values[node]);
      EXPECT_TRUE(node == graph.GetSink() || std::max(graph.Nodes[node].Error, shading) <= 0.002);
    }
    const auto getRefined = [&](vtkMTTargetCut::ErrorMetricType metric, const vtkMTGraph& of)
    {
      settings.ErrorMetric = metric;
      const auto nodes = Extract(of, settings).RefinedNodes;
      settings.ErrorMetric = vtkMTTargetCut::NormalDeviation;
      return nodes;
    };
    const auto byDistance = getRefined(vtkMTTargetCut::Distance, graph);
    EXPECT_TRUE(
      std::includes(result.RefinedNodes.begin(), result.RefinedNodes.end(), byDistance.begin(), byDistance.end()));
    EXPECT_EQ(result.RefinedNodes == byDistance, angle == 0.0);
    vtkMTGraph without = graph;
    without.Measures.clear();
    const auto byBoth = Extract(without, settings).RefinedNodes;
    EXPECT_TRUE(std::includes(byBoth.begin(), byBoth.end(), result.RefinedNodes.begin(), result.RefinedNodes.end()))
      << "where nothing is known of normals, edges count in full";
    const auto byEdges = getRefined(vtkMTTargetCut::EdgeLength, graph);
    EXPECT_TRUE(std::includes(byBoth.begin(), byBoth.end(), byEdges.begin(), byEdges.end()));
  }
}

TEST(Extraction, ResultDoesNotDependOnEarlierCalls)
{
  vtkMTTargetCut used;
  const vtkMTGraph graph = MTRandomGraph::Make(5, 100);
  const vtkMTGraph other = MTRandomGraph::Make(6, 150);
  for (const double error : { 1e-4, 1e-2, 1e-3, 0.0, 5e-3 })
  {
    for (const vtkMTGraph* each : { &graph, &other })
    {
      vtkMTTargetCut::Settings settings;
      settings.ModelError = error;
      settings.TriangleLimit = 20000;
      vtkMTTargetCut::Input input;
      input.Graph = each;
      const auto result = used.Extract(input, settings);
      EXPECT_EQ(result.Arcs, Extract(*each, settings).Arcs);
    }
  }
}

TEST(Extraction, WhatIsNotResidentIsRequestedAndNotDrawn)
{
  for (std::uint32_t seed = 0; seed < 10; ++seed)
  {
    const vtkMTGraph graph = MTRandomGraph::Make(seed, 80);
    std::vector<unsigned char> resident(graph.Arcs.size(), 0);
    for (std::size_t arc = 0; arc < resident.size(); ++arc)
    {
      resident[arc] = graph.Arcs[arc].From == graph.GetSource() || arc % 5 != 0;
    }
    vtkMTTargetCut::Settings settings;
    settings.ModelError = 1e-3;
    const auto result = Extract(graph, settings, &resident);
    ASSERT_TRUE(MTRandomGraph::IsClosed(graph, result.Cut));
    for (const std::uint32_t arc : result.Arcs)
    {
      EXPECT_TRUE(resident[arc]);
    }
    EXPECT_FALSE(result.Converged);
    ASSERT_FALSE(result.Requests.empty());
    for (std::size_t i = 0; i < result.Requests.size(); ++i)
    {
      EXPECT_FALSE(resident[result.Requests[i].Arc]);
      EXPECT_TRUE(i == 0 || result.Requests[i].Error <= result.Requests[i - 1].Error);
    }
  }
}

TEST(Extraction, LoadingWhatIsRequestedConvergesToTheFullCut)
{
  const vtkMTGraph graph = MTRandomGraph::Make(11, 100);
  vtkMTTargetCut::Settings settings;
  settings.ModelError = 5e-4;
  const auto wanted = Extract(graph, settings);
  std::vector<unsigned char> resident(graph.Arcs.size(), 0);
  for (std::size_t arc = 0; arc < resident.size(); ++arc)
  {
    resident[arc] = graph.Arcs[arc].From == graph.GetSource();
  }
  int frames = 0;
  std::size_t loaded = 0;
  auto result = Extract(graph, settings, &resident);
  while (!result.Requests.empty() && frames < 1000)
  {
    for (std::size_t i = 0; i < std::min<std::size_t>(10, result.Requests.size()); ++i)
    {
      resident[result.Requests[i].Arc] = 1;
      ++loaded;
    }
    result = Extract(graph, settings, &resident);
    ++frames;
  }
  std::cout << frames << " frames, " << loaded << " patches loaded for a cut of " << result.Arcs.size() << "\n";
  EXPECT_EQ(result.Arcs, wanted.Arcs);
}

TEST(Extraction, ByLevelTakesThatLevelsPatches)
{
  const vtkMTGraph graph = MTRandomGraph::Make(2, 40);
  std::string message;
  for (std::uint32_t level = 0; level < graph.GetNumberOfLevels(); ++level)
  {
    vtkMTCut cut(graph);
    ASSERT_TRUE(vtkMTTargetCut::ByLevel(graph, level, cut, message));
    for (const std::uint32_t arc : cut.GetArcs())
    {
      EXPECT_EQ(graph.GetLevelOfArc(arc), level);
    }
  }
  vtkMTCut cut(graph);
  EXPECT_FALSE(vtkMTTargetCut::ByLevel(graph, graph.GetNumberOfLevels(), cut, message));
  std::cout << message << "\n";
}

TEST(Extraction, ByErrorFailsBelowTheFinestLevelsError)
{
  const vtkMTGraph graph = MTRandomGraph::Make(2, 40);
  vtkMTTargetCut extraction;
  vtkMTCut cut(graph);
  std::string message;
  EXPECT_TRUE(extraction.ByError(graph, 1e-3, cut, message)) << message;
  EXPECT_LE(cut.GetError(), 1e-3);
  EXPECT_FALSE(extraction.ByError(graph, 0.5 * graph.Nodes[graph.GetSink()].Error, cut, message));
  std::cout << message << "\n";
}

TEST(Extraction, EmptyGraphGivesAnEmptyCut)
{
  const vtkMTGraph graph;
  const auto result = Extract(graph, vtkMTTargetCut::Settings());
  EXPECT_TRUE(result.Arcs.empty());
  EXPECT_TRUE(result.Converged);
}

TEST(Extraction, CutsOfARealModelConform)
{
  const auto store = MTTestModel::MakeTube();
  vtkMTValidate::Borders borders;
  ASSERT_TRUE(borders.Load(*store).IsValid());
  vtkMTTargetCut extraction;
  for (const double share : { 1.0, 0.5, 0.2, 0.1, 0.05 })
  {
    vtkMTCut cut(store->GetGraph());
    std::string message;
    const auto triangles = static_cast<std::uint64_t>(share * store->GetGraph().GetNumberOfFinestTriangles());
    if (!extraction.ByTriangles(store->GetGraph(), triangles, cut, message))
    {
      std::cout << message << "\n";
      continue;
    }
    EXPECT_TRUE(borders.Cut(cut).IsValid());
    EXPECT_EQ(borders.CountBorderEdges(cut), 0u);
    EXPECT_LE(cut.GetNumberOfTriangles(), triangles);
  }
}
}
