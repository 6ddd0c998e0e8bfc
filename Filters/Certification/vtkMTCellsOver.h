// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTCellsOver
 * @brief splits a triangle of one mesh along the triangles of another that lie over it, as seen along its normal
 *
 * Beginning with one triangle of the other mesh that lies over the middle, all are met that can be reached across edges
 * which cross the triangle, as seen along its normal. Where each of these edges has two triangles and none of the
 * triangles is turned over, they lie over all of it: the part that they cover can only end at one of their edges, and
 * there are triangles on either side. So every point of the triangle is in a *cell*, the part below one of them.
 *
 * Rounding: differences of corners are exact, so a place is found to a few times 2^-52 of the lengths around it; of
 * triangles that are too long for this nothing is known.
 *
 * Threads: one at a time.
 */
#ifndef vtkMTCellsOver_h
#define vtkMTCellsOver_h

#include "vtkMTPiece.h"
#include "vtkMTSurface.h"

#include <array>
#include <cstdint>
#include <vector>

class vtkMTCellsOver
{
public:
  using Vector = vtkMTSurface::Vector;
  static constexpr std::uint32_t None = vtkMTSurface::None;
  static constexpr std::size_t MostTriangles = 512; ///< over one triangle

  /// A place as seen along the normal: its barycentric coordinates of corners 1 and 2, and how far above the plane.
  struct Place
  {
    double Weight1;
    double Weight2;
    double Height;
  };
  struct Cell
  {
    std::uint32_t Triangle; ///< the one that lies over it
    std::uint32_t First;    ///< of its corners
    std::uint32_t Count;
    double Height; ///< no point of the cell is farther from the one over it
  };

  /// Both must outlive it.
  vtkMTCellsOver(const vtkMTSurface& from, const vtkMTSurface& to)
    : From(from)
    , To(to)
  {
  }

  /// Goes from a guess, a triangle of the other mesh nearby, to the one that lies over the middle, and gives the last
  /// one that was come to.
  std::uint32_t Begin(std::uint32_t triangle, std::uint32_t guess);
  /// Whether that lies over part of the triangle at least.
  bool HasBegun() const { return !this->Stack.empty(); }
  /// Finds the cells of the triangle that was begun with. False where none are known to cover it: where nothing was
  /// found to lie over part of it, where the other mesh is folded, and of long triangles.
  bool Split();
  const std::vector<Cell>& GetCells() const { return this->Cells; }
  /// The corners of a cell, in the triangle's plane.
  void GetShape(const Cell& cell, vtkMTPiece& shape) const;

private:
  // A triangle of the other mesh that was come to across one of its half-edges, and where that begins and ends.
  struct Entry
  {
    std::uint32_t Halfedge;
    Place Begin;
    Place End;
  };

  bool SetPlane(std::uint32_t triangle);
  Place See(const Vector& x) const;
  void BeginAt(std::uint32_t h, const std::array<Place, 3>& corners);
  void BeginAtPart(std::uint32_t h, const std::array<Place, 3>& corners);
  bool Visit(const Entry& entry);
  void GoOn(std::uint32_t h, const Place& begin, const Place& end);
  void AddBeyond(std::uint32_t triangle, const Place& begin, const Place& end);
  void PutCell(std::uint32_t triangle, const Place* corners, int count, double height);
  void AddCell(std::uint32_t triangle, const std::array<Place, 3>& corners, int outside);

  const vtkMTSurface& From;
  const vtkMTSurface& To;
  Vector Origin;
  Vector Edge1; // from corner 0 to the others
  Vector Edge2;
  Vector Normal;
  Vector Gradient1; // of the barycentric coordinates
  Vector Gradient2;
  Place Middle; // from where what lies beyond borders is seen
  std::vector<Entry> Stack;
  std::vector<std::uint32_t> MetBy; // [other mesh's triangles] the last question that met it
  std::uint32_t Question = 0;
  std::size_t Met = 0;
  std::vector<Cell> Cells;
  std::vector<Place> Corners;
};

#endif
