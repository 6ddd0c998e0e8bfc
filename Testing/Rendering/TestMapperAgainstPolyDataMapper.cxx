// SPDX-License-Identifier: BSD-3-Clause
// vtkMultiTriangulationMapper draws the pixels that vtkPolyDataMapper draws for the very same triangles.
#include "MTGridModel.h"
#include "MTPicture.h"

#include "vtkActor.h"
#include "vtkAssembly.h"
#include "vtkCamera.h"
#include "vtkCameraPass.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLookupTable.h"
#include "vtkMTPatchStore.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiTriangulation.h"
#include "vtkMultiTriangulationMapper.h"
#include "vtkOpenGLRenderer.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSequencePass.h"
#include "vtkShadowMapBakerPass.h"
#include "vtkShadowMapPass.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVariant.h"

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
constexpr double WideLines = 1e-2;
// The shadow map is the light's own view, with a cut of its own: the edge of a shadow is a pixel off here and there.
constexpr double OtherCut = 1e-2;

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
  add(
    "PointsLit",
    [=](MTScene& scene)
    {
      plain(scene);
      property(scene)->SetRepresentationToPoints();
      property(scene)->SetPointSize(2.0);
    },
    EqualDepths);
  add(
    "PointsAsSpheres",
    [=](MTScene& scene)
    {
      plain(scene);
      property(scene)->SetRepresentationToPoints();
      property(scene)->SetPointSize(6.0);
      property(scene)->RenderPointsAsSpheresOn();
    },
    EqualDepths);
  add(
    "WireframeLit",
    [=](MTScene& scene)
    {
      plain(scene);
      property(scene)->SetRepresentationToWireframe();
    },
    EqualDepths);
  add(
    "WireframeWide",
    [=](MTScene& scene)
    {
      plain(scene);
      property(scene)->SetRepresentationToWireframe();
      property(scene)->SetLineWidth(3.0);
      property(scene)->LightingOff();
    },
    EqualDepths);
  add(
    "WireframeAsTubes",
    [=](MTScene& scene)
    {
      plain(scene);
      property(scene)->SetRepresentationToWireframe();
      property(scene)->SetLineWidth(4.0);
      property(scene)->RenderLinesAsTubesOn();
    },
    WideLines);
  add(
    "EdgesOfCells",
    [=](MTScene& scene)
    {
      property(scene)->EdgeVisibilityOn();
      property(scene)->SetLineWidth(2.0);
      scene.Mapper->SetScalarModeToUseCellFieldData();
      scene.Mapper->SelectColorArray("Block");
      scene.Mapper->SetScalarRange(0.0, 63.0);
    },
    EqualDepths);
  add(
    "EdgesAndVertices",
    [=](MTScene& scene)
    {
      plain(scene);
      property(scene)->EdgeVisibilityOn();
      property(scene)->VertexVisibilityOn();
      property(scene)->SetVertexColor(1.0, 1.0, 0.0);
      property(scene)->SetPointSize(4.0);
    },
    EqualDepths);
  add("Gouraud",
    [=](MTScene& scene)
    {
      plain(scene);
      property(scene)->SetInterpolationToGouraud();
    });
  add("FlatPointScalars",
    [=](MTScene& scene)
    {
      property(scene)->SetInterpolationToFlat();
      scene.Mapper->SetScalarRange(-0.15, 0.15);
    });
  add("PhysicallyBasedCoatTextured",
    [=](MTScene& scene)
    {
      plain(scene);
      property(scene)->SetInterpolationToPBR();
      property(scene)->SetCoatStrength(0.8);
      property(scene)->SetCoatRoughness(0.2);
      vtkNew<vtkTexture> albedo;
      MakeTexture(albedo);
      albedo->UseSRGBColorSpaceOn();
      property(scene)->SetBaseColorTexture(albedo);
      vtkNew<vtkTexture> material;
      MakeTexture(material);
      property(scene)->SetORMTexture(material);
    });
  add(
    "OpacityUnsorted",
    [=](MTScene& scene)
    {
      plain(scene);
      property(scene)->SetOpacity(0.4);
      scene.Actor->RotateX(-32.0); // nearly edge on: one hill behind the other
    },
    Silhouettes);
  add("OpacityOfCells",
    [=](MTScene& scene)
    {
      vtkNew<vtkLookupTable> table;
      table->SetAlphaRange(0.1, 0.9);
      table->SetRange(0.0, 63.0);
      table->Build();
      scene.Mapper->SetLookupTable(table);
      scene.Mapper->UseLookupTableScalarRangeOn();
      scene.Mapper->SetScalarModeToUseCellFieldData();
      scene.Mapper->SelectColorArray("Block");
      scene.Renderer->UseDepthPeelingOn();
      scene.Renderer->SetMaximumNumberOfPeels(20);
      scene.Window->SetAlphaBitPlanes(1);
    });
  add("OneComponent",
    [](MTScene& scene)
    {
      scene.Mapper->SetScalarModeToUsePointFieldData();
      scene.Mapper->ColorByArrayComponent("TCoords", 1);
      scene.Mapper->GetLookupTable()->SetVectorModeToComponent();
      scene.Mapper->GetLookupTable()->SetVectorComponent(1);
      scene.Mapper->SetScalarRange(0.0, 1.0);
    });
  add("Magnitude",
    [](MTScene& scene)
    {
      scene.Mapper->SetScalarModeToUsePointFieldData();
      scene.Mapper->SelectColorArray("TCoords");
      scene.Mapper->GetLookupTable()->SetVectorModeToMagnitude();
      scene.Mapper->SetScalarRange(0.0, 1.5);
    });
  add("ArrayByNumber",
    [](MTScene& scene)
    {
      scene.Mapper->SetScalarModeToUsePointFieldData();
      scene.Mapper->SelectColorArray(0);
      scene.Mapper->SetScalarRange(-0.15, 0.15);
    });
  add("FieldDataTuple",
    [](MTScene& scene)
    {
      vtkNew<vtkFloatArray> kinds;
      kinds->SetName("Kind");
      for (const float kind : { 0.0f, 1.0f, 2.0f, 3.0f })
      {
        kinds->InsertNextValue(kind);
      }
      scene.Mapper->GetInputAsDataSet()->GetFieldData()->AddArray(kinds);
      scene.Mapper->SetScalarModeToUseFieldData();
      scene.Mapper->SelectColorArray("Kind");
      scene.Mapper->SetFieldDataTupleId(1);
      scene.Mapper->SetScalarRange(0.0, 3.0);
    });
  add("Logarithmic",
    [](MTScene& scene)
    {
      vtkNew<vtkLookupTable> table;
      table->SetScaleToLog10();
      table->SetRange(1.0, 63.0);
      table->Build();
      scene.Mapper->SetLookupTable(table);
      scene.Mapper->UseLookupTableScalarRangeOn();
      scene.Mapper->SetScalarModeToUseCellFieldData();
      scene.Mapper->SelectColorArray("Block");
    });
  add("Categories",
    [](MTScene& scene)
    {
      vtkNew<vtkLookupTable> table;
      table->IndexedLookupOn();
      table->SetNumberOfTableValues(5);
      for (int i = 0; i < 5; ++i)
      {
        table->SetTableValue(i, 0.2 * i, 1.0 - 0.2 * i, i % 2);
        table->SetAnnotation(vtkVariant(i * 9), "block");
      }
      table->SetNanColor(0.3, 0.3, 0.3, 1.0);
      scene.Mapper->SetLookupTable(table);
      scene.Mapper->SetScalarModeToUseCellFieldData();
      scene.Mapper->SelectColorArray("Block");
    });
  add("TexturedWithScalars",
    [](MTScene& scene)
    {
      scene.Mapper->SetScalarRange(-0.15, 0.15);
      vtkNew<vtkTexture> texture;
      MakeTexture(texture);
      scene.Actor->SetTexture(texture);
    });
  add("CoincidentPolygonOffset",
    [=](MTScene& scene)
    {
      plain(scene);
      scene.Mapper->SetResolveCoincidentTopologyToPolygonOffset();
      scene.Mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(2.0, 2.0);
    });
  add("CoincidentShiftScale",
    [=](MTScene& scene)
    {
      plain(scene);
      scene.Mapper->SetResolveCoincidentTopologyToShiftZBuffer();
    });
  add("SixClippingPlanes",
    [](MTScene& scene)
    {
      for (int axis = 0; axis < 2; ++axis)
      {
        for (const double side : { 1.0, -1.0 })
        {
          vtkNew<vtkPlane> plane;
          plane->SetOrigin(0.5 - 0.3 * side, 0.5 - 0.3 * side, 0.0);
          plane->SetNormal(axis == 0 ? side : 0.0, axis == 0 ? 0.0 : side, 0.0);
          scene.Mapper->AddClippingPlane(plane);
        }
      }
      scene.Actor->RotateZ(20.0);
      scene.Actor->SetScale(1.0, 2.0, 1.0);
    });
  add("ParallelClose",
    [](MTScene& scene)
    {
      scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
      scene.Renderer->GetActiveCamera()->Zoom(4.0);
    });
  // Crystal eyes draw these two eyes, left and right, into buffers that a virtual display does not have.
  for (const int type : { VTK_STEREO_RED_BLUE, VTK_STEREO_ANAGLYPH, VTK_STEREO_LEFT, VTK_STEREO_RIGHT,
         VTK_STEREO_INTERLACED, VTK_STEREO_SPLITVIEWPORT_HORIZONTAL })
  {
    add("Stereo" + std::to_string(type),
      [type](MTScene& scene)
      {
        scene.Mapper->SetScalarRange(-0.15, 0.15);
        scene.Window->SetStereoType(type);
        scene.Window->StereoRenderOn();
      });
  }
  add("StereoParallel",
    [](MTScene& scene)
    {
      scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
      scene.Window->SetStereoTypeToRedBlue();
      scene.Window->StereoRenderOn();
    });
  add(
    "Shadows",
    [=](MTScene& scene)
    {
      plain(scene);
      scene.Renderer->RemoveAllLights();
      vtkNew<vtkLight> light;
      light->SetPosition(-0.8, 0.2, 0.7);
      light->SetFocalPoint(0.5, 0.5, 0.0);
      light->PositionalOn();
      light->SetConeAngle(40.0);
      scene.Renderer->AddLight(light);
      vtkNew<vtkShadowMapPass> shadows;
      shadows->GetShadowMapBakerPass()->SetResolution(1024);
      vtkNew<vtkRenderPassCollection> passes;
      passes->AddItem(shadows->GetShadowMapBakerPass());
      passes->AddItem(shadows);
      vtkNew<vtkSequencePass> sequence;
      sequence->SetPasses(passes);
      vtkNew<vtkCameraPass> camera;
      camera->SetDelegatePass(sequence);
      vtkOpenGLRenderer::SafeDownCast(scene.Renderer)->SetPass(camera);
    },
    OtherCut);
  add("PartOfAnAssembly",
    [=](MTScene& scene)
    {
      plain(scene);
      vtkNew<vtkAssembly> assembly;
      scene.Renderer->RemoveActor(scene.Actor);
      scene.Actor->RotateZ(30.0);
      assembly->AddPart(scene.Actor);
      assembly->SetScale(1.0, 0.6, 1.4);
      assembly->RotateX(10.0);
      scene.Renderer->AddActor(assembly);
    });
  add("CameraOffItsAxis",
    [=](MTScene& scene)
    {
      plain(scene);
      scene.Renderer->GetActiveCamera()->SetWindowCenter(0.4, -0.2);
    });
  add("CameraWithAShearedView",
    [=](MTScene& scene)
    {
      plain(scene);
      scene.Renderer->GetActiveCamera()->SetViewShear(0.3, 0.1, 1.0);
    });
  add("CameraWithAModelTransform",
    [=](MTScene& scene)
    {
      plain(scene);
      vtkNew<vtkMatrix4x4> matrix;
      matrix->SetElement(0, 0, 1.3);
      matrix->SetElement(1, 0, 0.2);
      matrix->SetElement(2, 3, 0.1);
      scene.Renderer->GetActiveCamera()->SetModelTransformMatrix(matrix);
    });
  add("ShearOfNormals",
    [=](MTScene& scene)
    {
      plain(scene);
      vtkNew<vtkMatrix4x4> matrix;
      matrix->SetElement(0, 2, 1.5);
      matrix->SetElement(1, 0, -0.7);
      scene.Actor->SetUserMatrix(matrix);
      property(scene)->SetSpecular(0.5);
    });
  add("ReflectionFlat",
    [=](MTScene& scene)
    {
      plain(scene);
      scene.Actor->SetScale(-1.0, 1.0, 1.0);
      property(scene)->SetInterpolationToFlat();
      vtkNew<vtkProperty> back;
      back->SetColor(0.2, 0.9, 0.2);
      scene.Actor->SetBackfaceProperty(back);
    });
  // From either side, and twice mirrored.
  for (const double turn : { 0.0, 200.0 })
  {
    for (const bool twice : { false, true })
    {
      add(std::string("Mirrored") + (twice ? "Twice" : "Once") + (turn > 0.0 ? "FromBelow" : ""),
        [=](MTScene& scene)
        {
          plain(scene);
          scene.Actor->SetScale(-1.0, twice ? -1.3 : 1.2, 0.9);
          scene.Actor->RotateX(turn);
          property(scene)->SetSpecular(0.4);
        });
    }
  }
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
  std::cout << state.Name << ": " << mapper->GetNumberOfTriangles() << " triangles in " << mapper->GetNumberOfPatches()
            << " patches, " << difference << "\n";
  MTWritePicture(picture, std::string(MT_TEST_OUTPUT_DIRECTORY) + "/Mapper" + state.Name + ".png");
  MTWritePicture(expected, std::string(MT_TEST_OUTPUT_DIRECTORY) + "/Mapper" + state.Name + "Expected.png");
  EXPECT_GT(mapper->GetNumberOfPatches(), 15); // planes take some away
  EXPECT_GT(difference.Drawn, 4000u);
  EXPECT_LE(static_cast<double>(difference.ClearlyOff), state.Allowed * static_cast<double>(difference.Drawn));
}

INSTANTIATE_TEST_SUITE_P(States, AgainstPolyDataMapper, ::testing::ValuesIn(GetStates()),
  [](const ::testing::TestParamInfo<State>& info) { return info.param.Name; });
}
