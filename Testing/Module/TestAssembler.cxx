// SPDX-License-Identifier: BSD-3-Clause
#include "MTTestMeshes.h"
#include "MTTestModel.h"
#include "vtkMTAssembler.h"
#include "vtkMTCut.h"
#include "vtkMTValidate.h"

#include <gtest/gtest.h>

#include <cstring>
#include <map>
#include <set>

namespace
{
std::vector<vtkMTArrayInfo> OneFloatPerWedge()
{
  std::vector<vtkMTArrayInfo> arrays(2);
  arrays[0].Name = "u";
  arrays[1].Name = "cell";
  arrays[1].Type = VTK_INT;
  arrays[1].Association = vtkMTArrayInfo::Cell;
  return arrays;
}

template <typename T>
vtkMTColumn ToColumn(const std::vector<T>& values)
{
  vtkMTColumn column(values.size() * sizeof(T));
  std::memcpy(column.data(), values.data(), column.size());
  return column;
}

template <typename T>
std::vector<T> FromColumn(const vtkMTColumn& column)
{
  std::vector<T> values(column.size() / sizeof(T));
  std::memcpy(values.data(), column.data(), column.size());
  return values;
}

// One triangle; the first two points are shared.
vtkMTPatch OneTriangle(std::uint64_t id0, std::uint64_t id1, const vtkMTPoint& apex, const std::vector<float>& u)
{
  vtkMTPatch patch;
  patch.Points = { { 0, 0, 0 }, { 1, 0, 0 }, apex };
  patch.Ids = { id0, id1 };
  patch.Triangles = { { 0, 1, 2 } };
  patch.PointColumns = { ToColumn(u) };
  patch.CellColumns = { ToColumn(std::vector<int>{ apex[1] }) };
  return patch;
}
}

TEST(Assembler, PointsAreOneByIdAndNotByPlace)
{
  vtkMTAssembler assembler(OneFloatPerWedge());
  ASSERT_TRUE(assembler.Add(OneTriangle(10, 11, { 0, 5, 0 }, { 0, 0, 0 })));
  ASSERT_TRUE(assembler.Add(OneTriangle(10, 11, { 0, -5, 0 }, { 0, 0, 0 })));
  ASSERT_TRUE(assembler.Add(OneTriangle(20, 21, { 0, 5, 0 }, { 0, 0, 0 }))) << "coincident, but another sheet";
  const vtkMTPatch& mesh = assembler.GetMesh();
  EXPECT_EQ(mesh.Points.size(), 4u + 3u);
  EXPECT_EQ(mesh.GetNumberOfWedges(), 4u + 3u);
  EXPECT_EQ(mesh.Triangles.size(), 3u);
  EXPECT_EQ(mesh.Ids,
    (std::vector<std::uint64_t>{ 10, 11, vtkMTAssembler::NoId, vtkMTAssembler::NoId, 20, 21, vtkMTAssembler::NoId }));
  EXPECT_EQ(assembler.GetPointMap(), (std::vector<std::uint32_t>{ 4, 5, 6 }));
  EXPECT_EQ(FromColumn<int>(mesh.CellColumns[0]), (std::vector<int>{ 5, -5, 5 }));
  EXPECT_EQ(vtkMTValidate::Mesh(mesh, OneFloatPerWedge()).Violations, 0u);
}

// Triangles of the same three points, the first of which has a wedge of each value.
vtkMTPatch ManyWedges(const std::vector<float>& values)
{
  vtkMTPatch patch;
  patch.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
  patch.Ids = { 10, 11, 12 };
  std::vector<float> u = values;
  patch.WedgePoints.assign(values.size(), 0);
  patch.WedgePoints.insert(patch.WedgePoints.end(), { 1, 2 });
  u.insert(u.end(), { 0.0f, 0.0f });
  const auto others = static_cast<std::uint32_t>(values.size());
  for (std::uint32_t w = 0; w < others; ++w)
  {
    patch.Triangles.push_back({ w, others, others + 1 });
  }
  patch.PointColumns = { ToColumn(u) };
  patch.CellColumns = { ToColumn(std::vector<int>(others, 0)) };
  return patch;
}

TEST(Assembler, WedgesOfAHubAreOneWhenTheirBytesAreEqual)
{
  MTTestMeshes::Random random(1);
  vtkMTAssembler assembler(OneFloatPerWedge());
  std::map<float, std::uint32_t> known; // the values of wedges that were met, in their order
  std::vector<float> expected;
  for (int i = 0; i < 60; ++i)
  {
    std::vector<float> values(1 + random.Below(20));
    for (float& value : values)
    {
      value = static_cast<float>(random.Below(10 + 4 * static_cast<std::uint64_t>(i)));
      expected.push_back(value);
    }
    ASSERT_TRUE(assembler.Add(ManyWedges(values)));
  }
  const vtkMTPatch& mesh = assembler.GetMesh();
  const auto u = FromColumn<float>(mesh.PointColumns[0]);
  ASSERT_EQ(mesh.Triangles.size(), expected.size());
  for (std::size_t t = 0; t < expected.size(); ++t)
  {
    const std::uint32_t wedge = mesh.Triangles[t][0];
    EXPECT_EQ(mesh.WedgePoints[wedge], 0u);
    EXPECT_EQ(u[wedge], expected[t]);
    EXPECT_EQ(known.insert({ expected[t], wedge }).first->second, wedge) << "there are two of one value";
  }
  EXPECT_GT(known.size(), 100u);
  EXPECT_EQ(mesh.GetNumberOfWedges(), known.size() + 2);
}

// Held against all others, they would take half an hour, and the test does not.
TEST(Assembler, AMillionWedgesOfOnePointAreFoundOneByOne)
{
  std::vector<float> values(1000000);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = static_cast<float>(i);
  }
  vtkMTAssembler assembler(OneFloatPerWedge());
  for (int i = 0; i < 2; ++i)
  {
    ASSERT_TRUE(assembler.Add(ManyWedges(values)));
    EXPECT_EQ(assembler.GetMesh().GetNumberOfWedges(), values.size() + 2);
  }
}

TEST(Assembler, WedgesOfOnePointAreOneWhenTheirBytesAreEqual)
{
  vtkMTAssembler assembler(OneFloatPerWedge());
  ASSERT_TRUE(assembler.Add(OneTriangle(10, 11, { 0, 5, 0 }, { 1.0f, 2.0f, 3.0f })));
  ASSERT_TRUE(assembler.Add(OneTriangle(10, 11, { 0, -5, 0 }, { 1.0f, 7.0f, 3.0f }))) << "a seam runs through 11";
  ASSERT_TRUE(assembler.Add(OneTriangle(10, 11, { 0, 9, 0 }, { -0.0f, 7.0f, 3.0f })));
  ASSERT_TRUE(assembler.Add(OneTriangle(10, 11, { 0, 8, 0 }, { 0.0f, 7.0f, 3.0f }))) << "-0 and 0 differ in bytes";
  const vtkMTPatch& mesh = assembler.GetMesh();
  EXPECT_EQ(mesh.Points.size(), 2u + 4u);
  EXPECT_EQ(mesh.GetNumberOfWedges(), 3u + 2u + 4u);
  std::map<std::uint32_t, std::set<std::uint32_t>> wedges;
  for (std::uint32_t w = 0; w < mesh.GetNumberOfWedges(); ++w)
  {
    wedges[mesh.GetPointOfWedge(w)].insert(w);
  }
  EXPECT_EQ(wedges[0].size(), 3u);
  EXPECT_EQ(wedges[1].size(), 2u);
  EXPECT_EQ(mesh.Triangles[1][1], mesh.Triangles[2][1]);
  EXPECT_NE(mesh.Triangles[0][1], mesh.Triangles[1][1]);
}

TEST(Assembler, WithoutTheArrayNoSeamIsSeen)
{
  vtkMTAssembler assembler(OneFloatPerWedge());
  for (float u : { 2.0f, 7.0f })
  {
    vtkMTPatch patch = OneTriangle(10, 11, { 0, 5, 0 }, { 1.0f, u, 3.0f });
    patch.PointColumns[0].clear();
    patch.CellColumns.clear();
    ASSERT_TRUE(assembler.Add(patch));
  }
  EXPECT_EQ(assembler.GetMesh().GetNumberOfWedges(), 4u);
  EXPECT_TRUE(assembler.GetMesh().PointColumns[0].empty());
  EXPECT_TRUE(assembler.GetMesh().CellColumns[0].empty());
}

TEST(Assembler, BrokenPatchesAreRefusedWithAReason)
{
  const vtkMTPatch good = OneTriangle(10, 11, { 0, 5, 0 }, { 1, 2, 3 });
  std::map<std::string, vtkMTPatch> broken;
  broken["two places"] = good;
  broken["two places"].Points[1][2] = 1;
  broken["index"] = good;
  broken["index"].Triangles[0][2] = 3;
  broken["index "] = good;
  broken["index "].WedgePoints = { 0, 1, 99 };
  broken["length"] = good;
  broken["length"].PointColumns[0].pop_back();
  broken["length "] = good;
  broken["length "].CellColumns.clear();
  for (const auto& patch : broken)
  {
    vtkMTAssembler assembler(OneFloatPerWedge());
    ASSERT_TRUE(assembler.Add(good));
    EXPECT_FALSE(assembler.Add(patch.second)) << patch.first;
    EXPECT_NE(
      assembler.GetError().find(patch.first.substr(0, patch.first.find_last_not_of(' ') + 1)), std::string::npos)
      << assembler.GetError();
  }
}

TEST(Assembler, MeshOfACutIsClosedAndHasTheSumOfItsTriangles)
{
  const auto tube = MTTestModel::MakeTube();
  const vtkMTGraph& graph = tube->GetGraph();
  vtkMTCut cut(graph);
  cut.RefineWithDependencies(graph.Arcs[graph.Entering[graph.Nodes.back().FirstIn]].From);
  vtkMTAssembler assembler(graph.Arrays);
  vtkMTPatch patch;
  std::string error;
  std::uint64_t sharedPoints = 0;
  for (std::uint32_t arc : cut.GetArcs())
  {
    ASSERT_TRUE(tube->ReadPatch(arc, nullptr, patch, error));
    ASSERT_TRUE(assembler.Add(patch)) << assembler.GetError();
    sharedPoints += patch.Ids.size();
  }
  const vtkMTPatch mesh = assembler.TakeMesh();
  EXPECT_EQ(mesh.Triangles.size(), cut.GetNumberOfTriangles());
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    const vtkMTTriangle p = mesh.GetPointsOfTriangle(t);
    for (int i = 0; i < 3; ++i)
    {
      ++edges[std::minmax(p[i], p[(i + 1) % 3])];
    }
  }
  for (const auto& edge : edges)
  {
    ASSERT_EQ(edge.second, 2);
  }
  // A torus: V - E + F = 0, which needs every border point to be one point.
  EXPECT_EQ(mesh.Points.size() + mesh.Triangles.size(), edges.size());
  EXPECT_EQ(mesh.GetNumberOfWedges(), mesh.Points.size() / 8 * 9) << "one seam wedge more in every ring";
  EXPECT_GT(sharedPoints, 0u);
  EXPECT_EQ(vtkMTValidate::Mesh(mesh, graph.Arrays).Violations, 0u);
  EXPECT_TRUE(assembler.GetMesh().Triangles.empty()) << "taken";
  ASSERT_TRUE(assembler.Add(patch)) << "and ready for the next mesh";
  EXPECT_EQ(assembler.GetMesh().Triangles.size(), patch.Triangles.size());
}
