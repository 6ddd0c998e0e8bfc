// SPDX-License-Identifier: BSD-3-Clause
#include "MTTestModel.h"
#include "vtkMTCut.h"
#include "vtkMTRandomCut.h"

#include <gtest/gtest.h>

#include <iostream>
#include <set>

namespace
{
using Ends = std::pair<std::uint32_t, std::uint32_t>;

/**
 * Figure 1 of the BMT paper: g3 depends on D0, g1 and g2; g4 on g1 alone. Node 0 is D0, node 5 the sink; the number of
 * an arc's triangles is 10 from + to.
 */
vtkMTGraph PaperGraph()
{
  vtkMTGraph graph;
  graph.Nodes.resize(6);
  const std::uint32_t levels[] = { 4, 3, 2, 1, 1, 0 };
  for (int i = 0; i < 6; ++i)
  {
    graph.Nodes[i].Level = levels[i];
    graph.Nodes[i].OwnError = levels[i];
  }
  for (const Ends& ends :
    { Ends{ 0, 1 }, { 0, 2 }, { 0, 3 }, { 0, 5 }, { 1, 3 }, { 1, 4 }, { 2, 3 }, { 2, 5 }, { 3, 5 }, { 4, 5 } })
  {
    vtkMTArc arc;
    arc.From = ends.first;
    arc.To = ends.second;
    arc.Triangles = 10 * arc.From + arc.To;
    arc.Box = { 0, 1, 0, 1, 0, 1 };
    graph.Arcs.push_back(arc);
  }
  graph.Index();
  graph.Saturate(0.5);
  return graph;
}

std::set<Ends> GetEnds(const vtkMTGraph& graph, const vtkMTCut& cut)
{
  std::set<Ends> ends;
  for (std::uint32_t arc : cut.GetArcs())
  {
    ends.insert({ graph.Arcs[arc].From, graph.Arcs[arc].To });
  }
  return ends;
}

// The figures that the cut keeps are those of its arcs; every path from source to sink has one arc in the cut.
void ExpectConsistent(const vtkMTGraph& graph, const vtkMTCut& cut)
{
  const std::vector<std::uint32_t> arcs = cut.GetArcs();
  std::uint64_t triangles = 0;
  for (std::uint32_t arc : arcs)
  {
    triangles += graph.Arcs[arc].Triangles;
    ASSERT_TRUE(cut.Contains(arc));
  }
  ASSERT_EQ(triangles, cut.GetNumberOfTriangles());
  ASSERT_EQ(arcs.size(), cut.GetNumberOfArcs());
  ASSERT_TRUE(cut.IsRefined(graph.GetSource()));
  ASSERT_FALSE(cut.IsRefined(graph.GetSink()));
  for (const vtkMTArc& arc : graph.Arcs)
  {
    ASSERT_TRUE(cut.IsRefined(arc.From) || !cut.IsRefined(arc.To)) << "not closed under dependency";
  }
}
}

TEST(Cut, RefiningTheArc23OfThePaperRefinesArc01AsWell)
{
  const vtkMTGraph graph = PaperGraph();
  vtkMTCut cut(graph);
  EXPECT_EQ(GetEnds(graph, cut), (std::set<Ends>{ { 0, 1 }, { 0, 2 }, { 0, 3 }, { 0, 5 } }));
  EXPECT_TRUE(cut.Refine(2));
  EXPECT_EQ(GetEnds(graph, cut), (std::set<Ends>{ { 0, 1 }, { 0, 3 }, { 0, 5 }, { 2, 3 }, { 2, 5 } }));
  EXPECT_FALSE(cut.CanRefine(3)) << "g3 depends on g1";
  EXPECT_EQ(cut.RefineWithDependencies(3), 2u);
  EXPECT_EQ(GetEnds(graph, cut), (std::set<Ends>{ { 0, 5 }, { 1, 4 }, { 2, 5 }, { 3, 5 } }));
  ExpectConsistent(graph, cut);
}

TEST(Cut, IllegalOperationsDoNothing)
{
  const vtkMTGraph graph = PaperGraph();
  vtkMTCut cut(graph);
  const std::set<Ends> before = GetEnds(graph, cut);
  for (std::uint32_t node : { 0u, 3u, 4u, 5u })
  {
    EXPECT_FALSE(cut.CanRefine(node)) << node;
    EXPECT_FALSE(cut.Refine(node)) << node;
  }
  for (std::uint32_t node = 0; node < 6; ++node)
  {
    EXPECT_FALSE(cut.CanCoarsen(node)) << node;
    EXPECT_FALSE(cut.Coarsen(node)) << node;
  }
  EXPECT_EQ(cut.RefineWithDependencies(5), 0u) << "the sink";
  EXPECT_EQ(cut.RefineWithDependencies(0), 0u) << "the source";
  EXPECT_EQ(GetEnds(graph, cut), before);

  EXPECT_EQ(cut.RefineWithDependencies(4), 2u);
  EXPECT_FALSE(cut.Coarsen(1)) << "g4 depends on it";
  EXPECT_TRUE(cut.Coarsen(4));
  EXPECT_TRUE(cut.Coarsen(1));
  EXPECT_EQ(GetEnds(graph, cut), before);
  ExpectConsistent(graph, cut);
}

TEST(Cut, ErrorIsThatOfItsWorstArc)
{
  const vtkMTGraph graph = PaperGraph();
  vtkMTCut cut(graph);
  EXPECT_EQ(cut.GetError(), graph.Nodes[1].Error);
  cut.RefineWithDependencies(3);
  EXPECT_EQ(cut.GetError(), graph.Nodes[4].Error);
  cut.RefineWithDependencies(4);
  EXPECT_EQ(cut.GetError(), 0.5);
  EXPECT_EQ(cut.GetNumberOfTriangles(), graph.GetNumberOfFinestTriangles());
}

TEST(Cut, RandomCutsAreClosedAndHalfOfThemSpanThreeLevels)
{
  const auto tube = MTTestModel::MakeTube({ 1024, 8, 64 });
  const vtkMTGraph& graph = tube->GetGraph();
  std::size_t wide = 0;
  std::set<std::vector<std::uint32_t>> different;
  const std::size_t count = 400;
  for (std::size_t i = 0; i < count; ++i)
  {
    const vtkMTCut cut = vtkMTRandomCut::Make(graph, 5, i);
    ExpectConsistent(graph, cut);
    wide += vtkMTRandomCut::GetLevelSpan(graph, cut) >= 3 ? 1 : 0;
    different.insert(cut.GetArcs());
    EXPECT_EQ(cut.GetArcs(), vtkMTRandomCut::Make(graph, 5, i).GetArcs()) << "the same for the same seed";
  }
  std::cout << count << " cuts, " << different.size() << " different, " << wide << " span three levels or more\n";
  EXPECT_GE(2 * wide, count);
  EXPECT_GE(different.size(), count * 3 / 4);
  EXPECT_NE(vtkMTRandomCut::Make(graph, 6, 1).GetArcs(), vtkMTRandomCut::Make(graph, 5, 1).GetArcs());
}

TEST(Cut, EmptyModelHasTheEmptyCut)
{
  const vtkMTGraph graph;
  const vtkMTCut cut(graph);
  EXPECT_TRUE(cut.GetArcs().empty());
  EXPECT_EQ(cut.GetError(), 0.0);
  EXPECT_EQ(vtkMTRandomCut::GetLevelSpan(graph, vtkMTRandomCut::Make(graph, 1, 3)), 0u);
}
