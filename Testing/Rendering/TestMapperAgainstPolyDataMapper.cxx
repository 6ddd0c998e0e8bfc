// SPDX-License-Identifier: BSD-3-Clause
// vtkMultiTriangulationMapper draws the pixels that vtkPolyDataMapper draws for the very same triangles.
#include "MTGridModel.h"
#include "MTPicture.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLookupTable.h"
#include "vtkMTPatchStore.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiTriangulation.h"
#include "vtkMultiTriangulationMapper.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <functional>
#include <iostream>
#include <string>
#include <vector>

namespace
{
using Change = std::function<void(MTScene&)>;

struct State
{
  std::string Name;
  Change Apply;
  MTGridModel Model;
  double Allowed = 0.0; // share of the drawn pixels that may be clearly off
};

void PrintTo(const State& state, std::ostream* os)
{
  *os << state.Name;
}

// A silhouette may pass a pixel's centre on the other side: positions are rounded to floats in another way.
constexpr double Silhouettes = 1e-4;
// Lines along an edge of two triangles have equal depths, so the one drawn first wins, and the order is another.
constexpr double EqualDepths = 2e-3;

void LookFromTheSide(MTScene& scene)
{
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  scene.Renderer->ResetCamera();
  camera->Elevation(-50.0);
  camera->Azimuth(15.0);
  camera->Zoom(1.3);
  scene.Renderer->ResetCameraClippingRange();
}

void MakeTexture(vtkTexture* texture)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(16, 16, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int j = 0; j < 16; ++j)
  {
    for (int i = 0; i < 16; ++i)
    {
      auto* pixel = static_cast<unsigned char*>(image->GetScalarPointer(i, j, 0));
      pixel[0] = static_cast<unsigned char>(16 * i);
      pixel[1] = static_cast<unsigned char>(16 * j);
      pixel[2] = (i + j) % 2 ? 200 : 40;
    }
  }
  texture->SetInputData(image);
  texture->InterpolateOn();
}

std::vector<State> GetStates()
{
  std::vector<State> states;
  const auto add = [&states](const std::string& name, const Change& change, double allowed = Silhouettes,
                     const MTGridModel& model = MTGridModel()) {
    states.push_back({ name, change, model, allowed });
  };
  const auto property = [](MTScene& scene) { return scene.Actor->GetProperty(); };
  const auto plain = [](MTScene& scene) { scene.Mapper->ScalarVisibilityOff(); };

  add("ActiveScalars", [](MTScene& scene) { scene.Mapper->SetScalarRange(-0.15, 0.15); });
  add("PointArrayByName",
    [](MTScene& scene)
    {
      scene.Mapper->SetScalarModeToUsePointFieldData();
      scene.Mapper->SelectColorArray("TCoords");
      scene.Mapper->SetScalarRange(0.0, 1.0);
    });
  add("CellArrayByName",
    [](MTScene& scene)
    {
      scene.Mapper->SetScalarModeToUseCellFieldData();
      scene.Mapper->SelectColorArray("Block");
      scene.Mapper->SetScalarRange(0.0, 63.0);
    });
  add("DirectColors",
    [](MTScene& scene)
    {
      scene.Mapper->SetScalarModeToUsePointFieldData();
      scene.Mapper->SelectColorArray("Color");
      scene.Mapper->SetColorModeToDirectScalars();
      scene.Actor->ForceOpaqueOn();
    });
  add("DirectColorsTranslucent",
    [](MTScene& scene)
    {
      scene.Mapper->SetScalarModeToUsePointFieldData();
      scene.Mapper->SelectColorArray("Color");
      scene.Mapper->SetColorModeToDirectScalars();
      scene.Renderer->UseDepthPeelingOn();
      scene.Renderer->SetMaximumNumberOfPeels(20);
      scene.Window->SetAlphaBitPlanes(1);
    });
  add("ScalarsThroughTexture",
    [](MTScene& scene)
    {
      scene.Mapper->InterpolateScalarsBeforeMappingOn();
      scene.Mapper->SetScalarRange(-0.1, 0.1);
    });
  add("OwnLookupTable",
    [](MTScene& scene)
    {
      vtkNew<vtkLookupTable> table;
      table->SetNumberOfTableValues(7);
      table->SetHueRange(0.6, 0.0);
      table->SetRange(-0.1, 0.12);
      table->Build();
      scene.Mapper->SetLookupTable(table);
      scene.Mapper->UseLookupTableScalarRangeOn();
    });
  add("SurfaceColor",
    [=](MTScene& scene)
    {
      plain(scene);
      property(scene)->SetColor(0.9, 0.5, 0.2);
    });
  add("Specular",
    [=](MTScene& scene)
    {
      plain(scene);
      property(scene)->SetSpecular(0.8);
      property(scene)->SetSpecularPower(20.0);
      property(scene)->SetAmbient(0.1);
    });
  add("Flat",
    [=](MTScene& scene)
    {
      plain(scene);
      property(scene)->SetInterpolationToFlat();
    });
  add("NoLighting", [=](MTScene& scene) { property(scene)->LightingOff(); });
  add("TwoLights",
    [=](MTScene& scene)
    {
      plain(scene);
      for (const double x : { -1.0, 3.0 })
      {
        vtkNew<vtkLight> light;
        light->SetPosition(x, 2.0 * x, 3.0);
        light->SetFocalPoint(0.5, 0.5, 0.0);
        light->SetColor(1.0, x > 0.0 ? 0.3 : 1.0, 0.6);
        light->SetPositional(x > 0.0);
        scene.Renderer->AddLight(light);
      }
    });
  add("PhysicallyBased",
    [=](MTScene& scene)
    {
      plain(scene);
      property(scene)->SetInterpolationToPBR();
      property(scene)->SetMetallic(0.6);
      property(scene)->SetRoughness(0.4);
    });
  add("Backface",
    [=](MTScene& scene)
    {
      plain(scene);
      vtkNew<vtkProperty> back;
      back->SetColor(1.0, 0.0, 0.0);
      scene.Actor->SetBackfaceProperty(back);
      scene.Actor->RotateX(200.0);
    });
  add("FrontfaceCulling",
    [=](MTScene& scene)
    {
      plain(scene);
      property(scene)->FrontfaceCullingOn();
      scene.Actor->RotateX(200.0);
    });
  add("Opacity",
    [=](MTScene& scene)
    {
      plain(scene);
      property(scene)->SetOpacity(0.4);
      scene.Renderer->UseDepthPeelingOn();
      scene.Renderer->SetMaximumNumberOfPeels(20);
      scene.Window->SetAlphaBitPlanes(1);
    });
  add("Textured",
    [=](MTScene& scene)
    {
      plain(scene);
      vtkNew<vtkTexture> texture;
      MakeTexture(texture);
      scene.Actor->SetTexture(texture);
    });
  add("ClippingPlanes",
    [](MTScene& scene)
    {
      vtkNew<vtkPlane> plane;
      plane->SetOrigin(0.4, 0.5, 0.0);
      plane->SetNormal(1.0, 0.3, 0.2);
      scene.Mapper->AddClippingPlane(plane);
      vtkNew<vtkPlane> other;
      other->SetOrigin(0.5, 0.8, 0.0);
      other->SetNormal(0.1, -1.0, 0.0);
      scene.Mapper->AddClippingPlane(other);
    });
  add("ParallelProjection", [](MTScene& scene) { scene.Renderer->GetActiveCamera()->ParallelProjectionOn(); });
  add("ShearAndReflection",
    [](MTScene& scene)
    {
      vtkNew<vtkMatrix4x4> matrix;
      matrix->SetElement(0, 1, 0.6);
      matrix->SetElement(1, 1, -1.5);
      matrix->SetElement(2, 2, 0.7);
      matrix->SetElement(0, 3, 2.0);
      scene.Actor->SetUserMatrix(matrix);
      scene.Actor->SetScale(1.0, 0.5, 2.0);
    });
  add(
    "Edges",
    [=](MTScene& scene)
    {
      plain(scene);
      property(scene)->EdgeVisibilityOn();
      property(scene)->SetEdgeColor(0.9, 0.2, 0.1);
    },
    EqualDepths);
  add(
    "Wireframe",
    [=](MTScene& scene)
    {
      property(scene)->SetRepresentationToWireframe();
      property(scene)->LightingOff();
      plain(scene);
    },
    EqualDepths);
  add(
    "WireframeCellArray",
    [=](MTScene& scene)
    {
      property(scene)->SetRepresentationToWireframe();
      property(scene)->LightingOff();
      scene.Mapper->SetScalarModeToUseCellFieldData();
      scene.Mapper->SelectColorArray("Block");
      scene.Mapper->SetScalarRange(0.0, 63.0);
    },
    EqualDepths);
  add(
    "Points",
    [=](MTScene& scene)
    {
      property(scene)->SetRepresentationToPoints();
      property(scene)->SetPointSize(3.0);
    },
    EqualDepths);
  MTGridModel cellNormals;
  cellNormals.WithPointNormals = false;
  cellNormals.WithCellNormals = true;
  add("CellNormals", plain, Silhouettes, cellNormals);
  MTGridModel bare;
  bare.WithPointNormals = false;
  add("NoNormals", plain, Silhouettes, bare);
  return states;
}

class AgainstPolyDataMapper : public ::testing::TestWithParam<State>
{
};

vtkSmartPointer<vtkMultiTriangulation> MakeInput(const MTGridModel& model)
{
  auto input = vtkSmartPointer<vtkMultiTriangulation>::New();
  input->SetSource(model.Make());
  return input;
}

TEST_P(AgainstPolyDataMapper, DrawsTheSamePixels)
{
  const State& state = GetParam();
  vtkNew<vtkMultiTriangulationMapper> mapper;
  mapper->SetInputData(MakeInput(state.Model));
  mapper->SetPixelError(0.8);
  MTScene scene(mapper);
  state.Apply(scene);
  LookFromTheSide(scene);
  const auto picture = scene.Render();

  vtkNew<vtkPolyData> mesh;
  ASSERT_TRUE(mapper->GetCut(mesh));
  vtkNew<vtkPolyDataMapper> reference;
  reference->SetInputData(mesh);
  MTScene plain(reference);
  state.Apply(plain);
  LookFromTheSide(plain);
  const auto expected = plain.Render();

  const MTDifference difference = MTDifference::Compare(picture, expected);
  std::cout << state.Name << ": " << mapper->GetTriangles() << " triangles in " << mapper->GetPatches() << " patches, "
            << difference << "\n";
  MTWritePicture(picture, std::string(MT_TEST_OUTPUT_DIRECTORY) + "/Mapper" + state.Name + ".png");
  MTWritePicture(expected, std::string(MT_TEST_OUTPUT_DIRECTORY) + "/Mapper" + state.Name + "Expected.png");
  EXPECT_GT(mapper->GetPatches(), 20);
  EXPECT_GT(difference.Drawn, 4000u);
  EXPECT_LE(difference.ClearlyOff, state.Allowed * difference.Drawn);
}

INSTANTIATE_TEST_SUITE_P(States, AgainstPolyDataMapper, ::testing::ValuesIn(GetStates()),
  [](const ::testing::TestParamInfo<State>& info) { return info.param.Name; });
}
