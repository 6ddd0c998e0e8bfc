// SPDX-License-Identifier: BSD-3-Clause
// Errors that are held against meshes several levels below.
#include "MTTestMeshes.h"

#include "vtkMTGraph.h"
#include "vtkMTPatchSource.h"
#include "vtkMultiTriangulation.h"
#include "vtkMultiTriangulationBuilder.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <vector>

namespace
{
// The median of the nodes' own errors, by level from 1 on.
std::vector<double> BuildAndGetErrors(vtkPolyData* mesh, int directLevels, bool certifyNormals = false)
{
  vtkNew<vtkMultiTriangulationBuilder> builder;
  builder->SetInputData(mesh);
  builder->SetPatchTriangles(200);
  builder->SetDirectLevels(directLevels);
  builder->SetCertifyNormals(certifyNormals);
  builder->Update();
  const vtkMTGraph& graph = vtkMultiTriangulation::SafeDownCast(builder->GetOutput())->GetSource()->GetGraph();
  std::vector<std::vector<double>> errors(graph.GetNumberOfLevels() + 1);
  for (const vtkMTNode& node : graph.Nodes)
  {
    errors[node.Level].push_back(node.OwnError);
  }
  std::vector<double> medians;
  for (std::size_t level = 1; level + 1 < errors.size(); ++level)
  {
    std::sort(errors[level].begin(), errors[level].end());
    medians.push_back(errors[level].empty() ? 0.0 : errors[level][errors[level].size() / 2]);
  }
  return medians;
}
}

TEST(DirectLevels, ErrorsOfCoarseLevelsAreSmallerTheFartherBelow)
{
  const auto mesh = MTTestMeshes::FractalSphere(5);
  const std::vector<double> sums = BuildAndGetErrors(mesh, 1);
  const std::vector<double> near = BuildAndGetErrors(mesh, 3);
  const std::vector<double> far = BuildAndGetErrors(mesh, 6);
  ASSERT_EQ(sums.size(), far.size());
  ASSERT_EQ(sums.size(), near.size());
  for (std::size_t i = 0; i < sums.size(); ++i)
  {
    std::cout << "level " << i + 1 << ": " << sums[i] << ", 3 levels " << near[i] << ", 6 levels " << far[i] << "\n";
  }
  EXPECT_EQ(sums[0], far[0]) << "one step is what it is";
  EXPECT_LT(near[2], 0.85 * sums[2]);
  EXPECT_LT(far[4], 0.8 * sums[4]);
  EXPECT_LT(far[5], near[5]);
}

TEST(DirectLevels, AreNotUsedWhereNormalsAreCertifiedTogetherWithSums)
{
  const auto mesh = MTTestMeshes::FractalSphere(4);
  EXPECT_EQ(BuildAndGetErrors(mesh, 1, true), BuildAndGetErrors(mesh, 5, true));
  EXPECT_NE(BuildAndGetErrors(mesh, 1), BuildAndGetErrors(mesh, 5));
}

TEST(DirectLevels, AreClamped)
{
  vtkNew<vtkMultiTriangulationBuilder> builder;
  EXPECT_EQ(builder->GetDirectLevels(), 5);
  builder->SetDirectLevels(0);
  EXPECT_EQ(builder->GetDirectLevels(), 1);
  builder->SetDirectLevels(9);
  EXPECT_EQ(builder->GetDirectLevels(), 8);
}
