// SPDX-License-Identifier: BSD-3-Clause
// What is certified of each patch by itself, for each direction.
#include "MTTestMeshes.h"

#include "vtkMTCut.h"
#include "vtkMTGraph.h"
#include "vtkMTPatchSource.h"
#include "vtkMTRandomCut.h"
#include "vtkMultiTriangulation.h"
#include "vtkMultiTriangulationBuilder.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <vector>

namespace
{
std::shared_ptr<const vtkMTPatchSource> Build(vtkPolyData* mesh)
{
  vtkNew<vtkMultiTriangulationBuilder> builder;
  builder->SetInputData(mesh);
  builder->SetPatchTriangles(200);
  builder->Update();
  return vtkMultiTriangulation::SafeDownCast(builder->GetOutput())->GetSource();
}
}

TEST(ArcDistances, TheLargestOfANodesPatchesIsItsError)
{
  const auto source = Build(MTTestMeshes::FractalSphere(5));
  const vtkMTGraph& graph = source->GetGraph();
  ASSERT_TRUE(graph.HasArcDistances());
  double sum[2] = { 0.0, 0.0 };
  int patches = 0;
  for (std::uint32_t node = 1; node < graph.GetSink(); ++node)
  {
    double largest = 0.0;
    for (const std::uint32_t arc : graph.GetEntering(node))
    {
      largest = std::max({ largest, double(graph.Arcs[arc].ToInput), double(graph.Arcs[arc].FromInput) });
      EXPECT_LE(graph.GetDistanceToInput(arc), graph.Nodes[node].Error);
      EXPECT_LE(graph.GetDistanceFromInput(arc), graph.Nodes[node].Error);
      EXPECT_GE(graph.GetDistanceFromInput(arc), graph.Lattice.MaximumShift);
      sum[0] += graph.GetDistanceToInput(arc) / graph.Nodes[node].Error;
      sum[1] += graph.GetDistanceFromInput(arc) / graph.Nodes[node].Error;
      ++patches;
    }
    EXPECT_NEAR(largest * graph.Lattice.Step, graph.Nodes[node].OwnError, 1e-12 * graph.Nodes[node].OwnError);
  }
  std::cout << patches << " patches; their own distances are " << sum[0] / patches << " (to the input) and "
            << sum[1] / patches << " (from it) of their nodes' errors on average\n";
  EXPECT_LT(sum[0] / patches, 0.95);
  EXPECT_LT(sum[1] / patches, 0.95);
  for (const std::uint32_t arc : graph.GetEntering(graph.GetSink()))
  {
    EXPECT_EQ(graph.GetDistanceToInput(arc), graph.Lattice.MaximumShift);
    EXPECT_EQ(graph.GetDistanceFromInput(arc), graph.Lattice.MaximumShift);
  }
}

TEST(ArcDistances, OfACutAreTheLargestOfItsPatchesAndNeverAboveItsError)
{
  const auto source = Build(MTTestMeshes::FractalSphere(4));
  const vtkMTGraph& graph = source->GetGraph();
  double ratio = 0.0;
  constexpr int Cuts = 200;
  for (int i = 0; i < Cuts; ++i)
  {
    const vtkMTCut cut = vtkMTRandomCut::Make(graph, 7, static_cast<std::size_t>(i));
    double toInput = 0.0;
    double fromInput = 0.0;
    for (const std::uint32_t arc : cut.GetArcs())
    {
      toInput = std::max(toInput, graph.GetDistanceToInput(arc));
      fromInput = std::max(fromInput, graph.GetDistanceFromInput(arc));
    }
    ASSERT_EQ(cut.GetDistanceToInput(), toInput);
    ASSERT_EQ(cut.GetDistanceFromInput(), fromInput);
    ASSERT_LE(std::max(toInput, fromInput), cut.GetError());
    ratio += std::max(toInput, fromInput) / cut.GetError() / Cuts;
  }
  std::cout << "the larger one is " << ratio << " of the error on average\n";
}
