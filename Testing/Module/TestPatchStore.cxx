// SPDX-License-Identifier: BSD-3-Clause
#include "MTTestModel.h"
#include "vtkMTPatchStore.h"

#include <gtest/gtest.h>

namespace
{
vtkMTPatch Numbered(std::int32_t number)
{
  vtkMTPatch patch;
  patch.Points = { { number, 0, 0 }, { 0, number, 0 }, { 0, 0, number } };
  patch.Triangles = { { 0, 1, 2 } };
  return patch;
}
}

TEST(PatchStore, FinishGivesEveryArcItsPatch)
{
  vtkMTGraph graph;
  graph.Nodes.resize(3);
  for (const auto& ends : { std::make_pair(1u, 2u), std::make_pair(0u, 2u), std::make_pair(0u, 1u) })
  {
    vtkMTArc arc;
    arc.From = ends.first;
    arc.To = ends.second;
    graph.Arcs.push_back(arc);
  }
  const std::vector<std::uint32_t> patchOfArc = graph.Index();
  vtkMTPatchStore store;
  ASSERT_TRUE(store.Begin({}));
  for (std::int32_t i = 0; i < 3; ++i)
  {
    ASSERT_TRUE(store.WritePatch(Numbered(i + 1)));
  }
  ASSERT_TRUE(store.Finish(graph, patchOfArc));
  vtkMTPatch patch;
  std::string error;
  const std::int32_t expected[3] = { 3, 2, 1 }; // 0-1, 0-2, 1-2
  for (std::uint32_t arc = 0; arc < 3; ++arc)
  {
    ASSERT_TRUE(store.ReadPatch(arc, nullptr, patch, error));
    EXPECT_EQ(patch.Points[0][0], expected[arc]);
    EXPECT_EQ(store.GetPatchSize(arc), patch.GetMemorySize());
  }
  EXPECT_FALSE(store.ReadPatch(3, nullptr, patch, error));
  EXPECT_TRUE(patch.Points.empty());
  EXPECT_FALSE(error.empty());
}

TEST(PatchStore, PatchesThatDoNotBelongToArcsOneToOneAreRefused)
{
  vtkMTGraph graph;
  graph.Nodes.resize(2);
  graph.Arcs.resize(2);
  graph.Arcs[0].To = graph.Arcs[1].To = 1;
  graph.Index();
  for (const std::vector<std::uint32_t>& wrong : { std::vector<std::uint32_t>{ 0 }, { 0, 0 }, { 0, 7 }, { 0, 1, 2 } })
  {
    vtkMTPatchStore store;
    store.Begin({});
    store.WritePatch(Numbered(1));
    store.WritePatch(Numbered(2));
    EXPECT_FALSE(store.Finish(graph, wrong));
    EXPECT_FALSE(store.GetError().empty());
    EXPECT_TRUE(store.GetGraph().IsEmpty()) << "nothing of the model remains";
  }
}

TEST(PatchStore, OnlyTheArraysAskedForAreRead)
{
  const auto tube = MTTestModel::MakeTube();
  vtkMTPatch all;
  vtkMTPatch some;
  std::string error;
  ASSERT_TRUE(tube->ReadPatch(0, nullptr, all, error));
  const std::vector<unsigned char> second{ 0, 1, 0 };
  ASSERT_TRUE(tube->ReadPatch(0, &second, some, error));
  EXPECT_TRUE(some.PointColumns[0].empty());
  EXPECT_EQ(some.PointColumns[1], all.PointColumns[1]);
  EXPECT_TRUE(some.CellColumns[0].empty());
  EXPECT_EQ(some.Triangles, all.Triangles);
  EXPECT_EQ(some.Ids, all.Ids);
  const std::vector<unsigned char> wrong{ 1 };
  EXPECT_FALSE(tube->ReadPatch(0, &wrong, some, error));
}

TEST(Patch, FiguresCountOnlyWhatTrianglesUse)
{
  vtkMTPatch patch;
  patch.Points = { { 3, 0, 0 }, { 0, 4, 0 }, { 0, 0, 0 }, { 1000, 1000, 1000 } };
  EXPECT_EQ(patch.GetMeanEdgeLength(), 0.0);
  EXPECT_GT(patch.GetBox()[0], patch.GetBox()[1]);
  patch.WedgePoints = { 2, 0, 1, 2 };
  patch.Triangles = { { 0, 1, 2 } };
  EXPECT_EQ(patch.GetBox(), (vtkMTBox{ 0, 3, 0, 4, 0, 0 }));
  EXPECT_DOUBLE_EQ(patch.GetMeanEdgeLength(), 4.0);
  EXPECT_EQ(patch.GetPointsOfTriangle(0), (vtkMTTriangle{ 2, 0, 1 }));
}
