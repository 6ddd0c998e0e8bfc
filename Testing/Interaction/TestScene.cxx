// SPDX-License-Identifier: BSD-3-Clause
// Models that come later, with a preview first.
#include "MTTestModel.h"

#include "vtkCamera.h"
#include "vtkMTCameraPathFile.h"
#include "vtkMTFrameFigures.h"
#include "vtkMTScene.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
vtkSmartPointer<vtkPolyData> MakeMesh(double radius)
{
  vtkNew<vtkSphereSource> source;
  source->SetRadius(radius);
  source->Update();
  return source->GetOutput();
}
}

TEST(Scene, EverythingIsSeenUntilTheUserMovesTheCamera)
{
  vtkNew<vtkRenderer> renderer;
  vtkMTScene scene(renderer, vtkMTCameraView(), false);
  vtkCamera* camera = renderer->GetActiveCamera();
  EXPECT_EQ(scene.AddItem(), 0u);
  EXPECT_EQ(scene.AddItem(), 1u);
  EXPECT_FALSE(scene.IsAllSeen());
  scene.ShowPreview(0, MakeMesh(1.0));
  const double near = camera->GetDistance();
  scene.ShowPreview(1, MakeMesh(50.0));
  EXPECT_TRUE(scene.IsAllSeen());
  EXPECT_GT(camera->GetDistance(), 10.0 * near);
  camera->Azimuth(10.0);
  const double distance = camera->GetDistance();
  std::string error;
  ASSERT_TRUE(scene.ShowModel(1, MTTestModel::MakeTube(), "tube", "", error)) << error;
  EXPECT_EQ(camera->GetDistance(), distance);
  scene.ShowPreview(1, MakeMesh(1.0));
  EXPECT_EQ(vtkMTFrameFigures::Find(renderer).Models, 1u) << "a preview does not replace a model";

  vtkNew<vtkRenderer> other;
  vtkMTCameraView view;
  view.Position = { 0.0, 0.0, 7.0 };
  vtkMTScene placed(other, view, true);
  placed.ShowPreview(placed.AddItem(), MakeMesh(50.0));
  EXPECT_EQ(other->GetActiveCamera()->GetDistance(), 7.0) << "a view that was set stays";
}

TEST(Scene, WhatCannotBeDrawnIsAnError)
{
  vtkNew<vtkRenderer> renderer;
  vtkMTScene scene(renderer, vtkMTCameraView(), false);
  const std::size_t item = scene.AddItem();
  scene.ShowPreview(item, MakeMesh(1e38));
  EXPECT_FALSE(scene.IsAllSeen());
  std::string error;
  MTTestModel::TubeOptions options;
  options.Scale = std::ldexp(1.0, 200);
  EXPECT_FALSE(scene.ShowModel(item, MTTestModel::MakeTube(options), "tube.bmt", "", error));
  EXPECT_NE(error.find("tube.bmt cannot be drawn"), std::string::npos) << error;
  EXPECT_FALSE(scene.ShowModel(item, MTTestModel::MakeTube(), "tube.bmt", "/nowhere/a.png", error));
  EXPECT_NE(error.find("/nowhere/a.png"), std::string::npos) << error;
  EXPECT_FALSE(scene.IsAllSeen());
}
