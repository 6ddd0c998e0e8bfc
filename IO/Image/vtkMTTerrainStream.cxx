// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTTerrainStream.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace
{
constexpr double EarthRadius = 6371008.8;

// Where the grid's rows and columns are.
struct Frame
{
  Frame(const std::vector<vtkMTTerrainTiles::Placed>& tiles, bool degrees)
  {
    const vtkMTHeightTile& first = tiles.front().Tile;
    std::int64_t last[2] = { 0, 0 };
    for (const vtkMTTerrainTiles::Placed& placed : tiles)
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

  double GetX(std::size_t column) const
  {
    const double x =
      this->Corner[0] + static_cast<double>(this->Begin[0] + static_cast<std::int64_t>(column)) * this->Step[0];
    return this->Factor[0] * (x - this->Middle[0]);
  }
  double GetY(std::int64_t row) const
  {
    const double y = this->Corner[1] + static_cast<double>(row) * this->Step[1];
    return this->Factor[1] * (y - this->Middle[1]);
  }

  std::int64_t Begin[2] = { 0, 0 }; // column and row
  std::int64_t EndRow = 0;
  std::size_t Columns = 0;
  double Corner[2];
  double Step[2];
  double Middle[2] = { 0.0, 0.0 };
  double Factor[2] = { 1.0, 1.0 };
};

// The grid's row, dense between the westernmost and the easternmost column of all tiles.
struct GridRow
{
  std::vector<float> Heights;
  std::vector<std::int64_t> Points;   // -1 where there is a void or no tile
  std::vector<unsigned char> Covered; // 1 where some tile has a sample, void or not

  void Clear(std::size_t columns)
  {
    this->Heights.assign(columns, std::numeric_limits<float>::quiet_NaN());
    this->Points.assign(columns, -1);
    this->Covered.assign(columns, 0);
  }
};

// Counts places of the grid that no tile covers, between two tiles in their row or in their column.
class GapCount
{
public:
  void Add(const std::vector<unsigned char>& covered)
  {
    this->Waiting.resize(covered.size(), -1);
    const auto begin = std::find(covered.begin(), covered.end(), 1);
    const auto end = std::find(covered.rbegin(), covered.rend(), 1).base();
    for (auto at = covered.begin(); at != covered.end(); ++at)
    {
      std::int64_t& waiting = this->Waiting[static_cast<std::size_t>(at - covered.begin())];
      if (*at)
      {
        this->Count += std::max<std::int64_t>(waiting, 0);
        waiting = 0;
      }
      else if (begin < at && at < end)
      {
        ++this->Count;
      }
      else
      {
        waiting += waiting >= 0 ? 1 : 0;
      }
    }
  }

  std::int64_t Count = 0;

private:
  std::vector<std::int64_t> Waiting; // in each column, since its last tile; -1 before the first
};

//------------------------------------------------------------------------------
// Row by row from the south: two rows are in memory at a time, however far tiles are apart.
class Walk
{
public:
  Walk(const vtkMTTerrainTiles& tiles, const Frame& frame)
    : AllTiles(tiles)
    , Grid(frame)
  {
  }

  void Begin()
  {
    this->Row = this->Grid.Begin[1] - 1;
    this->Points = 0;
    this->Voids = 0;
    this->Disagreeing = 0;
    this->South.Clear(this->Grid.Columns);
    this->North.Clear(this->Grid.Columns);
  }
  bool IsAtEnd() const { return this->Row + 1 >= this->Grid.EndRow; }

  bool Advance(std::string& error)
  {
    ++this->Row;
    std::swap(this->South, this->North);
    this->North.Clear(this->Grid.Columns);
    for (const vtkMTTerrainTiles::Placed& placed : this->AllTiles.All)
    {
      if (this->Row >= placed.Row && this->Row < placed.Row + static_cast<std::int64_t>(placed.Tile.Rows) &&
        !this->AddSamples(placed, error))
      {
        return false;
      }
    }
    for (std::size_t i = 0; i < this->Grid.Columns; ++i)
    {
      const bool isVoid = std::isnan(this->North.Heights[i]);
      this->Voids += this->North.Covered[i] && isVoid ? 1 : 0;
      this->North.Points[i] = isVoid ? -1 : this->Points++;
    }
    return true;
  }

  // Between the row before and this one. Where tiles have all four samples of the square, be it one tile or several
  // that meet there: three tiles make no triangle at the place of the fourth.
  template <typename Use>
  void ForEachTriangle(Use&& use) const
  {
    const auto add = [&use](std::int64_t a, std::int64_t b, std::int64_t c)
    {
      if (a >= 0 && b >= 0 && c >= 0)
      {
        use(a, b, c);
      }
    };
    const std::vector<unsigned char>& south = this->South.Covered;
    const std::vector<unsigned char>& north = this->North.Covered;
    for (std::size_t i = 0; i + 1 < this->Grid.Columns; ++i)
    {
      if (south[i] & south[i + 1] & north[i] & north[i + 1])
      {
        const std::int64_t a = this->South.Points[i], b = this->South.Points[i + 1];
        const std::int64_t c = this->North.Points[i + 1], d = this->North.Points[i];
        // Where one corner is void, the diagonal goes past it, so that one triangle is left.
        const bool otherDiagonal = a < 0 || c < 0;
        add(a, b, otherDiagonal ? d : c);
        add(otherDiagonal ? b : a, c, d);
      }
    }
  }

  std::int64_t Row = 0;
  GridRow North; // the row
  std::int64_t Points = 0;
  std::int64_t Voids = 0;
  std::int64_t Disagreeing = 0;

private:
  bool AddSamples(const vtkMTTerrainTiles::Placed& placed, std::string& error)
  {
    const auto first = static_cast<std::size_t>(placed.Column - this->Grid.Begin[0]);
    const auto tileRow = static_cast<std::size_t>(this->Row - placed.Row);
    const float* heights = this->AllTiles.GetRow(placed, tileRow, this->Buffer, error);
    for (std::size_t i = 0; heights && i < placed.Tile.Columns; ++i)
    {
      float& height = this->North.Heights[first + i];
      this->North.Covered[first + i] = 1;
      if (std::isnan(height))
      {
        height = heights[i];
      }
      else if (!std::isnan(heights[i]) && heights[i] != height)
      {
        ++this->Disagreeing;
      }
    }
    return heights != nullptr;
  }

  const vtkMTTerrainTiles& AllTiles;
  const Frame& Grid;
  GridRow South;
  std::vector<float> Buffer;
};

//------------------------------------------------------------------------------
class Stream : public vtkMTTriangleStream
{
public:
  Stream(std::shared_ptr<const vtkMTTerrainTiles> tiles, double verticalScale, bool degrees)
    : AllTiles(std::move(tiles))
    , Grid(this->AllTiles->All, degrees)
    , VerticalScale(verticalScale)
    , PointWalk(*this->AllTiles, this->Grid)
    , TriangleWalk(*this->AllTiles, this->Grid)
  {
  }

  // Walks once over everything, to count.
  bool Open()
  {
    Walk walk(*this->AllTiles, this->Grid);
    GapCount gaps;
    walk.Begin();
    while (!walk.IsAtEnd())
    {
      if (!walk.Advance(this->Error))
      {
        return false;
      }
      walk.ForEachTriangle([this](std::int64_t, std::int64_t, std::int64_t) { ++this->Triangles; });
      gaps.Add(walk.North.Covered);
    }
    this->Points = static_cast<std::uint64_t>(walk.Points);
    this->Report["terrain_tiles"] = static_cast<std::int64_t>(this->AllTiles->All.size());
    this->Report["terrain_voids"] = walk.Voids;
    this->Report["terrain_disagreeing_samples"] = walk.Disagreeing;
    this->Report["terrain_gap_samples"] = gaps.Count;
    return this->Rewind();
  }

  const std::vector<vtkMTArrayInfo>& GetArrays() const override { return this->Arrays; }
  std::uint64_t GetNumberOfPoints() const override { return this->Points; }
  std::uint64_t GetNumberOfTriangles() const override { return this->Triangles; }
  const std::map<std::string, std::int64_t>& GetReport() const override { return this->Report; }

  bool Rewind() override
  {
    this->PointWalk.Begin();
    this->TriangleWalk.Begin();
    this->NextCell = 0;
    return true;
  }

  bool NextPoints(PointBlock& block) override
  {
    block = PointBlock();
    while (block.Points.size() < BlockSize && !this->PointWalk.IsAtEnd())
    {
      if (!this->PointWalk.Advance(this->Error))
      {
        return false;
      }
      const double y = this->Grid.GetY(this->PointWalk.Row);
      for (std::size_t i = 0; i < this->Grid.Columns; ++i)
      {
        if (this->PointWalk.North.Points[i] >= 0)
        {
          block.Points.push_back({ this->Grid.GetX(i), y, this->VerticalScale * this->PointWalk.North.Heights[i] });
        }
      }
    }
    return true;
  }

  bool NextTriangles(TriangleBlock& block) override
  {
    block = TriangleBlock();
    while (block.Triangles.size() < BlockSize && !this->TriangleWalk.IsAtEnd())
    {
      if (!this->TriangleWalk.Advance(this->Error))
      {
        return false;
      }
      this->TriangleWalk.ForEachTriangle(
        [&](std::int64_t a, std::int64_t b, std::int64_t c)
        {
          block.Triangles.push_back(
            { static_cast<std::uint64_t>(a), static_cast<std::uint64_t>(b), static_cast<std::uint64_t>(c) });
          block.CellIds.push_back(this->NextCell++);
        });
    }
    return true;
  }

private:
  static constexpr std::size_t BlockSize = 65536; // at least, while there are so many

  const std::shared_ptr<const vtkMTTerrainTiles> AllTiles;
  const Frame Grid;
  const double VerticalScale;
  const std::vector<vtkMTArrayInfo> Arrays;
  std::map<std::string, std::int64_t> Report;
  std::uint64_t Points = 0;
  std::uint64_t Triangles = 0;
  Walk PointWalk;
  Walk TriangleWalk;
  std::int64_t NextCell = 0;
};
}

const float* vtkMTTerrainTiles::GetRow(
  const Placed& placed, std::size_t row, std::vector<float>& buffer, std::string& error) const
{
  const std::size_t columns = placed.Tile.Columns;
  if (!this->Heights)
  {
    return placed.Tile.Heights.data() + row * columns;
  }
  buffer.resize(columns);
  const std::uint64_t first = placed.FirstByte + row * columns * sizeof(float);
  return this->Heights->Read(first, columns * sizeof(float), buffer.data(), error) ? buffer.data() : nullptr;
}

std::unique_ptr<vtkMTTriangleStream> vtkMTTerrainStream::Open(
  std::shared_ptr<const vtkMTTerrainTiles> tiles, double verticalScale, bool degrees, std::string& error)
{
  auto stream = std::make_unique<Stream>(std::move(tiles), verticalScale, degrees);
  const bool isOpen = stream->Open();
  error = isOpen ? error : stream->GetError();
  return isOpen ? std::move(stream) : nullptr;
}

vtkMTWorldFrame vtkMTTerrainStream::GetFrame(const vtkMTTerrainTiles& tiles, bool degrees)
{
  const vtkMTHeightTile& first = tiles.All.front().Tile;
  if (!first.IsGeographic)
  {
    return { first.Crs, "m" };
  }
  if (degrees)
  {
    return { first.Crs, "degree, degree, m" };
  }
  const Frame frame(tiles.All, degrees);
  std::ostringstream text;
  text.precision(17);
  text << "+proj=eqc +lat_ts=" << frame.Middle[1] << " +lat_0=" << frame.Middle[1] << " +lon_0=" << frame.Middle[0]
       << " +R=" << EarthRadius << " +units=m +no_defs";
  return { text.str(), "m" };
}
