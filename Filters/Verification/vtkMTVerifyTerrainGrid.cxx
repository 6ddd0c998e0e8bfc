// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTVerifyTerrainGrid.h"

#include "vtkCellArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
constexpr double EarthRadius = 6371008.8;
/// How far, in steps, a sample may be off the grid.
constexpr double Tolerance = 0.02;
/// Of the grid: in all, and as many times as many as the tiles have.
constexpr std::int64_t MostSamples = std::int64_t(1) << 29;
constexpr std::int64_t MostEmpty = 64;
const double NaN = std::numeric_limits<double>::quiet_NaN();

double GetArea(const std::array<double, 3>& a, const std::array<double, 3>& b, const std::array<double, 3>& c)
{
  double u[3], v[3], n[3];
  vtkMath::Subtract(b.data(), a.data(), u);
  vtkMath::Subtract(c.data(), a.data(), v);
  vtkMath::Cross(u, v, n);
  return 0.5 * vtkMath::Norm(n);
}
}

vtkMTVerifyTerrainGrid::vtkMTVerifyTerrainGrid(
  const vtkMTVerifyTerrainInput::Options& options, vtkMTVerifyTerrainInput::Facts& facts)
  : Options(options)
  , Facts(facts)
{
}

bool vtkMTVerifyTerrainGrid::FindOffset(const vtkMTVerifyTerrainTile& tile, std::array<std::int64_t, 2>& offset) const
{
  const auto& u = this->Base.ColumnStep;
  const auto& v = this->Base.RowStep;
  const double determinant = u[0] * v[1] - u[1] * v[0];
  // In steps of the first tile: where the tile begins, and what becomes of its own steps over its whole width.
  const auto toSteps = [&](double x, double y, double(&steps)[2])
  {
    steps[0] = (x * v[1] - y * v[0]) / determinant;
    steps[1] = (y * u[0] - x * u[1]) / determinant;
  };
  double begin[2], across[2], down[2];
  toSteps(tile.Origin[0] - this->Base.Origin[0], tile.Origin[1] - this->Base.Origin[1], begin);
  toSteps(tile.ColumnStep[0], tile.ColumnStep[1], across);
  toSteps(tile.RowStep[0], tile.RowStep[1], down);
  const auto columns = static_cast<double>(tile.Columns - 1);
  const auto rows = static_cast<double>(tile.Rows - 1);
  const double errors[] = { begin[0] - std::round(begin[0]), begin[1] - std::round(begin[1]), (across[0] - 1) * columns,
    across[1] * columns, down[0] * rows, (down[1] - 1) * rows };
  const bool isOnGrid =
    std::all_of(std::begin(errors), std::end(errors), [](double error) { return std::abs(error) <= Tolerance; });
  if (!isOnGrid || tile.IsGeographic != this->Base.IsGeographic || std::abs(begin[0]) > 1e15 ||
    std::abs(begin[1]) > 1e15)
  {
    return false;
  }
  offset = { std::llround(begin[0]), std::llround(begin[1]) };
  return true;
}

bool vtkMTVerifyTerrainGrid::SetLayout(const std::vector<vtkMTVerifyTerrainTile>& tiles, std::string& error)
{
  this->Base = tiles.front();
  std::vector<double>().swap(this->Base.Heights);
  std::array<std::int64_t, 2> first{ { 0, 0 } }, last{ { 0, 0 } };
  std::int64_t samples = 0;
  for (std::size_t i = 0; i < tiles.size(); ++i)
  {
    this->Offsets.emplace_back();
    if (!this->FindOffset(tiles[i], this->Offsets.back()))
    {
      this->Facts.IsUnsupported = true;
      error = tiles[i].Path + ": it is not on the grid of the first tile, and the checker joins no other";
      return false;
    }
    first[0] = std::min(first[0], this->Offsets[i][0]);
    first[1] = std::min(first[1], this->Offsets[i][1]);
    last[0] = std::max(last[0], this->Offsets[i][0] + tiles[i].Columns);
    last[1] = std::max(last[1], this->Offsets[i][1] + tiles[i].Rows);
    samples += tiles[i].Columns * tiles[i].Rows;
  }
  this->Facts.Dimensions = { last[0] - first[0], last[1] - first[1] };
  if (this->Facts.Dimensions[0] > MostSamples / this->Facts.Dimensions[1] ||
    this->Facts.Dimensions[0] * this->Facts.Dimensions[1] > MostEmpty * samples)
  {
    this->Facts.IsUnsupported = true;
    error = tiles.front().Path + ": the tiles are too far apart for the checker, which has one grid for all";
    return false;
  }
  for (auto& offset : this->Offsets)
  {
    offset = { offset[0] - first[0], offset[1] - first[1] };
  }
  for (std::size_t i = 0; i < 2; ++i)
  {
    this->Base.Origin[i] +=
      static_cast<double>(first[0]) * this->Base.ColumnStep[i] + static_cast<double>(first[1]) * this->Base.RowStep[i];
  }
  const auto places = static_cast<std::size_t>(this->Facts.Dimensions[0] * this->Facts.Dimensions[1]);
  this->Heights.assign(places, NaN);
  this->IsInTile.assign(places, 0);
  this->SetMap();
  return true;
}

void vtkMTVerifyTerrainGrid::SetMap()
{
  const vtkMTVerifyTerrainTile& base = this->Base;
  const auto columns = static_cast<double>(this->Facts.Dimensions[0] - 1);
  const auto rows = static_cast<double>(this->Facts.Dimensions[1] - 1);
  double scale[2] = { 1.0, 1.0 };
  double zero[2] = { 0.0, 0.0 };
  this->Facts.IsGeographic = base.IsGeographic;
  for (std::size_t i = 0; i < 2; ++i)
  {
    this->Facts.Middle[i] = base.Origin[i] + 0.5 * (columns * base.ColumnStep[i] + rows * base.RowStep[i]);
  }
  if (base.IsGeographic && !this->Options.Degrees)
  {
    scale[1] = EarthRadius * vtkMath::Pi() / 180.0;
    scale[0] = scale[1] * std::cos(this->Facts.Middle[1] * vtkMath::Pi() / 180.0);
    std::copy(this->Facts.Middle.begin(), this->Facts.Middle.end(), zero);
  }
  auto& map = this->Facts.IndexToWorld;
  for (std::size_t i = 0; i < 2; ++i)
  {
    map[4 * i] = scale[i] * base.ColumnStep[i];
    map[4 * i + 1] = scale[i] * base.RowStep[i];
    map[4 * i + 3] = scale[i] * (base.Origin[i] - zero[i]);
  }
  map[10] = this->Options.VerticalScale;
  this->IsMirrored = map[0] * map[5] - map[1] * map[4] < 0.0;
}

void vtkMTVerifyTerrainGrid::Enter(std::size_t number, const vtkMTVerifyTerrainTile& tile)
{
  for (std::int64_t row = 0; row < tile.Rows; ++row)
  {
    for (std::int64_t column = 0; column < tile.Columns; ++column)
    {
      const double height = tile.Heights[static_cast<std::size_t>(row * tile.Columns + column)];
      const auto at = static_cast<std::size_t>(
        (this->Offsets[number][1] + row) * this->Facts.Dimensions[0] + this->Offsets[number][0] + column);
      double& there = this->Heights[at];
      this->Facts.SharedSamples += this->IsInTile[at];
      this->Facts.DisagreeingSamples += !std::isnan(there) && !std::isnan(height) && there != height ? 1 : 0;
      there = std::isnan(there) ? height : there;
      this->IsInTile[at] = 1;
    }
  }
}

vtkMTVerifyTerrainGrid::Place vtkMTVerifyTerrainGrid::GetPlace(std::int64_t column, std::int64_t row) const
{
  const auto& map = this->Facts.IndexToWorld;
  const auto i = static_cast<double>(column);
  const auto j = static_cast<double>(row);
  return { map[0] * i + map[1] * j + map[3], map[4] * i + map[5] * j + map[7], map[10] * this->GetHeight(column, row) };
}

double vtkMTVerifyTerrainGrid::GetHeight(std::int64_t column, std::int64_t row) const
{
  return this->Heights[static_cast<std::size_t>(row * this->Facts.Dimensions[0] + column)];
}

vtkIdType vtkMTVerifyTerrainGrid::GetPoint(std::int64_t column, std::int64_t row)
{
  vtkIdType& id = this->Ids[row % 2][static_cast<std::size_t>(column)];
  if (id < 0)
  {
    id = this->Points->InsertNextPoint(this->GetPlace(column, row).data());
  }
  return id;
}

void vtkMTVerifyTerrainGrid::AddTriangle(const std::array<std::int64_t, 2> (&corners)[3])
{
  vtkIdType ids[3];
  for (std::size_t c = 0; c < 3; ++c)
  {
    ids[c] = this->GetPoint(corners[c][0], corners[c][1]);
  }
  this->Triangles->InsertNextCell(3, ids);
}

void vtkMTVerifyTerrainGrid::AddQuad(std::int64_t column, std::int64_t row)
{
  // Counterclockwise from above, beginning at an end of the diagonal from south-west to north-east.
  using Corner = std::array<std::int64_t, 2>;
  const std::int64_t right = column + 1;
  const std::int64_t down = row + 1;
  const Corner mirrored[4] = { { column, down }, { right, down }, { right, row }, { column, row } };
  const Corner straight[4] = { { column, row }, { right, row }, { right, down }, { column, down } };
  const auto& corners = this->IsMirrored ? mirrored : straight;
  Corner there[4];
  Place places[4];
  std::size_t count = 0;
  for (const Corner& corner : corners)
  {
    if (!std::isnan(this->GetHeight(corner[0], corner[1])))
    {
      there[count] = corner;
      places[count++] = this->GetPlace(corner[0], corner[1]);
    }
  }
  if (count < 3)
  {
    return;
  }
  this->AddTriangle({ there[0], there[1], there[2] });
  double areas[2] = { GetArea(places[0], places[1], places[2]), 0.0 };
  if (count == 4)
  {
    this->AddTriangle({ there[0], there[2], there[3] });
    areas[0] += GetArea(places[0], places[2], places[3]);
    areas[1] = GetArea(places[0], places[1], places[3]) + GetArea(places[1], places[2], places[3]);
  }
  else
  {
    areas[1] = areas[0];
  }
  this->Facts.AreaRange[0] += std::min(areas[0], areas[1]);
  this->Facts.AreaRange[1] += std::max(areas[0], areas[1]);
}

void vtkMTVerifyTerrainGrid::Triangulate(vtkPolyData* surface)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> triangles;
  points->SetDataTypeToDouble();
  this->Points = points;
  this->Triangles = triangles;
  auto& range = this->Facts.Range;
  range = { std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity() };
  for (std::size_t i = 0; i < this->Heights.size(); ++i)
  {
    const double height = this->Heights[i];
    const bool isThere = !std::isnan(height);
    this->Facts.Samples += isThere ? 1 : 0;
    this->Facts.Voids += this->IsInTile[i] && !isThere ? 1 : 0;
    range[0] = isThere ? std::min(range[0], height) : range[0];
    range[1] = isThere ? std::max(range[1], height) : range[1];
  }
  const auto [columns, rows] = this->Facts.Dimensions;
  this->Ids[0].assign(static_cast<std::size_t>(columns), -1);
  for (std::int64_t row = 0; row + 1 < rows; ++row)
  {
    this->Ids[(row + 1) % 2].assign(static_cast<std::size_t>(columns), -1);
    for (std::int64_t column = 0; column + 1 < columns; ++column)
    {
      this->AddQuad(column, row);
    }
  }
  surface->Initialize();
  surface->SetPoints(points);
  surface->SetPolys(triangles);
}
