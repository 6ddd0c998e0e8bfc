// SPDX-License-Identifier: BSD-3-Clause
// One mapper, several renderers, windows and eyes.
#include "MTGridModel.h"
#include "MTPicture.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkMTPatchStore.h"
#include "vtkMultiTriangulation.h"
#include "vtkMultiTriangulationMapper.h"
#include "vtkNew.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

#include <iostream>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace
{
// Close above one corner of the model or the opposite one: the two views have few patches in common.
void LookAtCorner(vtkRenderer* renderer, bool opposite)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(opposite ? 0.9 : 0.1, opposite ? 1.15 : -0.15, 0.25);
  camera->SetFocalPoint(opposite ? 0.75 : 0.25, opposite ? 0.8 : 0.2, 0.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  renderer->ResetCameraClippingRange();
}

TEST(MapperSharing, TwoRenderersOfAWindowUploadNothingWhereNothingMoves)
{
  for (const vtkIdType limit : { vtkIdType(512) << 20, vtkIdType(700000) })
  {
    const auto mapper = MTGridModel::MakeMapper(MTGridModel().MakeData(), 0.2);
    mapper->SetGraphicsMemoryLimit(limit);
    MTScene scene(mapper);
    vtkNew<vtkRenderer> other;
    other->AddActor(scene.Actor);
    scene.Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
    other->SetViewport(0.5, 0.0, 1.0, 1.0);
    scene.Window->AddRenderer(other);
    LookAtCorner(scene.Renderer, false);
    LookAtCorner(other, true);
    scene.Render();
    auto picture = scene.Render();
    const vtkIdType uploaded = mapper->GetNumberOfUploadedBytes();
    const vtkIdType cuts = mapper->GetNumberOfCuts();
    for (int frame = 0; frame < 5; ++frame)
    {
      const auto again = scene.Render();
      EXPECT_EQ(MTDifference::Compare(picture, again).Pixels, 0u);
      EXPECT_EQ(mapper->GetNumberOfUploadedBytes(), uploaded) << "frame " << frame;
    }
    std::cout << uploaded << " bytes uploaded for two views, " << mapper->GetGraphicsMemory() << " of "
              << mapper->GetMostGraphicsMemory() << " on the GPU, limit " << limit << "\n";
    EXPECT_EQ(mapper->GetNumberOfCuts(), cuts);
    EXPECT_LE(mapper->GetMostGraphicsMemory(), limit);
    // One of them moves: it uploads, and the other one's patches stay.
    other->GetActiveCamera()->Azimuth(20.0);
    scene.Render();
    const vtkIdType moved = mapper->GetNumberOfUploadedBytes();
    scene.Render();
    EXPECT_EQ(mapper->GetNumberOfUploadedBytes(), moved);
    EXPECT_LT(moved - uploaded, uploaded / 2);
  }
}

TEST(MapperSharing, TwoWindowsUploadNothingWhereNothingMovesAndShareTheLimit)
{
  for (const vtkIdType limit : { vtkIdType(512) << 20, vtkIdType(900000) })
  {
    const auto mapper = MTGridModel::MakeMapper(MTGridModel().MakeData(), 0.2);
    mapper->SetGraphicsMemoryLimit(limit);
    MTScene first(mapper);
    auto second = std::make_unique<MTScene>(mapper);
    second->Actor->GetProperty()->SetRepresentationToWireframe();
    LookAtCorner(first.Renderer, false);
    LookAtCorner(second->Renderer, true);
    vtkSmartPointer<vtkImageData> pictures[2];
    for (int frame = 0; frame < 3; ++frame)
    {
      pictures[0] = first.Render();
      pictures[1] = second->Render();
    }
    const vtkIdType uploaded = mapper->GetNumberOfUploadedBytes();
    for (int frame = 0; frame < 4; ++frame)
    {
      EXPECT_EQ(MTDifference::Compare(first.Render(), pictures[0]).Pixels, 0u);
      EXPECT_EQ(MTDifference::Compare(second->Render(), pictures[1]).Pixels, 0u);
      EXPECT_EQ(mapper->GetNumberOfUploadedBytes(), uploaded) << "frame " << frame;
    }
    const vtkIdType both = mapper->GetGraphicsMemory();
    EXPECT_LE(mapper->GetMostGraphicsMemory(), limit);
    second.reset();
    std::cout << uploaded << " bytes uploaded for two windows, " << both << " on the GPU, at most "
              << mapper->GetMostGraphicsMemory() << " of " << limit << "; " << mapper->GetGraphicsMemory()
              << " when one is closed\n";
    EXPECT_LT(mapper->GetGraphicsMemory(), both);
    EXPECT_GT(mapper->GetGraphicsMemory(), 0);
    first.Render();
    EXPECT_TRUE(limit < 1000000 || mapper->GetNumberOfUploadedBytes() == uploaded);
  }
}

TEST(MapperSharing, TwoActorsInARendererHaveTheirOwnCuts)
{
  const auto mapper = MTGridModel::MakeMapper(MTGridModel().MakeData(), 0.2);
  MTScene scene(mapper);
  vtkNew<vtkActor> other;
  other->SetMapper(mapper);
  other->SetPosition(0.1, 0.2, -0.1);
  scene.Renderer->AddActor(other);
  LookAtCorner(scene.Renderer, false);
  scene.Render();
  EXPECT_EQ(mapper->GetNumberOfCuts(), 2);
  scene.Render();
  const vtkIdType uploaded = mapper->GetNumberOfUploadedBytes();
  scene.Render();
  EXPECT_EQ(mapper->GetNumberOfCuts(), 2);
  EXPECT_EQ(mapper->GetNumberOfUploadedBytes(), uploaded);
}

// Surfaces, lines and points, smooth and flat, with data of cells: each has data on the GPU that the others have not.
TEST(MapperSharing, ActorsOfDifferentRepresentationTakeNothingFromEachOther)
{
  for (const bool cells : { false, true })
  {
    const auto mapper = MTGridModel::MakeMapper(MTGridModel().MakeData(), 0.2);
    if (cells)
    {
      mapper->SetScalarModeToUseCellFieldData();
      mapper->SelectColorArray("Block");
      mapper->SetScalarRange(0.0, 63.0);
    }
    MTScene scene(mapper, 150, 150);
    const int representations[] = { VTK_WIREFRAME, VTK_POINTS, VTK_SURFACE };
    for (int i = 0; i < 3; ++i)
    {
      vtkNew<vtkActor> other;
      other->SetMapper(mapper);
      other->SetPosition(0.05 * (i + 1), 0.1 * (i + 1), -0.06 * (i + 1));
      other->GetProperty()->SetRepresentation(representations[i]);
      other->GetProperty()->SetInterpolation(i == 2 ? VTK_FLAT : VTK_GOURAUD);
      scene.Renderer->AddActor(other);
    }
    LookAtCorner(scene.Renderer, false);
    scene.Render();
    const auto picture = scene.Render();
    const vtkIdType uploaded = mapper->GetNumberOfUploadedBytes();
    const vtkIdType reads = mapper->GetNumberOfReads();
    const vtkIdType cuts = mapper->GetNumberOfCuts();
    const vtkIdType all = mapper->GetGraphicsMemory();
    MTWritePicture(
      picture, std::string(MT_TEST_OUTPUT_DIRECTORY) + "/Representations" + (cells ? "OfCells" : "") + ".png");
    for (int frame = 0; frame < 5; ++frame)
    {
      EXPECT_EQ(MTDifference::Compare(scene.Render(), picture).Pixels, 0u);
      EXPECT_EQ(mapper->GetNumberOfUploadedBytes(), uploaded) << "frame " << frame;
      EXPECT_EQ(mapper->GetNumberOfReads(), reads) << "frame " << frame;
      EXPECT_EQ(mapper->GetNumberOfCuts(), cuts) << "frame " << frame;
    }
    // The others are drawn no more: what only they needed goes after some frames.
    vtkActorCollection* actors = scene.Renderer->GetActors();
    actors->InitTraversal();
    while (vtkActor* actor = actors->GetNextActor())
    {
      actor->SetVisibility(actor == scene.Actor);
    }
    for (int frame = 0; frame < 260; ++frame)
    {
      scene.Render();
    }
    std::cout << uploaded << " bytes uploaded for four actors, " << all << " on the GPU; "
              << mapper->GetGraphicsMemory() << " when three of them are gone\n";
    EXPECT_LT(mapper->GetGraphicsMemory(), all);
    EXPECT_EQ(mapper->GetNumberOfUploadedBytes(), uploaded);
  }
}

// Eyes far apart, so that each sees what the other does not.
TEST(MapperSharing, CullingInStereoChangesNoPixel)
{
  vtkIdType culled = 0;
  vtkIdType away = 0;
  for (const bool parallel : { false, true })
  {
    for (const double angle : { 2.0, 25.0 })
    {
      for (const bool shifted : { false, true })
      {
        std::vector<vtkSmartPointer<vtkImageData>> pictures;
        std::vector<vtkIdType> drawn;
        for (const bool culling : { true, false })
        {
          const auto mapper = MTGridModel::MakeMapper(MTGridModel().MakeData(), 0.2);
          mapper->SetFrustumCulling(culling);
          mapper->SetFacingCulling(culling);
          MTScene scene(mapper);
          scene.Actor->GetProperty()->BackfaceCullingOn();
          LookAtCorner(scene.Renderer, false);
          vtkCamera* camera = scene.Renderer->GetActiveCamera();
          camera->SetParallelProjection(parallel);
          camera->SetParallelScale(0.12);
          camera->SetEyeAngle(angle);
          camera->SetWindowCenter(shifted ? 0.3 : 0.0, shifted ? -0.2 : 0.0);
          scene.Renderer->ResetCameraClippingRange();
          scene.Window->SetStereoTypeToAnaglyph();
          scene.Window->StereoRenderOn();
          pictures.push_back(scene.Render());
          drawn.push_back(mapper->GetNumberOfPatches());
          EXPECT_EQ(mapper->GetNumberOfCuts(), 1); // both eyes share it
          scene.Render();
          EXPECT_EQ(mapper->GetNumberOfCuts(), 1);
          culled += mapper->GetNumberOfCulledPatches();
          away += mapper->GetNumberOfFacingAwayPatches();
        }
        EXPECT_LT(drawn[0], drawn[1]);
        EXPECT_EQ(MTDifference::Compare(pictures[0], pictures[1]).Pixels, 0u) << "eye angle " << angle;
      }
    }
  }
  std::cout << culled << " patches culled, " << away << " left out for facing away\n";
  EXPECT_GT(culled, 100);
}

TEST(MapperSharing, SettersRefuseWhatIsNotANumber)
{
  vtkNew<vtkMultiTriangulationMapper> mapper;
  int errors = 0;
  vtkNew<vtkCallbackCommand> callback;
  callback->SetClientData(&errors);
  callback->SetCallback([](vtkObject*, unsigned long, void* client, void*) { ++*static_cast<int*>(client); });
  mapper->AddObserver(vtkCommand::ErrorEvent, callback);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const vtkMTimeType before = mapper->GetMTime();
  mapper->SetPixelError(nan);
  mapper->SetCutTimeLimit(nan);
  mapper->SetDrawingRate(nan);
  EXPECT_EQ(errors, 3);
  EXPECT_EQ(mapper->GetMTime(), before);
  EXPECT_EQ(mapper->GetPixelError(), 1.0);
  EXPECT_EQ(mapper->GetCutTimeLimit(), 0.01);
  EXPECT_EQ(mapper->GetDrawingRate(), 0.0);
  mapper->SetPixelError(-3.0);
  EXPECT_EQ(mapper->GetPixelError(), 0.0);
  mapper->SetPixelError(std::numeric_limits<double>::infinity());
  EXPECT_EQ(mapper->GetPixelError(), 1e9);
}
}
