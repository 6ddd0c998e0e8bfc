// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTTerrain.h"

#include "vtkMTHeightTile.h"

#include "vtkCellArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <vector>

struct vtkMTTerrain::Internals
{
  // A tile with its place on the grid of all, counted in steps from the first tile's corner.
  struct Placed
  {
    vtkMTHeightTile Tile;
    std::int64_t Column;
    std::int64_t Row;
  };
  std::vector<Placed> Tiles;
};

namespace
{
constexpr double EarthRadius = 6371008.8;

// How far a sample may be from its place on the grid, in steps.
constexpr double Slack = 0.01;

// How far tiles may be apart, in steps: more than once around the Earth at a third of an arc second.
constexpr double Farthest = 4.0e6;

// The grid's row, dense between the westernmost and the easternmost column of all tiles.
struct GridRow
{
  std::vector<float> Heights;
  std::vector<vtkIdType> Points; // -1 where there is a void or no tile

  void Clear(std::size_t columns)
  {
    this->Heights.assign(columns, std::numeric_limits<float>::quiet_NaN());
    this->Points.assign(columns, -1);
  }
};

void AddTriangle(vtkCellArray* triangles, vtkIdType a, vtkIdType b, vtkIdType c)
{
  if (a >= 0 && b >= 0 && c >= 0)
  {
    triangles->InsertNextCell({ a, b, c });
  }
}

// isCovered: whether some tile has the square; three tiles that meet make no triangle in the place of the fourth.
void AddSquares(
  const GridRow& south, const GridRow& north, const std::vector<unsigned char>& isCovered, vtkCellArray* triangles)
{
  for (std::size_t column = 0; column + 1 < south.Points.size(); ++column)
  {
    if (!isCovered[column])
    {
      continue;
    }
    const vtkIdType a = south.Points[column], b = south.Points[column + 1];
    const vtkIdType c = north.Points[column + 1], d = north.Points[column];
    // Where one corner is void, the diagonal goes past it, so that one triangle is left.
    const bool otherDiagonal = a < 0 || c < 0;
    AddTriangle(triangles, a, b, otherDiagonal ? d : c);
    AddTriangle(triangles, otherDiagonal ? b : a, c, d);
  }
}

// Row by row from the south: two rows are at hand at a time, however far tiles are apart.
class Maker
{
public:
  template <typename Placed>
  Maker(const std::vector<Placed>& tiles, double verticalScale, bool degrees)
    : VerticalScale(verticalScale)
  {
    const vtkMTHeightTile& first = tiles.front().Tile;
    std::int64_t last[2] = { 0, 0 };
    for (const Placed& placed : tiles)
    {
      this->Begin[0] = std::min(this->Begin[0], placed.Column);
      this->Begin[1] = std::min(this->Begin[1], placed.Row);
      last[0] = std::max(last[0], placed.Column + static_cast<std::int64_t>(placed.Tile.Columns) - 1);
      last[1] = std::max(last[1], placed.Row + static_cast<std::int64_t>(placed.Tile.Rows) - 1);
    }
    this->Columns = static_cast<std::size_t>(last[0] - this->Begin[0] + 1);
    this->EndRow = last[1] + 1;
    this->Corner[0] = first.West;
    this->Corner[1] = first.South;
    this->Step[0] = first.StepX;
    this->Step[1] = first.StepY;
    if (first.IsGeographic && !degrees)
    {
      for (int i = 0; i < 2; ++i)
      {
        this->Middle[i] = this->Corner[i] + 0.5 * static_cast<double>(this->Begin[i] + last[i]) * this->Step[i];
      }
      this->Factor[1] = vtkMath::RadiansFromDegrees(1.0) * EarthRadius;
      this->Factor[0] = this->Factor[1] * std::cos(vtkMath::RadiansFromDegrees(this->Middle[1]));
    }
  }

  template <typename Placed>
  void Run(const std::vector<Placed>& tiles, vtkPoints* points, vtkCellArray* triangles)
  {
    GridRow rows[2];
    rows[0].Clear(this->Columns);
    rows[1].Clear(this->Columns);
    for (std::int64_t row = this->Begin[1]; row < this->EndRow; ++row)
    {
      std::swap(rows[0], rows[1]);
      rows[1].Clear(this->Columns);
      std::vector<unsigned char> covered(this->Columns, 0);
      std::vector<unsigned char> squares(this->Columns, 0); // between the row before and this one
      for (const Placed& placed : tiles)
      {
        if (row >= placed.Row && row < placed.Row + static_cast<std::int64_t>(placed.Tile.Rows))
        {
          const auto first = static_cast<std::size_t>(placed.Column - this->Begin[0]);
          this->AddSamples(placed.Tile, static_cast<std::size_t>(row - placed.Row), first, rows[1], covered);
          if (row > placed.Row)
          {
            std::fill_n(squares.begin() + static_cast<std::ptrdiff_t>(first), placed.Tile.Columns - 1, 1);
          }
        }
      }
      this->AddPoints(row, covered, rows[1], points);
      AddSquares(rows[0], rows[1], squares, triangles);
    }
  }

  std::int64_t Voids = 0;
  std::int64_t Disagreeing = 0;

private:
  void AddSamples(const vtkMTHeightTile& tile, std::size_t tileRow, std::size_t firstColumn, GridRow& row,
    std::vector<unsigned char>& covered)
  {
    const float* heights = tile.Heights.data() + tileRow * tile.Columns;
    for (std::size_t i = 0; i < tile.Columns; ++i)
    {
      float& height = row.Heights[firstColumn + i];
      covered[firstColumn + i] = 1;
      if (std::isnan(height))
      {
        height = heights[i];
      }
      else if (!std::isnan(heights[i]) && heights[i] != height)
      {
        ++this->Disagreeing;
      }
    }
  }

  void AddPoints(std::int64_t row, const std::vector<unsigned char>& covered, GridRow& samples, vtkPoints* points)
  {
    const double y = this->Corner[1] + static_cast<double>(row) * this->Step[1];
    for (std::size_t i = 0; i < this->Columns; ++i)
    {
      const bool isVoid = std::isnan(samples.Heights[i]);
      this->Voids += covered[i] && isVoid ? 1 : 0;
      if (!isVoid)
      {
        const double x =
          this->Corner[0] + static_cast<double>(this->Begin[0] + static_cast<std::int64_t>(i)) * this->Step[0];
        samples.Points[i] = points->InsertNextPoint(this->Factor[0] * (x - this->Middle[0]),
          this->Factor[1] * (y - this->Middle[1]), this->VerticalScale * samples.Heights[i]);
      }
    }
  }

  double VerticalScale;
  std::int64_t Begin[2] = { 0, 0 }; // column and row
  std::int64_t EndRow = 0;
  std::size_t Columns = 0;
  double Corner[2];
  double Step[2];
  double Middle[2] = { 0.0, 0.0 };
  double Factor[2] = { 1.0, 1.0 };
};
}

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
    Internals::Placed placed{ {}, 0, 0 };
    vtkMTHeightTile& tile = placed.Tile;
    if (!tile.Read(path, reason))
    {
      error = path + ": " + reason;
      return false;
    }
    if (!this->Implementation->Tiles.empty())
    {
      const vtkMTHeightTile& first = this->Implementation->Tiles.front().Tile;
      const double column = (tile.West - first.West) / first.StepX;
      const double row = (tile.South - first.South) / first.StepY;
      const double drift = std::max(std::abs(tile.StepX / first.StepX - 1.0) * static_cast<double>(tile.Columns),
        std::abs(tile.StepY / first.StepY - 1.0) * static_cast<double>(tile.Rows));
      const bool isOnGrid = std::max(std::abs(column - std::round(column)), std::abs(row - std::round(row))) < Slack &&
        std::max(std::abs(column), std::abs(row)) < Farthest;
      if (tile.IsGeographic != first.IsGeographic || !(drift < Slack) || !isOnGrid)
      {
        error = path + ": its samples do not lie on the grid of " + first.Path +
          "; tiles of one terrain have one spacing and one origin: build them as models of their own, or resample them";
        return false;
      }
      placed.Column = static_cast<std::int64_t>(std::llround(column));
      placed.Row = static_cast<std::int64_t>(std::llround(row));
    }
    this->Implementation->Tiles.push_back(std::move(placed));
    return true;
  }
  catch (const std::exception& exception) // no memory
  {
    error = path + ": " + exception.what();
    return false;
  }
}

bool vtkMTTerrain::Make(vtkPolyData* output, std::string& error)
{
  output->Initialize();
  this->Report.clear();
  if (this->Implementation->Tiles.empty() || !std::isfinite(this->VerticalScale) || this->VerticalScale == 0.0)
  {
    error = this->Implementation->Tiles.empty() ? "the terrain has no tiles"
                                                : "the vertical scale must be a finite number other than 0";
    return false;
  }
  try
  {
    vtkNew<vtkPoints> points;
    points->SetDataType(VTK_DOUBLE);
    vtkNew<vtkCellArray> triangles;
    Maker maker(this->Implementation->Tiles, this->VerticalScale, this->Degrees);
    maker.Run(this->Implementation->Tiles, points, triangles);
    this->Report["terrain_tiles"] = static_cast<std::int64_t>(this->Implementation->Tiles.size());
    this->Report["terrain_voids"] = maker.Voids;
    this->Report["terrain_disagreeing_samples"] = maker.Disagreeing;
    output->SetPoints(points);
    output->SetPolys(triangles);
  }
  catch (const std::exception& exception) // no memory
  {
    error = std::string("the terrain could not be made: ") + exception.what();
    output->Initialize();
    return false;
  }
  if (output->GetNumberOfPolys() == 0)
  {
    error = this->Implementation->Tiles.front().Tile.Path + ": there is not one triangle without a void";
    output->Initialize();
    return false;
  }
  return true;
}
