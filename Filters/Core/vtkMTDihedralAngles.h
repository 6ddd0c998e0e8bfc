// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTDihedralAngles
 * @brief how many edges of a mesh have which angle between their triangles, and what that says of its hard edges
 *
 * Counted are the edges of exactly two triangles that run in opposite directions, by the angle between their normals in
 * whole degrees. What is designed has flat and gently curved parts with hard edges between them: hardly any edge
 * is in between. What was scanned, or is terrain or noise, has fewer and fewer edges the larger the angle. So a mesh is
 * CAD when at least a fiftieth of its edges have angles of LeastHardAngle or more, and these are more than those of
 * half of that up to there. Documentation/decisions/0035-feature-angle.md has the figures.
 */
#ifndef vtkMTDihedralAngles_h
#define vtkMTDihedralAngles_h

#include "vtkMTFiltersCoreModule.h" // For export macro
#include "vtkMTPatch.h"

#include <array>
#include <cstddef>
#include <cstdint>

class VTKMTFILTERSCORE_EXPORT vtkMTDihedralAngles
{
public:
  static constexpr double Smooth = 180.0; ///< the feature angle that splits nothing
  static constexpr double OfCad = 30.0;
  static constexpr std::size_t LeastHardAngle = 40;

  void Add(const vtkMTPatch& mesh);
  void Add(const vtkMTDihedralAngles& other);

  /// Edges with angles from `from` up to `to` degrees, the latter excluded.
  std::uint64_t Count(std::size_t from, std::size_t to) const;
  bool IsCad() const;
  /// OfCad or Smooth.
  double ChooseFeatureAngle() const { return this->IsCad() ? OfCad : Smooth; }

private:
  std::array<std::uint64_t, 181> Edges{}; // by angle
};

#endif
