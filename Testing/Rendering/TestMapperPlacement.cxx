// SPDX-License-Identifier: BSD-3-Clause
// A model whose frame puts it elsewhere is drawn and picked there.
#include "MTGridModel.h"
#include "MTPicture.h"

#include "vtkActor.h"
#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkCellPicker.h"
#include "vtkCommand.h"
#include "vtkCullerCollection.h"
#include "vtkImageData.h"
#include "vtkMTPatchSource.h"
#include "vtkMTPatchStore.h"
#include "vtkMultiTriangulation.h"
#include "vtkMultiTriangulationCutFilter.h"
#include "vtkMultiTriangulationLocator.h"
#include "vtkMultiTriangulationMapper.h"
#include "vtkMultiTriangulationTransform.h"
#include "vtkPlane.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTransform.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <string>
#include <vector>

namespace
{
vtkSmartPointer<vtkTransform> MakeTransform(bool mirrors)
{
  auto transform = vtkSmartPointer<vtkTransform>::New();
  transform->Translate(5.0, -3.0, 2.0);
  transform->RotateWXYZ(25.0, 1.0, 0.5, 0.2);
  transform->Scale(mirrors ? -3.0 : 3.0, 2.0, 1.5);
  return transform;
}

void Look(MTScene& scene)
{
  scene.Renderer->ResetCamera();
  scene.Renderer->GetActiveCamera()->Elevation(-35.0);
  scene.Renderer->GetActiveCamera()->Azimuth(15.0);
  scene.Renderer->ResetCameraClippingRange();
}

// Through the frame, in the view of another scene.
void LookLike(MTScene& scene, MTScene& other)
{
  scene.Renderer->GetActiveCamera()->DeepCopy(other.Renderer->GetActiveCamera());
}
}

TEST(Placement, FrameDrawsWhatAnActorsMatrixDraws)
{
  for (const double pixelError : { 0.0, 2.0 })
  {
    vtkNew<vtkMultiTriangulationMapper> plain;
    plain->SetInputData(MTGridModel().MakeData());
    plain->SetPixelError(pixelError);
    vtkNew<vtkMultiTriangulationTransform> moved;
    moved->SetInputData(MTGridModel().MakeData());
    moved->SetTransform(MakeTransform(false));
    vtkNew<vtkMultiTriangulationMapper> mapper;
    mapper->SetInputConnection(moved->GetOutputPort());
    mapper->SetPixelError(pixelError);
    MTScene byActor(plain);
    byActor.Actor->SetUserTransform(MakeTransform(false));
    MTScene byFrame(mapper);
    Look(byActor);
    LookLike(byFrame, byActor);
    const auto expected = byActor.Render();
    const MTDifference difference = MTDifference::Compare(byFrame.Render(), expected);
    std::cout << difference << "\n";
    EXPECT_GT(difference.Drawn, 5000u);
    EXPECT_LE(difference.Largest, MTDifference::Slight);
    EXPECT_EQ(mapper->GetNumberOfTriangles(), plain->GetNumberOfTriangles());
    EXPECT_NEAR(mapper->GetAchievedPixelError(), plain->GetAchievedPixelError(), 1e-9);

    vtkNew<vtkPlane> clip;
    clip->SetOrigin(byActor.Actor->GetCenter());
    clip->SetNormal(1.0, 0.3, 0.0);
    plain->AddClippingPlane(clip);
    mapper->AddClippingPlane(clip);
    const auto clipped = byActor.Render();
    EXPECT_LE(MTDifference::Compare(byFrame.Render(), clipped).ClearlyOff, 3u);
    EXPECT_GT(MTDifference::Compare(clipped, expected).ClearlyOff, 1000u);
  }
}

TEST(Placement, ScaleThatVtkCannotDrawIsAnErrorOnce)
{
  for (const double scale : { 1e20, 1e39, 1e-24 })
  {
    vtkNew<vtkMultiTriangulationMapper> mapper;
    mapper->SetInputData(MTGridModel().MakeData());
    std::vector<std::string> errors;
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(&errors);
    command->SetCallback([](vtkObject*, unsigned long, void* client, void* text)
      { static_cast<std::vector<std::string>*>(client)->emplace_back(static_cast<const char*>(text)); });
    mapper->AddObserver(vtkCommand::ErrorEvent, command);
    MTScene scene(mapper);
    scene.Renderer->GetCullers()->RemoveAllItems(); // which may find it too small
    scene.Actor->SetScale(scale);
    scene.Renderer->ResetCamera();
    scene.Render();
    scene.Render();
    if (scale == 1e20)
    {
      EXPECT_TRUE(errors.empty());
      continue;
    }
    ASSERT_EQ(errors.size(), 1u) << scale;
    EXPECT_NE(errors[0].find("cannot be drawn"), std::string::npos) << errors[0];
    std::cout << errors[0];
  }
}

TEST(Placement, MirroredModelIsThatOfItsCut)
{
  vtkNew<vtkMultiTriangulationTransform> moved;
  moved->SetInputData(MTGridModel().MakeData());
  moved->SetTransform(MakeTransform(true));
  vtkNew<vtkMultiTriangulationCutFilter> cut;
  cut->SetInputConnection(moved->GetOutputPort());
  cut->SetLevel(0);
  vtkNew<vtkPolyDataMapper> stock;
  stock->SetInputConnection(cut->GetOutputPort());
  vtkNew<vtkMultiTriangulationMapper> mapper;
  mapper->SetInputConnection(moved->GetOutputPort());
  mapper->SetPixelError(0.0);
  MTScene expected(stock);
  MTScene scene(mapper);
  for (const bool culling : { false, true })
  {
    expected.Actor->GetProperty()->SetBackfaceCulling(culling);
    scene.Actor->GetProperty()->SetBackfaceCulling(culling);
    Look(expected);
    LookLike(scene, expected);
    const auto picture = expected.Render();
    const MTDifference difference = MTDifference::Compare(scene.Render(), picture);
    std::cout << difference << "\n";
    EXPECT_GT(difference.Drawn, 5000u);
    EXPECT_LE(difference.ClearlyOff, difference.Drawn / 100);
  }
  vtkNew<vtkPolyData> drawn;
  ASSERT_TRUE(mapper->GetCut(drawn));
  double bounds[6];
  double model[6];
  drawn->GetBounds(bounds);
  mapper->GetBounds(model);
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_GE(bounds[2 * i], model[2 * i] - 1e-9);
    EXPECT_LE(bounds[2 * i + 1], model[2 * i + 1] + 1e-9);
  }
}

// With every side culled, seen from above and from below: what is left is lit and culled as VTK does it.
TEST(Placement, MirroredActorsAreLitAndCulledAsVtkDoesIt)
{
  int drawn = 0;
  int empty = 0;
  int away = 0;
  for (int which = 0; which < 24; ++which)
  {
    vtkNew<vtkMultiTriangulationTransform> moved;
    moved->SetInputData(MTGridModel().MakeData());
    moved->SetTransform(MakeTransform(which % 2 == 1));
    vtkNew<vtkMultiTriangulationMapper> mapper;
    mapper->SetInputConnection(moved->GetOutputPort());
    mapper->SetPixelError(0.5);
    mapper->ScalarVisibilityOff();
    MTScene scene(mapper, 150, 150);
    scene.Render();
    mapper->FreezeCutOn();
    vtkNew<vtkPolyData> cut;
    ASSERT_TRUE(mapper->GetCut(cut));
    vtkNew<vtkPolyDataMapper> stock;
    stock->SetInputData(cut);
    stock->ScalarVisibilityOff();
    MTScene expected(stock, 150, 150);
    for (MTScene* each : { &scene, &expected })
    {
      each->Actor->SetScale(which / 2 % 2 == 1 ? -1.0 : 1.0, 1.0, 1.2);
      each->Actor->GetProperty()->SetBackfaceCulling(which / 8 == 1);
      each->Actor->GetProperty()->SetFrontfaceCulling(which / 8 == 2);
      each->Actor->GetProperty()->SetSpecular(0.5);
      each->Actor->RotateX(which / 4 % 2 == 1 ? 160.0 : 0.0);
    }
    Look(expected);
    LookLike(scene, expected);
    const auto picture = expected.Render();
    const MTDifference difference = MTDifference::Compare(scene.Render(), picture);
    EXPECT_LE(difference.ClearlyOff, difference.Drawn / 100) << "case " << which << ": " << difference;
    ++(difference.Drawn > 1000 ? drawn : empty);
    away += mapper->GetNumberOfFacingAwayPatches() > 0;
  }
  std::cout << drawn << " pictures of something, " << empty << " where that is culled, " << away
            << " with patches left out for facing away\n";
  EXPECT_GE(drawn, 12);
  EXPECT_GE(empty, 4);
  EXPECT_GE(away, 1);
}

TEST(Placement, ANewPlaceReadsAndUploadsNothing)
{
  vtkNew<vtkTransform> transform;
  vtkNew<vtkMultiTriangulationTransform> moved;
  moved->SetInputData(MTGridModel().MakeData());
  moved->SetTransform(transform);
  vtkNew<vtkMultiTriangulationMapper> mapper;
  mapper->SetInputConnection(moved->GetOutputPort());
  mapper->SetPixelError(0.0);
  MTScene scene(mapper);
  Look(scene);
  const auto before = scene.Render();
  const vtkIdType reads = mapper->GetNumberOfReads();
  const vtkIdType bytes = mapper->GetNumberOfUploadedBytes();
  transform->Translate(0.05, 0.02, 0.0);
  const auto after = scene.Render();
  EXPECT_GT(MTDifference::Compare(after, before).ClearlyOff, 500u);
  EXPECT_EQ(mapper->GetNumberOfReads(), reads);
  EXPECT_EQ(mapper->GetNumberOfUploadedBytes(), bytes);
}

TEST(Placement, PickerHitsWhatIsDrawn)
{
  vtkNew<vtkMultiTriangulationMapper> mappers[2];
  vtkNew<vtkMultiTriangulationTransform> moved;
  moved->SetInputData(MTGridModel().MakeData());
  moved->SetTransform(MakeTransform(false));
  mappers[0]->SetInputData(MTGridModel().MakeData());
  mappers[1]->SetInputConnection(moved->GetOutputPort());
  MTScene byActor(mappers[0]);
  byActor.Actor->SetUserTransform(MakeTransform(false));
  MTScene byFrame(mappers[1]);
  Look(byActor);
  LookLike(byFrame, byActor);
  MTScene* scenes[2] = { &byActor, &byFrame };
  vtkNew<vtkMultiTriangulationLocator> locators[2];
  vtkNew<vtkCellPicker> pickers[2];
  for (int i = 0; i < 2; ++i)
  {
    mappers[i]->SetPixelError(1.0);
    scenes[i]->Render();
    locators[i]->SetMapper(mappers[i]);
    pickers[i]->AddLocator(locators[i]);
  }
  int hits = 0;
  for (int pixel = 20; pixel < 300; pixel += 23)
  {
    const int found[2] = { pickers[0]->Pick(pixel + 0.5, 150.5, 0.0, byActor.Renderer),
      pickers[1]->Pick(pixel + 0.5, 150.5, 0.0, byFrame.Renderer) };
    ASSERT_EQ(found[0], found[1]);
    hits += found[0];
    for (int k = 0; k < 3 && found[0]; ++k)
    {
      EXPECT_EQ(pickers[0]->GetCellId(), pickers[1]->GetCellId());
      EXPECT_NEAR(pickers[0]->GetPickPosition()[k], pickers[1]->GetPickPosition()[k], 1e-9);
    }
  }
  EXPECT_GT(hits, 3);
}

TEST(Placement, CutOfARenderersViewIsWhatTheMapperDraws)
{
  const auto model = MTGridModel().MakeData();
  vtkNew<vtkMultiTriangulationMapper> mapper;
  mapper->SetInputData(model);
  mapper->SetPixelError(1.5);
  MTScene scene(mapper);
  Look(scene);
  scene.Render();
  vtkNew<vtkMultiTriangulationCutFilter> filter;
  filter->SetInputData(model);
  filter->SetRenderer(scene.Renderer);
  filter->SetPixelError(1.5);
  filter->Update();
  vtkNew<vtkPolyData> drawn;
  ASSERT_TRUE(mapper->GetCut(drawn));
  EXPECT_EQ(filter->GetNumberOfTriangles(), drawn->GetNumberOfPolys());
  EXPECT_GT(filter->GetNumberOfTriangles(), model->GetNumberOfPolys());
}
