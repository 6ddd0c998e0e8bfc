// SPDX-License-Identifier: BSD-3-Clause
#include "MTGeneralTest.h"

#include "vtkMTCut.h"
#include "vtkMTGraph.h"
#include "vtkMTPlacement.h"
#include "vtkMultiTriangulationCutFilter.h"

#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkCellLocator.h"
#include "vtkDataArraySelection.h"
#include "vtkErrorCode.h"
#include "vtkGenericCell.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderer.h"
#include "vtkSphere.h"
#include "vtkTransform.h"

#include <algorithm>
#include <iostream>
#include <limits>

using namespace MTGeneralTest;

namespace
{
using CutFilter = vtkMultiTriangulationCutFilter;

void ExpectClosed(vtkPolyData* mesh)
{
  const MTTestMeshes::EdgeFigures edges = MTTestMeshes::CountEdges(mesh, true);
  EXPECT_GT(edges.Inner, 0);
  EXPECT_EQ(edges.Open, 0);
  EXPECT_EQ(edges.Crowded, 0);
}

vtkSmartPointer<vtkCamera> LookFrom(double x, double y, double z)
{
  auto camera = vtkSmartPointer<vtkCamera>::New();
  camera->SetPosition(x, y, z);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetClippingRange(0.01, 1000.0);
  return camera;
}
}

TEST(CutFilter, LastCallChoosesWhichCut)
{
  vtkNew<CutFilter> filter;
  EXPECT_EQ(filter->GetMode(), CutFilter::BY_ERROR);
  filter->SetTriangleLimit(5000);
  EXPECT_EQ(filter->GetMode(), CutFilter::BY_TRIANGLES);
  filter->SetLevel(2);
  EXPECT_EQ(filter->GetMode(), CutFilter::BY_LEVEL);
  filter->SetTriangleLimit(5000);
  EXPECT_EQ(filter->GetMode(), CutFilter::BY_TRIANGLES) << "the same number again is a call as well";
  filter->SetView(LookFrom(3, 0, 0), 300, 200);
  EXPECT_EQ(filter->GetMode(), CutFilter::BY_VIEW);
  filter->SetError(0.1);
  EXPECT_EQ(filter->GetMode(), CutFilter::BY_ERROR);
}

TEST(CutFilter, NaNIsRefused)
{
  vtkNew<CutFilter> filter;
  Events warnings(filter, vtkCommand::WarningEvent);
  filter->SetLevel(1);
  filter->SetError(std::nan(""));
  filter->SetPixelError(std::nan(""));
  filter->SetOutsideError(std::nan(""));
  EXPECT_EQ(warnings.Count, 3);
  EXPECT_EQ(filter->GetMode(), CutFilter::BY_LEVEL);
  EXPECT_EQ(filter->GetError(), VTK_DOUBLE_MAX);
  EXPECT_EQ(filter->GetPixelError(), 1.0);
  filter->SetError(-1.0);
  EXPECT_EQ(filter->GetError(), 0.0);
}

TEST(CutFilter, WithoutASettingItIsTheCoarsestCut)
{
  vtkNew<CutFilter> filter;
  filter->SetInputData(GetSphere());
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfTriangles(), GetSphere()->GetNumberOfPolys());
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPolys(), GetSphere()->GetNumberOfPolys());
}

TEST(CutFilter, TriangleLimitHoldsAndIsFilled)
{
  const vtkMTGraph& graph = GetSphere()->GetSource()->GetGraph();
  std::uint64_t all = 0;
  for (const vtkMTArc& arc : graph.Arcs)
  {
    all += arc.Triangles;
  }
  const double mean = static_cast<double>(all) / static_cast<double>(graph.Arcs.size());
  MTTestMeshes::Random random(3);
  vtkNew<CutFilter> filter;
  filter->SetInputData(GetSphere());
  for (int i = 0; i < 12; ++i)
  {
    const auto limit = static_cast<vtkIdType>(random.Uniform(50.0 * mean, 25000.0));
    filter->SetTriangleLimit(limit);
    filter->Update();
    const vtkIdType triangles = filter->GetOutput()->GetNumberOfPolys();
    EXPECT_EQ(triangles, filter->GetNumberOfTriangles());
    EXPECT_LE(triangles, limit);
    EXPECT_GE(triangles, std::min<double>(0.9 * static_cast<double>(limit), 20480));
    ExpectClosed(filter->GetOutput());
  }
}

TEST(CutFilter, TrianglesHaveTheDistancesOfTheirPatches)
{
  vtkNew<vtkMultiTriangulation> model;
  model->ShallowCopy(GetSphere());
  vtkNew<vtkTransform> twice;
  twice->Scale(2.0, 2.0, 2.0);
  ASSERT_TRUE(model->ApplyTransform(twice->GetMatrix()->GetData()));
  vtkNew<vtkSphere> region;
  region->SetCenter(2.0, 0.0, 0.0);
  region->SetRadius(0.5);
  vtkNew<CutFilter> filter;
  filter->SetInputData(model);
  filter->SetLevel(0);
  filter->SetRegion(region);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetCellData()->GetArray("DistanceToInput"), nullptr);
  filter->GenerateDistancesOn();
  filter->Update();
  const vtkMTGraph& graph = model->GetSource()->GetGraph();
  vtkMTPlacement placement;
  model->GetFrame(placement.Matrix.data());
  EXPECT_NEAR(placement.GetStretch(), 2.0, 1e-6);
  const auto check = [&](const char* name, double (vtkMTGraph::*distance)(std::uint32_t) const, double figure)
  {
    std::set<double> known;
    for (std::uint32_t arc = 0; arc < graph.Arcs.size(); ++arc)
    {
      known.insert((graph.*distance)(arc)*placement.GetStretch());
    }
    vtkDataArray* values = filter->GetOutput()->GetCellData()->GetArray(name);
    ASSERT_NE(values, nullptr);
    ASSERT_EQ(values->GetNumberOfTuples(), filter->GetOutput()->GetNumberOfPolys());
    for (vtkIdType cell = 0; cell < values->GetNumberOfTuples(); ++cell)
    {
      ASSERT_EQ(known.count(values->GetTuple1(cell)), 1u) << name << " of cell " << cell;
    }
    std::cout << name << " from " << values->GetRange()[0] << " to " << values->GetRange()[1] << "\n";
    EXPECT_EQ(values->GetRange()[1], figure);
    EXPECT_LT(values->GetRange()[0], 0.01 * figure) << "the region is fine, the rest coarse";
  };
  check("DistanceToInput", &vtkMTGraph::GetDistanceToInput, filter->GetDistanceToInput());
  check("DistanceFromInput", &vtkMTGraph::GetDistanceFromInput, filter->GetDistanceFromInput());
  EXPECT_EQ(filter->GetCutError(), std::max(filter->GetDistanceToInput(), filter->GetDistanceFromInput()));
}

TEST(CutFilter, ErrorHoldsAndLevelsAreWhole)
{
  vtkMultiTriangulation* model = GetSphere();
  vtkNew<CutFilter> filter;
  filter->SetInputData(model);
  const double coarsest = vtkMTCut(model->GetSource()->GetGraph()).GetError();
  vtkIdType before = 0;
  for (const double part : { 1.0, 0.3, 0.1, 0.02 })
  {
    filter->SetError(part * coarsest);
    filter->Update();
    EXPECT_LE(filter->GetCutError(), part * coarsest);
    EXPECT_GT(filter->GetNumberOfTriangles(), before);
    before = filter->GetNumberOfTriangles();
    ExpectClosed(filter->GetOutput());
  }
  for (int level = 0; level < model->GetNumberOfLevels(); ++level)
  {
    filter->SetLevel(level);
    filter->Update();
    EXPECT_EQ(filter->GetFinestLevel(), level);
    EXPECT_EQ(filter->GetCoarsestLevel(), level);
    ExpectClosed(filter->GetOutput());
  }
}

// Measured against the input by other means: every point of the input in the region is near the cut.
TEST(CutFilter, RegionIsFineInsideCoarseOutsideAndConforming)
{
  vtkMultiTriangulation* model = GetSphere();
  vtkNew<CutFilter> finest;
  finest->SetInputData(model);
  finest->SetLevel(0);
  finest->Update();
  const double coarsest = vtkMTCut(model->GetSource()->GetGraph()).GetError();
  MTTestMeshes::Random random(11);
  for (int test = 0; test < 8; ++test)
  {
    vtkNew<vtkSphere> region;
    double center[3];
    finest->GetOutput()->GetPoint(
      static_cast<vtkIdType>(random.Below(finest->GetOutput()->GetNumberOfPoints())), center);
    region->SetCenter(center);
    region->SetRadius(random.Uniform(0.05, 0.4));
    const double error = coarsest * random.Uniform(0.004, 0.02);
    vtkNew<CutFilter> filter;
    filter->SetInputData(model);
    filter->SetError(error);
    filter->Update();
    const vtkIdType everywhere = filter->GetNumberOfTriangles();
    filter->SetRegion(region);
    filter->Update();
    ExpectClosed(filter->GetOutput());
    EXPECT_LT(filter->GetNumberOfTriangles(), everywhere * 3 / 4);
    vtkNew<vtkCellLocator> locator;
    locator->SetDataSet(filter->GetOutput());
    locator->BuildLocator();
    vtkIdType inside = 0;
    for (vtkIdType p = 0; p < finest->GetOutput()->GetNumberOfPoints(); ++p)
    {
      double x[3];
      finest->GetOutput()->GetPoint(p, x);
      if (region->FunctionValue(x) <= 0.0)
      {
        double nearest[3];
        vtkIdType cell = 0;
        int sub = 0;
        double square = 0.0;
        vtkNew<vtkGenericCell> scratch;
        locator->FindClosestPoint(x, nearest, scratch, cell, sub, square);
        ++inside;
        ASSERT_LE(std::sqrt(square), error * (1.0 + 1e-9));
      }
    }
    EXPECT_GT(inside, 0);
    std::cout << inside << " points within " << error << ", " << filter->GetNumberOfTriangles() << " of " << everywhere
              << " triangles\n";
    filter->SetOutsideError(3.0 * error);
    filter->Update();
    EXPECT_LE(filter->GetCutError(), 3.0 * error);
    ExpectClosed(filter->GetOutput());
    filter->SetTriangleLimit(2000);
    filter->SetOutsideError(VTK_DOUBLE_MAX);
    filter->Update();
    EXPECT_LE(filter->GetOutput()->GetNumberOfPolys(), 2000);
    EXPECT_GT(filter->GetOutput()->GetNumberOfPolys(), model->GetNumberOfPolys());
    ExpectClosed(filter->GetOutput());
    filter->SetLevel(1);
    filter->Update();
    EXPECT_EQ(filter->GetFinestLevel() <= 1, true);
    ExpectClosed(filter->GetOutput());
  }
}

TEST(CutFilter, RegionOfAllIsTheCutItself)
{
  vtkNew<vtkSphere> everything;
  everything->SetRadius(100.0);
  vtkNew<CutFilter> filter;
  filter->SetInputData(GetSphere());
  for (int mode = 0; mode < 4; ++mode)
  {
    mode == 0     ? filter->SetError(0.01)
      : mode == 1 ? filter->SetTriangleLimit(6000)
      : mode == 2 ? filter->SetLevel(2)
                  : filter->SetView(LookFrom(0, 0, 30), 500, 500);
    filter->SetRegion(nullptr);
    filter->Update();
    const vtkIdType without = filter->GetNumberOfTriangles();
    filter->SetRegion(everything);
    filter->Update();
    EXPECT_EQ(filter->GetNumberOfTriangles(), without) << "mode " << mode;
  }
}

TEST(CutFilter, ViewNeedsNoWindow)
{
  vtkNew<CutFilter> filter;
  filter->SetInputData(GetSphere());
  filter->SetView(LookFrom(0, 0, 30), 500, 500);
  filter->Update();
  const vtkIdType far = filter->GetNumberOfTriangles();
  ExpectClosed(filter->GetOutput());
  filter->SetPixelError(0.2);
  filter->Update();
  const vtkIdType finer = filter->GetNumberOfTriangles();
  filter->SetPixelError(1.0);
  filter->SetView(LookFrom(0, 0, 3), 500, 500);
  filter->Update();
  const vtkIdType near = filter->GetNumberOfTriangles();
  ExpectClosed(filter->GetOutput());
  vtkSmartPointer<vtkCamera> away = LookFrom(0, 0, 3);
  away->SetFocalPoint(0, 0, 6);
  filter->SetView(away, 500, 500);
  filter->Update();
  std::cout << far << " from afar, " << finer << " at a fifth of a pixel, " << near << " from near, "
            << filter->GetNumberOfTriangles() << " looking away\n";
  EXPECT_GT(near, far);
  EXPECT_GT(finer, far);
  EXPECT_EQ(filter->GetNumberOfTriangles(), GetSphere()->GetNumberOfPolys());
  away->SetFocalPoint(0, 0, 0);
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfTriangles(), near) << "the camera has been modified";
}

TEST(CutFilter, ArraysAreThoseThatWereChosen)
{
  vtkNew<CutFilter> filter;
  filter->SetInputData(MakeModel(MTTestModel::MakeTube()));
  filter->SetLevel(0);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetPointData()->GetNumberOfArrays(), 2);
  EXPECT_EQ(filter->GetOutput()->GetCellData()->GetNumberOfArrays(), 1);
  const vtkIdType wedges = filter->GetOutput()->GetNumberOfPoints();
  filter->GetPointArraySelection()->DisableArray("uv");
  filter->GetCellArraySelection()->DisableAllArrays();
  filter->Update();
  EXPECT_NE(filter->GetOutput()->GetPointData()->GetArray("height"), nullptr);
  EXPECT_EQ(filter->GetOutput()->GetPointData()->GetArray("uv"), nullptr);
  EXPECT_EQ(filter->GetOutput()->GetCellData()->GetNumberOfArrays(), 0);
  EXPECT_LE(filter->GetOutput()->GetNumberOfPoints(), wedges);
  ExpectClosed(filter->GetOutput());
}

TEST(CutFilter, WhatCannotBeGivenIsAnError)
{
  vtkNew<CutFilter> filter;
  Events errors(filter);
  filter->SetInputData(GetSphere());
  const auto expect = [&](unsigned long code, const char* text)
  {
    filter->Update();
    EXPECT_EQ(filter->GetErrorCode(), code) << text;
    EXPECT_NE(errors.Text.find(text), std::string::npos) << errors.Text;
    EXPECT_NE(std::string(filter->GetErrorMessage()).find(text), std::string::npos) << filter->GetErrorMessage();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_EQ(filter->GetNumberOfTriangles(), 0);
  };
  vtkNew<vtkSphere> region;
  region->SetCenter(1.0, 0.0, 0.0);
  for (vtkImplicitFunction* each :
    { static_cast<vtkImplicitFunction*>(nullptr), static_cast<vtkImplicitFunction*>(region.Get()) })
  {
    filter->SetRegion(each);
    filter->SetTriangleLimit(1);
    expect(vtkErrorCode::UserError, "the coarsest cut has");
    filter->SetLevel(99);
    expect(vtkErrorCode::UserError, "there is no level 99");
    filter->SetError(0.0);
    expect(vtkErrorCode::UserError, "the finest level has an error");
  }
  filter->SetView(LookFrom(1, 1, 1), 0, 100);
  expect(vtkErrorCode::UserError, "no size");
  filter->SetView(nullptr, 100, 100);
  expect(vtkErrorCode::UserError, "no camera");
  vtkNew<vtkRenderer> renderer;
  filter->SetRenderer(renderer);
  expect(vtkErrorCode::UserError, "no size");
  filter->SetRegion(nullptr);
  filter->SetLevel(0);
  filter->Update();
  EXPECT_EQ(filter->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPolys(), 20480);

  const auto source = std::make_shared<CountingSource>(GetSphere()->GetSource());
  filter->SetInputData(MakeModel(source));
  source->IsBroken = true;
  expect(vtkErrorCode::FileFormatError, "broken on purpose");
  vtkNew<vtkMultiTriangulation> empty;
  filter->SetInputData(empty);
  expect(vtkErrorCode::UnknownError, "no patches");
}

TEST(CutFilter, CanBeAborted)
{
  vtkNew<CutFilter> filter;
  filter->SetInputData(GetSphere());
  filter->SetLevel(0);
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback(
    [](vtkObject* caller, unsigned long, void* data, void*)
    {
      auto* algorithm = static_cast<vtkAlgorithm*>(caller);
      const double progress = algorithm->GetProgress();
      algorithm->SetAbortExecute(progress > 0.5 ? 1 : 0);
      // Newer pipelines report the end of what was aborted as well.
      double& farthest = *static_cast<double*>(data);
      farthest = progress < 1.0 ? std::max(farthest, progress) : farthest;
    });
  double farthest = 0.0;
  abort->SetClientData(&farthest);
  filter->AddObserver(vtkCommand::ProgressEvent, abort);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(filter->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::UserError));
  EXPECT_GT(farthest, 0.5);
  EXPECT_LT(farthest, 0.6);
}
