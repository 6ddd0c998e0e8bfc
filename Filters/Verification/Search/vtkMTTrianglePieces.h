// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class VTKMTVERIFICATION_EXPORT vtkMTTrianglePieces
 * @brief the triangles of a surface, with the long ones divided into pieces, for trees of boxes
 *
 * The boxes of long thin triangles that run askew overlap nearly all others, so a tree over them finds nothing out.
 * Here a triangle whose longest edge is above a threshold is halved there, and its halves likewise: the pieces' boxes
 * are small. The threshold is four times the mean size of a triangle (the root of twice its area), and is doubled until
 * there are at most three pieces per triangle on average. Where all triangles are alike, every piece is a whole
 * triangle and takes no memory.
 */
#ifndef vtkMTTrianglePieces_h
#define vtkMTTrianglePieces_h

#include "vtkMTPrincipalAxes.h"
#include "vtkMTSampledSurface.h"

#include <cstddef>
#include <cstdint>
#include <vector>

class VTKMTVERIFICATION_EXPORT vtkMTTrianglePieces
{
public:
  /// The surface must outlive this object and not change.
  explicit vtkMTTrianglePieces(const vtkMTSampledSurface& surface);

  /// The numbers of all pieces, ascending; a piece that is a whole triangle has the triangle's number.
  std::vector<std::uint32_t> List() const;

  std::uint32_t GetTriangle(std::uint32_t piece) const;
  /// Boxes and barycentres are those of the turned surface.
  const vtkMTPrincipalAxes& GetAxes() const { return this->Axes; }
  vtkMTRealBounds GetBounds(std::uint32_t piece) const;
  /// Three times the piece's barycentre.
  vtkMTRealPoint GetBarycentre(std::uint32_t piece) const;
  /// The numbers of pieces are below this.
  std::size_t GetNumberOfPieces() const { return this->Whole + this->Parts.size(); }
  /// Whether two pieces have the same corners in the same order, and so do their triangles.
  bool AreEqual(std::uint32_t a, std::uint32_t b) const;

  struct Corners
  {
    vtkMTRealPoint P[3];
  };
  /// Of the piece, in the turned surface.
  Corners GetCorners(std::uint32_t piece) const;
  /// Whether triangles are so long that they were divided.
  bool HasNeedles() const { return !this->Parts.empty(); }

private:
  double GetMeanSize() const;
  double GetLongest() const;
  std::size_t CountDivisions(double threshold) const;
  void Divide(double threshold);
  template <typename Visitor>
  static void VisitParts(const Corners& corners, double threshold2, Visitor&& visitor);

  const vtkMTSampledSurface& Surface;
  const vtkMTPrincipalAxes Axes;
  std::size_t Whole = 0;
  std::vector<bool> IsDivided;           // by triangle; empty when none is
  std::vector<Corners> Parts;            // their numbers follow those of the triangles
  std::vector<std::uint32_t> PartOwners; // the triangle of each
};

#endif
