// SPDX-License-Identifier: BSD-3-Clause
// Extraction in a view: pixels, frustum, budget of what is drawn.
#include "MTRandomGraph.h"
#include "MTViews.h"

#include "vtkMTTargetCut.h"
#include "vtkMTView.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <random>

namespace
{
vtkMTTargetCut::Result Extract(const vtkMTGraph& graph, const vtkMTView& view, const vtkMTTargetCut::Settings& settings)
{
  vtkMTTargetCut extraction;
  vtkMTTargetCut::Input input;
  input.Graph = &graph;
  input.Views = { view };
  return extraction.Extract(input, settings);
}

TEST(ExtractionView, EverythingVisibleIsBelowTheThreshold)
{
  const vtkMTGraph graph = MTRandomGraph::Make(4, 300);
  for (const vtkMTView& view : MTViews::MakeRandom(1, 24))
  {
    for (const double pixels : { 0.1, 0.5, 2.0 })
    {
      vtkMTTargetCut::Settings settings;
      settings.PixelError = pixels;
      const auto result = Extract(graph, view, settings);
      ASSERT_TRUE(MTRandomGraph::IsClosed(graph, result.Cut));
      EXPECT_TRUE(result.Converged);
      for (const std::uint32_t arc : result.Arcs)
      {
        const double error = vtkMTTargetCut::GetPixelError(graph, view, arc, vtkMTTargetCut::Distance);
        EXPECT_TRUE(error <= pixels || graph.Arcs[arc].To == graph.GetSink());
        EXPECT_LE(error, result.PixelError);
      }
    }
  }
}

TEST(ExtractionView, NormalsCountWhileEdgesExceedAPixelAndByHowThePatchIsTurned)
{
  vtkMTGraph graph = MTRandomGraph::Make(4, 300);
  vtkMTMeasure measure{ vtkMTMeasure::MeanNormalDeviation, std::vector<double>(graph.Nodes.size(), 1.0) };
  graph.Measures.push_back(measure);
  std::array<std::size_t, 3> cases{ 0, 0, 0 };
  for (const vtkMTView& view : MTViews::MakeRandom(2, 24))
  {
    for (std::uint32_t arc = 0; arc < graph.Arcs.size(); ++arc)
    {
      const auto get = [&](vtkMTTargetCut::ErrorMetricType metric)
      { return vtkMTTargetCut::GetPixelError(graph, view, arc, metric); };
      const double distance = get(vtkMTTargetCut::Distance);
      const double edges = get(vtkMTTargetCut::EdgeLength);
      graph.Arcs[arc].ConeAxis = { 0.0f, 0.0f, 1.0f };
      const double above = get(vtkMTTargetCut::NormalDeviation);
      graph.Arcs[arc].ConeAxis = { 0.0f, 0.0f, -1.0f };
      const double below = get(vtkMTTargetCut::NormalDeviation);
      if (!vtkMTTargetCut::IsVisible(graph, view, arc))
      {
        continue;
      }
      ASSERT_LE(above, std::max(distance, edges));
      ASSERT_GE(below, distance);
      ASSERT_GE(above, below) << "all cameras look down";
      ++cases[edges <= 1.0 ? 0 : (above > below ? 1 : 2)];
      ASSERT_TRUE(edges > 1.0 || above == distance);
    }
  }
  std::cout << cases[0] << " below a pixel, " << cases[1] << " by how they are turned, " << cases[2] << " others\n";
  EXPECT_GT(std::min(cases[0], cases[1]), 100u);
}

TEST(ExtractionView, AtOnePixelNormalsRefineNoMoreThanDistanceAndEdges)
{
  vtkMTGraph graph = MTRandomGraph::Make(5, 300);
  vtkMTMeasure measure{ vtkMTMeasure::MeanNormalDeviation, {} };
  for (const vtkMTNode& node : graph.Nodes)
  {
    measure.Values.push_back(0.1 * node.Level);
  }
  graph.Measures.push_back(measure);
  std::array<std::uint64_t, 2> triangles{ 0, 0 };
  for (const vtkMTView& view : MTViews::MakeRandom(3, 24))
  {
    vtkMTTargetCut::Settings settings;
    settings.ErrorMetric = vtkMTTargetCut::EdgeLength;
    const auto edges = Extract(graph, view, settings);
    settings.ErrorMetric = vtkMTTargetCut::NormalDeviation;
    const auto normals = Extract(graph, view, settings);
    ASSERT_TRUE(MTRandomGraph::IsClosed(graph, normals.Cut));
    EXPECT_LE(normals.PixelError, std::max(1.0, edges.PixelError)) << "the distance is kept to";
    EXPECT_LE(normals.Triangles, edges.Triangles) << "no distance is above an edge length here";
    triangles[0] += normals.Triangles;
    triangles[1] += edges.Triangles;
  }
  std::cout << triangles[0] << " of " << triangles[1] << " triangles\n";
  EXPECT_LT(triangles[0], triangles[1]);
}

TEST(ExtractionView, NoNodeIsRefinedWithoutNeed)
{
  std::size_t nodes = 0;
  const vtkMTGraph graph = MTRandomGraph::Make(8, 200);
  for (const vtkMTView& view : MTViews::MakeRandom(1, 24))
  {
    vtkMTTargetCut::Settings settings;
    settings.PixelError = 0.5;
    const auto result = Extract(graph, view, settings);
    for (std::uint32_t node = 1; node < graph.GetSink(); ++node)
    {
      if (!result.Cut.CanCoarsen(node))
      {
        continue;
      }
      // Coarsened, one of its patches that may be seen would be above the threshold.
      const vtkMTNode& record = graph.Nodes[node];
      bool needed = false;
      for (std::uint32_t k = record.FirstIn; k < record.FirstIn + record.InCount; ++k)
      {
        const std::uint32_t arc = graph.Entering[k];
        needed =
          needed || vtkMTTargetCut::GetPixelError(graph, view, arc, vtkMTTargetCut::Distance) > settings.PixelError;
      }
      EXPECT_TRUE(needed) << "node " << node;
      ++nodes;
    }
  }
  std::cout << nodes << " nodes at the cut\n";
  EXPECT_GT(nodes, 100u);
}

TEST(ExtractionView, SmallerThresholdsRefineTheSameNodesAndMore)
{
  const vtkMTGraph graph = MTRandomGraph::Make(9, 200);
  for (const vtkMTView& view : MTViews::MakeRandom(1, 24))
  {
    vtkMTCut last(graph);
    for (const double pixels : { 10.0, 3.0, 1.0, 0.3, 0.1 })
    {
      vtkMTTargetCut::Settings settings;
      settings.PixelError = pixels;
      const auto result = Extract(graph, view, settings);
      for (std::uint32_t node = 0; node < graph.Nodes.size(); ++node)
      {
        ASSERT_TRUE(!last.IsRefined(node) || result.Cut.IsRefined(node));
      }
      last = result.Cut;
    }
  }
}

TEST(ExtractionView, NoPointOfACulledPatchIsInTheFrustum)
{
  const vtkMTGraph graph = MTRandomGraph::Make(10, 200);
  std::size_t points = 0;
  std::size_t culled = 0;
  for (const vtkMTView& view : MTViews::MakeRandom(1, 24))
  {
    vtkMTTargetCut::Settings settings;
    const auto result = Extract(graph, view, settings);
    for (const std::uint32_t arc : result.Cut.GetArcs())
    {
      if (std::binary_search(result.Arcs.begin(), result.Arcs.end(), arc))
      {
        continue;
      }
      ++culled;
      double box[6];
      graph.Lattice.ToWorld(graph.Arcs[arc].Box, box);
      for (int i = 0; i < 125; ++i)
      {
        const double t[3] = { (i % 5) / 4.0, (i / 5 % 5) / 4.0, (i / 25) / 4.0 };
        std::array<double, 3> x;
        for (int k = 0; k < 3; ++k)
        {
          x[k] = box[2 * k] + t[k] * (box[2 * k + 1] - box[2 * k]);
        }
        const std::array<double, 3> eye = view.ToEye(x);
        const double scale = view.ParallelProjection ? 1.0 : -eye[2];
        const bool inside = -eye[2] > view.Near && -eye[2] < view.Far && std::abs(eye[0]) < view.HalfSize[0] * scale &&
          std::abs(eye[1]) < view.HalfSize[1] * scale;
        EXPECT_FALSE(inside);
        ++points;
      }
    }
    EXPECT_EQ(result.ArcsCulled + result.Arcs.size(), result.ArcsInCut);
  }
  std::cout << culled << " culled patches, " << points << " points tested\n";
  EXPECT_GT(culled, 100u);
}

TEST(ExtractionView, CullingOffDrawsTheSameCutWhole)
{
  const vtkMTGraph graph = MTRandomGraph::Make(12, 200);
  for (const vtkMTView& view : MTViews::MakeRandom(1, 24))
  {
    vtkMTTargetCut::Settings settings;
    const auto culled = Extract(graph, view, settings);
    settings.FrustumCulling = false;
    const auto whole = Extract(graph, view, settings);
    EXPECT_EQ(whole.Arcs.size(), whole.ArcsInCut);
    EXPECT_EQ(whole.NodesRefined, culled.NodesRefined);
    EXPECT_TRUE(std::includes(whole.Arcs.begin(), whole.Arcs.end(), culled.Arcs.begin(), culled.Arcs.end()));
  }
}

TEST(ExtractionView, BudgetCountsWhatIsDrawnAndIsUsed)
{
  const vtkMTGraph graph = MTRandomGraph::Make(13, 2000);
  double mean = 0.0;
  for (const vtkMTArc& arc : graph.Arcs)
  {
    mean += static_cast<double>(arc.Triangles) / static_cast<double>(graph.Arcs.size());
  }
  double least = 1.0;
  int short_ = 0;
  for (const vtkMTView& view : MTViews::MakeRandom(1, 24))
  {
    for (const double patches : { 50.0, 100.0, 300.0 })
    {
      vtkMTTargetCut::Settings settings;
      settings.PixelError = 0.02;
      settings.TriangleLimit = static_cast<std::uint64_t>(patches * mean);
      const auto result = Extract(graph, view, settings);
      ASSERT_TRUE(MTRandomGraph::IsClosed(graph, result.Cut));
      std::uint64_t triangles = 0;
      for (const std::uint32_t arc : result.Arcs)
      {
        triangles += graph.Arcs[arc].Triangles;
      }
      EXPECT_EQ(result.Triangles, triangles);
      EXPECT_LE(result.Triangles, settings.TriangleLimit);
      if (!result.Converged)
      {
        const double used = static_cast<double>(triangles) / static_cast<double>(settings.TriangleLimit);
        least = std::min(least, used);
        EXPECT_GE(used, 0.9);
        ++short_;
      }
    }
  }
  std::cout << short_ << " budgets too small for the error, the least use of them is " << least << "\n";
  EXPECT_GT(short_, 10);
}

TEST(ExtractionView, KeptCutIsShownAsItWasExtracted)
{
  const vtkMTGraph graph = MTRandomGraph::Make(14, 200);
  vtkMTTargetCut extraction;
  for (const vtkMTView& view : MTViews::MakeRandom(1, 24))
  {
    vtkMTTargetCut::Settings settings;
    settings.PixelError = 0.5;
    vtkMTTargetCut::Input input;
    input.Graph = &graph;
    input.Views = { view };
    const auto result = extraction.Extract(input, settings);
    const auto shown = extraction.View(result.Cut, input, settings);
    EXPECT_EQ(shown.Arcs, result.Arcs);
    EXPECT_EQ(shown.Triangles, result.Triangles);
    EXPECT_EQ(shown.PixelError, result.PixelError);
    EXPECT_EQ(shown.NodesRefined, result.NodesRefined);
    EXPECT_EQ(shown.Converged, result.Converged);
  }
}

TEST(ExtractionView, OutOfSightNothingIsRefinedOrDrawn)
{
  const vtkMTGraph graph = MTRandomGraph::Make(15, 100);
  const vtkMTView view = MTViews::LookAt(0.5, 0.5, 0.5, 3.0); // upwards
  const auto result = Extract(graph, view, vtkMTTargetCut::Settings());
  EXPECT_EQ(result.NodesRefined, 0u);
  EXPECT_TRUE(result.Arcs.empty());
  EXPECT_EQ(result.Triangles, 0u);
  EXPECT_EQ(result.PixelError, 0.0);
  EXPECT_TRUE(result.Converged);
}

// One cut for several views, of which each one alone asks for another.
TEST(ExtractionViews, CutOfSeveralIsAsFineAsThatOfEachAndNoFinerThanNeeded)
{
  const vtkMTGraph graph = MTRandomGraph::Make(16, 300);
  const std::vector<vtkMTView> views = MTViews::MakeRandom(2, 40);
  std::size_t finer = 0;
  std::size_t shared = 0;
  for (std::size_t i = 0; i < views.size(); ++i)
  {
    vtkMTTargetCut::Settings settings;
    settings.PixelError = 0.3;
    vtkMTTargetCut::Input input;
    input.Graph = &graph;
    input.Views = { views[i], views[(i + 7) % views.size()], views[(i + 16) % views.size()] };
    input.Views.resize(i % 4 == 0 ? 3 : 2);
    vtkMTTargetCut extraction;
    const auto together = extraction.Extract(input, settings);
    ASSERT_TRUE(MTRandomGraph::IsClosed(graph, together.Cut));
    EXPECT_TRUE(together.Converged);
    vtkMTCut needed(graph);
    double largest = 0.0;
    for (const vtkMTView& view : input.Views)
    {
      const auto alone = Extract(graph, view, settings);
      for (std::uint32_t node = 1; node < graph.GetSink(); ++node)
      {
        ASSERT_TRUE(!alone.Cut.IsRefined(node) || together.Cut.IsRefined(node)) << "node " << node;
        finer += together.Cut.IsRefined(node) && !alone.Cut.IsRefined(node) ? 1 : 0;
        if (alone.Cut.IsRefined(node))
        {
          needed.RefineWithDependencies(node);
        }
      }
      // What this view shows of the cut is drawn, and within the error.
      const auto seen = vtkMTTargetCut().View(together.Cut, { &graph, { view } }, settings);
      EXPECT_TRUE(seen.Converged);
      EXPECT_TRUE(std::includes(together.Arcs.begin(), together.Arcs.end(), seen.Arcs.begin(), seen.Arcs.end()));
      largest = std::max(largest, seen.PixelError);
      shared += seen.Arcs.size();
    }
    EXPECT_EQ(together.PixelError, largest);
    EXPECT_EQ(needed.GetArcs(), together.Cut.GetArcs());
    for (const std::uint32_t arc : together.Arcs)
    {
      EXPECT_TRUE(std::any_of(input.Views.begin(), input.Views.end(),
        [&](const vtkMTView& view) { return vtkMTTargetCut::IsVisible(graph, view, arc); }));
    }
    EXPECT_EQ(together.ArcsCulled + together.Arcs.size(), together.ArcsInCut);
  }
  std::cout << finer << " nodes that one of the views alone would not refine, " << shared << " patches seen\n";
  EXPECT_GT(finer, 100u);
}

TEST(ExtractionViews, SameViewTwiceIsThatView)
{
  const vtkMTGraph graph = MTRandomGraph::Make(17, 200);
  for (const vtkMTView& view : MTViews::MakeRandom(3, 24))
  {
    vtkMTTargetCut::Settings settings;
    settings.PixelError = 0.5;
    settings.TriangleLimit = 3000;
    settings.FacingCulling = true;
    vtkMTTargetCut extraction;
    const auto once = extraction.Extract({ &graph, { view } }, settings);
    const auto twice = extraction.Extract({ &graph, { view, view } }, settings);
    EXPECT_EQ(once.Arcs, twice.Arcs);
    EXPECT_EQ(once.PixelError, twice.PixelError);
    EXPECT_EQ(once.ArcsFacingAway, twice.ArcsFacingAway);
  }
}
}
