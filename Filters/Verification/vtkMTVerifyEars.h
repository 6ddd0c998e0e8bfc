// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTVerifyEars
 * @brief the ears of a polygon, for vtkMTVerifyPolygons
 *
 * The polygon is projected into the plane of its area vector. A corner is an ear when it turns as the polygon does, no
 * edge crosses its diagonal, and no other corner lies in its triangle or on its diagonal.
 */
#ifndef vtkMTVerifyEars_h
#define vtkMTVerifyEars_h

#include "vtkMTSampledSurface.h"
#include "vtkMTVerificationModule.h" // For export macro
#include "vtkType.h"

#include <cstddef>
#include <cstdint>
#include <vector>

class VTKMTVERIFICATION_EXPORT vtkMTVerifyEars
{
public:
  struct Corner
  {
    std::uint32_t Point;
    vtkMTRealPoint Place;
    double X;
    double Y;
  };

  struct Polygon
  {
    std::vector<Corner> Corners;
    double Area = 0.0;      ///< of the area vector: the least that any triangulation has
    double Thickness = 0.0; ///< how far two triangulations may be apart
    double Reach = 0.0;     ///< twice the distance of the farthest corner from the middle
  };

  /// Of points of the surface, three at least.
  static Polygon Project(const std::vector<vtkIdType>& ids, const vtkMTSampledSurface& surface);
  /// Twice the area of a, b, c in the plane, negative where they turn against the polygon.
  static double GetTurn(const Corner& a, const Corner& b, const Corner& c);
  static bool IsSamePlace(const Corner& a, const Corner& b) { return a.Place == b.Place; }
  /// isFlatAllowed: a corner that does not turn is one too.
  static bool IsEar(const std::vector<Corner>& corners, std::size_t index, bool isFlatAllowed);
  /// The one with the shortest diagonal; -1 when there is none.
  static int FindShortestEar(const std::vector<Corner>& corners, bool isFlatAllowed);
  /// Moves a corner's triangle from the polygon to the triangles.
  static void Cut(std::vector<Corner>& corners, std::size_t i, std::vector<vtkMTTriangle>& triangles);
};

#endif
