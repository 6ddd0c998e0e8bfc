// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTView
 * @brief a view of the model: how distances in model units become pixels, and what lies in the frustum
 *
 * Pixel error, honest off the axis. A point at depth z, seen at the angle t off the view axis, that is displaced by at
 * most e moves on the screen by at most e f / ((z - e) cos t), f being the focal length in pixels; the usual distance
 * formula is 30 % short in the corners of a wide view. GetPixelError takes the smallest depth and the largest angle
 * that a sphere reaches inside the view, so it bounds the movement of everything in it; nothing nearer than the near
 * plane is drawn, so the depth is at least Near. With parallel projection the bound is e times pixels per unit. An
 * actor's matrix may stretch: distances are multiplied by its largest singular value.
 *
 * The bound is monotone: a sphere inside another one with a smaller e never has the larger pixel error.
 */
#ifndef vtkMTView_h
#define vtkMTView_h

#include "vtkMTCoreModule.h" // For export macro

#include <array>
#include <cstdint>

class vtkMTGraph;
struct vtkMTNode;

struct VTKMTCORE_EXPORT vtkMTView
{
  /// Row-major; takes model points to eye space, where the camera looks along -z.
  std::array<double, 16> ModelToEye{ 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
  double Stretch = 1.0; ///< largest singular value of ModelToEye's linear part
  bool ParallelProjection = false;
  double PixelsPerUnit = 500.0;               ///< perspective: focal length in pixels; parallel: pixels per eye unit
  std::array<double, 2> HalfSize{ 1.0, 1.0 }; ///< perspective: tangents of the half angles; parallel: half extents
  double Near = 0.0;                          ///< distances along the axis; what lies outside is not drawn
  double Far = 1e300;

  /**
   * From a camera's matrices, row-major, so that parallel, oblique and explicit projections are covered; where the
   * frustum is not symmetric, the larger half counts. projection takes eye space to the cube of +-1, size is that of
   * the picture in pixels, range the clipping range.
   */
  static vtkMTView FromProjection(const std::array<double, 16>& modelToEye, const double projection[16],
    const std::array<int, 2>& size, const double range[2]);

  /// Fills Stretch from ModelToEye.
  void UpdateStretch();

  std::array<double, 3> ToEye(const std::array<double, 3>& model) const;

  /// Upper bound, in pixels, of what an error of `error` model units can do inside the sphere; +infinity when the
  /// sphere comes so near that no bound exists.
  double GetPixelError(const std::array<double, 3>& center, double radius, double error) const;

  /// False only when no point of the sphere (model units) can be seen.
  bool IsSphereVisible(const std::array<double, 3>& center, double radius) const;
  /// False only when no point of the box (model units) can be seen.
  bool IsBoxVisible(const double bounds[6]) const;
};

#endif
