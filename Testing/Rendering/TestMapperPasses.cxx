// SPDX-License-Identifier: BSD-3-Clause
// What several passes, props and windows make of one mapper.
#include "MTGridModel.h"
#include "MTPicture.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkDataObject.h"
#include "vtkHardwareSelector.h"
#include "vtkImageData.h"
#include "vtkLookupTable.h"
#include "vtkMTPatchStore.h"
#include "vtkMultiTriangulation.h"
#include "vtkMultiTriangulationMapper.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSelection.h"

#include <gtest/gtest.h>

#include <functional>
#include <iostream>
#include <string>
#include <vector>

namespace
{
TEST(MapperPasses, AllPassesOfAFrameShareOneCut)
{
  const auto mapper = MTGridModel::MakeMapper(MTGridModel().MakeData(), 0.8);
  MTScene scene(mapper);
  scene.LookFromTheSide();
  scene.Actor->GetProperty()->SetOpacity(0.4);
  scene.Window->SetAlphaBitPlanes(1);
  scene.Renderer->UseDepthPeelingOn();
  scene.Renderer->SetMaximumNumberOfPeels(20);
  scene.Render();
  EXPECT_EQ(mapper->GetNumberOfCuts(), 1);
  scene.Render();
  EXPECT_EQ(mapper->GetNumberOfCuts(), 1);
  scene.Renderer->GetActiveCamera()->Azimuth(10.0);
  scene.Render();
  EXPECT_EQ(mapper->GetNumberOfCuts(), 2);
  const vtkIdType uploaded = mapper->GetNumberOfUploadedBytes();
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.Renderer);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  selector->SetArea(0, 0, 299, 299);
  vtkSmartPointer<vtkSelection>::Take(selector->Select());
  EXPECT_EQ(mapper->GetNumberOfCuts(), 2);
  EXPECT_EQ(mapper->GetNumberOfUploadedBytes(), uploaded);
  scene.Window->SetStereoTypeToRedBlue();
  scene.Window->StereoRenderOn();
  scene.Render();
  EXPECT_EQ(mapper->GetNumberOfCuts(), 3); // both eyes share the view of the one between them
}

TEST(MapperPasses, WireframeShowsOnItsOwnSurface)
{
  // Two props at the same place: without offsets they would fight for every pixel.
  vtkSmartPointer<vtkImageData> pictures[2];
  vtkNew<vtkPolyData> mesh;
  for (int i = 0; i < 2; ++i)
  {
    vtkSmartPointer<vtkMapper> surface;
    vtkSmartPointer<vtkMapper> lines;
    const auto input = MTGridModel().MakeData();
    for (auto* mapper : { &surface, &lines })
    {
      if (i == 0)
      {
        *mapper = MTGridModel::MakeMapper(input, 0.8);
      }
      else
      {
        const auto plain = vtkSmartPointer<vtkPolyDataMapper>::New();
        plain->SetInputData(mesh);
        *mapper = plain;
      }
      (*mapper)->ScalarVisibilityOff();
      (*mapper)->SetResolveCoincidentTopologyToPolygonOffset();
    }
    lines->SetRelativeCoincidentTopologyLineOffsetParameters(-1.0, -4.0);
    MTScene scene(surface);
    vtkNew<vtkActor> other;
    other->SetMapper(lines);
    other->GetProperty()->SetRepresentationToWireframe();
    other->GetProperty()->SetColor(1.0, 0.0, 0.0);
    other->GetProperty()->LightingOff();
    scene.Renderer->AddActor(other);
    scene.LookFromTheSide();
    pictures[i] = scene.Render();
    if (i == 0)
    {
      ASSERT_TRUE(vtkMultiTriangulationMapper::SafeDownCast(surface)->GetCut(mesh));
      MTWritePicture(pictures[i], std::string(MT_TEST_OUTPUT_DIRECTORY) + "/MapperWireframeOnSurface.png");
    }
  }
  const MTDifference difference = MTDifference::Compare(pictures[0], pictures[1]);
  std::cout << difference << "\n";
  EXPECT_GT(difference.Drawn, 10000u);
  EXPECT_LE(difference.ClearlyOff, difference.Drawn / 500);
}

TEST(MapperPasses, ColourChangesUploadColoursOnly)
{
  const auto mapper = MTGridModel::MakeMapper(MTGridModel().MakeData(), 0.8);
  MTScene scene(mapper);
  scene.LookFromTheSide();
  scene.Render();
  vtkNew<vtkPolyData> mesh;
  ASSERT_TRUE(mapper->GetCut(mesh));
  // Patches repeat the points on their borders.
  const vtkIdType vertices = 2 * mesh->GetNumberOfPoints();
  const vtkIdType triangles = mapper->GetNumberOfTriangles();
  const auto change = [&](const char* what, vtkIdType allowed, const std::function<void()>& apply)
  {
    const vtkIdType before = mapper->GetNumberOfUploadedBytes();
    const vtkIdType cuts = mapper->GetNumberOfCuts();
    apply();
    scene.Render();
    const vtkIdType uploaded = mapper->GetNumberOfUploadedBytes() - before;
    std::cout << what << ": " << uploaded << " bytes uploaded, " << allowed << " allowed\n";
    EXPECT_LE(uploaded, allowed) << what;
    EXPECT_EQ(mapper->GetNumberOfCuts(), cuts) << what;
  };
  change("range", 4 * vertices, [&]() { mapper->SetScalarRange(-0.1, 0.1); });
  change(
    "hues", 4 * vertices, [&]() { vtkLookupTable::SafeDownCast(mapper->GetLookupTable())->SetHueRange(0.3, 0.8); });
  change("table", 4 * vertices,
    [&]()
    {
      vtkNew<vtkLookupTable> table;
      table->SetRange(-0.1, 0.1);
      mapper->SetLookupTable(table);
    });
  change("point array", 4 * vertices,
    [&]()
    {
      mapper->SetScalarModeToUsePointFieldData();
      mapper->SelectColorArray("TCoords");
    });
  change("cell array", 4 * triangles,
    [&]()
    {
      mapper->SetScalarModeToUseCellFieldData();
      mapper->SelectColorArray("Block");
      mapper->SetScalarRange(0.0, 63.0);
    });
  change("range of cells", 4 * triangles, [&]() { mapper->SetScalarRange(10.0, 53.0); });
  change("through a texture", 8 * vertices,
    [&]()
    {
      mapper->SetScalarModeToDefault();
      mapper->InterpolateScalarsBeforeMappingOn();
      mapper->SetScalarRange(-0.15, 0.15);
    });
  change("none", 0, [&]() { mapper->ScalarVisibilityOff(); });
  change("colour of the property", 0, [&]() { scene.Actor->GetProperty()->SetColor(1.0, 0.5, 0.0); });
  change("opacity", 0, [&]() { scene.Actor->GetProperty()->SetOpacity(0.5); });
  change("flat", 0, [&]() { scene.Actor->GetProperty()->SetInterpolationToFlat(); });
}

TEST(MapperPasses, ArraysThatNobodyAsksForAreNotUploaded)
{
  vtkIdType bytes[3];
  for (int i = 0; i < 3; ++i)
  {
    const auto mapper = MTGridModel::MakeMapper(MTGridModel().MakeData(), 0.8);
    mapper->SetScalarVisibility(i > 0);
    MTScene scene(mapper);
    scene.LookFromTheSide();
    scene.Actor->GetProperty()->SetInterpolation(i == 2 ? VTK_GOURAUD : VTK_FLAT);
    scene.Render();
    bytes[i] = mapper->GetNumberOfUploadedBytes();
  }
  std::cout << "positions and triangles " << bytes[0] << " bytes, with scalars " << bytes[1] << ", with normals "
            << bytes[2] << "\n";
  EXPECT_LT(bytes[0], bytes[1]);
  EXPECT_EQ(bytes[1], bytes[2]) << "normals lie in the same words as positions";
}

TEST(MapperPasses, NeedsNoInteractorAndNoSecondFrame)
{
  const auto mapper = MTGridModel::MakeMapper(MTGridModel().MakeData(), 0.8);
  MTScene scene(mapper);
  scene.LookFromTheSide();
  EXPECT_EQ(scene.Window->GetInteractor(), nullptr);
  const auto first = scene.Render();
  EXPECT_TRUE(mapper->GetConverged());
  EXPECT_EQ(MTDifference::Compare(scene.Render(), first).Pixels, 0u);
}

TEST(MapperPasses, SecondWindowMayLookDifferently)
{
  // One mapper, two windows, two actors, two views, turn by turn.
  const auto input = MTGridModel().MakeData();
  const auto shared = MTGridModel::MakeMapper(input, 0.8);
  MTScene near(shared);
  MTScene far(shared);
  far.Actor->GetProperty()->SetRepresentationToWireframe();
  vtkSmartPointer<vtkImageData> pictures[2];
  near.LookFromTheSide();
  far.LookFromTheSide();
  far.Renderer->GetActiveCamera()->Zoom(0.4);
  for (int turn = 0; turn < 3; ++turn)
  {
    pictures[0] = near.Render();
    pictures[1] = far.Render();
  }
  for (int i = 0; i < 2; ++i)
  {
    const auto alone = MTGridModel::MakeMapper(input, 0.8);
    MTScene scene(alone);
    scene.Actor->GetProperty()->SetRepresentation(i == 0 ? VTK_SURFACE : VTK_WIREFRAME);
    scene.LookFromTheSide();
    scene.Renderer->GetActiveCamera()->Zoom(i == 0 ? 1.0 : 0.4);
    EXPECT_EQ(MTDifference::Compare(pictures[i], scene.Render()).Pixels, 0u);
  }
}
}
