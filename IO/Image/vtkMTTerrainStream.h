// SPDX-License-Identifier: BSD-3-Clause
// Tiles of heights on one grid, and their terrain as a triangle stream. Not installed.
#ifndef vtkMTTerrainStream_h
#define vtkMTTerrainStream_h

#include "vtkMTHeightTile.h"
#include "vtkMTSpool.h"
#include "vtkMTTriangleStream.h"
#include "vtkMTWorldFrame.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

struct vtkMTTerrainTiles
{
  // A tile with its place on the grid of all, counted in steps from the first tile's corner.
  struct Placed
  {
    vtkMTHeightTile Tile; // without its heights where these are in the spool
    std::int64_t Column = 0;
    std::int64_t Row = 0;
    std::uint64_t FirstByte = 0; // in the spool
  };
  std::vector<Placed> All;
  std::unique_ptr<vtkMTSpool> Heights; // null: tiles hold theirs

  /// One row of a tile's heights; null on failure, with a message in error.
  const float* GetRow(const Placed& placed, std::size_t row, std::vector<float>& buffer, std::string& error) const;
};

namespace vtkMTTerrainStream
{
/// What vtkMTTerrain says. Walks once over everything; null on failure, with a message in error.
std::unique_ptr<vtkMTTriangleStream> Open(
  std::shared_ptr<const vtkMTTerrainTiles> tiles, double verticalScale, bool degrees, std::string& error);
/// In which its points are.
vtkMTWorldFrame GetFrame(const vtkMTTerrainTiles& tiles, bool degrees);
}

#endif
