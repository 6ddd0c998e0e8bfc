// SPDX-License-Identifier: BSD-3-Clause
// Frames that do not wait: what is there is drawn, the rest comes.
#include "MTGridModel.h"
#include "MTPicture.h"

#include "vtkActor.h"
#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkMTGraph.h"
#include "vtkMTPatchSource.h"
#include "vtkMTPatchStore.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiTriangulation.h"
#include "vtkMultiTriangulationMapper.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <iostream>
#include <mutex>
#include <set>
#include <thread>

namespace
{
// Reads wait while it is shut; some patches are broken.
class SlowSource : public vtkMTPatchSource
{
public:
  explicit SlowSource(std::shared_ptr<const vtkMTPatchSource> model)
    : Model(std::move(model))
  {
  }
  const vtkMTGraph& GetGraph() const override { return this->Model->GetGraph(); }
  bool ReadPatch(
    std::uint32_t arc, const std::vector<unsigned char>* arrays, vtkMTPatch& patch, std::string& error) const override
  {
    {
      std::unique_lock<std::mutex> lock(this->Mutex);
      const bool coarsest = this->GetGraph().Arcs[arc].From == this->GetGraph().GetSource();
      this->Changed.wait(lock, [this, coarsest] { return this->Open || coarsest; });
    }
    if (this->Broken.count(arc))
    {
      error = "slow.bmt: patch " + std::to_string(arc) + ": planned failure";
      return false;
    }
    return this->Model->ReadPatch(arc, arrays, patch, error);
  }
  std::uint64_t GetPatchSize(std::uint32_t arc) const override { return this->Model->GetPatchSize(arc); }
  std::string GetName() const override { return "slow.bmt"; }

  void SetOpen(bool open)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Open = open;
    this->Changed.notify_all();
  }

  std::set<std::uint32_t> Broken;

private:
  std::shared_ptr<const vtkMTPatchSource> Model;
  mutable std::mutex Mutex;
  mutable std::condition_variable Changed;
  bool Open = true;
};

vtkSmartPointer<vtkMultiTriangulationMapper> MakeMapper(
  const std::shared_ptr<const vtkMTPatchSource>& source, double pixelError = 0.3)
{
  vtkNew<vtkMultiTriangulation> input;
  EXPECT_TRUE(input->SetSource(source));
  auto mapper = vtkSmartPointer<vtkMultiTriangulationMapper>::New();
  mapper->SetInputData(input);
  mapper->SetPixelError(pixelError);
  mapper->SetScalarRange(-0.15, 0.15);
  return mapper;
}

void Look(MTScene& scene, double t = 0.3)
{
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(0.1 + 0.8 * t, -1.5 + 2.0 * t, 1.2 - 1.0 * std::sin(3.14 * t));
  camera->SetFocalPoint(0.5, 0.5 + 0.3 * t, 0.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  scene.Renderer->ResetCameraClippingRange();
}

// The picture of the mapper's cut by a plain mapper.
std::size_t CountWrongPixels(vtkMultiTriangulationMapper* mapper, MTScene& scene, vtkImageData* picture)
{
  vtkNew<vtkPolyData> mesh;
  EXPECT_TRUE(mapper->GetCut(mesh));
  vtkNew<vtkPolyDataMapper> reference;
  reference->SetInputData(mesh);
  reference->SetScalarRange(mapper->GetScalarRange());
  MTScene plain(reference);
  plain.Renderer->SetActiveCamera(scene.Renderer->GetActiveCamera());
  return MTDifference::Compare(picture, plain.Render()).ClearlyOff;
}

TEST(MapperLoading, CoarsestPatchesAreOnScreenAtOnceWhileEverythingElseHangs)
{
  const auto source = std::make_shared<SlowSource>(MTGridModel().Make());
  source->SetOpen(false);
  const auto mapper = MakeMapper(source);
  mapper->WaitForConvergenceOff();
  MTScene scene(mapper);
  Look(scene);
  for (int frame = 0; frame < 5; ++frame)
  {
    const auto picture = scene.Render(); // would never come back if it waited for anything
    EXPECT_EQ(mapper->GetNumberOfRefinedNodes(), 0);
    EXPECT_GT(mapper->GetNumberOfTriangles(), 0);
    EXPECT_TRUE(mapper->GetLoading());
    EXPECT_FALSE(mapper->GetConverged());
    EXPECT_LE(CountWrongPixels(mapper, scene, picture), 6u);
  }
  source->SetOpen(true);
}

TEST(MapperLoading, FramesThatDoNotWaitEndWithThePictureOfThoseThatDo)
{
  const auto source = std::make_shared<SlowSource>(MTGridModel().Make());
  const auto waiting = MakeMapper(source);
  waiting->WaitForConvergenceOn();
  MTScene first(waiting);
  Look(first);
  const auto expected = first.Render();
  EXPECT_FALSE(waiting->GetLoading());

  const auto mapper = MakeMapper(source);
  mapper->WaitForConvergenceOff();
  mapper->SetUploadLimit(60000);
  MTScene second(mapper);
  Look(second);
  auto picture = second.Render();
  int frames = 1;
  vtkIdType uploaded = mapper->GetNumberOfUploadedBytes();
  for (; mapper->GetLoading() && frames < 5000; ++frames)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    picture = second.Render();
    EXPECT_LE(mapper->GetNumberOfUploadedBytes() - uploaded, 60000);
    uploaded = mapper->GetNumberOfUploadedBytes();
  }
  std::cout << frames << " frames, " << mapper->GetNumberOfTriangles() << " triangles, longest lock "
            << mapper->GetLongestLock() * 1e6 << " microseconds\n";
  EXPECT_FALSE(mapper->GetLoading());
  EXPECT_TRUE(mapper->GetConverged());
  EXPECT_EQ(mapper->GetNumberOfTriangles(), waiting->GetNumberOfTriangles());
  EXPECT_EQ(MTDifference::Compare(picture, expected).Pixels, 0u);
}

TEST(MapperLoading, EveryFrameOfAFlightIsRightAndWithinItsLimits)
{
  const auto source = std::make_shared<SlowSource>(MTGridModel().Make());
  const auto mapper = MakeMapper(source);
  mapper->WaitForConvergenceOff();
  mapper->SetUploadLimit(80000);
  mapper->SetPatchMemoryLimit(600000);
  mapper->SetGraphicsMemoryLimit(900000);
  mapper->SetTriangleLimit(12000);
  MTScene scene(mapper);
  std::size_t worst = 0;
  vtkIdType most = 0;
  vtkIdType uploaded = 0;
  for (int step = 0; step <= 40; ++step)
  {
    const double t = step / 40.0;
    Look(scene, t);
    const auto picture = scene.Render();
    most = std::max(most, mapper->GetNumberOfTriangles());
    EXPECT_LE(mapper->GetNumberOfTriangles(), 12000);
    EXPECT_LE(mapper->GetMostPatchMemory(), 600000);
    EXPECT_LE(mapper->GetMostGraphicsMemory(), 900000);
    if (step > 0)
    {
      EXPECT_LE(mapper->GetNumberOfUploadedBytes() - uploaded, 80000);
    }
    uploaded = mapper->GetNumberOfUploadedBytes();
    if (step % 4 == 0)
    {
      worst = std::max(worst, CountWrongPixels(mapper, scene, picture));
    }
  }
  std::cout << "at most " << most << " triangles, " << mapper->GetMostPatchMemory() << " bytes in main memory, "
            << mapper->GetMostGraphicsMemory() << " on the GPU; " << mapper->GetNumberOfReads()
            << " patches read; at worst " << worst << " pixels clearly off\n";
  EXPECT_LE(worst, 6u);
}

TEST(MapperLoading, StillFramesWaitAndMovingOnesDoNot)
{
  const auto source = std::make_shared<SlowSource>(MTGridModel().Make());
  source->SetOpen(false);
  const auto mapper = MakeMapper(source);
  MTScene scene(mapper);
  Look(scene);
  scene.Window->SetDesiredUpdateRate(15.0);
  scene.Render();
  EXPECT_TRUE(mapper->GetLoading());
  source->SetOpen(true);
  scene.Window->SetDesiredUpdateRate(0.0001);
  scene.Render();
  EXPECT_FALSE(mapper->GetLoading());
  EXPECT_TRUE(mapper->GetConverged());
}

TEST(MapperLoading, SeveralMappersAndViewsShareOneSource)
{
  const auto source = std::make_shared<SlowSource>(MTGridModel().Make());
  const auto first = MakeMapper(source);
  const auto second = MakeMapper(source);
  first->WaitForConvergenceOff();
  second->WaitForConvergenceOff();
  MTScene scene(first);
  vtkNew<vtkActor> other;
  other->SetMapper(second);
  other->SetPosition(0.0, 0.0, 0.3);
  scene.Renderer->AddActor(other);
  // The first mapper has a second view besides.
  vtkNew<vtkRenderer> beside;
  beside->SetViewport(0.5, 0.0, 1.0, 1.0);
  scene.Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  vtkNew<vtkActor> again;
  again->SetMapper(first);
  beside->AddActor(again);
  scene.Window->AddRenderer(beside);
  Look(scene);
  beside->ResetCamera();
  int frames = 0;
  int quiet = 0;
  for (; quiet < 3 && frames < 5000; ++frames)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    scene.Render();
    quiet = first->GetLoading() || second->GetLoading() ? 0 : quiet + 1;
  }
  std::cout << frames << " frames\n";
  EXPECT_TRUE(first->GetConverged());
  EXPECT_TRUE(second->GetConverged());
}

TEST(MapperLoading, BrokenPatchIsNamedOnceAndTheCoarserOneStays)
{
  const auto source = std::make_shared<SlowSource>(MTGridModel().Make());
  const vtkMTGraph& graph = source->GetGraph();
  for (std::uint32_t arc = 0; arc < graph.Arcs.size(); arc += 9)
  {
    if (graph.Arcs[arc].From != graph.GetSource())
    {
      source->Broken.insert(arc);
    }
  }
  const auto mapper = MakeMapper(source, 0.0);
  mapper->WaitForConvergenceOff();
  std::multiset<std::string> messages;
  vtkNew<vtkCallbackCommand> callback;
  callback->SetClientData(&messages);
  callback->SetCallback([](vtkObject*, unsigned long, void* client, void* text)
    { static_cast<std::multiset<std::string>*>(client)->insert(static_cast<const char*>(text)); });
  mapper->AddObserver(vtkCommand::ErrorEvent, callback);
  MTScene scene(mapper);
  scene.Renderer->ResetCamera(); // all of it: GetCut reads patches outside the view as well
  auto picture = scene.Render();
  for (int frame = 0; mapper->GetLoading() && frame < 5000; ++frame)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    picture = scene.Render();
  }
  EXPECT_FALSE(mapper->GetLoading());
  EXPECT_FALSE(mapper->GetConverged());
  EXPECT_FALSE(messages.empty());
  for (const std::string& message : messages)
  {
    EXPECT_EQ(messages.count(message), 1u);
    EXPECT_NE(message.find("slow.bmt"), std::string::npos);
    EXPECT_NE(message.find("patch"), std::string::npos);
  }
  std::cout << messages.size() << " messages, " << mapper->GetNumberOfTriangles() << " triangles\n";
  EXPECT_GT(mapper->GetNumberOfRefinedNodes(), 0);
  EXPECT_LE(CountWrongPixels(mapper, scene, picture), 6u);
}

TEST(MapperLoading, WhatFacesAwayIsLeftOutAndChangesNoPixel)
{
  const auto source = std::make_shared<SlowSource>(MTGridModel().Make());
  vtkIdType leftOut = 0;
  for (const bool mirrored : { false, true })
  {
    for (const bool parallel : { false, true })
    {
      for (const double side : { 0.4, -0.4 })
      {
        std::vector<vtkSmartPointer<vtkImageData>> pictures;
        for (const bool culling : { true, false })
        {
          const auto mapper = MakeMapper(source, 0.2);
          mapper->SetFacingCulling(culling);
          MTScene scene(mapper);
          scene.Actor->GetProperty()->BackfaceCullingOn();
          vtkNew<vtkMatrix4x4> matrix;
          matrix->SetElement(0, 0, mirrored ? -1.0 : 1.0);
          matrix->SetElement(0, 1, 0.2);
          scene.Actor->SetUserMatrix(matrix);
          vtkCamera* camera = scene.Renderer->GetActiveCamera();
          camera->SetParallelProjection(parallel);
          camera->SetPosition(0.5, -1.0, side);
          camera->SetFocalPoint(mirrored ? -0.5 : 0.5, 0.5, 0.0);
          camera->SetViewUp(0.0, 0.0, 1.0);
          scene.Renderer->ResetCamera();
          pictures.push_back(scene.Render());
          leftOut += mapper->GetNumberOfFacingAwayPatches();
          EXPECT_TRUE(culling || mapper->GetNumberOfFacingAwayPatches() == 0);
        }
        EXPECT_EQ(MTDifference::Compare(pictures[0], pictures[1]).Pixels, 0u);
      }
    }
  }
  std::cout << leftOut << " patches left out\n";
  EXPECT_GT(leftOut, 100);
}
}
