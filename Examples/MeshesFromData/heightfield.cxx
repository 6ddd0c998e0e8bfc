// SPDX-License-Identifier: BSD-3-Clause
#include "heightfield.h"

#include "vtkCellArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <regex>
#include <stdexcept>

namespace
{
constexpr std::int16_t Void = -32768;

struct Tile
{
  int Latitude = 0; // of the south-west corner
  int Longitude = 0;
  std::size_t Size = 0; // samples along a side
  std::vector<std::int16_t> Heights;
};

std::vector<unsigned char> ReadAll(const std::string& path)
{
  const std::unique_ptr<gzFile_s, int (*)(gzFile)> file(
    gzopen(path.c_str(), "rb"), gzclose); // reads plain files as well
  if (!file)
  {
    throw std::runtime_error(path + ": cannot be opened");
  }
  std::vector<unsigned char> bytes;
  std::vector<unsigned char> block(1 << 20);
  int count = 0;
  while ((count = gzread(file.get(), block.data(), static_cast<unsigned>(block.size()))) > 0)
  {
    bytes.insert(bytes.end(), block.begin(), block.begin() + count);
  }
  if (count < 0)
  {
    throw std::runtime_error(path + ": is damaged");
  }
  return bytes;
}

void ParseName(const std::string& path, Tile& tile)
{
  static const std::regex corner("([NSns])([0-9]{2})([EWew])([0-9]{3})[^/]*$");
  std::smatch match;
  if (!std::regex_search(path, match, corner))
  {
    throw std::runtime_error(path + ": the name does not say the south-west corner, as N36W005 does");
  }
  tile.Latitude = std::stoi(match[2]) * (std::toupper(match[1].str()[0]) == 'S' ? -1 : 1);
  tile.Longitude = std::stoi(match[4]) * (std::toupper(match[3].str()[0]) == 'W' ? -1 : 1);
}

Tile ReadTile(const std::string& path)
{
  Tile tile;
  ParseName(path, tile);
  const std::vector<unsigned char> bytes = ReadAll(path);
  const std::size_t samples = bytes.size() / 2;
  tile.Size = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(samples))));
  if (tile.Size < 2 || 2 * tile.Size * tile.Size != bytes.size())
  {
    throw std::runtime_error(path + ": " + std::to_string(bytes.size()) + " bytes are no square tile");
  }
  tile.Heights.resize(tile.Size * tile.Size);
  for (std::size_t i = 0; i < tile.Heights.size(); ++i)
  {
    tile.Heights[i] = static_cast<std::int16_t>(static_cast<std::uint16_t>(bytes[2 * i] << 8 | bytes[2 * i + 1]));
  }
  return tile;
}

// All tiles on one grid, row 0 in the south.
struct Grid
{
  std::size_t Columns = 0;
  std::size_t Rows = 0;
  std::size_t Squares = 0; // of a tile, along a side
  int South = 0;
  std::vector<std::int16_t> Heights;

  std::int16_t At(std::size_t column, std::size_t row) const { return this->Heights[row * this->Columns + column]; }

  void Add(const Tile& tile, int west)
  {
    const std::size_t firstColumn = static_cast<std::size_t>(tile.Longitude - west) * this->Squares;
    const std::size_t firstRow = static_cast<std::size_t>(tile.Latitude - this->South) * this->Squares;
    for (std::size_t i = 0; i < tile.Heights.size(); ++i)
    {
      const std::size_t row = firstRow + this->Squares - i / tile.Size;
      std::int16_t& height = this->Heights[row * this->Columns + firstColumn + i % tile.Size];
      height = tile.Heights[i] != Void ? tile.Heights[i] : height;
    }
  }
};

Grid Join(const std::vector<Tile>& tiles)
{
  int west = tiles.front().Longitude, east = west;
  int south = tiles.front().Latitude, north = south;
  for (const Tile& tile : tiles)
  {
    if (tile.Size != tiles.front().Size)
    {
      throw std::runtime_error("the tiles are not of one size");
    }
    west = std::min(west, tile.Longitude);
    east = std::max(east, tile.Longitude);
    south = std::min(south, tile.Latitude);
    north = std::max(north, tile.Latitude);
  }
  Grid grid;
  grid.South = south;
  grid.Squares = tiles.front().Size - 1;
  grid.Columns = static_cast<std::size_t>(east - west + 1) * grid.Squares + 1;
  grid.Rows = static_cast<std::size_t>(north - south + 1) * grid.Squares + 1;
  grid.Heights.assign(grid.Columns * grid.Rows, Void);
  for (const Tile& tile : tiles)
  {
    grid.Add(tile, west);
  }
  return grid;
}

// Points of all samples that are there; gives, per sample, the index of its point or -1.
std::vector<vtkIdType> MakePoints(const Grid& grid, vtkPoints* points)
{
  const double metresPerDegree = vtkMath::RadiansFromDegrees(1.0) * 6371008.8;
  const double step = metresPerDegree / static_cast<double>(grid.Squares);
  const double middle = grid.South + 0.5 * static_cast<double>(grid.Rows - 1) / static_cast<double>(grid.Squares);
  const double narrowing = std::cos(vtkMath::RadiansFromDegrees(middle));
  std::vector<vtkIdType> index(grid.Heights.size(), -1);
  for (std::size_t row = 0; row < grid.Rows; ++row)
  {
    for (std::size_t column = 0; column < grid.Columns; ++column)
    {
      if (grid.At(column, row) != Void)
      {
        index[row * grid.Columns + column] = points->InsertNextPoint(
          step * narrowing * static_cast<double>(column), step * static_cast<double>(row), grid.At(column, row));
      }
    }
  }
  return index;
}

void AddTriangle(vtkCellArray* triangles, vtkIdType a, vtkIdType b, vtkIdType c)
{
  if (a >= 0 && b >= 0 && c >= 0)
  {
    triangles->InsertNextCell({ a, b, c });
  }
}
}

void MakeTerrain(const std::vector<std::string>& tiles, vtkPolyData* mesh)
{
  std::vector<Tile> read;
  read.reserve(tiles.size());
  for (const std::string& tile : tiles)
  {
    read.push_back(ReadTile(tile));
  }
  const Grid grid = Join(read);
  vtkNew<vtkPoints> points;
  const std::vector<vtkIdType> index = MakePoints(grid, points);
  vtkNew<vtkCellArray> triangles;
  for (std::size_t row = 0; row + 1 < grid.Rows; ++row)
  {
    for (std::size_t column = 0; column + 1 < grid.Columns; ++column)
    {
      const std::size_t corner = row * grid.Columns + column;
      const vtkIdType a = index[corner], b = index[corner + 1];
      const vtkIdType c = index[corner + grid.Columns + 1], d = index[corner + grid.Columns];
      // Where one corner is void, the diagonal goes past it, so that one triangle is left.
      const bool otherDiagonal = a < 0 || c < 0;
      AddTriangle(triangles, a, b, otherDiagonal ? d : c);
      AddTriangle(triangles, otherDiagonal ? b : a, c, d);
    }
  }
  mesh->SetPoints(points);
  mesh->SetPolys(triangles);
}
