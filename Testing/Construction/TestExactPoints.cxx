// SPDX-License-Identifier: BSD-3-Clause
// Level 0 keeps the input's coordinates bit for bit when it is asked to, at any size and place.
#include "MTCuts.h"
#include "MTTestMeshes.h"

#include "vtkMTCut.h"
#include "vtkMTExactPoints.h"
#include "vtkMTMeshToPolyData.h"
#include "vtkMTPatchStore.h"
#include "vtkMTPolyDataStream.h"
#include "vtkMTValidate.h"
#include "vtkMultiTriangulationBuilder.h"

#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
#include <string>

namespace
{
using MTTestMeshes::Random;

std::uint64_t GetBits(double x)
{
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof(bits));
  return bits;
}

// A bumpy sphere; a tenth of all coordinates are zeros of either sign.
vtkSmartPointer<vtkPolyData> MakeInput(int type, double scale, double offset)
{
  std::vector<MTTestMeshes::Place> places;
  std::vector<MTTestMeshes::Corners> triangles;
  MTTestMeshes::MakeIcosphere(4, places, triangles);
  Random random(2);
  for (auto& place : places)
  {
    const double bump = 1.0 + 0.01 * random.Uniform();
    for (double& x : place)
    {
      x = x * bump * scale + offset;
      x = random.Below(10) == 0 && offset == 0.0 && std::abs(x) < 0.3 * scale ? std::copysign(0.0, x) : x;
    }
  }
  return MTTestMeshes::Make(places, triangles, type);
}

bool Build(vtkPolyData* input, int bits, bool isExact, vtkMTPatchStore& store)
{
  vtkNew<vtkMultiTriangulationBuilder> builder;
  builder->SetPatchTriangles(200);
  builder->SetLatticeBits(bits);
  builder->SetExactPoints(isExact);
  vtkMTPolyDataStream stream(input);
  const bool built = builder->Build(stream, store);
  EXPECT_TRUE(built) << builder->GetErrorMessage();
  return built;
}

// Coordinates of corners that differ from those of the input's triangle, and the largest difference.
std::pair<int, double> CountDifferences(vtkPolyData* input, vtkPolyData* output)
{
  auto* ids = vtkIdTypeArray::SafeDownCast(output->GetCellData()->GetArray("vtkMTInputCellIds"));
  std::pair<int, double> result{ 0, 0.0 };
  for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
  {
    for (int c = 0; c < 3; ++c)
    {
      double x[3];
      double y[3];
      output->GetPoint(output->GetCell(cell)->GetPointId(c), x);
      input->GetPoint(input->GetCell(ids->GetValue(cell))->GetPointId(c), y);
      for (int i = 0; i < 3; ++i)
      {
        result.first += GetBits(x[i]) != GetBits(y[i]) ? 1 : 0;
        result.second = std::max(result.second, std::abs(x[i] - y[i]));
      }
    }
  }
  return result;
}

struct Case
{
  const char* Name;
  int Type;
  double Scale;
  double Offset;
};

const Case Cases[] = { { "float", VTK_FLOAT, 1.0, 0.0 }, { "double", VTK_DOUBLE, 1.0, 0.0 },
  { "float in UTM", VTK_FLOAT, 1000.0, 5.4e6 }, { "double in UTM", VTK_DOUBLE, 1000.0, 5.4e6 },
  { "float of 1e-30", VTK_FLOAT, 1e-30, 0.0 }, { "double of 1e-30", VTK_DOUBLE, 1e-30, 0.0 },
  { "float of 1e30", VTK_FLOAT, 1e30, 0.0 }, { "double of 1e30", VTK_DOUBLE, 1e30, 0.0 },
  { "denormal floats", VTK_FLOAT, 1e-40, 0.0 }, { "denormal doubles", VTK_DOUBLE, 1e-310, 0.0 },
  { "largest floats", VTK_FLOAT, 3.3e38, 0.0 }, { "largest doubles", VTK_DOUBLE, 8e307, 0.0 } };
}

TEST(ExactPoints, FinestLevelGivesTheInputsBitsBack)
{
  for (const Case& c : Cases)
  {
    const auto input = MakeInput(c.Type, c.Scale, c.Offset);
    for (const int bits : { 10, 14, 24, 31 })
    {
      SCOPED_TRACE(std::string(c.Name) + ", " + std::to_string(bits) + " bits");
      vtkMTPatchStore store;
      ASSERT_TRUE(Build(input, bits, true, store));
      const auto finest = MTCuts::GetFinestMesh(store);
      ASSERT_GT(finest->GetNumberOfCells(), input->GetNumberOfCells() / 2); // few bits make slivers degenerate
      EXPECT_EQ(CountDifferences(input, finest).first, 0);
      EXPECT_EQ(finest->GetPoints()->GetDataType(), c.Type);
      EXPECT_EQ(finest->GetPointData()->GetArray("vtkMTExactPoints"), nullptr);
    }
  }
}

TEST(ExactPoints, WithoutThemTheFinestLevelIsOnTheLattice)
{
  const auto input = MakeInput(VTK_FLOAT, 1.0, 0.0);
  vtkMTPatchStore store;
  ASSERT_TRUE(Build(input, 14, false, store));
  const auto finest = MTCuts::GetFinestMesh(store);
  const auto [different, largest] = CountDifferences(input, finest);
  std::printf("%d coordinates differ, by %.3g at most\n", different, largest);
  EXPECT_GT(different, 1000);
  EXPECT_LE(largest, store.GetGraph().Lattice.MaximumShift);
}

// The array costs coarse levels nothing, and changes nothing else: nodes, arcs and patches are those without it.
TEST(ExactPoints, OnlyPatchesOfLevelZeroHaveThem)
{
  const auto input = MakeInput(VTK_FLOAT, 1.0, 0.0);
  vtkMTPatchStore exact;
  vtkMTPatchStore plain;
  ASSERT_TRUE(Build(input, 20, true, exact) && Build(input, 20, false, plain));
  const vtkMTGraph& graph = exact.GetGraph();
  ASSERT_EQ(graph.Arcs.size(), plain.GetGraph().Arcs.size());
  EXPECT_TRUE(vtkMTValidate::All(exact, 20, 1).IsValid());
  for (std::uint32_t arc = 0; arc < graph.Arcs.size(); ++arc)
  {
    vtkMTPatch a;
    vtkMTPatch b;
    std::string error;
    ASSERT_TRUE(exact.ReadPatch(arc, nullptr, a, error) && plain.ReadPatch(arc, nullptr, b, error)) << error;
    ASSERT_EQ(a.PointColumns.size(), 2u);
    EXPECT_EQ(a.PointColumns[0].size(),
      graph.GetLevelOfArc(arc) == 0 ? a.GetNumberOfWedges() * graph.Arrays[0].GetTupleSize() : 0u);
    if (graph.GetLevelOfArc(arc) > 0)
    {
      EXPECT_EQ(a.Points, b.Points);
      EXPECT_EQ(a.Triangles, b.Triangles);
    }
  }
  vtkMTCut mixed(graph);
  while (mixed.GetNumberOfTriangles() < graph.GetNumberOfFinestTriangles() / 2)
  {
    for (std::uint32_t node = 1; node < graph.GetSink(); ++node)
    {
      if (mixed.CanRefine(node))
      {
        mixed.Refine(node);
        break;
      }
    }
  }
  const auto output = MTCuts::GetMesh(exact, mixed);
  EXPECT_EQ(output->GetPoints()->GetDataType(), VTK_DOUBLE);
}

TEST(ExactPoints, PlacesFarFromTheLatticeAreRefused)
{
  vtkMTLattice lattice;
  lattice.MaximumShift = 0.5;
  for (const bool isSingle : { false, true })
  {
    const vtkMTArrayInfo info = vtkMTExactPoints::MakeInfo(isSingle, {});
    vtkMTPatch patch;
    patch.Points = { { 3, -4, 0 } };
    patch.PointColumns.emplace_back(info.GetTupleSize());
    vtkNew<vtkPolyData> output;
    const vtkMTExactPoints::Place near{ 3.25, -4.5, -0.0 };
    vtkMTExactPoints::Encode(info, lattice, patch.Points[0], near, patch.PointColumns[0].data());
    ASSERT_TRUE(vtkMTMeshToPolyData::Convert(patch, lattice, { info }, output));
    for (int i = 0; i < 3; ++i)
    {
      EXPECT_EQ(GetBits(output->GetPoint(0)[i]), GetBits(near[i]));
    }
    for (const double far : { 3.51, 1e30, double(std::numeric_limits<float>::infinity()), std::nan("") })
    {
      vtkMTExactPoints::Encode(
        info, lattice, patch.Points[0], vtkMTExactPoints::Place{ far, -4.0, 0.0 }, patch.PointColumns[0].data());
      EXPECT_FALSE(vtkMTMeshToPolyData::Convert(patch, lattice, { info }, output)) << far;
      EXPECT_EQ(output->GetNumberOfPoints(), 0);
    }
  }
}
