// SPDX-License-Identifier: BSD-3-Clause
// Squares and hexagons: every level of a model has its exact share of nodes and of triangles.
#include "MTTestMeshes.h"

#include "vtkMTHexagonPartition.h"
#include "vtkMTPatchStore.h"
#include "vtkMTPolyDataStream.h"
#include "vtkMTQuadPartition.h"
#include "vtkMTValidate.h"
#include "vtkMultiTriangulationBuilder.h"

#include "vtkNew.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

namespace
{
// By level from 1 on: its nodes, and the triangles of their fragments.
struct Levels
{
  std::vector<double> Nodes;
  std::vector<double> Triangles;
};

Levels Build(vtkPolyData* mesh, vtkMTPartitionStrategy* strategy)
{
  vtkNew<vtkMultiTriangulationBuilder> builder;
  builder->SetPatchTriangles(100);
  builder->SetPartitionStrategy(strategy);
  vtkMTPatchStore store;
  vtkMTPolyDataStream stream(mesh);
  EXPECT_TRUE(builder->Build(stream, store)) << builder->GetErrorMessage();
  EXPECT_TRUE(vtkMTValidate::All(store, 40, 1).IsValid()) << "and forty random cuts conform";
  const vtkMTGraph& graph = store.GetGraph();
  Levels levels;
  for (std::uint32_t node = 0; node < graph.Nodes.size(); ++node)
  {
    const std::uint32_t level = graph.Nodes[node].Level;
    if (node == graph.GetSource() || node == graph.GetSink())
    {
      continue;
    }
    levels.Nodes.resize(std::max<std::size_t>(levels.Nodes.size(), level), 0.0);
    levels.Triangles.resize(levels.Nodes.size(), 0.0);
    ++levels.Nodes[level - 1];
    for (const std::uint32_t arc : graph.GetEntering(node))
    {
      levels.Triangles[level - 1] += graph.Arcs[arc].Triangles;
    }
  }
  std::cout << strategy->GetSettings() << ":";
  for (std::size_t i = 0; i < levels.Nodes.size(); ++i)
  {
    std::cout << " " << levels.Nodes[i] << " (" << levels.Triangles[i] << ")";
  }
  std::cout << "\n";
  return levels;
}

// Of all levels whose next coarser one has so many nodes at least.
void ExpectRatios(const std::vector<double>& nodes, const std::vector<double>& values, double least, double ratio)
{
  int steps = 0;
  for (std::size_t i = 0; i + 1 < values.size() && nodes[i + 1] >= least; ++i, ++steps)
  {
    EXPECT_NEAR(values[i] / values[i + 1], ratio, 0.05) << "from level " << i + 1;
  }
  EXPECT_GE(steps, 2);
}
}

TEST(DomainLevels, QuadsHalveExactly)
{
  const Levels sphere = Build(MTTestMeshes::FractalSphere(5), vtkNew<vtkMTQuadPartition>());
  ExpectRatios(sphere.Nodes, sphere.Nodes, 3.0, 2.0);
  ExpectRatios(sphere.Nodes, sphere.Triangles, 1.0, 2.0);
  // In terrain a region may be so flat that what is left of it is a sliver, which its neighbours take.
  const Levels terrain = Build(MTTestMeshes::Terrain(128, 128), vtkNew<vtkMTQuadPartition>());
  ExpectRatios(terrain.Nodes, terrain.Triangles, 1.0, 2.0);
  EXPECT_NEAR(std::log2(terrain.Nodes.front()), std::round(std::log2(terrain.Nodes.front())), 0.1);
}

TEST(DomainLevels, HexagonsDivideByThree)
{
  for (const auto& mesh : { MTTestMeshes::FractalSphere(5), MTTestMeshes::Terrain(128, 128) })
  {
    const Levels levels = Build(mesh, vtkNew<vtkMTHexagonPartition>());
    ExpectRatios(levels.Nodes, levels.Triangles, 1.0, 3.0);
  }
}
