// SPDX-License-Identifier: BSD-3-Clause
#include "MTGeneralTest.h"

#include "vtkMTGraph.h"
#include "vtkMultiTriangulationCutFilter.h"
#include "vtkMultiTriangulationSection.h"

#include "vtkCutter.h"
#include "vtkErrorCode.h"
#include "vtkPlane.h"
#include "vtkSphere.h"

using namespace MTGeneralTest;

namespace
{
// How many lines come to each place, and how many leave it.
std::map<MTTestMeshes::Place, std::array<int, 2>> CountEnds(vtkPolyData* lines, bool byPlace)
{
  std::map<MTTestMeshes::Place, std::array<int, 2>> ends;
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < lines->GetNumberOfLines(); ++i)
  {
    lines->GetLines()->GetCellAtId(i, ids);
    EXPECT_EQ(ids->GetNumberOfIds(), 2);
    for (int k = 0; k < 2; ++k)
    {
      MTTestMeshes::Place p{ static_cast<double>(ids->GetId(k)), 0.0, 0.0 };
      if (byPlace)
      {
        lines->GetPoint(ids->GetId(k), p.data());
      }
      ++ends[p][k];
    }
  }
  return ends;
}

double GetLength(vtkPolyData* lines)
{
  double sum = 0.0;
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < lines->GetNumberOfLines(); ++i)
  {
    lines->GetLines()->GetCellAtId(i, ids);
    double a[3];
    double b[3];
    lines->GetPoint(ids->GetId(0), a);
    lines->GetPoint(ids->GetId(1), b);
    sum += std::sqrt(vtkMath::Distance2BetweenPoints(a, b));
  }
  return sum;
}

vtkSmartPointer<vtkPlane> MakePlane(MTTestMeshes::Random& random)
{
  auto plane = vtkSmartPointer<vtkPlane>::New();
  double normal[3];
  for (double& x : normal)
  {
    x = random.Uniform(-1.0, 1.0);
  }
  vtkMath::Normalize(normal);
  plane->SetNormal(normal);
  const double shift = random.Uniform(-0.6, 0.6);
  plane->SetOrigin(shift * normal[0], shift * normal[1], shift * normal[2]);
  return plane;
}
}

TEST(Section, ClosedSurfaceGivesClosedLoops)
{
  MTTestMeshes::Random random(5);
  vtkNew<vtkMultiTriangulationSection> section;
  section->SetInputData(GetSphere());
  for (int test = 0; test < 20; ++test)
  {
    const vtkSmartPointer<vtkPlane> plane = MakePlane(random);
    section->SetImplicitFunction(plane);
    section->SetError(test % 2 ? random.Uniform(0.001, 0.05) : 0.0);
    section->Update();
    ASSERT_GT(section->GetOutput()->GetNumberOfLines(), 0);
    for (const auto& end : CountEnds(section->GetOutput(), false))
    {
      ASSERT_EQ(end.second[0], 1) << "test " << test;
      ASSERT_EQ(end.second[1], 1) << "test " << test;
    }
    for (vtkIdType p = 0; p < section->GetOutput()->GetNumberOfPoints(); ++p)
    {
      EXPECT_NEAR(plane->FunctionValue(section->GetOutput()->GetPoint(p)), 0.0, 1e-12);
    }
  }
}

TEST(Section, SeamsAreClosedPlaceByPlace)
{
  vtkNew<vtkMultiTriangulationSection> section;
  section->SetInputData(MakeModel(MTTestModel::MakeTube()));
  vtkNew<vtkPlane> plane;
  plane->SetNormal(0.3, 0.1, 1.0);
  section->SetImplicitFunction(plane);
  section->Update();
  ASSERT_GT(section->GetOutput()->GetNumberOfLines(), 100);
  for (const auto& end : CountEnds(section->GetOutput(), true))
  {
    ASSERT_EQ(end.second[0], 1);
    ASSERT_EQ(end.second[1], 1);
  }
}

TEST(Section, ZeroAtPointsOfTheMeshLeavesNoGap)
{
  // All points of the equator are in the plane.
  vtkNew<vtkMultiTriangulationBuilder> builder;
  builder->SetInputData(MTTestMeshes::Icosphere(4));
  builder->SetPatchTriangles(50);
  vtkNew<vtkMultiTriangulationSection> section;
  section->SetInputConnection(builder->GetOutputPort());
  vtkNew<vtkPlane> plane;
  plane->SetNormal(1.0, 0.0, 0.0);
  section->SetImplicitFunction(plane);
  section->Update();
  ASSERT_GT(section->GetOutput()->GetNumberOfLines(), 0);
  for (const auto& end : CountEnds(section->GetOutput(), false))
  {
    ASSERT_EQ(end.second[0], 1);
    ASSERT_EQ(end.second[1], 1);
  }
}

TEST(Section, IsThatOfTheFinestMeshWhereNoErrorIsAllowed)
{
  MTTestMeshes::Random random(9);
  vtkNew<vtkMultiTriangulationCutFilter> finest;
  finest->SetInputData(GetSphere());
  finest->SetLevel(0);
  for (int test = 0; test < 5; ++test)
  {
    const vtkSmartPointer<vtkPlane> plane = MakePlane(random);
    vtkNew<vtkCutter> cutter;
    cutter->SetInputConnection(finest->GetOutputPort());
    cutter->SetCutFunction(plane);
    cutter->Update();
    vtkNew<vtkMultiTriangulationSection> section;
    section->SetInputData(GetSphere());
    section->SetImplicitFunction(plane);
    section->Update();
    EXPECT_EQ(section->GetOutput()->GetNumberOfLines(), cutter->GetOutput()->GetNumberOfCells());
    EXPECT_NEAR(GetLength(section->GetOutput()), GetLength(cutter->GetOutput()), 1e-5);
  }
}

TEST(Section, LinesHaveTheDistancesOfTheirPatches)
{
  vtkNew<vtkPlane> plane;
  plane->SetNormal(0.3, 0.1, 1.0);
  vtkNew<vtkMultiTriangulationSection> section;
  section->SetInputData(GetSphere());
  section->SetImplicitFunction(plane);
  section->SetError(0.05);
  section->GenerateDistancesOn();
  section->Update();
  for (const char* name : { "DistanceToInput", "DistanceFromInput" })
  {
    vtkDataArray* values = section->GetOutput()->GetCellData()->GetArray(name);
    ASSERT_NE(values, nullptr) << name;
    ASSERT_EQ(values->GetNumberOfTuples(), section->GetOutput()->GetNumberOfLines());
    std::cout << name << " from " << values->GetRange()[0] << " to " << values->GetRange()[1] << ", the section's "
              << section->GetSectionError() << "\n";
    EXPECT_LE(values->GetRange()[1], 0.05);
    EXPECT_LT(values->GetRange()[0], values->GetRange()[1]);
  }
  EXPECT_LE(
    section->GetOutput()->GetCellData()->GetArray("DistanceToInput")->GetRange()[1], section->GetSectionError());
}

TEST(Section, ReadsOnlyWhatItMeets)
{
  MTTestModel::TubeOptions options;
  options.Rings = 16384;
  options.Regions = 1024;
  const auto source = std::make_shared<CountingSource>(MTTestModel::MakeTube(options));
  const auto model = MakeModel(source);
  const int before = source->Reads;
  vtkNew<vtkPlane> plane;
  plane->SetNormal(1.0, 0.02, 0.01);
  vtkNew<vtkMultiTriangulationSection> section;
  section->SetInputData(model);
  section->SetImplicitFunction(plane);
  section->Update();
  const int reads = source->Reads - before;
  std::cout << reads << " of " << model->GetNumberOfPatches() << " patches read, "
            << section->GetOutput()->GetNumberOfLines() << " lines\n";
  EXPECT_EQ(reads, section->GetNumberOfPatches());
  EXPECT_GT(section->GetOutput()->GetNumberOfLines(), 0);
  EXPECT_LT(reads, 0.02 * static_cast<double>(model->GetNumberOfPatches()));
  EXPECT_EQ(section->GetSectionError(), source->GetGraph().Nodes.back().Error) << "the finest level's";
}

TEST(Section, ArraysAreInterpolatedAndIdsAreNot)
{
  vtkNew<vtkMultiTriangulationSection> section;
  section->SetInputData(MakeModel(MTTestModel::MakeTube()));
  vtkNew<vtkSphere> sphere;
  sphere->SetCenter(1.0, 0.0, 0.0);
  sphere->SetRadius(0.35);
  section->SetImplicitFunction(sphere);
  section->Update();
  vtkPolyData* output = section->GetOutput();
  vtkDataArray* height = output->GetPointData()->GetArray("height");
  ASSERT_NE(height, nullptr);
  EXPECT_EQ(height, output->GetPointData()->GetScalars());
  ASSERT_GT(output->GetNumberOfPoints(), 10);
  for (vtkIdType p = 0; p < output->GetNumberOfPoints(); ++p)
  {
    EXPECT_NEAR(height->GetComponent(p, 0), output->GetPoint(p)[2], 1e-6);
  }
  vtkDataArray* cells = output->GetCellData()->GetArray("vtkMTInputCellIds");
  ASSERT_NE(cells, nullptr);
  EXPECT_EQ(cells->GetNumberOfTuples(), output->GetNumberOfLines());
  EXPECT_EQ(cells->GetDataType(), VTK_ID_TYPE);
}

TEST(Section, SaysWhatIsWrong)
{
  vtkNew<vtkMultiTriangulationSection> section;
  Events errors(section);
  section->SetInputData(GetSphere());
  section->Update();
  EXPECT_EQ(section->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::UserError));
  vtkNew<vtkPlane> plane;
  section->SetImplicitFunction(plane);
  const auto source = std::make_shared<CountingSource>(GetSphere()->GetSource());
  section->SetInputData(MakeModel(source));
  source->IsBroken = true;
  section->Update();
  EXPECT_EQ(section->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::FileFormatError));
  EXPECT_NE(errors.Text.find("broken on purpose"), std::string::npos);
  EXPECT_EQ(section->GetOutput()->GetNumberOfPoints(), 0);
  vtkNew<vtkMultiTriangulation> empty;
  section->SetInputData(empty);
  section->Update();
  EXPECT_EQ(section->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::UnknownError));
  Events warnings(section, vtkCommand::WarningEvent);
  section->SetError(std::nan(""));
  EXPECT_EQ(section->GetError(), 0.0);
  EXPECT_EQ(warnings.Count, 1);
}

TEST(Section, CanBeAborted)
{
  vtkNew<vtkMultiTriangulationSection> section;
  section->SetInputData(GetSphere());
  vtkNew<vtkPlane> plane;
  section->SetImplicitFunction(plane);
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback(
    [](vtkObject* caller, unsigned long, void*, void*) { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1); });
  section->AddObserver(vtkCommand::ProgressEvent, abort);
  section->Update();
  EXPECT_EQ(section->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(section->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::UserError));
}
