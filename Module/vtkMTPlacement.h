// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTPlacement
 * @brief where a model stands: the affine map from the coordinates of its lattice to those of its data object
 *
 * Patches stay what they are; the map is applied to what is made of them. Distances grow by the largest singular value
 * of its linear part (GetStretch) at most, so an error times that is still certified. Where the map mirrors, triangles
 * are turned, so that their front stays the front; normals go by the inverse transpose.
 */
#ifndef vtkMTPlacement_h
#define vtkMTPlacement_h

#include "vtkMTCoreModule.h" // For export macro

#include <array>

class vtkPolyData;

struct VTKMTCORE_EXPORT vtkMTPlacement
{
  std::array<double, 16> Matrix{ 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 }; ///< row-major

  /// Whether a matrix can place a model: finite, affine, and with an inverse.
  static bool IsSound(const double matrix[16]);

  bool IsIdentity() const;
  bool IsMirrored() const;
  /// The largest singular value of the linear part, rounded up.
  double GetStretch() const;
  vtkMTPlacement GetInverse() const;
  /// This map, and then the other one.
  void Append(const double matrix[16]);

  std::array<double, 3> ToObject(const std::array<double, 3>& model) const;
  /// The bounds of a box's eight corners; bounds that are not initialised stay so.
  void ToObject(const double box[6], double bounds[6]) const;

  /// Moves a mesh: points (in double precision from then on), active point normals, and the order of the corners.
  void Apply(vtkPolyData* mesh) const;
};

#endif
