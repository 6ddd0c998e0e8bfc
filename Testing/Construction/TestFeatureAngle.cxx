// SPDX-License-Identifier: BSD-3-Clause
// Made normals are split along hard edges, and only there.
#include "MTTestMeshes.h"

#include "vtkMTPatchStore.h"
#include "vtkMTPolyDataStream.h"
#include "vtkMTValidate.h"
#include "vtkMultiTriangulationBuilder.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <string>

namespace
{
using Patches = std::vector<vtkMTPatch>;

void Build(vtkPolyData* input, double angle, vtkMTPatchStore& store, Patches& patches, int threads = 1)
{
  vtkNew<vtkMultiTriangulationBuilder> builder;
  builder->SetPatchTriangles(100);
  builder->SetFeatureAngle(angle);
  builder->SetNumberOfThreads(threads);
  vtkMTPolyDataStream stream(input);
  ASSERT_TRUE(builder->Build(stream, store)) << builder->GetErrorMessage();
  EXPECT_TRUE(vtkMTValidate::All(store, 20, 1).IsValid());
  patches.resize(store.GetGraph().Arcs.size());
  for (std::uint32_t arc = 0; arc < patches.size(); ++arc)
  {
    std::string error;
    ASSERT_TRUE(store.ReadPatch(arc, nullptr, patches[arc], error)) << error;
  }
}

bool AreEqual(const Patches& a, const Patches& b)
{
  bool equal = a.size() == b.size();
  for (std::size_t i = 0; equal && i < a.size(); ++i)
  {
    equal = a[i].Triangles == b[i].Triangles && a[i].Points == b[i].Points && a[i].Ids == b[i].Ids &&
      a[i].WedgePoints == b[i].WedgePoints && a[i].PointColumns == b[i].PointColumns;
  }
  return equal;
}

// The angle, as a cosine, between a triangle and the normal of one of its corners; made normals are the last array.
double GetCosine(const vtkMTPatch& patch, std::size_t t, std::size_t c)
{
  std::array<double, 3> x[3];
  for (std::size_t k = 0; k < 3; ++k)
  {
    const vtkMTPoint& p = patch.Points[patch.GetPointsOfTriangle(t)[k]];
    x[k] = { double(p[0]), double(p[1]), double(p[2]) };
  }
  std::array<double, 3> n{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    n[i] = (x[1][j] - x[0][j]) * (x[2][k] - x[0][k]) - (x[1][k] - x[0][k]) * (x[2][j] - x[0][j]);
  }
  float normal[3];
  std::memcpy(normal, patch.PointColumns.back().data() + patch.Triangles[t][c] * sizeof(normal), sizeof(normal));
  return (n[0] * normal[0] + n[1] * normal[1] + n[2] * normal[2]) / std::hypot(n[0], n[1], n[2]);
}

// A cube with cells x cells squares on each side, without normals, whose points are shared along its edges.
vtkSmartPointer<vtkPolyData> MakeCube(int cells)
{
  std::vector<MTTestMeshes::Place> places;
  std::vector<MTTestMeshes::Corners> triangles;
  for (int side = 0; side < 6; ++side)
  {
    for (int i = 0; i < cells; ++i)
    {
      for (int j = 0; j < cells; ++j)
      {
        const auto base = static_cast<vtkIdType>(places.size());
        for (const auto& [u, v] : { std::pair(i, j), { i + 1, j }, { i + 1, j + 1 }, { i, j + 1 } })
        {
          MTTestMeshes::Place place;
          place[side % 3] = side < 3 ? cells : 0;
          place[(side + 1) % 3] = side < 3 ? u : v;
          place[(side + 2) % 3] = side < 3 ? v : u;
          places.push_back(place);
        }
        triangles.push_back({ base, base + 1, base + 2 });
        triangles.push_back({ base, base + 2, base + 3 });
      }
    }
  }
  return MTTestMeshes::Make(places, triangles, VTK_DOUBLE);
}

vtkSmartPointer<vtkPolyData> MakeSphere()
{
  std::vector<MTTestMeshes::Place> places;
  std::vector<MTTestMeshes::Corners> triangles;
  MTTestMeshes::MakeIcosphere(4, places, triangles);
  return MTTestMeshes::Make(places, triangles, VTK_DOUBLE);
}
}

TEST(FeatureAngle, ACubeIsCadAndItsTrianglesHaveTheNormalsOfTheirSidesOnAllLevels)
{
  for (const int cells : { 1, 20 })
  {
    vtkMTPatchStore store;
    Patches patches;
    ASSERT_NO_FATAL_FAILURE(
      Build(MakeCube(cells), vtkMultiTriangulationBuilder::AutomaticFeatureAngle, store, patches));
    EXPECT_EQ(store.GetGraph().Settings.at("feature_angle"), "30");
    std::size_t corners = 0;
    for (const vtkMTPatch& patch : patches)
    {
      for (std::size_t t = 0; t < patch.Triangles.size(); ++t)
      {
        for (std::size_t c = 0; c < 3; ++c, ++corners)
        {
          EXPECT_GT(GetCosine(patch, t, c), 0.999999);
        }
      }
    }
    std::printf("%d cells a side: %zu patches, %zu corners\n", cells, patches.size(), corners);
    EXPECT_GE(corners, 36u * cells * cells);
  }
}

TEST(FeatureAngle, PointsStaySharedWhereNormalsAreSplit)
{
  vtkMTPatchStore store;
  Patches patches;
  ASSERT_NO_FATAL_FAILURE(Build(MakeCube(1), 30.0, store, patches));
  ASSERT_EQ(patches.size(), 1u);
  EXPECT_EQ(patches[0].Points.size(), 8u);
  EXPECT_EQ(patches[0].GetNumberOfWedges(), 24u);
}

TEST(FeatureAngle, ASmoothSurfaceIsTheSameAsWithoutAnyHardEdge)
{
  vtkMTPatchStore automatic;
  vtkMTPatchStore none;
  Patches a;
  Patches b;
  ASSERT_NO_FATAL_FAILURE(Build(MakeSphere(), vtkMultiTriangulationBuilder::AutomaticFeatureAngle, automatic, a));
  ASSERT_NO_FATAL_FAILURE(Build(MakeSphere(), 180.0, none, b));
  EXPECT_EQ(automatic.GetGraph().Settings, none.GetGraph().Settings);
  EXPECT_EQ(none.GetGraph().Settings.at("feature_angle"), "180");
  EXPECT_TRUE(AreEqual(a, b));
}

TEST(FeatureAngle, ThreadsHaveNoInfluence)
{
  vtkMTPatchStore one;
  vtkMTPatchStore three;
  Patches a;
  Patches b;
  ASSERT_NO_FATAL_FAILURE(Build(MakeCube(30), 30.0, one, a, 1));
  ASSERT_NO_FATAL_FAILURE(Build(MakeCube(30), 30.0, three, b, 3));
  EXPECT_TRUE(AreEqual(a, b));
}

TEST(FeatureAngle, OfZeroEveryTriangleOfASphereIsFlat)
{
  vtkMTPatchStore store;
  Patches patches;
  ASSERT_NO_FATAL_FAILURE(Build(MakeSphere(), 0.0, store, patches));
  const vtkMTGraph& graph = store.GetGraph();
  for (std::uint32_t arc = 0; arc < patches.size(); ++arc)
  {
    const bool isFinest = graph.Arcs[arc].To + 1 == graph.Nodes.size();
    for (std::size_t t = 0; isFinest && t < patches[arc].Triangles.size(); ++t)
    {
      EXPECT_GT(GetCosine(patches[arc], t, 0), 0.999999);
    }
  }
}

TEST(FeatureAngle, SetterRefusesWhatIsNoNumber)
{
  vtkNew<vtkMultiTriangulationBuilder> builder;
  int errors = 0;
  vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&errors);
  count->SetCallback([](vtkObject*, unsigned long, void* counter, void*) { ++*static_cast<int*>(counter); });
  builder->AddObserver(vtkCommand::ErrorEvent, count);
  builder->SetFeatureAngle(45.0);
  builder->SetFeatureAngle(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(builder->GetFeatureAngle(), 45.0);
  EXPECT_EQ(errors, 1);
  builder->SetFeatureAngle(-7.0);
  EXPECT_EQ(builder->GetFeatureAngle(), vtkMultiTriangulationBuilder::AutomaticFeatureAngle);
  builder->SetFeatureAngle(1000.0);
  EXPECT_EQ(builder->GetFeatureAngle(), 180.0);
}
