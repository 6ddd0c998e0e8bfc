// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTRendererView.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

vtkMTView vtkMTRendererView::Make(vtkRenderer* renderer, vtkActor* actor)
{
  vtkMTView view;
  vtkCamera* camera = renderer->GetActiveCamera();
  vtkMatrix4x4::Multiply4x4(
    camera->GetModelViewTransformMatrix()->GetData(), actor->GetMatrix()->GetData(), view.ModelToEye.data());
  view.UpdateStretch();

  const vtkMatrix4x4* projection = camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1, 1);
  const int* size = renderer->GetSize();
  view.ParallelProjection = projection->GetElement(3, 3) != 0.0;
  view.PixelsPerUnit = 0.0;
  for (int i = 0; i < 2; ++i)
  {
    const double scale = std::abs(projection->GetElement(i, i));
    const double shift = std::abs(projection->GetElement(i, view.ParallelProjection ? 3 : 2));
    view.HalfSize[i] = (1.0 + shift) / scale;
    view.PixelsPerUnit = std::max(view.PixelsPerUnit, 0.5 * scale * size[i]);
  }
  // A little more than what the planes say: the rasteriser rounds, and culling must not.
  view.Near = camera->GetClippingRange()[0] * (1.0 - 1e-6);
  view.Far = camera->GetClippingRange()[1] * (1.0 + 1e-6);
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
