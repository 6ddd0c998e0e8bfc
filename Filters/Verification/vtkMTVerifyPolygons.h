// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTVerifyPolygons
 * @brief the polygons of a mesh as triangles, for the verification
 *
 * Ears are clipped (Meisters 1975) in the plane of the polygon's area vector. An ear is taken only when its diagonal
 * crosses no edge and no other corner lies in it, so polygons with holes (bridge edges) and such that touch themselves
 * keep their area. A polygon that is bent, or has several triangulations, is no surface before its diagonals are
 * chosen: of all ears those come first that are triangles of the model, which countTriangles says. So every right
 * choice of the builder's gives the same triangles here, and a wrong one does not. That the model has an ear's diagonal
 * would not do: it may be an edge of another face beside or upon the polygon. For the same reason a triangle of the
 * model is used by as many faces as it has copies, and by those in its own turn before those in the opposite one, which
 * are there where the builder was asked to turn triangles. Where faces that lie on each other are split in several
 * ways, which one has which split cannot be told: their triangles are "mixed".
 *
 * Where the model has other diagonals, two surfaces of one bent polygon may be as far apart as it is thick: that is the
 * slack of its triangles, and of the sums of areas and volumes. A polygon that has no ears crosses itself; nothing is
 * demanded of it, and it is counted.
 */
#ifndef vtkMTVerifyPolygons_h
#define vtkMTVerifyPolygons_h

#include "vtkMTSampledSurface.h"
#include "vtkMTVerificationModule.h" // For export macro
#include "vtkMTVerifyEars.h"
#include "vtkType.h"

#include <cstdint>
#include <functional>
#include <unordered_map>
#include <vector>

class vtkPolyData;

class VTKMTVERIFICATION_EXPORT vtkMTVerifyPolygons
{
public:
  /// How many triangles the model has at a, b, c in this turn.
  using TriangleCount =
    std::function<std::size_t(const vtkMTRealPoint& a, const vtkMTRealPoint& b, const vtkMTRealPoint& c)>;

  /// countTriangles: none when there is no model to follow.
  explicit vtkMTVerifyPolygons(TriangleCount countTriangles)
    : CountTriangles(std::move(countTriangles))
  {
  }

  /// Fills the surface's points, triangles, cells, slack and what is mixed. Triangles that are no surface are left out
  /// and counted.
  void Split(vtkPolyData* mesh, vtkMTSampledSurface& surface);

  ///@{
  /// What the last mesh leaves open: triangles, area and volume (model units) that depend on a choice.
  std::int64_t GetOpenTriangles() const { return this->OpenTriangles; }
  double GetOpenArea() const { return this->OpenArea; }
  double GetOpenVolume() const { return this->OpenVolume; }
  std::int64_t GetNumberOfCrossing() const { return this->Crossing; } ///< polygons that cross themselves
  ///@}

private:
  using Corner = vtkMTVerifyEars::Corner;
  using Polygon = vtkMTVerifyEars::Polygon;

  void AddPolygon(const std::vector<vtkIdType>& ids, vtkIdType cell, vtkMTSampledSurface& surface);
  void AddTriangle(
    const vtkMTTriangle& triangle, vtkIdType cell, double slack, bool isMixed, vtkMTSampledSurface& surface);
  void AddFace(const std::vector<vtkIdType>& ids, vtkIdType cell, vtkMTSampledSurface& surface);
  template <class Add>
  static void VisitFaces(vtkPolyData* mesh, const Add& add);

  // Which triangles of the model a polygon may have.
  struct Choice
  {
    bool IsUnusedOnly = false;
    bool IsTurnedAllowed = false;
  };
  bool Clip(const Polygon& polygon, std::vector<vtkMTTriangle>& triangles, bool& isOfModel) const;
  bool ClipAsModel(const Polygon& polygon, std::vector<vtkMTTriangle>& triangles) const;
  bool ClipAsModel(
    const Polygon& polygon, std::size_t start, Choice choice, std::vector<vtkMTTriangle>& triangles) const;
  bool HasOtherSplit(const Polygon& polygon, std::vector<vtkMTTriangle> triangles) const;
  bool IsOfModel(const Corner& a, const Corner& b, const Corner& c, Choice choice) const;
  std::size_t GetUses(const vtkMTRealPoint& a, const vtkMTRealPoint& b, const vtkMTRealPoint& c) const;
  void Use(const vtkMTRealPoint& a, const vtkMTRealPoint& b, const vtkMTRealPoint& c);
  int FindEarOfModel(const std::vector<Corner>& corners, std::size_t start, Choice choice) const;

  const TriangleCount CountTriangles;
  std::unordered_map<std::uint64_t, std::size_t> Uses; // of triangles of the model, by faces
  std::int64_t OpenTriangles = 0;
  double OpenArea = 0.0;
  double OpenVolume = 0.0;
  std::int64_t Crossing = 0;
};

#endif
