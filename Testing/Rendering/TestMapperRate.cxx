// SPDX-License-Identifier: BSD-3-Clause
// A window's frames are timed as a whole, for all mappers in it, for as long as there are mappers.
#include "MTGridModel.h"
#include "MTPicture.h"

#include "vtkActor.h"
#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkHardwareSelector.h"
#include "vtkMTPatchStore.h"
#include "vtkMultiTriangulation.h"
#include "vtkMultiTriangulationMapper.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSelection.h"

#include <gtest/gtest.h>

#include <chrono>
#include <iostream>
#include <memory>
#include <thread>

#include <sys/resource.h>

namespace
{
// Of the finest cut; it waits for it also where a frame rate is asked for.
vtkSmartPointer<vtkMultiTriangulationMapper> MakeFinestMapper()
{
  auto mapper = MTGridModel::MakeMapper(MTGridModel().MakeData(), 0.0);
  mapper->WaitForConvergenceOn();
  return mapper;
}

bool IsTimed(vtkRenderWindow* window)
{
  return window->HasObserver(vtkCommand::StartEvent) && window->HasObserver(vtkCommand::EndEvent);
}

// Part of a renderer's time that no mapper has.
void Delay(vtkRenderer* renderer, unsigned long event)
{
  vtkNew<vtkCallbackCommand> callback;
  callback->SetCallback(
    [](vtkObject*, unsigned long, void*, void*) { std::this_thread::sleep_for(std::chrono::milliseconds(40)); });
  renderer->AddObserver(event, callback);
}

long GetPageFaults()
{
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_minflt;
}

// Only software OpenGL has its memory from the heap: 2,000 pages where the C library takes it back after each frame.
TEST(MapperRate, MemoryOfAFrameStaysForTheNextOne)
{
  const auto mapper = MakeFinestMapper();
  MTScene scene(mapper);
  scene.Render();
  scene.Render();
  const long before = GetPageFaults();
  constexpr int frames = 10;
  for (int frame = 0; frame < frames; ++frame)
  {
    scene.Render();
  }
  const long faults = (GetPageFaults() - before) / frames;
  std::cout << mapper->GetNumberOfTriangles() << " triangles: " << faults << " pages fetched by a frame\n";
  EXPECT_LT(faults, 1000);
}

TEST(MapperRate, WholeFramesAreMeasured)
{
  for (const unsigned long event : { vtkCommand::StartEvent, vtkCommand::EndEvent })
  {
    const auto mapper = MakeFinestMapper();
    MTScene scene(mapper);
    Delay(scene.Renderer, event);
    for (int frame = 0; frame < 4; ++frame)
    {
      scene.Render();
    }
    const double rate = mapper->GetCurrentDrawingRate();
    std::cout << mapper->GetNumberOfTriangles() << " triangles, " << rate << " a second\n";
    EXPECT_GT(rate, 0.0);
    EXPECT_LE(rate, static_cast<double>(mapper->GetNumberOfTriangles()) / 0.04);
  }
}

TEST(MapperRate, TimeThatOthersTakeMakesTheCutCoarser)
{
  const auto mapper = MakeFinestMapper();
  MTScene scene(mapper);
  scene.Render();
  const vtkIdType all = mapper->GetNumberOfTriangles();
  Delay(scene.Renderer, vtkCommand::EndEvent);
  scene.Window->SetDesiredUpdateRate(50.0); // less than what the others alone take
  for (int frame = 0; frame < 60; ++frame)
  {
    scene.Render();
  }
  std::cout << all << " triangles without a rate, " << mapper->GetNumberOfTriangles() << " with one\n";
  EXPECT_LE(mapper->GetNumberOfTriangles(), all / 10);
}

TEST(MapperRate, ObserversGoWithTheLastMapperOfTheWindow)
{
  auto first = MakeFinestMapper();
  auto scene = std::make_unique<MTScene>(first);
  EXPECT_FALSE(IsTimed(scene->Window));
  vtkNew<vtkActor> actor;
  {
    const auto second = MakeFinestMapper();
    actor->SetMapper(second);
    scene->Renderer->AddActor(actor);
    scene->Render();
    EXPECT_TRUE(IsTimed(scene->Window));
    actor->SetMapper(nullptr);
    scene->Renderer->RemoveActor(actor);
  }
  scene->Render();
  EXPECT_TRUE(IsTimed(scene->Window));
  scene->Renderer->RemoveActor(scene->Actor);
  scene->Actor->SetMapper(nullptr);
  scene->Mapper = nullptr;
  first = nullptr;
  EXPECT_FALSE(IsTimed(scene->Window));
  scene->Window->Render();
}

TEST(MapperRate, WindowMayGoFirst)
{
  const auto mapper = MakeFinestMapper();
  for (int i = 0; i < 3; ++i)
  {
    MTScene scene(mapper);
    for (int frame = 0; frame < 4; ++frame)
    {
      scene.Render();
    }
    EXPECT_GT(mapper->GetCurrentDrawingRate(), 0.0);
  }
  EXPECT_EQ(mapper->GetCurrentDrawingRate(), 0.0); // there is no window that it would be of
}

TEST(MapperRate, EachWindowOfAMapperHasItsOwn)
{
  const auto mapper = MakeFinestMapper();
  MTScene slow(mapper);
  MTScene other(mapper);
  Delay(slow.Renderer, vtkCommand::EndEvent);
  for (int frame = 0; frame < 4; ++frame)
  {
    slow.Render();
    EXPECT_LE(mapper->GetCurrentDrawingRate(), static_cast<double>(mapper->GetNumberOfTriangles()) / 0.04);
    other.Render();
  }
  EXPECT_GT(mapper->GetCurrentDrawingRate(), 0.0);
  EXPECT_TRUE(IsTimed(slow.Window));
  EXPECT_TRUE(IsTimed(other.Window));
}

TEST(MapperRate, SelectionsAreNoFrames)
{
  const auto mapper = MakeFinestMapper();
  MTScene scene(mapper);
  for (int frame = 0; frame < 4; ++frame)
  {
    scene.Render();
  }
  Delay(scene.Renderer, vtkCommand::EndEvent);
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.Renderer);
  selector->SetArea(100, 100, 200, 200);
  vtkSmartPointer<vtkSelection>::Take(selector->Select()); // in which it becomes known what the last frame took
  const double rate = mapper->GetCurrentDrawingRate();
  for (int i = 0; i < 4; ++i)
  {
    vtkSmartPointer<vtkSelection>::Take(selector->Select());
  }
  EXPECT_GT(rate, 0.0);
  EXPECT_EQ(mapper->GetCurrentDrawingRate(), rate);
}
}
