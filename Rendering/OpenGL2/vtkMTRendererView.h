// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTRendererView
 * @brief a renderer's camera and viewport as a vtkMTView of a model
 *
 * Read off the camera's own matrices, so parallel projection, oblique and explicit projections, tiles of a large
 * picture and horizontal view angles are covered; where the frustum is not symmetric, the larger half counts. In stereo
 * both eyes share the view of the eye between them, so that they share the cut.
 */
#ifndef vtkMTRendererView_h
#define vtkMTRendererView_h

#include "vtkMTView.h"

class vtkRenderer;

struct vtkMTRendererView
{
  /// modelToWorld is row-major: where actor and frame put the model.
  static vtkMTView Make(vtkRenderer* renderer, const double modelToWorld[16]);
  /// Whether two eyes look: then what one of them sees may lie outside the view.
  static bool IsStereo(vtkRenderer* renderer);
  static bool IsSame(const vtkMTView& a, const vtkMTView& b);
};

#endif
