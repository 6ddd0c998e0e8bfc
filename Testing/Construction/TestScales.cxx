// SPDX-License-Identifier: BSD-3-Clause
// The size and the place of a model have no influence on what is made of it.
#include "MTTestMeshes.h"

#include "vtkMTPatchStore.h"
#include "vtkMTPolyDataStream.h"
#include "vtkMTValidate.h"
#include "vtkMultiTriangulationBuilder.h"

#include "vtkNew.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

namespace
{
// Places with 20 bits, so that they stay what they are at any of the offsets below.
vtkSmartPointer<vtkPolyData> MakeInput(double scale, double offset)
{
  std::vector<MTTestMeshes::Place> places;
  std::vector<MTTestMeshes::Corners> triangles;
  MTTestMeshes::MakeIcosphere(4, places, triangles);
  for (auto& place : places)
  {
    const double bump = 1.0 + 0.05 * MTTestMeshes::Bumps(place, 3);
    for (double& x : place)
    {
      x = (std::nearbyint(std::ldexp(x * bump, 19)) * 0x1p-19 + offset) * scale;
    }
  }
  return MTTestMeshes::Make(places, triangles, VTK_DOUBLE);
}

void Build(vtkPolyData* input, vtkMTPatchStore& store)
{
  vtkNew<vtkMultiTriangulationBuilder> builder;
  builder->SetPatchTriangles(200);
  vtkMTPolyDataStream stream(input);
  ASSERT_TRUE(builder->Build(stream, store)) << builder->GetErrorMessage();
}
}

TEST(Scales, PowersOfTwoAndOffsetsGiveTheSameTopologyAndTheSameErrorsUpToTheScale)
{
  vtkMTPatchStore plain;
  ASSERT_NO_FATAL_FAILURE(Build(MakeInput(1.0, 0.0), plain));
  const vtkMTGraph& expected = plain.GetGraph();
  // 2^100 is 1.3e30; 5400000 is a northing in UTM, in units of the model's size.
  const std::pair<double, double> cases[] = { { 0x1p-100, 0.0 }, { 0x1p100, 0.0 }, { 1.0, 5400000.0 },
    { 0x1p-100, 4096.0 }, { 0x1p100, -65536.0 } };
  for (const auto& [scale, offset] : cases)
  {
    SCOPED_TRACE("scale " + std::to_string(std::log2(scale)) + ", offset " + std::to_string(offset));
    vtkMTPatchStore store;
    ASSERT_NO_FATAL_FAILURE(Build(MakeInput(scale, offset), store));
    const vtkMTGraph& graph = store.GetGraph();
    ASSERT_EQ(graph.Nodes.size(), expected.Nodes.size());
    ASSERT_EQ(graph.Arcs.size(), expected.Arcs.size());
    EXPECT_EQ(graph.Lattice.Step, expected.Lattice.Step * scale);
    for (std::size_t n = 0; n < graph.Nodes.size(); ++n)
    {
      EXPECT_EQ(graph.Nodes[n].OwnError, expected.Nodes[n].OwnError * scale);
      EXPECT_EQ(graph.Nodes[n].Error, expected.Nodes[n].Error * scale);
    }
    for (std::uint32_t arc = 0; arc < graph.Arcs.size(); ++arc)
    {
      vtkMTPatch a;
      vtkMTPatch b;
      std::string error;
      ASSERT_TRUE(store.ReadPatch(arc, nullptr, a, error) && plain.ReadPatch(arc, nullptr, b, error)) << error;
      EXPECT_EQ(a.Triangles, b.Triangles);
      EXPECT_EQ(a.Ids, b.Ids);
      EXPECT_EQ(a.Points, b.Points);
    }
  }
}

// Where the scale is no power of two the lattice is another one in units of the model, up to twice as coarse.
TEST(Scales, OtherScalesGiveModelsOfTheSameQuality)
{
  vtkMTPatchStore plain;
  ASSERT_NO_FATAL_FAILURE(Build(MakeInput(1.0, 0.0), plain));
  for (const double scale : { 1e-300, 1e-30, 1e30, 1e300 })
  {
    vtkMTPatchStore store;
    ASSERT_NO_FATAL_FAILURE(Build(MakeInput(scale, 0.0), store));
    const double ratio = store.GetGraph().Nodes[1].OwnError / scale / plain.GetGraph().Nodes[1].OwnError;
    std::printf("scale %g: error of the coarsest node %.3f of that at scale 1\n", scale, ratio);
    EXPECT_TRUE(vtkMTValidate::All(store, 20, 1).IsValid());
    EXPECT_EQ(store.GetGraph().GetNumberOfFinestTriangles(), plain.GetGraph().GetNumberOfFinestTriangles());
    EXPECT_NEAR(ratio, 1.0, 0.3);
    for (const vtkMTArc& arc : store.GetGraph().Arcs)
    {
      EXPECT_TRUE(std::isfinite(arc.MeanEdgeLength)); // a float, in a file that refuses what is not finite
    }
  }
}
