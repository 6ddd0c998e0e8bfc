// SPDX-License-Identifier: BSD-3-Clause
// The simplification filter in a pipeline, and the settings of the simplifier.
#include "SimplificationTesting.h"

#include "vtkErrorCode.h"
#include "vtkMTSimplificationFilter.h"

#include "vtkCallbackCommand.h"
#include "vtkExecutive.h"
#include "vtkFeatureEdges.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

using namespace SimplificationTesting;

namespace
{
vtkIdType CountBorderEdges(vtkPolyData* mesh)
{
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(mesh);
  edges->BoundaryEdgesOn();
  edges->NonManifoldEdgesOn();
  edges->FeatureEdgesOff();
  edges->ManifoldEdgesOff();
  edges->Update();
  return edges->GetOutput()->GetNumberOfCells();
}

void AddArrays(vtkPolyData* mesh)
{
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  vtkNew<vtkDoubleArray> height;
  height->SetName("x");
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double x[3];
    mesh->GetPoint(i, x);
    height->InsertNextValue(x[0]);
    vtkMath::Normalize(x);
    normals->InsertNextTuple(x);
  }
  mesh->GetPointData()->SetNormals(normals);
  mesh->GetPointData()->AddArray(height);
  vtkNew<vtkIntArray> label;
  label->SetName("half");
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    double bounds[6];
    mesh->GetCell(i)->GetBounds(bounds);
    label->InsertNextValue(bounds[0] + bounds[1] > 0.0 ? 1 : 0);
  }
  mesh->GetCellData()->AddArray(label);
}
}

TEST(Filter, ASphereIsHalvedAndStaysClosed)
{
  const auto sphere = MTTestMeshes::FractalSphere(4);
  vtkNew<vtkMTSimplificationFilter> filter;
  filter->SetInputData(sphere);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), sphere->GetNumberOfCells() / 2);
  EXPECT_EQ(CountBorderEdges(filter->GetOutput()), 0);
  filter->SetTargetTriangles(500);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 500);
  EXPECT_EQ(filter->GetNumberOfBlockedEdges(), 0);
}

TEST(Filter, ArraysComeThroughWithTheirMeaning)
{
  const auto sphere = MTTestMeshes::Icosphere(4);
  AddArrays(sphere);
  vtkNew<vtkMTSimplificationFilter> filter;
  filter->SetInputData(sphere);
  filter->SetTargetReduction(0.75);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  vtkDataArray* x = output->GetPointData()->GetArray("x");
  vtkDataArray* normals = output->GetPointData()->GetNormals();
  vtkDataArray* half = output->GetCellData()->GetArray("half");
  ASSERT_TRUE(x && normals && half);
  ASSERT_EQ(x->GetNumberOfTuples(), output->GetNumberOfPoints());
  ASSERT_EQ(half->GetNumberOfTuples(), output->GetNumberOfCells());
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    double p[3];
    output->GetPoint(i, p);
    EXPECT_NEAR(x->GetTuple1(i), p[0], 0.02);
    double n[3];
    normals->GetTuple(i, n);
    EXPECT_NEAR(vtkMath::Norm(n), 1.0, 1e-6);
    EXPECT_GT(vtkMath::Dot(n, p) / vtkMath::Norm(p), 0.999);
  }
  for (vtkIdType i = 0; i < output->GetNumberOfCells(); ++i)
  {
    double bounds[6];
    output->GetCell(i)->GetBounds(bounds);
    const double middle = bounds[0] + bounds[1];
    EXPECT_TRUE(std::abs(middle) < 0.3 || (middle > 0.0) == (half->GetTuple1(i) == 1.0));
  }
}

TEST(Filter, PointsThatStayKeepTheirCoordinatesBitForBit)
{
  const auto terrain = MTTestMeshes::Terrain(40, 40);
  vtkNew<vtkMTSimplificationFilter> filter;
  filter->SetInputData(terrain);
  filter->SetLatticeBits(10);
  filter->Update();
  std::set<std::array<double, 3>> places;
  for (vtkIdType i = 0; i < terrain->GetNumberOfPoints(); ++i)
  {
    std::array<double, 3> p;
    terrain->GetPoint(i, p.data());
    places.insert(p);
  }
  vtkIdType same = 0;
  for (vtkIdType i = 0; i < filter->GetOutput()->GetNumberOfPoints(); ++i)
  {
    std::array<double, 3> p;
    filter->GetOutput()->GetPoint(i, p.data());
    same += static_cast<vtkIdType>(places.count(p));
  }
  EXPECT_GE(same, 4 * 39); // the border is locked
  EXPECT_EQ(CountBorderEdges(filter->GetOutput()), 4 * 39);
}

TEST(Filter, TheBorderIsSimplifiedWhereItIsNotLocked)
{
  vtkNew<vtkMTSimplificationFilter> filter;
  filter->SetInputData(MTTestMeshes::Terrain(40, 40));
  filter->LockBorderOff();
  filter->SetTargetReduction(0.9);
  filter->Update();
  EXPECT_LT(CountBorderEdges(filter->GetOutput()), 2 * 39);
  EXPECT_LE(filter->GetOutput()->GetNumberOfCells(), 39 * 39 * 2 / 10 + 1);
}

TEST(Filter, PolygonsAndStripsAreTriangulated)
{
  for (const auto& mesh : { MTTestMeshes::Quads(20, 20), MTTestMeshes::Strips(20, 20), MTTestMeshes::Polygons(30) })
  {
    vtkNew<vtkMTSimplificationFilter> filter;
    filter->SetInputData(mesh);
    filter->SetTargetReduction(0.0);
    filter->Update();
    EXPECT_GT(filter->GetOutput()->GetNumberOfCells(), mesh->GetNumberOfCells());
    EXPECT_EQ(filter->GetOutput()->GetPolys()->GetMaxCellSize(), 3);
  }
}

TEST(Filter, AnEmptyInputGivesAnEmptyOutput)
{
  vtkNew<vtkPolyData> nothing;
  vtkNew<vtkMTSimplificationFilter> filter;
  filter->SetInputData(nothing);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_EQ(filter->GetErrorCode(), vtkErrorCode::NoError);
}

TEST(Filter, PointsThatAreNoNumbersAreAnError)
{
  const auto sphere = MTTestMeshes::Icosphere(2);
  sphere->GetPoints()->SetPoint(5, std::nan(""), 0.0, 0.0);
  vtkNew<vtkMTSimplificationFilter> filter;
  int errors = 0;
  vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&errors);
  count->SetCallback([](vtkObject*, unsigned long, void* data, void*) { ++*static_cast<int*>(data); });
  filter->AddObserver(vtkCommand::ErrorEvent, count);
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, count);
  filter->SetInputData(sphere);
  filter->Update();
  EXPECT_GT(errors, 0);
  EXPECT_EQ(filter->GetErrorCode(), vtkErrorCode::UserError);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
}

TEST(Settings, ModesAreFoundByTheirNamesOnly)
{
  vtkNew<vtkMTEdgeCollapse> simplifier;
  EXPECT_STREQ(simplifier->GetSimplifierName(), "fast");
  for (const char* name : { "best", "lindstrom-turk", "garland-heckbert", "fast" })
  {
    EXPECT_TRUE(simplifier->SetModeByName(name));
    EXPECT_STREQ(simplifier->GetSimplifierName(), name);
    EXPECT_EQ(simplifier->GetSettings().find(name), 0u);
  }
  EXPECT_FALSE(simplifier->SetModeByName("quick"));
  EXPECT_FALSE(simplifier->SetModeByName(nullptr));
  EXPECT_STREQ(simplifier->GetSimplifierName(), "fast");
  simplifier->SetMode(17);
  EXPECT_STREQ(simplifier->GetSimplifierName(), "garland-heckbert");
}

TEST(Settings, EverySettingIsPartOfTheSettingsText)
{
  vtkNew<vtkMTEdgeCollapse> simplifier;
  std::set<std::string> texts{ simplifier->GetSettings() };
  simplifier->SetComponentBound(0.25);
  texts.insert(simplifier->GetSettings());
  simplifier->SetStepsPerEdge(77);
  texts.insert(simplifier->GetSettings());
  EXPECT_EQ(texts.size(), 3u);
}

TEST(Settings, IndicesOutOfRangeAreAnErrorAndNoCrash)
{
  const vtkMTPatch floor = MakeGrid(5, 5);
  const Locks locked = LockNothing(floor);
  EXPECT_FALSE(Simplify(floor, Locks(3), 10).Ok);
  vtkMTPatch bad = floor;
  bad.Triangles[3][1] = 25;
  const Outcome outcome = Simplify(bad, locked, 10);
  EXPECT_FALSE(outcome.Ok);
  EXPECT_NE(outcome.Error.find("triangle 3"), std::string::npos);
  bad = floor;
  for (std::uint32_t i = 0; i < 25; ++i)
  {
    bad.WedgePoints.push_back(i + 1);
  }
  EXPECT_FALSE(Simplify(bad, locked, 10).Ok);
  EXPECT_TRUE(Simplify(vtkMTPatch(), Locks(), 10).Ok);
}
