// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTPointWelding
 * @brief gives points that are one place on the surface one identity
 *
 * Meshes come apart at seams: an OBJ repeats a point for every texture coordinate, an STL for every triangle. A border
 * edge (one that a single triangle uses, by index) is stitched to another one when their ends are equal bit for bit,
 * when no third border edge lies there, and when they run in opposite directions. Edges of different parts do not see
 * each other; an edge is of its triangle's part. Nothing else is merged: sheets that merely coincide, and points that
 * merely are close, stay what their indices make them.
 *
 * The mesh comes in blocks. Edges that only one block can have are settled there; the others are sorted by index,
 * border edges by the hash of their places, and what is to be joined by place again: joined points lie at one place, so
 * every place is solved by itself. All sorts are external. The identity of joined points is the smallest index among
 * them, so the result does not depend on blocks, order or memory.
 */
#ifndef vtkMTPointWelding_h
#define vtkMTPointWelding_h

#include "vtkMTConstructionModule.h" // For export macro
#include "vtkMTInputBlock.h"
#include "vtkMTRecordSort.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

class VTKMTCONSTRUCTION_EXPORT vtkMTPointWelding
{
public:
  /// memory: bytes, for all sorts together.
  vtkMTPointWelding(vtkMTSpoolStore& store, std::size_t memory);
  ~vtkMTPointWelding();

  /// Edges of a block's triangles that may be border edges: 3 t + c for that from corner c of triangle t to its next
  /// one.
  struct BlockEdges
  {
    std::vector<std::uint32_t> Open;   ///< both ends belong to other blocks as well
    std::vector<std::uint32_t> Border; ///< no other triangle has them
  };
  /// May be called by any thread.
  static BlockEdges FindEdges(const vtkMTInputBlock& block);

  ///@{
  /// All blocks with their edges, then Finish. No triangle may have two corners at one place. partColumn: which of the
  /// block's columns holds the part that a triangle is of, as 32-bit integers; -1: there is only one. False with a
  /// message in GetError.
  bool Add(const vtkMTInputBlock& block, const BlockEdges& edges, int partColumn = -1);
  bool Finish();
  ///@}

  std::int64_t GetNumberOfStitchedEdges() const
  {
    return this->StitchedEdges;
  } ///< pairs of border edges that were joined
  std::int64_t GetNumberOfWeldedPoints() const
  {
    return this->StitchedPoints;
  } ///< points that took another one's identity

  /**
   * The identity of a point that was joined with others (the smallest of them has its own); None for all others. Points
   * must be asked for in increasing order.
   */
  std::uint32_t FindRoot(std::uint32_t point);
  static constexpr std::uint32_t None = ~std::uint32_t(0);

  const std::string& GetError() const { return this->Error; }

private:
  struct Edge;
  struct Union;

  bool Fail(const std::string& error);
  static Edge MakeEdge(const vtkMTInputBlock& block, std::uint32_t corner, int partColumn);
  bool AddBorderEdge(const Edge& edge);
  bool FindBorderAmongOpen();
  bool JoinEdges();
  bool JoinEdgesAtPlaces(std::vector<Edge>& edges);
  bool SolvePlaces();
  bool SolvePlace(std::vector<std::pair<std::uint32_t, std::uint32_t>>& unions);

  vtkMTSpoolStore& Store;
  const std::size_t Memory;
  std::string Error;
  std::unique_ptr<vtkMTRecordSort> Open;   // edges that several blocks may have, by index
  std::unique_ptr<vtkMTRecordSort> Border; // border edges, by their places
  std::unique_ptr<vtkMTRecordSort> Unions; // pairs of points, by place
  std::unique_ptr<vtkMTRecordSort> Roots;  // point above, root below
  std::uint64_t NextRoot = ~std::uint64_t(0);
  std::int64_t StitchedEdges = 0;
  std::int64_t StitchedPoints = 0;
};

#endif
