// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTRendererView
 * @brief a renderer's camera and viewport as views of a model
 *
 * Read off the camera's own matrices, so parallel projection, oblique and explicit projections, tiles of a large
 * picture and horizontal view angles are covered; where the frustum is not symmetric, the larger half counts. In stereo
 * there are two views, one for each eye, whichever of them is being drawn, so that both eyes share a cut. VTK's eyes
 * look through one frustum with space sheared to the left and to the right, and so do the views.
 */
#ifndef vtkMTRendererView_h
#define vtkMTRendererView_h

#include "vtkMTView.h"

#include <array>
#include <vector>

class vtkRenderer;

struct vtkMTRendererView
{
  /// modelToWorld is row-major: where actor and frame put the model.
  static std::vector<vtkMTView> Make(vtkRenderer* renderer, const std::array<double, 16>& modelToWorld);

  /// The point of the box (model units) that is nearest to what the camera looks at most closely.
  static std::array<double, 3> GetNearest(
    vtkRenderer* renderer, const std::array<double, 16>& modelToWorld, const std::array<double, 6>& box);
};

#endif
