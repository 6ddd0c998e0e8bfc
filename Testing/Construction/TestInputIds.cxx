// SPDX-License-Identifier: BSD-3-Clause
// Which patches have the input's ids, and that they are the input's.
#include "MTCuts.h"
#include "MTTestMeshes.h"

#include "vtkMTCut.h"
#include "vtkMTGraph.h"
#include "vtkMTPatchStore.h"
#include "vtkMTPolyDataStream.h"
#include "vtkMTRandomCut.h"
#include "vtkMTValidate.h"
#include "vtkMultiTriangulationBuilder.h"

#include <gtest/gtest.h>

#include <cstring>
#include <iostream>
#include <set>
#include <string>

namespace
{
using Builder = vtkMultiTriangulationBuilder;

void Build(vtkPolyData* input, int ids, bool pointIds, vtkMTPatchStore& store)
{
  vtkNew<Builder> builder;
  builder->SetPatchTriangles(200);
  builder->SetInputIds(ids);
  builder->SetInputPointIds(pointIds);
  vtkMTPolyDataStream stream(input);
  ASSERT_TRUE(builder->Build(stream, store)) << builder->GetErrorMessage();
}

int FindRole(const vtkMTGraph& graph, vtkMTArrayInfo::RoleType role)
{
  for (std::size_t i = 0; i < graph.Arrays.size(); ++i)
  {
    if (graph.Arrays[i].Role == role)
    {
      return static_cast<int>(i);
    }
  }
  return -1;
}

vtkIdTypeArray* GetIds(vtkDataSetAttributes* attributes, const char* name)
{
  return vtkIdTypeArray::SafeDownCast(attributes->GetArray(name));
}

// The square of the largest distance between points of the mesh and of the input that have the same id.
double GetLargestShift2(vtkPolyData* mesh, vtkPolyData* input)
{
  vtkIdTypeArray* ids = GetIds(mesh->GetPointData(), "vtkMTInputPointIds");
  double largest = 0.0;
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    if (ids->GetValue(p) >= 0)
    {
      double x[3];
      double y[3];
      mesh->GetPoint(p, x);
      input->GetPoint(ids->GetValue(p), y);
      largest = std::max(largest, vtkMath::Distance2BetweenPoints(x, y));
    }
  }
  return largest;
}
}

// What is kept has no influence on anything else, so that figures of one kind of model hold for the others.
TEST(InputIds, AreOnTheLevelsThatWereAskedForAndChangeNothingElse)
{
  const auto input = MTTestMeshes::FractalSphere(4);
  vtkMTPatchStore none;
  Build(input, Builder::NoInputIds, false, none);
  ASSERT_EQ(FindRole(none.GetGraph(), vtkMTArrayInfo::InputCellIds), -1);
  for (const int ids : { Builder::FinestInputIds, Builder::AllInputIds })
  {
    vtkMTPatchStore store;
    Build(input, ids, true, store);
    const vtkMTGraph& graph = store.GetGraph();
    EXPECT_TRUE(vtkMTValidate::All(store, 20, 1).IsValid());
    ASSERT_EQ(graph.Arcs.size(), none.GetGraph().Arcs.size());
    std::size_t withIds = 0;
    for (std::uint32_t arc = 0; arc < graph.Arcs.size(); ++arc)
    {
      vtkMTPatch patch;
      vtkMTPatch other;
      std::string error;
      ASSERT_TRUE(store.ReadPatch(arc, nullptr, patch, error) && none.ReadPatch(arc, nullptr, other, error)) << error;
      ASSERT_EQ(patch.CellColumns.size(), 1u);
      ASSERT_EQ(patch.PointColumns.size(), 2u); // ids and normals
      const bool isFinest = graph.IsFinest(arc);
      const bool has = isFinest || ids == Builder::AllInputIds;
      EXPECT_EQ(patch.CellColumns[0].size(), has ? patch.Triangles.size() * sizeof(vtkIdType) : 0u);
      EXPECT_EQ(patch.PointColumns[0].size(), isFinest ? patch.GetNumberOfWedges() * sizeof(vtkIdType) : 0u);
      EXPECT_TRUE(patch.Points == other.Points && patch.Triangles == other.Triangles);
      EXPECT_EQ(patch.PointColumns[1], other.PointColumns[0]);
      withIds += patch.CellColumns[0].empty() ? 0 : 1;
    }
    std::cout << withIds << " of " << graph.Arcs.size() << " patches have ids of cells\n";
  }
}

TEST(InputIds, OnTheFinestLevelAreThoseOfTheInputsCellsAndPoints)
{
  const auto input = MTTestMeshes::FractalSphere(4);
  vtkMTPatchStore store;
  Build(input, Builder::FinestInputIds, true, store);
  const auto mesh = MTCuts::GetFinestMesh(store);
  vtkIdTypeArray* cells = GetIds(mesh->GetCellData(), "vtkMTInputCellIds");
  vtkIdTypeArray* points = GetIds(mesh->GetPointData(), "vtkMTInputPointIds");
  ASSERT_TRUE(cells && points);
  std::set<vtkIdType> seen;
  vtkNew<vtkIdList> fine;
  vtkNew<vtkIdList> ofInput;
  for (vtkIdType c = 0; c < mesh->GetNumberOfCells(); ++c)
  {
    seen.insert(cells->GetValue(c));
    mesh->GetCellPoints(c, fine);
    input->GetCellPoints(cells->GetValue(c), ofInput);
    for (int i = 0; i < 3; ++i)
    {
      EXPECT_EQ(points->GetValue(fine->GetId(i)), ofInput->GetId(i));
    }
  }
  EXPECT_EQ(seen.size(), static_cast<std::size_t>(input->GetNumberOfCells()));
  EXPECT_EQ(mesh->GetNumberOfPoints(), input->GetNumberOfPoints());
}

TEST(InputIds, OfPointsThatWereStitchedAreTheLeast)
{
  const auto soup = MTTestMeshes::SphereSoup(3);
  vtkMTPatchStore store;
  Build(soup, Builder::FinestInputIds, true, store);
  vtkMTPatchStore without;
  Build(soup, Builder::FinestInputIds, false, without);
  const auto mesh = MTCuts::GetFinestMesh(store);
  EXPECT_EQ(mesh->GetNumberOfPoints(), MTCuts::GetFinestMesh(without)->GetNumberOfPoints()) << "ids make no wedges";
  vtkIdTypeArray* points = GetIds(mesh->GetPointData(), "vtkMTInputPointIds");
  std::set<vtkIdType> ids;
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    ids.insert(points->GetValue(p));
  }
  EXPECT_EQ(ids.size(), static_cast<std::size_t>(mesh->GetNumberOfPoints()));
  EXPECT_LE(GetLargestShift2(mesh, soup), std::pow(store.GetGraph().Lattice.MaximumShift, 2));
  std::map<std::array<double, 3>, vtkIdType> least;
  for (vtkIdType p = 0; p < soup->GetNumberOfPoints(); ++p)
  {
    std::array<double, 3> x;
    soup->GetPoint(p, x.data());
    least.emplace(x, p);
  }
  for (const vtkIdType id : ids)
  {
    std::array<double, 3> x;
    soup->GetPoint(id, x.data());
    EXPECT_EQ(least[x], id);
  }
}

// A mesh of several levels has the array, complete where the finest level is, and is conforming by its points.
TEST(InputIds, OfMixedCutsAreTheInputsOrMinusOne)
{
  const auto input = MTTestMeshes::FractalSphere(4);
  vtkMTPatchStore store;
  Build(input, Builder::FinestInputIds, true, store);
  const vtkMTGraph& graph = store.GetGraph();
  vtkIdType known = 0;
  vtkIdType all = 0;
  for (std::size_t i = 0; i < 24; ++i)
  {
    const vtkMTCut cut = i == 0 ? vtkMTCut(graph) : vtkMTRandomCut::Make(graph, 3, i);
    const auto mesh = MTCuts::GetMesh(store, cut);
    vtkIdTypeArray* cells = GetIds(mesh->GetCellData(), "vtkMTInputCellIds");
    vtkIdTypeArray* points = GetIds(mesh->GetPointData(), "vtkMTInputPointIds");
    ASSERT_TRUE(cells && points);
    vtkIdType cell = 0;
    vtkNew<vtkIdList> corners;
    for (const std::uint32_t arc : cut.GetArcs())
    {
      for (const vtkIdType end = cell + graph.Arcs[arc].Triangles; cell < end; ++cell)
      {
        EXPECT_EQ(cells->GetValue(cell) >= 0, graph.IsFinest(arc));
        mesh->GetCellPoints(cell, corners);
        for (int k = 0; k < 3 && graph.IsFinest(arc); ++k)
        {
          EXPECT_GE(points->GetValue(corners->GetId(k)), 0);
        }
        known += graph.IsFinest(arc) ? 1 : 0;
        ++all;
      }
    }
    EXPECT_LE(GetLargestShift2(mesh, input), std::pow(graph.Lattice.MaximumShift, 2));
    const MTTestMeshes::EdgeFigures edges = MTTestMeshes::CountEdges(mesh, false);
    EXPECT_EQ(edges.Open, 0) << "an id splits no point";
  }
  std::cout << known << " of " << all << " triangles of mixed cuts have ids\n";
  EXPECT_GT(known, all / 10);
  EXPECT_LT(known, all);
}

// The planted faults: a coarse patch with ids, a fine one without.
TEST(InputIds, ThatAreWhereTheyMustNotBeOrMissingAreFound)
{
  vtkMTPatchStore store;
  Build(MTTestMeshes::FractalSphere(3), Builder::FinestInputIds, false, store);
  const vtkMTGraph& graph = store.GetGraph();
  ASSERT_TRUE(vtkMTValidate::All(store, 2, 1).IsValid());
  for (const bool isFinest : { false, true })
  {
    std::uint32_t arc = 0;
    while (graph.IsFinest(arc) != isFinest)
    {
      ++arc;
    }
    vtkMTPatch& patch = store.GetMutablePatches()[arc];
    const vtkMTPatch good = patch;
    patch.CellColumns[0].assign(isFinest ? 0 : patch.Triangles.size() * sizeof(vtkIdType), 0);
    EXPECT_FALSE(vtkMTValidate::Patch(graph, arc, patch).IsValid());
    patch = good;
    EXPECT_TRUE(vtkMTValidate::Patch(graph, arc, patch).IsValid());
  }
}
