// SPDX-License-Identifier: BSD-3-Clause
// What becomes of the input's arrays, ids and normals on the way to the cuts.
#include "MTCuts.h"

#include "vtkMTAssembler.h"
#include "vtkMTCut.h"
#include "vtkMTGraph.h"
#include "vtkMTMadeNormals.h"
#include "vtkMTPatchSource.h"
#include "vtkMTRandomCut.h"
#include "vtkMultiTriangulation.h"
#include "vtkMultiTriangulationBuilder.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>

namespace
{
void MakeSphere(vtkPolyData* output, int resolution)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(resolution);
  sphere->SetPhiResolution(resolution);
  sphere->SetGenerateNormals(false);
  sphere->Update();
  output->ShallowCopy(sphere->GetOutput());
}

// A tube open at both ends, its texture coordinate u running once around: at the seam points have two wedges.
void MakeTube(vtkPolyData* output, int around, int along)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkFloatArray> texture;
  texture->SetName("TCoords");
  texture->SetNumberOfComponents(2);
  const double pi = std::acos(-1.0);
  for (int j = 0; j <= along; ++j)
  {
    for (int i = 0; i <= around; ++i)
    {
      const double angle = 2.0 * pi * (i % around) / around;
      points->InsertNextPoint(std::cos(angle), std::sin(angle), 4.0 * j / along);
      texture->InsertNextTuple2(static_cast<double>(i) / around, static_cast<double>(j) / along);
    }
  }
  for (int j = 0; j < along; ++j)
  {
    for (int i = 0; i < around; ++i)
    {
      const vtkIdType a = static_cast<vtkIdType>(j) * (around + 1) + i;
      const vtkIdType c = a + around + 1;
      const vtkIdType t1[3] = { a, a + 1, c + 1 };
      const vtkIdType t2[3] = { a, c + 1, c };
      triangles->InsertNextCell(3, t1);
      triangles->InsertNextCell(3, t2);
    }
  }
  output->SetPoints(points);
  output->SetPolys(triangles);
  output->GetPointData()->SetTCoords(texture);
}

std::shared_ptr<const vtkMTPatchSource> Build(vtkPolyData* input, int patchTriangles)
{
  vtkNew<vtkMultiTriangulationBuilder> builder;
  builder->SetInputData(input);
  builder->SetPatchTriangles(patchTriangles);
  builder->Update();
  EXPECT_EQ(builder->GetErrorMessage(), "");
  return vtkMultiTriangulation::SafeDownCast(builder->GetOutputDataObject(0))->GetSource();
}

}

TEST(BuilderArrays, FinestLevelKeepsEveryCellAndValue)
{
  vtkNew<vtkPolyData> input;
  MakeSphere(input, 60);
  vtkNew<vtkUnsignedCharArray> colour;
  colour->SetName("Colour");
  colour->SetNumberOfComponents(4);
  vtkNew<vtkIntArray> label;
  label->SetName("Label");
  for (vtkIdType p = 0; p < input->GetNumberOfPoints(); ++p)
  {
    colour->InsertNextTuple4(p % 256, (p / 7) % 256, (p / 11) % 256, (p / 3) % 256);
  }
  for (vtkIdType c = 0; c < input->GetNumberOfCells(); ++c)
  {
    label->InsertNextValue(static_cast<int>(1000 + c * 3));
  }
  input->GetPointData()->SetScalars(colour);
  input->GetCellData()->AddArray(label);
  const auto source = Build(input, 200);
  const auto finest = MTCuts::GetFinestMesh(*source);
  ASSERT_EQ(finest->GetNumberOfCells(), input->GetNumberOfCells());
  auto* ids = vtkIdTypeArray::SafeDownCast(finest->GetCellData()->GetArray("vtkMTInputCellIds"));
  auto* labels = vtkIntArray::SafeDownCast(finest->GetCellData()->GetArray("Label"));
  auto* colours = vtkUnsignedCharArray::SafeDownCast(finest->GetPointData()->GetScalars());
  ASSERT_TRUE(ids && labels && colours);
  EXPECT_STREQ(colours->GetName(), "Colour");
  std::set<vtkIdType> seen;
  for (vtkIdType c = 0; c < finest->GetNumberOfCells(); ++c)
  {
    const vtkIdType id = ids->GetValue(c);
    EXPECT_TRUE(seen.insert(id).second) << "cell " << id << " twice";
    EXPECT_EQ(labels->GetValue(c), 1000 + id * 3);
    vtkNew<vtkIdList> fineCell;
    vtkNew<vtkIdList> inputCell;
    finest->GetCellPoints(c, fineCell);
    input->GetCellPoints(id, inputCell);
    for (int i = 0; i < 3; ++i)
    {
      double x[3];
      double y[3];
      finest->GetPoint(fineCell->GetId(i), x);
      input->GetPoint(inputCell->GetId(i), y);
      EXPECT_LE(std::sqrt(std::pow(x[0] - y[0], 2) + std::pow(x[1] - y[1], 2) + std::pow(x[2] - y[2], 2)),
        source->GetGraph().Lattice.MaximumShift);
      for (int k = 0; k < 4; ++k)
      {
        EXPECT_EQ(colours->GetTypedComponent(fineCell->GetId(i), k), colour->GetTypedComponent(inputCell->GetId(i), k));
      }
    }
  }
}

TEST(BuilderArrays, MadeNormalsAreOneForEachPointInEveryCut)
{
  vtkNew<vtkPolyData> input;
  MakeSphere(input, 100);
  const auto source = Build(input, 200);
  double worst = 1.0;
  for (std::size_t i = 0; i < 30; ++i)
  {
    const vtkMTCut cut = vtkMTRandomCut::Make(source->GetGraph(), 1, i);
    vtkMTAssembler assembler(source->GetGraph().Arrays);
    std::string error;
    for (std::uint32_t arc : cut.GetArcs())
    {
      vtkMTPatch patch;
      ASSERT_TRUE(source->ReadPatch(arc, nullptr, patch, error)) << error;
      ASSERT_TRUE(assembler.Add(patch)) << assembler.GetError();
    }
    // Wedges of a point are merged when their values are equal bit for bit: none may be left over.
    EXPECT_EQ(assembler.GetMesh().GetNumberOfWedges(), assembler.GetMesh().Points.size());
    const auto mesh = MTCuts::GetMesh(*source, cut);
    vtkDataArray* normals = mesh->GetPointData()->GetNormals();
    ASSERT_TRUE(normals);
    for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
    {
      double x[3];
      double n[3];
      mesh->GetPoint(p, x);
      normals->GetTuple(p, n);
      const double length = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
      worst = std::min(worst, (x[0] * n[0] + x[1] * n[1] + x[2] * n[2]) / length);
    }
  }
  std::printf("least cosine between a normal and the sphere's own: %.4f\n", worst);
  EXPECT_GT(worst, 0.9);
}

// By this a file of theirs is small: the triangles of a patch say what they are, but at points that are shared.
TEST(BuilderArrays, MadeNormalsInsideOfPatchesFollowFromTheirTrianglesOnEveryLevel)
{
  for (const int bits : { 7, 12, 16 })
  {
    vtkNew<vtkPolyData> input;
    MakeSphere(input, 80);
    vtkNew<vtkMultiTriangulationBuilder> builder;
    builder->SetInputData(input);
    builder->SetPatchTriangles(200);
    builder->SetNormalBits(bits);
    builder->Update();
    const auto source = vtkMultiTriangulation::SafeDownCast(builder->GetOutputDataObject(0))->GetSource();
    const vtkMTGraph& graph = source->GetGraph();
    const auto info = std::find_if(graph.Arrays.begin(), graph.Arrays.end(), vtkMTMadeNormals::AreIn);
    ASSERT_NE(info, graph.Arrays.end());
    EXPECT_EQ(vtkMTMadeNormals::GetBits(*info), bits);
    std::size_t inside = 0;
    std::size_t shared = 0;
    std::size_t others = 0;
    for (std::uint32_t arc = 0; arc < graph.Arcs.size(); ++arc)
    {
      vtkMTPatch patch;
      std::string error;
      ASSERT_TRUE(source->ReadPatch(arc, nullptr, patch, error)) << error;
      ASSERT_TRUE(patch.WedgePoints.empty());
      std::vector<vtkMTMadeNormals::Sum> sums;
      vtkMTMadeNormals::GetSums(patch, true, sums);
      for (std::size_t p = 0; p < patch.Points.size(); ++p)
      {
        std::array<float, 3> normal;
        std::memcpy(normal.data(), patch.PointColumns[0].data() + p * sizeof(normal), sizeof(normal));
        EXPECT_EQ(vtkMTMadeNormals::GetNormal(vtkMTMadeNormals::GetPlace(normal, bits), bits), normal)
          << "is on the net";
        const bool follows = vtkMTMadeNormals::GetNormal(vtkMTMadeNormals::GetPlace(sums[p], bits), bits) == normal;
        (p < patch.Ids.size() ? shared : inside) += 1;
        others += !follows && p >= patch.Ids.size() ? 1 : 0;
      }
    }
    std::printf("%d bits: %zu inside, %zu shared, %zu inside do not follow\n", bits, inside, shared, others);
    EXPECT_GT(inside, shared);
    EXPECT_EQ(others, 0u);
  }
}

TEST(BuilderArrays, BitsOfNormalsAreClamped)
{
  vtkNew<vtkMultiTriangulationBuilder> builder;
  EXPECT_EQ(builder->GetNormalBits(), 12);
  builder->SetNormalBits(1);
  EXPECT_EQ(builder->GetNormalBits(), vtkMTMadeNormals::MinimumBits);
  builder->SetNormalBits(99);
  EXPECT_EQ(builder->GetNormalBits(), vtkMTMadeNormals::MaximumBits);
}

TEST(BuilderArrays, LabelsAndIdsAreNeverMixed)
{
  vtkNew<vtkPolyData> input;
  MakeSphere(input, 80);
  vtkNew<vtkIntArray> label;
  label->SetName("Label");
  for (vtkIdType p = 0; p < input->GetNumberOfPoints(); ++p)
  {
    label->InsertNextValue(input->GetPoint(p)[2] > 0.0 ? 1000000 : -7);
  }
  input->GetPointData()->AddArray(label);
  const auto source = Build(input, 100);
  const auto coarse = MTCuts::GetMesh(*source, vtkMTCut(source->GetGraph()));
  auto* labels = vtkIntArray::SafeDownCast(coarse->GetPointData()->GetArray("Label"));
  ASSERT_TRUE(labels);
  for (vtkIdType p = 0; p < coarse->GetNumberOfPoints(); ++p)
  {
    EXPECT_TRUE(labels->GetValue(p) == 1000000 || labels->GetValue(p) == -7) << labels->GetValue(p);
  }
}

TEST(BuilderArrays, SeamStaysASeamAndDoesNotCrack)
{
  vtkNew<vtkPolyData> input;
  MakeTube(input, 120, 160);
  const auto source = Build(input, 300);
  const vtkMTGraph& graph = source->GetGraph();
  EXPECT_GE(graph.GetNumberOfLevels(), 5u);
  double widest = 0.0;
  for (std::size_t i = 0; i < 40; ++i)
  {
    const auto mesh = MTCuts::GetMesh(*source, i == 0 ? vtkMTCut(graph) : vtkMTRandomCut::Make(graph, 2, i));
    vtkDataArray* texture = mesh->GetPointData()->GetTCoords();
    ASSERT_TRUE(texture);
    for (vtkIdType c = 0; c < mesh->GetNumberOfCells(); ++c)
    {
      vtkNew<vtkIdList> cell;
      mesh->GetCellPoints(c, cell);
      double least = 1.0;
      double most = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        const double u = texture->GetComponent(cell->GetId(k), 0);
        least = std::min(least, u);
        most = std::max(most, u);
      }
      widest = std::max(widest, most - least);
    }
  }
  std::printf("widest triangle in u over 40 cuts: %.3f; root %llu triangles\n", widest,
    static_cast<unsigned long long>(graph.GetNumberOfRootTriangles()));
  EXPECT_LT(widest, 0.5); // a triangle that mixed the seam's sides would span nearly 1
}
