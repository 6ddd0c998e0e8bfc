// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTRendererView.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <array>
#include <cmath>

vtkMTView vtkMTRendererView::Make(vtkRenderer* renderer, const double modelToWorld[16])
{
  vtkCamera* camera = renderer->GetActiveCamera();
  std::array<double, 16> modelToEye;
  vtkMatrix4x4::Multiply4x4(camera->GetModelViewTransformMatrix()->GetData(), modelToWorld, modelToEye.data());
  const double* projection = camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1, 1)->GetData();
  const int* size = renderer->GetSize();
  vtkMTView view = vtkMTView::FromProjection(modelToEye, projection, { size[0], size[1] }, camera->GetClippingRange());
  if (vtkMTRendererView::IsStereo(renderer))
  {
    const double spread = std::tan(camera->GetEyeAngle() * 3.14159265358979323846 / 360.0);
    view.HalfSize[0] += view.ParallelProjection ? 0.0 : 2.0 * spread;
  }
  return view;
}

bool vtkMTRendererView::IsStereo(vtkRenderer* renderer)
{
  return renderer->GetRenderWindow()->GetStereoRender() != 0;
}

bool vtkMTRendererView::IsSame(const vtkMTView& a, const vtkMTView& b)
{
  return a.ModelToEye == b.ModelToEye && a.Stretch == b.Stretch && a.ParallelProjection == b.ParallelProjection &&
    a.PixelsPerUnit == b.PixelsPerUnit && a.HalfSize == b.HalfSize && a.Near == b.Near && a.Far == b.Far;
}
