// SPDX-License-Identifier: BSD-3-Clause
// The same scene somewhere else, or in another size, gives the same picture.
//
// What is ours: positions, clipping planes, normals, and the directions of flat shading, of PBR and of positional
// lights come out the same at any place and size; vtkPolyDataMapper's pictures of the same cuts are compared too, and
// printed: from 1e-9 on, and at 1e20, it has no flat shading and no PBR, for the squares of such lengths are no floats.
// What is not: vtkCamera lets no distance and no clipping range become smaller than 1e-20, so VTK draws nothing smaller
// by itself; an actor that scales such a model up shows it. ResetCamera and ResetCameraClippingRange work in double
// precision and are right at all the sizes here. Lights that fade with the distance fade in world units.
#include "MTGridModel.h"
#include "MTPicture.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMTPatchStore.h"
#include "vtkMultiTriangulation.h"
#include "vtkMultiTriangulationMapper.h"
#include "vtkPlane.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <iostream>
#include <ostream>
#include <string>
#include <tuple>
#include <vector>

namespace
{
struct Place
{
  std::string Name;
  std::array<double, 3> Offset;
  double Scale;

  std::array<double, 3> At(double x, double y, double z) const
  {
    return { this->Offset[0] + this->Scale * x, this->Offset[1] + this->Scale * y, this->Offset[2] + this->Scale * z };
  }
};

struct Look
{
  std::string Name;
  std::function<void(MTScene&, const Place&)> Apply;
  bool WithNormals = true;
  double Allowed = 1e-4; // share of the drawn pixels that may be clearly off
};

// A line passes a pixel's centre on one side or the other; cameras are rounded to the doubles of their place.
constexpr double Lines = 1e-3;

void PrintTo(const Place& place, std::ostream* os)
{
  *os << place.Name;
}

void PrintTo(const Look& look, std::ostream* os)
{
  *os << look.Name;
}

const Place Origin{ "Origin", { 0.0, 0.0, 0.0 }, 1.0 };

std::vector<Place> GetPlaces()
{
  return { { "UtmNorthing", { 5e5, 4e6, 0.0 }, 1000.0 }, { "TenMillionAway", { 1e7, 2e7, -1e7 }, 1.0 },
    { "ScaledDown", { 0.0, 0.0, 0.0 }, 1e-20 }, { "ScaledUp", { 0.0, 0.0, 0.0 }, 1e20 },
    { "Nanometres", { 1.0, -2.0, 0.5 }, 1e-9 }, { "FarAndLarge", { 1e19, 2e18, 0.0 }, 1e12 } };
}

std::vector<Look> GetLooks()
{
  std::vector<Look> looks;
  looks.push_back({ "Smooth", [](MTScene&, const Place&) {} });
  looks.push_back(
    { "Flat", [](MTScene& scene, const Place&) { scene.Actor->GetProperty()->SetInterpolationToFlat(); } });
  looks.push_back({ "NoNormals", [](MTScene&, const Place&) {}, false });
  looks.push_back({ "Specular",
    [](MTScene& scene, const Place&)
    {
      scene.Actor->GetProperty()->SetSpecular(0.8);
      scene.Actor->GetProperty()->SetSpecularPower(20.0);
    } });
  looks.push_back({ "Pbr",
    [](MTScene& scene, const Place&)
    {
      scene.Actor->GetProperty()->SetInterpolationToPBR();
      scene.Actor->GetProperty()->SetMetallic(0.6);
      scene.Actor->GetProperty()->SetRoughness(0.4);
    } });
  looks.push_back({ "PositionalLight",
    [](MTScene& scene, const Place& place)
    {
      vtkNew<vtkLight> light;
      light->SetPosition(place.At(0.2, 0.3, 0.8).data());
      light->SetFocalPoint(place.At(0.5, 0.5, 0.0).data());
      light->PositionalOn();
      light->SetConeAngle(60.0);
      scene.Renderer->AddLight(light);
    } });
  looks.push_back({ "ClippingPlane",
    [](MTScene& scene, const Place& place)
    {
      vtkNew<vtkPlane> plane;
      plane->SetOrigin(place.At(0.4, 0.5, 0.0).data());
      plane->SetNormal(1.0, 0.3, 0.2);
      scene.Mapper->AddClippingPlane(plane);
    } });
  looks.push_back(
    { "Edges", [](MTScene& scene, const Place&) { scene.Actor->GetProperty()->EdgeVisibilityOn(); }, true, Lines });
  looks.push_back({ "Wireframe",
    [](MTScene& scene, const Place&)
    {
      scene.Actor->GetProperty()->SetRepresentationToWireframe();
      scene.Actor->GetProperty()->LightingOff();
    },
    true, Lines });
  looks.push_back({ "ParallelProjection",
    [](MTScene& scene, const Place& place)
    {
      scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
      scene.Renderer->GetActiveCamera()->SetParallelScale(0.5 * place.Scale);
    } });
  looks.push_back({ "VtksCamera", [](MTScene& scene, const Place&) { scene.Renderer->ResetCamera(); } });
  return looks;
}

struct Picture
{
  vtkSmartPointer<vtkImageData> Image;
  vtkIdType Triangles = 0;
  vtkSmartPointer<vtkPolyData> Cut;
};

void SetCamera(MTScene& scene, const Place& place)
{
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(place.At(0.4, -0.6, 1.1).data());
  camera->SetFocalPoint(place.At(0.45, 0.35, 0.0).data());
  camera->SetViewUp(0.0, 0.0, 1.0);
}

Picture Draw(const Place& place, const Look& look)
{
  MTGridModel model;
  model.Size = place.Scale;
  model.Corner = place.Offset;
  model.WithPointNormals = look.WithNormals;
  vtkNew<vtkMultiTriangulation> input;
  input->SetSource(model.Make());
  vtkNew<vtkMultiTriangulationMapper> mapper;
  mapper->SetInputData(input);
  mapper->SetPixelError(0.3);
  mapper->ScalarVisibilityOff();
  MTScene scene(mapper);
  SetCamera(scene, place);
  look.Apply(scene, place);
  scene.Renderer->ResetCameraClippingRange();
  Picture picture;
  picture.Image = scene.Render();
  picture.Triangles = mapper->GetNumberOfTriangles();
  picture.Cut = vtkSmartPointer<vtkPolyData>::New();
  mapper->GetCut(picture.Cut);
  return picture;
}

vtkSmartPointer<vtkImageData> DrawStock(vtkPolyData* mesh, const Place& place, const Look& look)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  mapper->ScalarVisibilityOff();
  MTScene scene(mapper);
  SetCamera(scene, place);
  look.Apply(scene, place);
  scene.Renderer->ResetCameraClippingRange();
  return scene.Render();
}

class MapperAt : public ::testing::TestWithParam<std::tuple<Place, Look>>
{
};

TEST_P(MapperAt, DrawsWhatItDrawsAtTheOrigin)
{
  const auto& [place, look] = GetParam();
  const Picture there = Draw(place, look);
  const Picture here = Draw(Origin, look);
  const MTDifference difference = MTDifference::Compare(there.Image, here.Image);
  const MTDifference stock =
    MTDifference::Compare(DrawStock(there.Cut, place, look), DrawStock(here.Cut, Origin, look));
  const std::string path = std::string(MT_TEST_OUTPUT_DIRECTORY) + "/At" + place.Name + look.Name;
  MTWritePicture(there.Image, path + ".png");
  std::cout << place.Name << ", " << look.Name << ": " << there.Triangles << " triangles, " << difference
            << "; vtkPolyDataMapper with the same cut: " << stock << "\n";
  EXPECT_GT(difference.Drawn, 5000u);
  EXPECT_LE(static_cast<double>(difference.ClearlyOff), look.Allowed * static_cast<double>(difference.Drawn));
}

INSTANTIATE_TEST_SUITE_P(Places, MapperAt,
  ::testing::Combine(::testing::ValuesIn(GetPlaces()), ::testing::ValuesIn(GetLooks())),
  [](const ::testing::TestParamInfo<std::tuple<Place, Look>>& info)
  { return std::get<0>(info.param).Name + std::get<1>(info.param).Name; });

// VTK's own camera could not come near these; the actor brings them to it.
class MapperUnderScale : public ::testing::TestWithParam<double>
{
};

TEST_P(MapperUnderScale, DrawsAnySizeThatTheActorScalesToOne)
{
  const double size = GetParam();
  for (const bool withNormals : { true, false })
  {
    vtkSmartPointer<vtkImageData> pictures[2];
    for (int i = 0; i < 2; ++i)
    {
      MTGridModel model;
      model.Size = i == 0 ? size : 1.0;
      model.WithPointNormals = withNormals;
      vtkNew<vtkMultiTriangulation> input;
      input->SetSource(model.Make());
      vtkNew<vtkMultiTriangulationMapper> mapper;
      mapper->SetInputData(input);
      mapper->SetPixelError(0.3);
      mapper->ScalarVisibilityOff();
      vtkNew<vtkPlane> plane;
      plane->SetOrigin(0.4, 0.5, 0.0);
      plane->SetNormal(1.0, 0.3, 0.2);
      mapper->AddClippingPlane(plane);
      MTScene scene(mapper);
      scene.Actor->SetScale(1.0 / model.Size);
      SetCamera(scene, Origin);
      scene.Renderer->ResetCameraClippingRange();
      pictures[i] = scene.Render();
    }
    const MTDifference difference = MTDifference::Compare(pictures[0], pictures[1]);
    std::cout << "size " << size << (withNormals ? "" : ", no normals") << ": " << difference << "\n";
    EXPECT_GT(difference.Drawn, 5000u);
    EXPECT_LE(difference.ClearlyOff, difference.Drawn / 10000);
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, MapperUnderScale, ::testing::Values(1e-60, 1e-30, 1e30, 1e60));
}
