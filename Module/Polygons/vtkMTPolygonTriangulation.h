// SPDX-License-Identifier: BSD-3-Clause
// Triangles of a polygon. Not installed.
#ifndef vtkMTPolygonTriangulation_h
#define vtkMTPolygonTriangulation_h

#include "vtkMTCoreModule.h" // For export macro
#include "vtkMTEarClipping.h"

#include <array>
#include <cstdint>
#include <vector>

/**
 * A polygon of n corners always becomes n - 2 triangles of its own corners. Convex quads are split along the shorter
 * diagonal. Of all other polygons ears are clipped (vtkMTEarClipping) in the plane across their mean normal: concave
 * ones, ones that touch themselves, and ones with holes, which a bridge joins to the outline, that is an edge passed
 * there and back. Triangles that all turn as the polygon does cover it exactly once; so that is checked, not assumed.
 * Where ears alone do not lead there, and there are at most 128 corners, the triangles that overlap least are found
 * among all that are possible (vtkMTLeastOverlap).
 */
class VTKMTCORE_EXPORT vtkMTPolygonTriangulation
{
public:
  using Place = std::array<double, 3>;
  using Triangle = vtkMTEarClipping::Triangle;

  /// The corners must be finite, three at least. False where triangles overlap or turn over, by more than a millionth
  /// of the area: then the outline crosses itself, and no triangles of its corners alone cover it.
  bool Triangulate(const std::vector<Place>& corners);

  /// Of the last polygon.
  const std::vector<Triangle>& GetTriangles() const { return this->Triangles; }

private:
  bool SplitQuad(const std::vector<Place>& corners);
  void Scale(const std::vector<Place>& corners);
  bool FindNormal(bool& isCrossed);
  void Project();
  bool ClipEars();
  bool IsCoveredOnce() const;

  vtkMTOutline Outline;
  vtkMTEarClipping Ears;
  double Extent = 0.0; // of the outline, scaled
  std::vector<Triangle> Triangles;
};

#endif
