// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTRendererView.h"

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

std::vector<vtkMTView> vtkMTRendererView::Make(vtkRenderer* renderer, const std::array<double, 16>& modelToWorld)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  std::array<double, 16> modelToEye;
  vtkMatrix4x4::Multiply4x4(camera->GetModelViewTransformMatrix()->GetData(), modelToWorld.data(), modelToEye.data());
  std::array<double, 16> projection;
  std::copy_n(
    camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1, 1)->GetData(), 16, projection.begin());
  const double shear = GetShear(camera);
  if (shear != 0.0)
  {
    // The projection has the shear of the eye that is being drawn. Both eyes must come to the same numbers without it,
    // so what rounding leaves of it goes.
    const double present = projection[0] * (camera->GetLeftEye() ? shear : -shear);
    projection[2] = std::nearbyint((projection[2] - present) * 1e9) / 1e9;
    projection[3] = std::nearbyint((projection[3] - present * camera->GetDistance()) * 1e9) / 1e9;
  }
  const int* size = renderer->GetSize();
  vtkMTView view =
    vtkMTView::FromProjection(modelToEye, projection.data(), { size[0], size[1] }, camera->GetClippingRange());
  if (shear == 0.0)
  {
    return { view };
  }
  view.HalfSize[0] *= 1.0 + 1e-8; // more than that rounding
  std::vector<vtkMTView> views{ view, view };
  Shear(views[0], shear, camera->GetDistance());
  Shear(views[1], -shear, camera->GetDistance());
  return views;
}

std::array<double, 3> vtkMTRendererView::GetNearest(
  vtkRenderer* renderer, const std::array<double, 16>& modelToWorld, const std::array<double, 6>& box)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  double place[4] = { 0.0, 0.0, 0.0, 1.0 };
  camera->GetParallelProjection() ? camera->GetFocalPoint(place) : camera->GetPosition(place);
  double inverse[16];
  vtkMatrix4x4::Invert(modelToWorld.data(), inverse);
  vtkMatrix4x4::MultiplyPoint(inverse, place, place);
  std::array<double, 3> nearest;
  for (int i = 0; i < 3; ++i)
  {
    const bool finite = std::isfinite(place[i]);
    nearest[i] = std::clamp(finite ? place[i] : box[2 * i], box[2 * i], box[2 * i + 1]);
  }
  return nearest;
}
