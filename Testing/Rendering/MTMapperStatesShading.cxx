// SPDX-License-Identifier: BSD-3-Clause
// Surfaces, lights, opacity and normals.
#include "MTMapperStates.h"

#include "vtkActor.h"
#include "vtkCameraPass.h"
#include "vtkLight.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderer.h"
#include "vtkProperty.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSequencePass.h"
#include "vtkShadowMapBakerPass.h"
#include "vtkShadowMapPass.h"
#include "vtkTexture.h"

void MTMapperStates::Plain(MTScene& scene)
{
  scene.Mapper->ScalarVisibilityOff();
}

void MTMapperStates::AddShading()
{
  this->Add("SurfaceColor",
    [](MTScene& scene)
    {
      Plain(scene);
      scene.Actor->GetProperty()->SetColor(0.9, 0.5, 0.2);
    });
  this->Add("Specular",
    [](MTScene& scene)
    {
      Plain(scene);
      scene.Actor->GetProperty()->SetSpecular(0.8);
      scene.Actor->GetProperty()->SetSpecularPower(20.0);
      scene.Actor->GetProperty()->SetAmbient(0.1);
    });
  this->Add("Flat",
    [](MTScene& scene)
    {
      Plain(scene);
      scene.Actor->GetProperty()->SetInterpolationToFlat();
    });
  this->Add("NoLighting", [](MTScene& scene) { scene.Actor->GetProperty()->LightingOff(); });
  this->Add("TwoLights",
    [](MTScene& scene)
    {
      Plain(scene);
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
  this->Add("PhysicallyBased",
    [](MTScene& scene)
    {
      Plain(scene);
      scene.Actor->GetProperty()->SetInterpolationToPBR();
      scene.Actor->GetProperty()->SetMetallic(0.6);
      scene.Actor->GetProperty()->SetRoughness(0.4);
    });
  this->Add("Backface",
    [](MTScene& scene)
    {
      Plain(scene);
      vtkNew<vtkProperty> back;
      back->SetColor(1.0, 0.0, 0.0);
      scene.Actor->SetBackfaceProperty(back);
      scene.Actor->RotateX(200.0);
    });
  this->Add("FrontfaceCulling",
    [](MTScene& scene)
    {
      Plain(scene);
      scene.Actor->GetProperty()->FrontfaceCullingOn();
      scene.Actor->RotateX(200.0);
    });
  this->Add("Opacity",
    [](MTScene& scene)
    {
      Plain(scene);
      scene.Actor->GetProperty()->SetOpacity(0.4);
      scene.Renderer->UseDepthPeelingOn();
      scene.Renderer->SetMaximumNumberOfPeels(20);
      scene.Window->SetAlphaBitPlanes(1);
    });
  this->Add("Gouraud",
    [](MTScene& scene)
    {
      Plain(scene);
      scene.Actor->GetProperty()->SetInterpolationToGouraud();
    });
  this->Add("PhysicallyBasedCoatTextured",
    [](MTScene& scene)
    {
      Plain(scene);
      scene.Actor->GetProperty()->SetInterpolationToPBR();
      scene.Actor->GetProperty()->SetCoatStrength(0.8);
      scene.Actor->GetProperty()->SetCoatRoughness(0.2);
      vtkNew<vtkTexture> albedo;
      MakeTexture(albedo);
      albedo->UseSRGBColorSpaceOn();
      scene.Actor->GetProperty()->SetBaseColorTexture(albedo);
      vtkNew<vtkTexture> material;
      MakeTexture(material);
      scene.Actor->GetProperty()->SetORMTexture(material);
    });
  this->Add(
    "OpacityUnsorted",
    [](MTScene& scene)
    {
      Plain(scene);
      scene.Actor->GetProperty()->SetOpacity(0.4);
      scene.Actor->RotateX(-32.0); // nearly edge on: one hill behind the other
    },
    Silhouettes);
  this->Add(
    "Shadows",
    [](MTScene& scene)
    {
      Plain(scene);
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
  MTGridModel cellNormals;
  cellNormals.WithPointNormals = false;
  cellNormals.WithCellNormals = true;
  this->Add("CellNormals", Plain, Silhouettes, cellNormals);
  MTGridModel bare;
  bare.WithPointNormals = false;
  this->Add("NoNormals", Plain, Silhouettes, bare);
}
