// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTCameraMoves
 * @brief what a mouse does to a camera, in steps for keys
 *
 * All of them leave the clipping range fit for what the renderer shows.
 */
#ifndef vtkMTCameraMoves_h
#define vtkMTCameraMoves_h

class vtkRenderer;

struct vtkMTCameraMoves
{
  /// About the focal point, in degrees: to the right and upwards.
  static void Turn(vtkRenderer* renderer, double right, double up);
  /// Camera and focal point, in heights of the view.
  static void Pan(vtkRenderer* renderer, double right, double up);
  /// The picture becomes larger by the factor.
  static void Zoom(vtkRenderer* renderer, double factor);
  /// About the direction of the view, in degrees.
  static void Roll(vtkRenderer* renderer, double degrees);
  /// All that is shown, along an axis (0, 1, 2) from its positive (side 1) or negative end (side -1).
  static void LookAlong(vtkRenderer* renderer, int axis, int side);
};

#endif
