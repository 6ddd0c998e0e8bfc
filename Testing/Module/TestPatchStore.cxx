// SPDX-License-Identifier: BSD-3-Clause
#include "MTTestModel.h"
#include "vtkMTPatchStore.h"

#include "vtkType.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <type_traits>

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

TEST(PatchStore, RangesAreThoseOfTheFinestLevel)
{
  const auto model = MTTestModel::MakeTube();
  const vtkMTGraph& graph = model->GetGraph();
  ASSERT_EQ(graph.ArrayRanges.size(), 3u);
  ASSERT_EQ(graph.ArrayRanges[1].size(), 2u);
  // The ids of all input cells are in the finest level, and nowhere else are there as many.
  EXPECT_EQ(graph.ArrayRanges[2][0].Minimum, 0.0);
  EXPECT_EQ(graph.ArrayRanges[2][0].Maximum, static_cast<double>(graph.GetNumberOfFinestTriangles() - 1));
  EXPECT_LT(graph.ArrayRanges[0][0].Minimum, graph.ArrayRanges[0][0].Maximum);
}

TEST(ArrayInfo, RangesAreExactInEveryTypeAndLeaveNaNOut)
{
  const auto column = [](auto... values)
  {
    const std::common_type_t<decltype(values)...> list[] = { values... };
    vtkMTColumn bytes(sizeof(list));
    std::memcpy(bytes.data(), list, sizeof(list));
    return bytes;
  };
  vtkMTArrayInfo array;
  array.Type = VTK_FLOAT;
  array.Components = 2;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::vector<vtkMTRange> ranges = array.GetRanges(column(nan, 3.0f, -0.1f, nan, 7.5f, 3.0f));
  EXPECT_TRUE((ranges[0] == vtkMTRange{ static_cast<double>(-0.1f), 7.5 }));
  EXPECT_TRUE((ranges[1] == vtkMTRange{ 3.0, 3.0 }));
  EXPECT_TRUE(array.GetRanges(column(nan, 1.0f))[0].IsEmpty());
  EXPECT_TRUE(array.GetRanges({})[1].IsEmpty());
  array.Components = 1;
  array.Type = VTK_SIGNED_CHAR;
  ranges = array.GetRanges(column(static_cast<signed char>(-128), static_cast<signed char>(127)));
  EXPECT_TRUE((ranges[0] == vtkMTRange{ -128.0, 127.0 }));
  array.Type = VTK_UNSIGNED_LONG_LONG;
  ranges = array.GetRanges(column(~0ull, 1ull));
  EXPECT_TRUE((ranges[0] == vtkMTRange{ 1.0, 0x1p64 }));
  array.Type = VTK_INT;
  array.Role = vtkMTArrayInfo::ExactPoints;
  EXPECT_TRUE(array.GetRanges(column(1, 2))[0].IsEmpty());
}
