// SPDX-License-Identifier: BSD-3-Clause
#include "MTGeneralTest.h"

#include "vtkMTCut.h"
#include "vtkMTGraph.h"
#include "vtkMultiTriangulationCutFilter.h"
#include "vtkMultiTriangulationSection.h"
#include "vtkMultiTriangulationTransform.h"

#include "vtkErrorCode.h"
#include "vtkMatrix4x4.h"
#include "vtkMatrixToLinearTransform.h"
#include "vtkPlane.h"
#include "vtkPolyDataNormals.h"
#include "vtkSphere.h"
#include "vtkTransform.h"

#include <limits>

using namespace MTGeneralTest;

namespace
{
vtkSmartPointer<vtkTransform> MakeTransform(MTTestMeshes::Random& random, bool mirrors)
{
  auto transform = vtkSmartPointer<vtkTransform>::New();
  transform->Translate(random.Uniform(-100.0, 100.0), random.Uniform(-100.0, 100.0), random.Uniform(-9.0, 9.0));
  transform->RotateWXYZ(random.Uniform(0.0, 360.0), random.Uniform(), random.Uniform(), random.Uniform() + 0.1);
  transform->Scale(random.Uniform(0.2, 5.0), random.Uniform(0.2, 5.0), (mirrors ? -1.0 : 1.0) * random.Uniform(1, 2));
  return transform;
}
}

TEST(Transform, CutsAreThoseOfTheInputElsewhere)
{
  MTTestMeshes::Random random(21);
  for (int test = 0; test < 6; ++test)
  {
    const bool mirrors = test % 2 == 1;
    const vtkSmartPointer<vtkTransform> transform = MakeTransform(random, mirrors);
    const auto source = std::make_shared<CountingSource>(GetSphere()->GetSource());
    const auto model = MakeModel(source);
    const int before = source->Reads;
    vtkNew<vtkMultiTriangulationTransform> moved;
    moved->SetInputData(model);
    moved->SetTransform(transform);
    moved->Update();
    EXPECT_EQ(source->Reads, before) << "patches are not touched";
    EXPECT_EQ(moved->GetOutput()->GetSource(), model->GetSource());
    EXPECT_EQ(moved->GetOutput()->GetNumberOfPolys(), model->GetNumberOfPolys());

    vtkNew<vtkMultiTriangulationCutFilter> cuts[2];
    cuts[0]->SetInputData(model);
    cuts[1]->SetInputConnection(moved->GetOutputPort());
    for (const auto& cut : cuts)
    {
      cut->SetLevel(1);
      cut->Update();
    }
    ASSERT_EQ(cuts[0]->GetOutput()->GetNumberOfPoints(), cuts[1]->GetOutput()->GetNumberOfPoints());
    double bounds[6];
    moved->GetOutput()->GetModelBounds(bounds);
    for (vtkIdType p = 0; p < cuts[0]->GetOutput()->GetNumberOfPoints(); ++p)
    {
      double expected[3];
      transform->TransformPoint(cuts[0]->GetOutput()->GetPoint(p), expected);
      const double* x = cuts[1]->GetOutput()->GetPoint(p);
      ASSERT_LT(std::sqrt(vtkMath::Distance2BetweenPoints(expected, x)), 1e-12 * 300.0);
      for (int i = 0; i < 3; ++i)
      {
        ASSERT_LE(bounds[2 * i] - 1e-9, x[i]);
        ASSERT_GE(bounds[2 * i + 1] + 1e-9, x[i]);
      }
    }
    const double factor = std::abs(transform->GetMatrix()->Determinant());
    EXPECT_NEAR(GetVolume(cuts[1]->GetOutput()) / GetVolume(cuts[0]->GetOutput()) / factor, 1.0, 1e-6)
      << "the front stays the front, also of what mirrors";
    EXPECT_GT(GetVolume(moved->GetOutput()), 0.0);
    EXPECT_GT(GetVolume(cuts[0]->GetOutput()), 0.0);
  }
}

TEST(Transform, ErrorsStayCertified)
{
  vtkNew<vtkTransform> transform;
  transform->RotateX(30.0);
  transform->Scale(10.0, 1.0, 0.1);
  vtkNew<vtkMultiTriangulationTransform> moved;
  moved->SetInputData(GetSphere());
  moved->SetTransform(transform);
  moved->Update();
  EXPECT_NEAR(moved->GetOutput()->GetStretch(), 10.0, 1e-9);
  vtkNew<vtkMultiTriangulationCutFilter> cuts[2];
  cuts[0]->SetInputData(GetSphere());
  cuts[0]->SetError(0.01);
  cuts[1]->SetInputConnection(moved->GetOutputPort());
  cuts[1]->SetError(0.1 * (1.0 + 1e-9));
  for (const auto& cut : cuts)
  {
    cut->Update();
  }
  EXPECT_EQ(cuts[0]->GetNumberOfTriangles(), cuts[1]->GetNumberOfTriangles());
  EXPECT_NEAR(cuts[1]->GetCutError(), 10.0 * cuts[0]->GetCutError(), 1e-9);
  EXPECT_GE(cuts[1]->GetCutError(), 10.0 * cuts[0]->GetCutError());
}

TEST(Transform, AddsUpInARow)
{
  vtkNew<vtkTransform> first;
  first->RotateZ(40.0);
  first->Translate(1.0, 2.0, 3.0);
  vtkNew<vtkTransform> second;
  second->Scale(2.0, -3.0, 0.5);
  vtkNew<vtkMultiTriangulationTransform> filters[2];
  filters[0]->SetInputData(GetSphere());
  filters[0]->SetTransform(first);
  filters[1]->SetInputConnection(filters[0]->GetOutputPort());
  filters[1]->SetTransform(second);
  filters[1]->Update();
  vtkNew<vtkMatrix4x4> product;
  vtkMatrix4x4::Multiply4x4(second->GetMatrix(), first->GetMatrix(), product);
  double frame[16];
  filters[1]->GetOutput()->GetFrame(frame);
  for (int i = 0; i < 16; ++i)
  {
    EXPECT_NEAR(frame[i], product->GetData()[i], 1e-12);
  }
  first->Identity();
  filters[1]->Update();
  filters[1]->GetOutput()->GetFrame(frame);
  EXPECT_EQ(frame[0], 2.0) << "a transform that changes makes the filter run again";
  vtkNew<vtkMultiTriangulation> copy;
  copy->ShallowCopy(filters[1]->GetOutput());
  copy->GetFrame(frame);
  EXPECT_EQ(frame[5], -3.0) << "copies have the frame";
}

TEST(Transform, SectionAndRegionAreInTheNewPlace)
{
  MTTestMeshes::Random random(2);
  vtkNew<vtkMultiTriangulationTransform> moved;
  moved->SetInputData(GetSphere());
  const vtkSmartPointer<vtkTransform> transform = MakeTransform(random, true);
  moved->SetTransform(transform);
  moved->Update();
  double center[3] = { 0.0, 0.0, 0.0 };
  transform->TransformPoint(center, center);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(center);
  plane->SetNormal(0.2, 0.9, 0.4);
  vtkNew<vtkMultiTriangulationSection> section;
  section->SetInputConnection(moved->GetOutputPort());
  section->SetImplicitFunction(plane);
  section->Update();
  ASSERT_GT(section->GetOutput()->GetNumberOfLines(), 10);
  EXPECT_EQ(section->GetOutput()->GetNumberOfLines(), section->GetOutput()->GetNumberOfPoints());
  EXPECT_LT(section->GetNumberOfPatches(), GetSphere()->GetNumberOfPatches() / 4);

  vtkNew<vtkSphere> region;
  region->SetCenter(center);
  region->SetRadius(1e-3);
  vtkNew<vtkMultiTriangulationCutFilter> cut;
  cut->SetInputConnection(moved->GetOutputPort());
  cut->SetLevel(0);
  cut->SetRegion(region);
  cut->Update();
  EXPECT_LT(cut->GetNumberOfTriangles(), 20480 / 2) << "the region is in the middle, where no surface is";
}

TEST(Transform, WhatCannotPlaceAModelIsAnError)
{
  vtkNew<vtkMultiTriangulationTransform> filter;
  Events errors(filter);
  filter->SetInputData(GetSphere());
  filter->Update();
  EXPECT_EQ(filter->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::UserError)) << "no transform";
  vtkNew<vtkMatrix4x4> matrix;
  vtkNew<vtkMatrixToLinearTransform> transform;
  transform->SetInput(matrix);
  filter->SetTransform(transform);
  const double bad[4][3] = { { 0, 0, 0.0 }, { 3, 0, 1.0 }, { 1, 3, std::nan("") },
    { 2, 2, std::numeric_limits<double>::infinity() } };
  for (const auto& each : bad)
  {
    matrix->Identity();
    matrix->SetElement(static_cast<int>(each[0]), static_cast<int>(each[1]), each[2]);
    filter->Update();
    EXPECT_EQ(filter->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::UserError)) << each[2];
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  }
  EXPECT_GT(errors.Count, 4);
  matrix->Identity();
  filter->Update();
  EXPECT_EQ(filter->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
  EXPECT_EQ(filter->GetOutput()->GetSource(), GetSphere()->GetSource());
}

TEST(Transform, NormalsPointOutwardsWhateverTheTransform)
{
  vtkNew<vtkMultiTriangulationBuilder> builder;
  builder->SetInputData(MTTestMeshes::Icosphere(4));
  builder->SetPatchTriangles(100);
  builder->MakeNormalsOn();
  MTTestMeshes::Random random(31);
  for (int test = 0; test < 4; ++test)
  {
    const vtkSmartPointer<vtkTransform> transform = MakeTransform(random, test % 2 == 0);
    vtkNew<vtkMultiTriangulationTransform> moved;
    moved->SetInputConnection(builder->GetOutputPort());
    moved->SetTransform(transform);
    vtkNew<vtkMultiTriangulationCutFilter> cut;
    cut->SetInputConnection(moved->GetOutputPort());
    cut->SetLevel(0);
    cut->Update();
    vtkDataArray* normals = cut->GetOutput()->GetPointData()->GetNormals();
    ASSERT_NE(normals, nullptr);
    double center[3] = { 0.0, 0.0, 0.0 };
    transform->TransformPoint(center, center);
    for (vtkIdType p = 0; p < cut->GetOutput()->GetNumberOfPoints(); ++p)
    {
      double n[3];
      double outwards[3];
      normals->GetTuple(p, n);
      vtkMath::Subtract(cut->GetOutput()->GetPoint(p), center, outwards);
      ASSERT_GT(vtkMath::Dot(n, outwards), 0.0);
      ASSERT_NEAR(vtkMath::Norm(n), 1.0, 1e-6);
    }
  }
}
