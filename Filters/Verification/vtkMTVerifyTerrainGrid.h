// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTVerifyTerrainGrid
 * @brief joins tiles on one grid, and makes triangles of it
 */
#ifndef vtkMTVerifyTerrainGrid_h
#define vtkMTVerifyTerrainGrid_h

#include "vtkMTVerificationModule.h" // For export macro
#include "vtkMTVerifyTerrainInput.h"
#include "vtkMTVerifyTerrainTile.h"

#include "vtkType.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

class vtkCellArray;
class vtkPoints;
class vtkPolyData;

class VTKMTVERIFICATION_EXPORT vtkMTVerifyTerrainGrid
{
public:
  vtkMTVerifyTerrainGrid(const vtkMTVerifyTerrainInput::Options& options, vtkMTVerifyTerrainInput::Facts& facts);

  /// Finds the grid of all tiles, whose heights are not looked at. False with the reason in error.
  bool SetLayout(const std::vector<vtkMTVerifyTerrainTile>& tiles, std::string& error);
  /// Enters the heights of the tile that had this number in SetLayout.
  void Enter(std::size_t number, const vtkMTVerifyTerrainTile& tile);
  /// Makes the surface, and what facts has about it.
  void Triangulate(vtkPolyData* surface);

private:
  using Place = std::array<double, 3>;
  bool FindOffset(const vtkMTVerifyTerrainTile& tile, std::array<std::int64_t, 2>& offset) const;
  void SetMap();
  Place GetPlace(std::int64_t column, std::int64_t row) const;
  double GetHeight(std::int64_t column, std::int64_t row) const;
  void AddQuad(std::int64_t column, std::int64_t row);
  void AddTriangle(const std::array<std::int64_t, 2> (&corners)[3]);
  vtkIdType GetPoint(std::int64_t column, std::int64_t row);

  vtkMTVerifyTerrainInput::Options Options;
  vtkMTVerifyTerrainInput::Facts& Facts;
  vtkMTVerifyTerrainTile Base;                      ///< the first tile's place, without heights
  std::vector<std::array<std::int64_t, 2>> Offsets; ///< of every tile in the grid
  std::vector<double> Heights;                      ///< NaN: void, or no tile
  std::vector<unsigned char> IsInTile;
  bool IsMirrored = false; ///< rows run against columns: seen from above their angle is clockwise
  vtkPoints* Points = nullptr;
  vtkCellArray* Triangles = nullptr;
  std::vector<vtkIdType> Ids[2]; ///< of the points of the quads' even and odd rows; -1: none yet
};

#endif
