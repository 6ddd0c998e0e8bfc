// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTCameraMoves.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkRenderer.h"

#include <cmath>

//------------------------------------------------------------------------------
void vtkMTCameraMoves::Turn(vtkRenderer* renderer, double right, double up)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->Azimuth(right);
  camera->Elevation(up);
  camera->OrthogonalizeViewUp(); // or else the next step could look along it
  renderer->ResetCameraClippingRange();
}

//------------------------------------------------------------------------------
void vtkMTCameraMoves::Pan(vtkRenderer* renderer, double right, double up)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->OrthogonalizeViewUp();
  const double height = camera->GetParallelProjection()
    ? 2.0 * camera->GetParallelScale()
    : 2.0 * camera->GetDistance() * std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle()));
  double side[3];
  vtkMath::Cross(camera->GetDirectionOfProjection(), camera->GetViewUp(), side);
  double position[3];
  double focalPoint[3];
  camera->GetPosition(position);
  camera->GetFocalPoint(focalPoint);
  for (int i = 0; i < 3; ++i)
  {
    const double step = height * (right * side[i] + up * camera->GetViewUp()[i]);
    position[i] += step;
    focalPoint[i] += step;
  }
  camera->SetPosition(position);
  camera->SetFocalPoint(focalPoint);
  renderer->ResetCameraClippingRange();
}

//------------------------------------------------------------------------------
void vtkMTCameraMoves::Zoom(vtkRenderer* renderer, double factor)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  if (camera->GetParallelProjection())
  {
    camera->SetParallelScale(camera->GetParallelScale() / factor);
  }
  else
  {
    camera->Dolly(factor);
  }
  renderer->ResetCameraClippingRange();
}

//------------------------------------------------------------------------------
void vtkMTCameraMoves::Roll(vtkRenderer* renderer, double degrees)
{
  renderer->GetActiveCamera()->Roll(degrees);
  renderer->ResetCameraClippingRange();
}

//------------------------------------------------------------------------------
void vtkMTCameraMoves::LookAlong(vtkRenderer* renderer, int axis, int side)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  double direction[3] = { 0.0, 0.0, 0.0 };
  direction[axis] = side;
  double position[3];
  vtkMath::Add(camera->GetFocalPoint(), direction, position);
  camera->SetPosition(position);
  camera->SetViewUp(0.0, axis == 2 ? 1.0 : 0.0, axis == 2 ? 0.0 : 1.0);
  renderer->ResetCamera();
}
