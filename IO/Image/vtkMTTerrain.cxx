// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTTerrain.h"

#include "vtkMTSpoolStore.h"
#include "vtkMTTerrainStream.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <vector>

namespace
{
// How far a sample may be from its place on the grid, in steps.
constexpr double Slack = 0.01;

// How far tiles may be apart, in steps: more than once around the Earth at a third of an arc second.
constexpr double Farthest = 4.0e6;

// Finds the tile's place on the grid of the first one.
bool Place(const vtkMTHeightTile& first, vtkMTTerrainTiles::Placed& placed, std::string& error)
{
  const vtkMTHeightTile& tile = placed.Tile;
  const double column = (tile.West - first.West) / first.StepX;
  const double row = (tile.South - first.South) / first.StepY;
  const double drift = std::max(std::abs(tile.StepX / first.StepX - 1.0) * static_cast<double>(tile.Columns),
    std::abs(tile.StepY / first.StepY - 1.0) * static_cast<double>(tile.Rows));
  const bool isOnGrid = std::max(std::abs(column - std::round(column)), std::abs(row - std::round(row))) < Slack &&
    std::max(std::abs(column), std::abs(row)) < Farthest;
  const bool isCode = tile.Crs.rfind("EPSG:", 0) == 0 && first.Crs.rfind("EPSG:", 0) == 0;
  if (tile.IsGeographic != first.IsGeographic || (isCode && tile.Crs != first.Crs))
  {
    error = "its coordinates are of another reference system than those of " + first.Path + "; warp it (gdalwarp)";
    return false;
  }
  if (!(drift < Slack) || !isOnGrid)
  {
    error = "its samples do not lie on the grid of " + first.Path +
      "; tiles of one terrain have one spacing and one origin: build them as models of their own, or resample them";
    return false;
  }
  placed.Column = static_cast<std::int64_t>(std::llround(column));
  placed.Row = static_cast<std::int64_t>(std::llround(row));
  return true;
}

// Longitudes go round: tiles on both sides of the 180th meridian are neighbours. The grid begins behind the widest gap
// between them.
void CloseCircle(std::vector<vtkMTTerrainTiles::Placed>& tiles)
{
  const double round = 360.0 / tiles.front().Tile.StepX;
  if (!tiles.front().Tile.IsGeographic || std::abs(round - std::round(round)) >= Slack)
  {
    return;
  }
  const auto period = static_cast<std::int64_t>(std::llround(round));
  std::vector<std::array<std::int64_t, 2>> ranges; // the first column, and that behind the last
  for (const vtkMTTerrainTiles::Placed& placed : tiles)
  {
    ranges.push_back({ placed.Column, placed.Column + static_cast<std::int64_t>(placed.Tile.Columns) });
  }
  std::sort(ranges.begin(), ranges.end());
  std::int64_t widest = 0;
  std::int64_t begin = ranges.front()[0]; // of what is east of the widest gap
  std::int64_t end = ranges.front()[1];
  for (const auto& range : ranges)
  {
    if (range[0] - end > widest)
    {
      widest = range[0] - end;
      begin = range[0];
    }
    end = std::max(end, range[1]);
  }
  const bool isTorn = widest > ranges.front()[0] + period - end;
  for (vtkMTTerrainTiles::Placed& placed : tiles)
  {
    placed.Column += isTorn && placed.Column < begin ? period : 0;
  }
}
}

struct vtkMTTerrain::Internals
{
  std::shared_ptr<vtkMTTerrainTiles> AllTiles = std::make_shared<vtkMTTerrainTiles>();
};

vtkMTTerrain::vtkMTTerrain()
  : Implementation(std::make_unique<Internals>())
{
}

vtkMTTerrain::~vtkMTTerrain() = default;

bool vtkMTTerrain::CanRead(const std::string& path)
{
  return vtkMTHeightTile::CanRead(path);
}

bool vtkMTTerrain::AddTile(const std::string& path, std::string& error)
{
  std::string reason;
  try
  {
    vtkMTTerrainTiles::Placed placed;
    vtkMTTerrainTiles& tiles = *this->Implementation->AllTiles;
    vtkMTHeightTile& tile = placed.Tile;
    if (!tile.Read(path, reason))
    {
      error = path + ": " + reason;
      return false;
    }
    if (!tiles.All.empty() && !Place(tiles.All.front().Tile, placed, reason))
    {
      error = path + ": " + reason;
      return false;
    }
    if (this->Store && !this->PutHeights(placed.Tile.Heights, placed.FirstByte, error))
    {
      return false;
    }
    tiles.All.push_back(std::move(placed));
    return true;
  }
  catch (const std::exception& exception) // no memory
  {
    error = path + ": " + exception.what();
    return false;
  }
}

bool vtkMTTerrain::PutHeights(std::vector<float>& heights, std::uint64_t& firstByte, std::string& error)
{
  std::unique_ptr<vtkMTSpool>& spool = this->Implementation->AllTiles->Heights;
  spool = spool ? std::move(spool) : this->Store->Create(error);
  firstByte = spool ? spool->GetSize() : 0;
  const bool put = spool && spool->Append(heights.data(), heights.size() * sizeof(float), error);
  heights = std::vector<float>();
  return put;
}

std::unique_ptr<vtkMTTriangleStream> vtkMTTerrain::MakeStream(std::string& error)
{
  const std::shared_ptr<vtkMTTerrainTiles>& tiles = this->Implementation->AllTiles;
  if (tiles->All.empty() || !std::isfinite(this->VerticalScale) || this->VerticalScale == 0.0)
  {
    error = tiles->All.empty() ? "the terrain has no tiles" : "the vertical scale must be a finite number other than 0";
    return nullptr;
  }
  try
  {
    CloseCircle(tiles->All);
    auto stream = vtkMTTerrainStream::Open(tiles, this->VerticalScale, this->Degrees, error);
    if (!stream || stream->GetNumberOfTriangles() > 0)
    {
      return stream;
    }
    error = tiles->All.front().Tile.Path + ": there is not one triangle without a void";
  }
  catch (const std::exception& exception) // no memory
  {
    error = std::string("the terrain could not be made: ") + exception.what();
  }
  return nullptr;
}

vtkMTWorldFrame vtkMTTerrain::GetFrame() const
{
  const vtkMTTerrainTiles& tiles = *this->Implementation->AllTiles;
  return tiles.All.empty() ? vtkMTWorldFrame() : vtkMTTerrainStream::GetFrame(tiles, this->Degrees);
}

namespace
{
bool Fill(vtkMTTriangleStream& stream, vtkPoints* points, vtkCellArray* triangles, std::string& error)
{
  vtkMTTriangleStream::PointBlock block;
  vtkMTTriangleStream::TriangleBlock cells;
  bool good = true;
  while ((good = stream.NextPoints(block)) && !block.Points.empty())
  {
    for (const std::array<double, 3>& point : block.Points)
    {
      points->InsertNextPoint(point.data());
    }
  }
  while (good && (good = stream.NextTriangles(cells)) && !cells.Triangles.empty())
  {
    for (const std::array<std::uint64_t, 3>& t : cells.Triangles)
    {
      triangles->InsertNextCell(
        { static_cast<vtkIdType>(t[0]), static_cast<vtkIdType>(t[1]), static_cast<vtkIdType>(t[2]) });
    }
  }
  error = good ? error : stream.GetError();
  return good;
}
}

bool vtkMTTerrain::Make(vtkPolyData* output, std::string& error)
{
  output->Initialize();
  this->Report.clear();
  const std::unique_ptr<vtkMTTriangleStream> stream = this->MakeStream(error);
  if (!stream)
  {
    return false;
  }
  try
  {
    vtkNew<vtkPoints> points;
    points->SetDataType(VTK_DOUBLE);
    vtkNew<vtkCellArray> triangles;
    if (!Fill(*stream, points, triangles, error))
    {
      return false;
    }
    output->SetPoints(points);
    output->SetPolys(triangles);
    this->Report = stream->GetReport();
    return true;
  }
  catch (const std::exception& exception) // no memory
  {
    error = std::string("the terrain could not be made: ") + exception.what();
    output->Initialize();
    return false;
  }
}
