// SPDX-License-Identifier: BSD-3-Clause
// What lies so far away that it would coarsen the lattice for everything else.
#include "MTTestMeshes.h"

#include "vtkMTBuildSettings.h"
#include "vtkMTCertifiedMesh.h"
#include "vtkMTFarOutliers.h"
#include "vtkMTInputMesh.h"
#include "vtkMTMemorySpoolStore.h"
#include "vtkMTPolyDataStream.h"
#include "vtkMTSequenceState.h"
#include "vtkMTVoronoiPartition.h"

#include "vtkCellArray.h"
#include "vtkPoints.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

namespace
{
constexpr int Bits = 24;

// A mesh with one of its vertices, or more, moved far away.
vtkSmartPointer<vtkPolyData> MakeSphere(const std::vector<vtkIdType>& moved, double place)
{
  auto mesh = MTTestMeshes::FractalSphere(4); // 5120 triangles
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->DeepCopy(mesh->GetPoints());
  for (vtkIdType p : moved)
  {
    points->SetPoint(p, place, 0.0, 0.0);
  }
  mesh->SetPoints(points);
  return mesh;
}

struct Input
{
  std::map<std::string, std::int64_t> Report;
  std::uint64_t InputTriangles = 0;
  std::uint64_t Triangles = 0;
  vtkMTLattice Lattice;
  std::string Warning;
  std::size_t CellIds = 0; // of all fragments
};

bool Read(vtkPolyData* mesh, Input& input, std::string& error, bool keep = false, int bits = Bits)
{
  const vtkNew<vtkMTVoronoiPartition> partition;
  vtkMTMemorySpoolStore store;
  vtkMTBuildSettings settings;
  settings.LatticeBits = bits;
  settings.MakeNormals = false;
  settings.KeepFarOutliers = keep;
  settings.Partition = partition;
  settings.Store = &store;
  vtkMTPolyDataStream stream(mesh);
  vtkMTSequenceState state;
  vtkMTInputMesh reader(settings);
  input = Input();
  const bool read = reader.Read(stream, state);
  error = reader.GetError();
  input.Warning = reader.GetWarning();
  input.Report = state.Graph.InputReport;
  input.InputTriangles = state.Graph.InputCounts.Triangles;
  input.Lattice = state.Graph.Lattice;
  for (std::size_t region = 0; read && region < state.Fragments.GetNumberOfKeys(); ++region)
  {
    std::vector<vtkMTBytes::Record> records;
    vtkMTCertifiedMesh fragment;
    EXPECT_TRUE(state.Fragments.Take(region, records, error) && !records.empty() && fragment.Decode(records[0], error));
    input.Triangles += fragment.Mesh.Triangles.size();
    input.CellIds += fragment.Mesh.CellColumns[0].size() / sizeof(vtkIdType);
  }
  return read;
}

std::unique_ptr<vtkMTFarOutliers> Find(const std::vector<std::array<double, 3>>& points,
  const std::vector<std::array<std::uint32_t, 3>>& triangles, vtkMTSpoolStore& store)
{
  vtkMTInputBlock block;
  block.Triangles = triangles;
  block.FindPoints();
  for (const std::uint32_t p : block.Points)
  {
    block.Places.push_back(points[p]);
  }
  auto found = std::make_unique<vtkMTFarOutliers>(Bits, store, std::size_t(1) << 20);
  while (!found->IsFinished())
  {
    EXPECT_TRUE(found->Add(block) && found->FinishStep()) << found->GetError();
  }
  return found;
}

std::int64_t CountDropped(const Input& input)
{
  const auto found = input.Report.find("dropped_far_outlier");
  return found == input.Report.end() ? 0 : found->second;
}
}

TEST(FarOutliers, OneVertexFarAwayIsLeftOutAndTheRestKeepsItsLattice)
{
  Input clean;
  std::string error;
  ASSERT_TRUE(Read(MakeSphere({}, 0.0), clean, error)) << error;
  EXPECT_EQ(CountDropped(clean), 0);
  for (const double place : { 1e6, 1e12, 1e38, -1e38, 1e300 })
  {
    const auto mesh = MakeSphere({ 700 }, place);
    Input input;
    ASSERT_TRUE(Read(mesh, input, error)) << error;
    EXPECT_EQ(CountDropped(input), 6) << "the triangles about one vertex";
    EXPECT_EQ(input.Triangles, 5120u - 6u);
    EXPECT_EQ(input.InputTriangles, 5120u);
    EXPECT_EQ(input.Lattice.Step, clean.Lattice.Step) << place;
    EXPECT_NE(input.Warning.find("6 of 5120"), std::string::npos) << input.Warning;
    EXPECT_EQ(input.CellIds, input.Triangles);
    std::printf("%g: %s\n", place, input.Warning.c_str());
  }
}

TEST(FarOutliers, SeveralAtDifferentPlacesAreAllFound)
{
  auto mesh = MakeSphere({ 700 }, 1e38);
  mesh->GetPoints()->SetPoint(300, 0.0, 1e20, 0.0);
  mesh->GetPoints()->SetPoint(1500, 0.0, 0.0, -3e7);
  Input input;
  std::string error;
  ASSERT_FALSE(Read(mesh, input, error)) << "18 triangles are more than 16";
  EXPECT_NE(error.find("18 of 5120"), std::string::npos) << error;
  mesh->GetPoints()->SetPoint(1500, 0.0, 0.0, 0.0);
  ASSERT_TRUE(Read(mesh, input, error)) << error;
  EXPECT_EQ(CountDropped(input), 12);
}

TEST(FarOutliers, MoreThanAFewAreRefusedWithWhatToDo)
{
  std::vector<vtkIdType> many;
  for (vtkIdType p = 200; p < 1200; p += 100)
  {
    many.push_back(p);
  }
  const auto mesh = MakeSphere(many, 1e12);
  Input input;
  std::string error;
  EXPECT_FALSE(Read(mesh, input, error));
  EXPECT_NE(error.find("KeepFarOutliers"), std::string::npos) << error;
  EXPECT_TRUE(Read(mesh, input, error, true)) << error;
  EXPECT_EQ(CountDropped(input), 0);
  EXPECT_EQ(input.Triangles, 5120u);
}

TEST(FarOutliers, WhatDoesNotCoarsenTheLatticeTooMuchStays)
{
  // Edges are about 0.05: a step of 1e3 / 2^24 is fine enough for them.
  Input input;
  std::string error;
  ASSERT_TRUE(Read(MakeSphere({ 700 }, 1e3), input, error)) << error;
  EXPECT_EQ(CountDropped(input), 0);
  EXPECT_EQ(input.Warning, "");
  // And so is 1e6 / 2^31.
  ASSERT_TRUE(Read(MakeSphere({ 700 }, 1e6), input, error, false, 31)) << error;
  EXPECT_EQ(CountDropped(input), 0);
}

TEST(FarOutliers, WhatIsContinuousIsNotTornApart)
{
  // Triangles that grow by a fifth from one to the next, over 15 orders of magnitude: there is no gap.
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  double size = 1.0;
  for (std::uint32_t i = 0; i < 200; ++i, size *= 1.2)
  {
    points.push_back({ size, 0.0, 0.0 });
    points.push_back({ 0.0, size, 0.0 });
    if (i > 0)
    {
      triangles.push_back({ 2 * i - 2, 2 * i, 2 * i - 1 });
      triangles.push_back({ 2 * i, 2 * i + 1, 2 * i - 1 });
    }
  }
  vtkMTMemorySpoolStore store;
  const auto found = Find(points, triangles, store);
  EXPECT_EQ(found->GetNumberOfOutliers(), 0u);
  EXPECT_FALSE(found->IsRefused()) << found->GetMessage();
}

TEST(FarOutliers, SmallThingsScatteredOverAVastSpaceAreBuiltWithAWarning)
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  MTTestMeshes::Random random(1);
  for (std::uint32_t i = 0; i < 1000; ++i)
  {
    const double x = 1e12 * (random.Uniform() - 0.5);
    points.push_back({ x, 0.0, 0.0 });
    points.push_back({ x + 1.0, 0.0, 0.0 });
    points.push_back({ x, 1.0, 0.0 });
    triangles.push_back({ 3 * i, 3 * i + 1, 3 * i + 2 });
  }
  vtkMTMemorySpoolStore store;
  const auto found = Find(points, triangles, store);
  EXPECT_FALSE(found->IsRefused());
  EXPECT_EQ(found->GetNumberOfOutliers(), 0u);
  EXPECT_NE(found->GetMessage(), "");
}
