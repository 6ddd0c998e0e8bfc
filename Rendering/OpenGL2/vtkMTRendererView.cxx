// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTRendererView.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

namespace
{
// By how much an eye sees x moved, for each unit along z; 0 where there is one eye. An off-axis projection has a
// frustum of its own for each eye, so there each eye has its own view; an explicit one is that of both.
double GetShear(vtkCamera* camera)
{
  const bool sheared =
    camera->GetStereo() && !camera->GetUseOffAxisProjection() && !camera->GetUseExplicitProjectionTransformMatrix();
  return sheared ? std::tan(vtkMath::RadiansFromDegrees(camera->GetEyeAngle() / 2.0)) : 0.0;
}

// Eye space, sheared so that what lies at the distance stays where it is.
void Shear(vtkMTView& view, double shear, double distance)
{
  for (int j = 0; j < 4; ++j)
  {
    view.ModelToEye[j] += shear * view.ModelToEye[8 + j];
  }
  view.ModelToEye[3] += shear * distance;
  view.UpdateStretch();
}
}

std::vector<vtkMTView> vtkMTRendererView::Make(vtkRenderer* renderer, vtkActor* actor)
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
  const double shear = GetShear(camera);
  // The projection has the shear of the eye that is being drawn.
  const double present = camera->GetLeftEye() ? shear : -shear;
  for (int i = 0; i < 2; ++i)
  {
    const double scale = std::abs(projection->GetElement(i, i));
    double shift = projection->GetElement(i, view.ParallelProjection ? 3 : 2);
    if (i == 0 && shear != 0.0)
    {
      shift -= projection->GetElement(0, 0) * present * (view.ParallelProjection ? camera->GetDistance() : 1.0);
      // Both eyes must come to the same number, so what rounding left of it goes, and the frustum gets a little larger.
      shift = std::nearbyint(shift * 1e9) / 1e9;
    }
    view.HalfSize[i] = (1.0 + std::abs(shift) + (shear != 0.0 ? 1e-9 : 0.0)) / scale;
    view.PixelsPerUnit = std::max(view.PixelsPerUnit, 0.5 * scale * size[i]);
  }
  // A little more than what the planes say: the rasteriser rounds, and culling must not.
  view.Near = camera->GetClippingRange()[0] * (1.0 - 1e-6);
  view.Far = camera->GetClippingRange()[1] * (1.0 + 1e-6);
  if (shear == 0.0)
  {
    return { view };
  }
  std::vector<vtkMTView> views{ view, view };
  Shear(views[0], shear, camera->GetDistance());
  Shear(views[1], -shear, camera->GetDistance());
  return views;
}

std::array<double, 3> vtkMTRendererView::GetNearest(
  vtkRenderer* renderer, vtkActor* actor, const std::array<double, 6>& box)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  double place[4] = { 0.0, 0.0, 0.0, 1.0 };
  camera->GetParallelProjection() ? camera->GetFocalPoint(place) : camera->GetPosition(place);
  double inverse[16];
  vtkMatrix4x4::Invert(actor->GetMatrix()->GetData(), inverse);
  vtkMatrix4x4::MultiplyPoint(inverse, place, place);
  std::array<double, 3> nearest;
  for (int i = 0; i < 3; ++i)
  {
    const bool finite = std::isfinite(place[i]);
    nearest[i] = std::clamp(finite ? place[i] : box[2 * i], box[2 * i], box[2 * i + 1]);
  }
  return nearest;
}
