// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTVerifyPolygons
 * @brief the polygons of a mesh as triangles, for the verification
 *
 * Ears are clipped (Meisters 1975) in the plane of the polygon's area vector. An ear is taken only when its diagonal
 * crosses no edge and no other corner lies in it, so polygons with holes (bridge edges) and such that touch themselves
 * keep their area. A polygon that is bent, or has several triangulations, is no surface before its diagonals are
 * chosen: of all ears those come first whose diagonal the model has, which isEdge says. So every right choice of the
 * builder's gives the same triangles here, and a wrong one does not.
 *
 * Where the model has other diagonals, two surfaces of one bent polygon may be as far apart as it is thick: that is the
 * slack of its triangles, and of the sums of areas and volumes. A polygon that has no ears crosses itself; nothing is
 * demanded of it, and it is counted.
 */
#ifndef vtkMTVerifyPolygons_h
#define vtkMTVerifyPolygons_h

#include "vtkMTSampledSurface.h"
#include "vtkMTVerificationModule.h" // For export macro
#include "vtkType.h"

#include <cstdint>
#include <functional>
#include <vector>

class vtkPolyData;

class VTKMTVERIFICATION_EXPORT vtkMTVerifyPolygons
{
public:
  using EdgeTest = std::function<bool(const vtkMTRealPoint& a, const vtkMTRealPoint& b)>;

  explicit vtkMTVerifyPolygons(EdgeTest isEdge)
    : IsEdge(std::move(isEdge))
  {
  }

  /// Fills the surface's points, triangles, cells and slack. Triangles that are no surface are left out and counted.
  void Split(vtkPolyData* mesh, vtkMTSampledSurface& surface);

  ///@{
  /// What the last mesh leaves open: triangles, area and volume (model units) that depend on a choice.
  std::int64_t GetOpenTriangles() const { return this->OpenTriangles; }
  double GetOpenArea() const { return this->OpenArea; }
  double GetOpenVolume() const { return this->OpenVolume; }
  std::int64_t GetNumberOfCrossing() const { return this->Crossing; } ///< polygons that cross themselves
  ///@}

private:
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
    double Area = 0.0; ///< of the area vector: the least that any triangulation has
    double Thickness = 0.0;
    double Reach = 0.0;
  };
  static Polygon Project(const std::vector<vtkIdType>& ids, const vtkMTSampledSurface& surface);
  void AddPolygon(const std::vector<vtkIdType>& ids, vtkIdType cell, vtkMTSampledSurface& surface);
  void AddTriangle(const vtkMTTriangle& triangle, vtkIdType cell, double slack, vtkMTSampledSurface& surface);
  bool Clip(const Polygon& polygon, std::vector<vtkMTTriangle>& triangles, bool& isOfModel) const;
  static int FindEar(const std::vector<Corner>& corners, const EdgeTest& isWanted, bool isFlatAllowed);
  static bool IsEar(const std::vector<Corner>& corners, std::size_t index, bool isFlatAllowed);

  const EdgeTest IsEdge;
  std::int64_t OpenTriangles = 0;
  double OpenArea = 0.0;
  double OpenVolume = 0.0;
  std::int64_t Crossing = 0;
};

#endif
