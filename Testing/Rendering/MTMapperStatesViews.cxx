// SPDX-License-Identifier: BSD-3-Clause
// Placement, clipping planes, cameras and stereo.
#include "MTMapperStates.h"

#include "vtkActor.h"
#include "vtkAssembly.h"
#include "vtkCamera.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <string>

void MTMapperStates::AddViews()
{
  this->Add("ClippingPlanes",
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
  this->Add("ParallelProjection", [](MTScene& scene) { scene.Renderer->GetActiveCamera()->ParallelProjectionOn(); });
  this->Add("ShearAndReflection",
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
  this->Add("SixClippingPlanes",
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
  this->Add("ParallelClose",
    [](MTScene& scene)
    {
      scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
      scene.Renderer->GetActiveCamera()->Zoom(4.0);
    });
  // Crystal eyes draw these two eyes, left and right, into buffers that a virtual display does not have.
  for (const int type : { VTK_STEREO_RED_BLUE, VTK_STEREO_ANAGLYPH, VTK_STEREO_LEFT, VTK_STEREO_RIGHT,
         VTK_STEREO_INTERLACED, VTK_STEREO_SPLITVIEWPORT_HORIZONTAL })
  {
    this->Add("Stereo" + std::to_string(type),
      [type](MTScene& scene)
      {
        scene.Mapper->SetScalarRange(-0.15, 0.15);
        scene.Window->SetStereoType(type);
        scene.Window->StereoRenderOn();
      });
  }
  this->Add("StereoParallel",
    [](MTScene& scene)
    {
      scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
      scene.Window->SetStereoTypeToRedBlue();
      scene.Window->StereoRenderOn();
    });
  this->Add("PartOfAnAssembly",
    [](MTScene& scene)
    {
      Plain(scene);
      vtkNew<vtkAssembly> assembly;
      scene.Renderer->RemoveActor(scene.Actor);
      scene.Actor->RotateZ(30.0);
      assembly->AddPart(scene.Actor);
      assembly->SetScale(1.0, 0.6, 1.4);
      assembly->RotateX(10.0);
      scene.Renderer->AddActor(assembly);
    });
  this->Add("CameraOffItsAxis",
    [](MTScene& scene)
    {
      Plain(scene);
      scene.Renderer->GetActiveCamera()->SetWindowCenter(0.4, -0.2);
    });
  this->Add("CameraWithAShearedView",
    [](MTScene& scene)
    {
      Plain(scene);
      scene.Renderer->GetActiveCamera()->SetViewShear(0.3, 0.1, 1.0);
    });
  this->Add("CameraWithAModelTransform",
    [](MTScene& scene)
    {
      Plain(scene);
      vtkNew<vtkMatrix4x4> matrix;
      matrix->SetElement(0, 0, 1.3);
      matrix->SetElement(1, 0, 0.2);
      matrix->SetElement(2, 3, 0.1);
      scene.Renderer->GetActiveCamera()->SetModelTransformMatrix(matrix);
    });
  this->Add("ShearOfNormals",
    [](MTScene& scene)
    {
      Plain(scene);
      vtkNew<vtkMatrix4x4> matrix;
      matrix->SetElement(0, 2, 1.5);
      matrix->SetElement(1, 0, -0.7);
      scene.Actor->SetUserMatrix(matrix);
      scene.Actor->GetProperty()->SetSpecular(0.5);
    });
  this->Add("ReflectionFlat",
    [](MTScene& scene)
    {
      Plain(scene);
      scene.Actor->SetScale(-1.0, 1.0, 1.0);
      scene.Actor->GetProperty()->SetInterpolationToFlat();
      vtkNew<vtkProperty> back;
      back->SetColor(0.2, 0.9, 0.2);
      scene.Actor->SetBackfaceProperty(back);
    });
  // From either side, and twice mirrored.
  for (const double turn : { 0.0, 200.0 })
  {
    for (const bool twice : { false, true })
    {
      this->Add(std::string("Mirrored") + (twice ? "Twice" : "Once") + (turn > 0.0 ? "FromBelow" : ""),
        [turn, twice](MTScene& scene)
        {
          Plain(scene);
          scene.Actor->SetScale(-1.0, twice ? -1.3 : 1.2, 0.9);
          scene.Actor->RotateX(turn);
          scene.Actor->GetProperty()->SetSpecular(0.4);
        });
    }
  }
}
