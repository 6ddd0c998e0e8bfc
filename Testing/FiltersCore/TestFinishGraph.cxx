// SPDX-License-Identifier: BSD-3-Clause
// The records of a build become a graph from coarse to fine, indexed and saturated, with the right patch on every arc.
#include "vtkMTFinishGraph.h"

#include "vtkMTBuildState.h"
#include "vtkMTPatchStore.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace
{
// A patch with so many triangles, all of them the same.
vtkMTPatch MakePatch(std::uint32_t triangles)
{
  vtkMTPatch patch;
  patch.Points = { { 0, 0, 0 }, { 8, 0, 0 }, { 0, 8, 0 } };
  patch.Triangles.assign(triangles, vtkMTTriangle{ 0, 1, 2 });
  return patch;
}

// Two regions of level 1 below one of level 2, recorded from fine to coarse as builders do.
struct Build
{
  vtkMTBuildState State;
  vtkMTPatchStore Sink;

  void Put(std::uint32_t triangles, std::uint32_t from, std::uint32_t to)
  {
    vtkMTPatch patch = MakePatch(triangles);
    vtkMTArc arc;
    arc.Triangles = triangles;
    arc.Points = 3;
    arc.Box = patch.GetBox();
    this->State.Arcs.push_back({ arc, from, to });
    EXPECT_TRUE(this->Sink.WritePatch(std::move(patch)));
  }

  Build()
  {
    constexpr std::uint32_t none = vtkMTBuildState::None;
    this->State.Graph.Lattice.Step = 0.5;
    this->State.Graph.Lattice.MaximumShift = 0.125;
    EXPECT_TRUE(this->Sink.Begin({}));
    this->State.Nodes = { { 1, 10, 4.0, 8.0, 0.5, 0.25 }, { 1, 11, 2.0, 8.0, 0.75, 0.125 },
      { 2, 0, 1.0, 16.0, 0.625, 0.375 } };
    this->Put(40, 0, none);
    this->Put(41, 1, none);
    this->Put(20, 2, 0);
    this->Put(21, 2, 1);
    this->Put(10, none, 2);
  }
};
}

TEST(FinishGraph, NodesGoFromCoarseToFineAndArcsKeepTheirPatches)
{
  Build build;
  std::string error;
  ASSERT_TRUE(vtkMTFinishGraph::Run(build.State, build.Sink, error)) << error;
  const vtkMTGraph& graph = build.Sink.GetGraph();
  ASSERT_EQ(graph.Nodes.size(), 5u);
  EXPECT_EQ(graph.Nodes[0].Level, 3u);
  EXPECT_EQ(graph.Nodes[1].Level, 2u);
  EXPECT_EQ(graph.Nodes[2].Region, 10u);
  EXPECT_EQ(graph.Nodes[3].Region, 11u);
  EXPECT_EQ(graph.Nodes[1].EdgeLength, 8.0) << "model units";
  ASSERT_EQ(graph.Arcs.size(), 5u);
  for (std::uint32_t a = 0; a < graph.Arcs.size(); ++a)
  {
    vtkMTPatch patch;
    ASSERT_TRUE(build.Sink.ReadPatch(a, nullptr, patch, error)) << error;
    EXPECT_EQ(patch.Triangles.size(), graph.Arcs[a].Triangles) << "arc " << a;
    EXPECT_LT(graph.Arcs[a].From, graph.Arcs[a].To);
  }
  EXPECT_EQ(graph.Arcs[0].Triangles, 10u);
  EXPECT_TRUE(build.State.Arcs.empty());
}

TEST(FinishGraph, ErrorsAreSaturatedAndRoundedUp)
{
  Build build;
  std::string error;
  ASSERT_TRUE(vtkMTFinishGraph::Run(build.State, build.Sink, error)) << error;
  const vtkMTGraph& graph = build.Sink.GetGraph();
  std::printf("own %.3f %.3f %.3f, saturated %.3f %.3f %.3f\n", graph.Nodes[1].OwnError, graph.Nodes[2].OwnError,
    graph.Nodes[3].OwnError, graph.Nodes[1].Error, graph.Nodes[2].Error, graph.Nodes[3].Error);
  EXPECT_GT(graph.Nodes[2].OwnError, 2.0) << "rounded up";
  EXPECT_LT(graph.Nodes[2].OwnError, 2.0 + 1e-12);
  for (const vtkMTArc& arc : graph.Arcs)
  {
    EXPECT_GE(graph.Nodes[arc.From].Error, graph.Nodes[arc.To].Error);
  }
  EXPECT_GE(graph.Nodes[1].Error, graph.Nodes[2].Error) << "no less than what is finer";
}

TEST(FinishGraph, NormalDeviationsAreSaturatedMeasures)
{
  Build build;
  std::string error;
  ASSERT_TRUE(vtkMTFinishGraph::Run(build.State, build.Sink, error)) << error;
  const vtkMTGraph& graph = build.Sink.GetGraph();
  const vtkMTMeasure* largest = graph.FindMeasure(vtkMTMeasure::NormalDeviation);
  const vtkMTMeasure* mean = graph.FindMeasure(vtkMTMeasure::MeanNormalDeviation);
  ASSERT_TRUE(largest && mean);
  EXPECT_EQ(graph.FindMeasure("no such"), nullptr);
  EXPECT_EQ(largest->Values, (std::vector<double>{ 0.75, 0.75, 0.5, 0.75, 0.0 })) << "the coarse node has its floor's";
  EXPECT_EQ(mean->Values, (std::vector<double>{ 0.375, 0.375, 0.25, 0.125, 0.0 }));
}

TEST(FinishGraph, InputOfOnePatchIsAnArcFromSourceToSink)
{
  Build build;
  build.State.Nodes.clear();
  build.State.Arcs.clear();
  vtkMTPatchStore sink;
  ASSERT_TRUE(sink.Begin({}));
  ASSERT_TRUE(sink.WritePatch(MakePatch(5)));
  vtkMTArc arc;
  arc.Triangles = 5;
  arc.Box = MakePatch(5).GetBox();
  build.State.Arcs.push_back({ arc, vtkMTBuildState::None, vtkMTBuildState::None });
  std::string error;
  ASSERT_TRUE(vtkMTFinishGraph::Run(build.State, sink, error)) << error;
  ASSERT_EQ(sink.GetGraph().Nodes.size(), 2u);
  EXPECT_EQ(sink.GetGraph().Nodes[0].Level, 1u);
  EXPECT_EQ(sink.GetGraph().Arcs[0].To, sink.GetGraph().GetSink());
}

namespace
{
class FullSink : public vtkMTPatchStore
{
public:
  bool Finish(const vtkMTGraph&, const std::vector<std::uint32_t>&) override
  {
    this->Error = "the disk is full";
    return false;
  }
};
}

TEST(FinishGraph, FailureOfTheSinkIsReported)
{
  Build build;
  FullSink sink;
  std::string error;
  EXPECT_FALSE(vtkMTFinishGraph::Run(build.State, sink, error));
  EXPECT_EQ(error, "the disk is full");
}
