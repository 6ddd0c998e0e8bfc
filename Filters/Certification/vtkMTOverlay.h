// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTOverlay
 * @brief a common subdivision of a floor and its fragment, which bounds their distance both ways at once
 *
 * Every point of the floor is given a place on the fragment. Every edge of the floor is then traced over the fragment,
 * from the place of one end to that of the other, and crosses edges of the fragment on its way: at each crossing a
 * point of the one edge goes with a point of the other. The three traces around a triangle t make a loop. Where it
 * closes up over the fragment (crossings that go forth and back over the same edge cancel; a loop around an inner point
 * of the fragment is pulled across it, and that point goes with the nearest one of t), t falls into cells with one
 * triangle s of the fragment each, and the cells' corners, on t and on s, are the ends, crossings and points above.
 *
 * Why the cells bound distances. The cells of t, glued as they adjoin, are a disc whose rim runs once around t, so
 * their images, each within the convex hull of its corners, cover t. The distance to a triangle s is convex, so no
 * point of a cell is farther from s than the farthest of its corners is from its partner. That is the distance from
 * floor to fragment. For the way back: the partners define a continuous map from the floor's triangles whose loops
 * close up to the fragment, of which each cell goes to the convex hull of its partners, in s. How often it covers a
 * place of the fragment, counted modulo two (its degree), changes only across the image of the rim of that part of the
 * floor. So where no rim comes, and a point of the fragment nearby is inside of an odd number of loops, every point of
 * s is within a cell's partners, and no farther from t than that cell's corners.
 *
 * See Cohen, Manocha and Olano, "Simplifying Polygonal Models Using Successive Mappings" (IEEE Visualization 1997) for
 * maps made collapse by collapse; here one map is made for all collapses of a step, from where the points end up.
 */
#ifndef vtkMTOverlay_h
#define vtkMTOverlay_h

#include "vtkMTSurface.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <vector>

class vtkMTOverlay
{
public:
  using Vector = vtkMTSurface::Vector;
  static constexpr std::uint32_t None = vtkMTSurface::None;

  /// Where on the fragment a point of the floor is taken to be.
  struct Place
  {
    std::uint32_t Triangle = None; ///< None where nothing is known
    std::uint32_t Point = None;    ///< the fragment's point at the very same place, if there is one
    double Distance = 0.0;         ///< from the floor's point, steps
    Vector At{ 0.0, 0.0, 0.0 };
  };

  /// The part of a floor's triangle that goes with one triangle of the fragment, and their largest distance. It is zero
  /// only where they meet in corners of both. On either side the cell may be but a single point, which other cells
  /// cover as well: it then says nothing of that side.
  struct Cell
  {
    std::uint32_t Triangle;
    double Distance;
    bool CoversFloor;
    bool CoversFragment;
  };

  /// places: per point of the floor.
  vtkMTOverlay(const vtkMTSurface& floor, const vtkMTSurface& fragment, const std::vector<Place>& places);

  std::vector<Cell> Cells; ///< by triangle of the floor
  /// [floor's triangles + 1] where each triangle's cells begin; it has none where its loop does not close up.
  std::vector<std::uint32_t> FirstCell;

  /// Per triangle of the fragment, 1 where the cells that it has cover it.
  std::vector<unsigned char> FindCovered() const;

private:
  // One corner or several: their largest distance, and the one point of either mesh that all of them are, if so.
  struct Corners
  {
    double Distance = 0.0;
    std::uint32_t FloorPoint = None;
    std::uint32_t FragmentPoint = None;
  };
  // An edge of the fragment is left across a half-edge.
  struct Crossing
  {
    std::uint32_t Halfedge;
    Corners Corner;
  };
  struct Trace
  {
    std::uint32_t First = 0;
    std::uint32_t Count = 0;
    bool Arrives = false;
  };
  class Tracer;

  // A cell of the loop and the crossing by which the loop leaves it.
  struct Step
  {
    std::uint32_t Halfedge;
    Corners Cell; // so far
    Corners Crossing;
  };

  void TraceEdges();
  void FindCells();
  bool CollectLoop(std::uint32_t triangle);
  void Cross(std::uint32_t h, const Corners& corner);
  bool PullAcross(std::uint32_t triangle);
  void AddCell(std::uint32_t triangle, const Corners& corners);
  void AddCellsAround(std::uint32_t triangle, std::size_t first, std::size_t last);
  bool PullTogether();
  bool PullTogetherReversed();
  bool PullAcrossPoint();
  void ReplaceRun(std::size_t begin, std::size_t run, std::size_t others);
  std::size_t CountAround(std::uint32_t out);
  /// Where partners are not corners on both sides, their distance may have been rounded to zero.
  static double AboveZero(double distance) { return std::max(distance, std::numeric_limits<double>::min()); }
  static Corners Merge(const Corners& a, const Corners& b);
  Corners MakeCorner(std::uint32_t floorPoint) const;
  Corners MakeInnerCorner(std::uint32_t out, std::uint32_t triangle) const;
  bool Closes(std::uint32_t triangle) const { return this->FirstCell[triangle] < this->FirstCell[triangle + 1]; }
  bool IsKeptBorder(std::uint32_t h, const Trace& trace) const;
  std::vector<unsigned char> FindRims() const;

  const vtkMTSurface& Floor;
  const vtkMTSurface& Fragment;
  const std::vector<Place>& Places;
  std::vector<Trace> Traces; // [floor's half-edges] where two are opposite, of the first one
  std::vector<Crossing> Crossings;
  std::vector<unsigned char> IsEnclosed; // [fragment's half-edges] their start, by an odd number of loops
  std::unordered_map<std::uint32_t, std::size_t> FansOfHubs; // by half-edge: triangles around its start
  const std::size_t MostPulling;
  std::size_t Pulling = 0; // crossings that were looked at
  std::vector<Step> Loop;
  Corners Here;                         // of the cell that the loop has come to
  std::vector<std::uint32_t> Remainder; // half-edges that a loop crosses once nothing cancels any more
  std::vector<std::uint32_t> Rim;       // the same while it is pulled together
  std::vector<std::uint32_t> Enclosed;  // a half-edge from each point that it was pulled across
};

#endif
