// SPDX-License-Identifier: BSD-3-Clause
// Extraction by the certified deviation of an array's values.
#include "MTRandomGraph.h"
#include "MTViews.h"

#include "vtkMTCutFollower.h"
#include "vtkMTTargetCut.h"
#include "vtkMTValidate.h"
#include "vtkMTView.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <iostream>
#include <random>
#include <utility>
#include <vector>

namespace
{
// A random graph whose nodes deviate by 0 to about 10 in the values of "heat", less on finer levels.
vtkMTGraph MakeGraph(std::uint32_t seed, int finestNodes)
{
  vtkMTGraph graph = MTRandomGraph::Make(seed, finestNodes);
  std::mt19937 random(seed);
  vtkMTMeasure measure{ vtkMTMeasure::GetValueDeviationName("heat"), std::vector<double>(graph.Nodes.size(), 0.0) };
  for (std::uint32_t node = graph.GetSink(); node-- > 0;)
  {
    const vtkMTNode& record = graph.Nodes[node];
    for (std::uint32_t arc = record.FirstOut; arc < record.FirstOut + record.OutCount; ++arc)
    {
      measure.Values[node] = std::max(measure.Values[node], measure.Values[graph.Arcs[arc].To]);
    }
    measure.Values[node] += random() % 4 == 0 ? 0.001 * static_cast<double>(random() % 1000) : 0.0;
  }
  graph.Measures.push_back({ "another", std::vector<double>(graph.Nodes.size(), 0.0) });
  graph.Measures.push_back(measure);
  return graph;
}

vtkMTTargetCut::Settings MakeSettings(double pixels, double deviation)
{
  vtkMTTargetCut::Settings settings;
  settings.PixelError = pixels;
  settings.ErrorMetric = vtkMTTargetCut::Value;
  settings.ValueArray = "heat";
  settings.ValueError = deviation;
  return settings;
}

vtkMTTargetCut::Result Extract(const vtkMTGraph& graph, const vtkMTView& view, const vtkMTTargetCut::Settings& settings)
{
  vtkMTTargetCut extraction;
  vtkMTTargetCut::Input input;
  input.Graph = &graph;
  input.Views = { view };
  return extraction.Extract(input, settings);
}

TEST(ExtractionByValue, GraphsWithTheMeasureAreValid)
{
  const auto result = vtkMTValidate::Graph(MakeGraph(1, 40));
  EXPECT_TRUE(result.IsValid()) << (result.Findings.empty() ? "" : result.Findings[0].What);
}

// What is drawn keeps to the rule, and what was refined had to be.
TEST(ExtractionByValue, RefinesWhatDeviatesByMoreAndIsLargerThanThePixelError)
{
  const vtkMTGraph graph = MakeGraph(4, 300);
  const std::vector<double>& deviations = graph.Measures.back().Values;
  std::array<std::size_t, 4> cases{ 0, 0, 0, 0 }; // drawn: small ones that deviate, large ones that do not; refined
  for (const vtkMTView& view : MTViews::MakeRandom(1, 24))
  {
    for (const std::pair<double, double>& each :
      std::vector<std::pair<double, double>>{ { 1.0, 0.0 }, { 1.0, 1.0 }, { 5.0, 0.0 }, { 5.0, 0.3 }, { 5.0, 2.0 } })
    {
      const double pixels = each.first;
      const double deviation = each.second;
      auto settings = MakeSettings(pixels, deviation);
      const auto result = Extract(graph, view, settings);
      ASSERT_TRUE(MTRandomGraph::IsClosed(graph, result.Cut));
      EXPECT_TRUE(result.Converged);
      const auto get = [&](std::uint32_t arc, vtkMTTargetCut::ErrorMetricType metric)
      { return vtkMTTargetCut::GetPixelError(graph, view, arc, metric); };
      for (const std::uint32_t arc : result.Arcs)
      {
        const std::uint32_t node = graph.Arcs[arc].To;
        const double distance = get(arc, vtkMTTargetCut::Distance);
        const bool isLarge = get(arc, vtkMTTargetCut::EdgeLength) > pixels;
        const bool deviates = deviations[node] > deviation;
        EXPECT_TRUE(node == graph.GetSink() || (distance <= pixels && !(deviates && isLarge)));
        EXPECT_EQ(vtkMTTargetCut::GetPixelError(graph, view, arc, settings) > pixels,
          distance > pixels || (deviates && isLarge));
        cases[0] += deviates && !isLarge ? 1 : 0;
        cases[1] += node != graph.GetSink() && !deviates && isLarge ? 1 : 0;
      }
      settings.ErrorMetric = vtkMTTargetCut::Distance;
      EXPECT_EQ(result.PixelError, vtkMTTargetCut().View(result.Cut, { &graph, { view } }, settings).PixelError)
        << "the error that is achieved is the distance";
      for (std::uint32_t node = 1; node < graph.GetSink(); ++node)
      {
        const vtkMTArcList entering = graph.GetEntering(node);
        const bool isFar = std::any_of(entering.begin(), entering.end(),
          [&](std::uint32_t arc) { return get(arc, vtkMTTargetCut::Distance) > pixels; });
        const bool isLarge = std::any_of(entering.begin(), entering.end(),
          [&](std::uint32_t arc) { return get(arc, vtkMTTargetCut::EdgeLength) > pixels; });
        if (result.Cut.CanCoarsen(node))
        {
          EXPECT_TRUE(isFar || (deviations[node] > deviation && isLarge)) << "node " << node;
          ++cases[isFar ? 2 : 3];
        }
      }
    }
  }
  std::cout << cases[0] << " drawn deviate and are small, " << cases[1] << " do not and are large; at the cut "
            << cases[2] << " were refined for their distance, " << cases[3] << " for their values\n";
  EXPECT_GT(*std::min_element(cases.begin(), cases.end()), 100u);
}

TEST(ExtractionByValue, SmallerDeviationsRefineTheSameNodesAndMore)
{
  const vtkMTGraph graph = MakeGraph(9, 200);
  vtkMTGraph without = graph;
  without.Measures.clear();
  std::array<std::size_t, 3> nodes{ 0, 0, 0 };
  for (const vtkMTView& view : MTViews::MakeRandom(1, 24))
  {
    auto settings = MakeSettings(0.7, 0.0);
    settings.ErrorMetric = vtkMTTargetCut::Distance;
    auto last = Extract(graph, view, settings).RefinedNodes;
    EXPECT_EQ(Extract(graph, view, MakeSettings(0.7, 1000.0)).RefinedNodes, last) << "then distance alone counts";
    nodes[0] += last.size();
    for (const double deviation : { 5.0, 2.0, 1.0, 0.5, 0.1, 0.0 })
    {
      const auto now = Extract(graph, view, MakeSettings(0.7, deviation)).RefinedNodes;
      ASSERT_TRUE(std::includes(now.begin(), now.end(), last.begin(), last.end())) << deviation;
      last = now;
    }
    nodes[1] += last.size();
    // Where nothing is known of the values, edges count in full: the larger of distance and edges.
    const auto unknown = Extract(without, view, MakeSettings(0.7, 1.0)).RefinedNodes;
    ASSERT_TRUE(std::includes(unknown.begin(), unknown.end(), last.begin(), last.end()));
    settings.ErrorMetric = vtkMTTargetCut::EdgeLength;
    const auto edges = Extract(graph, view, settings).RefinedNodes;
    ASSERT_TRUE(std::includes(unknown.begin(), unknown.end(), edges.begin(), edges.end()));
    settings = MakeSettings(0.7, 1.0);
    settings.ValueArray = "cold";
    EXPECT_EQ(Extract(graph, view, settings).RefinedNodes, unknown) << "nor of arrays of other names";
    settings.ValueArray = "";
    EXPECT_EQ(Extract(graph, view, settings).RefinedNodes, unknown);
    nodes[2] += unknown.size();
  }
  std::cout << nodes[0] << " nodes by distance, " << nodes[1] << " for all values, " << nodes[2] << " unknown\n";
  EXPECT_LT(3 * nodes[0], 2 * nodes[1]);
  EXPECT_LT(nodes[1], nodes[2]);
}

TEST(ExtractionByValue, TheLimitOfTrianglesHoldsAndLimitedCutsAreParts)
{
  const vtkMTGraph graph = MakeGraph(13, 600);
  int limited = 0;
  for (const vtkMTView& view : MTViews::MakeRandom(4, 24))
  {
    for (const double deviation : { 0.0, 1.0 })
    {
      auto settings = MakeSettings(0.3, deviation);
      const auto whole = Extract(graph, view, settings);
      const auto coarsest = vtkMTTargetCut().View(vtkMTCut(graph), { &graph, { view } }, settings);
      for (const double share : { 0.2, 0.5, 0.8 })
      {
        settings.TriangleLimit =
          std::max<std::uint64_t>(1 + coarsest.Triangles, static_cast<std::uint64_t>(share * whole.Triangles));
        const auto result = Extract(graph, view, settings);
        ASSERT_TRUE(MTRandomGraph::IsClosed(graph, result.Cut));
        EXPECT_TRUE(result.WithinLimits);
        EXPECT_LE(result.Triangles, settings.TriangleLimit);
        limited += result.Converged ? 0 : 1;
        ASSERT_TRUE(std::includes(whole.RefinedNodes.begin(), whole.RefinedNodes.end(), result.RefinedNodes.begin(),
          result.RefinedNodes.end()));
      }
    }
  }
  std::cout << limited << " cuts that the limit ended\n";
  EXPECT_GT(limited, 50);
}

TEST(ExtractionByValue, WithoutAViewEdgesAreComparedInModelUnits)
{
  const vtkMTGraph graph = MakeGraph(3, 80);
  const std::vector<double>& deviations = graph.Measures.back().Values;
  std::size_t last = 0;
  for (const double deviation : { 1000.0, 1.0, 0.0 })
  {
    auto settings = MakeSettings(1.0, deviation);
    settings.ModelError = 0.004;
    vtkMTTargetCut extraction;
    vtkMTTargetCut::Input input;
    input.Graph = &graph;
    const auto result = extraction.Extract(input, settings);
    ASSERT_TRUE(MTRandomGraph::IsClosed(graph, result.Cut));
    const auto isWanted = [&](std::uint32_t node) {
      return graph.Nodes[node].Error > 0.004 || (deviations[node] > deviation && graph.Nodes[node].EdgeLength > 0.004);
    };
    for (const std::uint32_t arc : result.Arcs)
    {
      EXPECT_TRUE(graph.Arcs[arc].To == graph.GetSink() || !isWanted(graph.Arcs[arc].To));
    }
    for (std::uint32_t node = 1; node < graph.GetSink(); ++node)
    {
      EXPECT_TRUE(!result.Cut.CanCoarsen(node) || isWanted(node));
    }
    std::cout << "deviation " << deviation << ": " << result.NodesRefined << " nodes\n";
    EXPECT_GT(result.NodesRefined, last);
    last = result.NodesRefined;
  }
}

// The cut that follows a moving camera is the one that is extracted anew, also while the deviation changes.
TEST(ExtractionByValue, AFollowedCutIsTheExtractedOne)
{
  const vtkMTGraph graph = MakeGraph(21, 300);
  vtkMTCutFollower follower;
  std::size_t nodes = 0;
  int frame = 0;
  for (const vtkMTView& view : MTViews::MakePath(40))
  {
    vtkMTCutFollower::Settings settings;
    static_cast<vtkMTTargetCut::Settings&>(settings) = MakeSettings(0.7, ++frame % 3 == 0 ? 0.0 : 1.0);
    vtkMTCutFollower::Input input;
    input.Graph = &graph;
    input.Views = { view };
    const auto followed = follower.Update(input, settings);
    EXPECT_TRUE(followed.OnTarget);
    EXPECT_EQ(followed.RefinedNodes, Extract(graph, view, settings).RefinedNodes) << "frame " << frame;
    nodes += followed.NodesRefined;
  }
  std::cout << nodes << " nodes refined in all\n";
  EXPECT_GT(nodes, 1000u);
}
}
