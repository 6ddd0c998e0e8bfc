// SPDX-License-Identifier: BSD-3-Clause
// Time and memory of a frame are what they are allowed to be.
#include "MTGridModel.h"
#include "MTPicture.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkMTPatchStore.h"
#include "vtkMultiTriangulation.h"
#include "vtkMultiTriangulationMapper.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace
{
// It waits for what its cut needs also where a frame rate is asked for.
vtkSmartPointer<vtkMultiTriangulationMapper> MakeWaitingMapper(double pixelError)
{
  auto mapper = MTGridModel::MakeMapper(MTGridModel().MakeData(), pixelError);
  mapper->WaitForConvergenceOn();
  return mapper;
}

// A path over the model: far, approach, close, turn, pull back.
void Fly(MTScene& scene, double t)
{
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(0.1 + 0.8 * t, -1.5 + 2.0 * t, 1.2 - 1.0 * std::sin(3.14 * t));
  camera->SetFocalPoint(0.5, 0.5 + 0.3 * t, 0.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  scene.Renderer->ResetCameraClippingRange();
}

TEST(MapperBudget, DesiredUpdateRateLimitsTriangles)
{
  const auto mapper = MakeWaitingMapper(0.0);
  mapper->SetDrawingRate(2e5);
  MTScene scene(mapper);
  scene.LookFromTheSide();
  for (const double rate : { 200.0, 50.0, 20.0, 10.0 })
  {
    scene.Window->SetDesiredUpdateRate(rate);
    scene.Render();
    std::cout << rate << " frames per second: " << mapper->GetNumberOfTriangles() << " triangles\n";
    EXPECT_LE(static_cast<double>(mapper->GetNumberOfTriangles()), 2e5 / rate);
    EXPECT_GE(static_cast<double>(mapper->GetNumberOfTriangles()), rate < 100.0 ? 0.6 * 2e5 / rate : 1.0);
    EXPECT_FALSE(mapper->GetConverged());
  }
}

TEST(MapperBudget, StillViewIsRefinedToThePixelError)
{
  const auto mapper = MakeWaitingMapper(0.3);
  mapper->SetDrawingRate(1e5);
  MTScene scene(mapper);
  scene.LookFromTheSide();
  scene.Window->SetDesiredUpdateRate(30.0);
  scene.Render();
  const vtkIdType moving = mapper->GetNumberOfTriangles();
  EXPECT_FALSE(mapper->GetConverged());
  scene.Window->SetDesiredUpdateRate(0.0001); // what an interactor asks for when it rests
  const auto still = scene.Render();
  std::cout << moving << " triangles while moving, " << mapper->GetNumberOfTriangles() << " when still\n";
  EXPECT_TRUE(mapper->GetConverged());
  const auto unhurried = MakeWaitingMapper(0.3);
  MTScene other(unhurried);
  other.LookFromTheSide();
  EXPECT_EQ(MTDifference::Compare(still, other.Render()).Pixels, 0u);
}

TEST(MapperBudget, ActorsShareTheTimeOfTheirRenderer)
{
  const auto first = MakeWaitingMapper(0.0);
  const auto second = MakeWaitingMapper(0.0);
  MTScene scene(first);
  vtkNew<vtkActor> other;
  other->SetMapper(second);
  other->SetPosition(0.0, 0.0, 0.5);
  scene.Renderer->AddActor(other);
  scene.LookFromTheSide();
  scene.Window->SetDesiredUpdateRate(10.0);
  for (const auto& mapper : { first, second })
  {
    mapper->SetDrawingRate(3e5);
  }
  scene.Render();
  std::cout << first->GetNumberOfTriangles() << " and " << second->GetNumberOfTriangles() << " triangles\n";
  EXPECT_LE(first->GetNumberOfTriangles() + second->GetNumberOfTriangles(), 30000);
  EXPECT_GT(first->GetNumberOfTriangles(), 5000);
  EXPECT_GT(second->GetNumberOfTriangles(), 5000);
}

TEST(MapperBudget, RateIsMeasuredWhenNoneIsSet)
{
  const auto mapper = MakeWaitingMapper(0.0);
  MTScene scene(mapper);
  scene.LookFromTheSide();
  EXPECT_EQ(mapper->GetCurrentDrawingRate(), 0.0);
  for (int frame = 0; frame < 5; ++frame)
  {
    scene.Render();
  }
  EXPECT_GT(mapper->GetCurrentDrawingRate(), 0.0);
  const vtkIdType all = mapper->GetNumberOfTriangles();
  // So that whatever this machine draws in a second, a tenth of the triangles must do.
  const double rate = 10.0 * mapper->GetCurrentDrawingRate() / static_cast<double>(all);
  scene.Window->SetDesiredUpdateRate(rate);
  scene.Render();
  std::cout << mapper->GetCurrentDrawingRate() << " triangles per second; " << all << " triangles, at " << rate
            << " frames per second " << mapper->GetNumberOfTriangles() << "\n";
  EXPECT_LT(mapper->GetNumberOfTriangles(), all);
  EXPECT_GT(mapper->GetNumberOfTriangles(), all / 100);
}

TEST(MapperBudget, GraphicsMemoryStaysWithinItsLimitAlongAPath)
{
  for (const vtkIdType limit : { 250000, 400000, 550000, 700000, 800000, 1600000 })
  {
    const auto mapper = MakeWaitingMapper(0.25);
    mapper->SetGraphicsMemoryLimit(limit);
    MTScene scene(mapper);
    std::size_t worst = 0;
    vtkIdType most = 0;
    for (int step = 0; step <= 16; ++step)
    {
      Fly(scene, step / 16.0);
      const auto picture = scene.Render();
      most = std::max(most, mapper->GetNumberOfTriangles());
      EXPECT_LE(mapper->GetGraphicsMemory(), limit);
      vtkNew<vtkPolyData> mesh;
      ASSERT_TRUE(mapper->GetCut(mesh));
      vtkNew<vtkPolyDataMapper> reference;
      reference->SetInputData(mesh);
      reference->SetScalarRange(mapper->GetScalarRange());
      MTScene plain(reference);
      Fly(plain, step / 16.0);
      worst = std::max(worst, MTDifference::Compare(picture, plain.Render()).ClearlyOff);
    }
    std::cout << "limit " << limit << ": at most " << mapper->GetMostGraphicsMemory() << " bytes, " << most
              << " triangles; " << mapper->GetNumberOfUploadedBytes() << " bytes uploaded, at worst " << worst
              << " pixels clearly off\n";
    EXPECT_LE(mapper->GetMostGraphicsMemory(), limit);
    EXPECT_GT(mapper->GetMostGraphicsMemory(), limit / 4);
    EXPECT_LE(worst, 6u);
  }
}

TEST(MapperBudget, CoarsestCutIsDrawnWhateverTheLimit)
{
  const auto mapper = MakeWaitingMapper(0.0);
  mapper->SetGraphicsMemoryLimit(0);
  MTScene scene(mapper);
  scene.LookFromTheSide();
  const auto picture = scene.Render();
  EXPECT_EQ(mapper->GetNumberOfRefinedNodes(), 0);
  vtkNew<vtkPolyData> mesh;
  ASSERT_TRUE(mapper->GetCut(mesh));
  EXPECT_EQ(mesh->GetNumberOfCells(), mapper->GetNumberOfTriangles());
  std::cout << mapper->GetNumberOfTriangles() << " triangles in " << mapper->GetMostGraphicsMemory() << " bytes\n";
  vtkNew<vtkPolyDataMapper> reference;
  reference->SetInputData(mesh);
  reference->SetScalarRange(mapper->GetScalarRange());
  MTScene plain(reference);
  plain.LookFromTheSide();
  EXPECT_LE(MTDifference::Compare(picture, plain.Render()).ClearlyOff, 5u);
}

TEST(MapperBudget, LoweredLimitTakesEffectInTheNextFrame)
{
  const auto mapper = MakeWaitingMapper(0.0);
  MTScene scene(mapper);
  scene.LookFromTheSide();
  scene.Render();
  const vtkIdType before = mapper->GetGraphicsMemory();
  mapper->FreezeCutOn();
  for (const vtkIdType limit : { before / 2, before / 4 })
  {
    mapper->SetGraphicsMemoryLimit(limit);
    scene.Render();
    std::cout << "limit " << limit << " after " << before << ": " << mapper->GetGraphicsMemory() << " bytes, "
              << mapper->GetNumberOfTriangles() << " triangles\n";
    EXPECT_LE(mapper->GetGraphicsMemory(), limit);
  }
}

TEST(MapperBudget, GrowingArenaUploadsNothingTwice)
{
  const auto mapper = MakeWaitingMapper(0.0);
  MTScene scene(mapper);
  scene.LookFromTheSide();
  mapper->SetTriangleLimit(2000);
  vtkIdType last = 0;
  for (const vtkIdType budget : { 2000, 4000, 9000, 20000, 0 })
  {
    mapper->SetTriangleLimit(budget);
    scene.Render();
    const vtkIdType uploaded = mapper->GetNumberOfUploadedBytes();
    std::cout << "budget " << budget << ": " << mapper->GetNumberOfTriangles() << " triangles, "
              << mapper->GetGraphicsMemory() << " bytes, " << uploaded - last << " uploaded\n";
    last = uploaded;
  }
  // What a mapper uploads that draws the same at once, and what it drew on the way there.
  const auto direct = MakeWaitingMapper(0.0);
  MTScene other(direct);
  other.LookFromTheSide();
  const auto expected = other.Render();
  EXPECT_EQ(MTDifference::Compare(scene.Render(), expected).Pixels, 0u);
  EXPECT_LE(last, 2 * direct->GetNumberOfUploadedBytes());
}
}
