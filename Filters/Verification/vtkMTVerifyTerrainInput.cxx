// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTVerifyTerrainInput.h"

#include "vtkMTVerifyTerrainGrid.h"
#include "vtkMTVerifyTerrainReaders.h"
#include "vtkMTVerifyTerrainTile.h"
#include "vtkMTVerifyVolumeBytes.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <iterator>

using vtkMTVerifyVolumeBytes::EndsWith;

namespace
{
bool ReadTile(const std::string& path, vtkMTVerifyTerrainTile& tile, std::string& error)
{
  if (EndsWith(path, ".tif") || EndsWith(path, ".tiff"))
  {
    return vtkMTVerifyTerrainReaders::ReadGeoTiff(path, tile, error);
  }
  if (EndsWith(path, ".hgt") || EndsWith(path, ".hgt.gz"))
  {
    return vtkMTVerifyTerrainReaders::ReadSrtm(path, tile, error);
  }
  return EndsWith(path, ".dem") ? vtkMTVerifyTerrainReaders::ReadDem(path, tile, error)
                                : tile.Refuse("This kind of file", error);
}

/// The file's name once, also where the reason has it.
std::string ToMessage(const std::string& path, const std::string& error)
{
  return error.find(path) == std::string::npos ? path + ": " + error : error;
}

/// What a tile adds to the report: its reader, and notes, each once.
void AddFacts(const vtkMTVerifyTerrainTile& tile, vtkMTVerifyTerrainInput::Facts& facts)
{
  if (facts.Reader.find(tile.Reader) == std::string::npos)
  {
    facts.Reader += (facts.Reader.empty() ? "" : ", ") + tile.Reader;
  }
  for (const std::string& note : tile.Notes)
  {
    if (std::find(facts.Notes.begin(), facts.Notes.end(), note) == facts.Notes.end())
    {
      facts.Notes.push_back(note);
    }
  }
}

bool ReadTiles(const std::vector<std::string>& paths, std::vector<vtkMTVerifyTerrainTile>& tiles,
  vtkMTVerifyTerrainInput::Facts& facts, std::string& error)
{
  for (const std::string& path : paths)
  {
    tiles.emplace_back();
    tiles.back().Path = path;
    const bool isRead = ReadTile(path, tiles.back(), error);
    AddFacts(tiles.back(), facts);
    if (!isRead)
    {
      facts.IsUnsupported = tiles.back().IsUnsupported;
      error = ToMessage(path, error);
      return false;
    }
  }
  return true;
}
}

bool vtkMTVerifyTerrainInput::CanRead(const std::string& path)
{
  const char* const endings[] = { ".tif", ".tiff", ".hgt", ".hgt.gz", ".dem" };
  return std::any_of(
    std::begin(endings), std::end(endings), [&](const char* ending) { return EndsWith(path, ending); });
}

bool vtkMTVerifyTerrainInput::Read(
  const std::vector<std::string>& paths, const Options& options, vtkPolyData* surface, std::string& error)
{
  Facts facts;
  return Read(paths, options, surface, facts, error);
}

bool vtkMTVerifyTerrainInput::Read(
  const std::vector<std::string>& paths, const Options& options, vtkPolyData* surface, Facts& facts, std::string& error)
{
  facts = Facts();
  error.clear();
  if (paths.empty() || !std::isfinite(options.VerticalScale))
  {
    error = paths.empty() ? "there is no tile of terrain" : "the vertical scale is not finite";
    return false;
  }
  try
  {
    std::vector<vtkMTVerifyTerrainTile> tiles;
    vtkMTVerifyTerrainGrid grid(options, facts);
    if (!ReadTiles(paths, tiles, facts, error) || !grid.SetLayout(tiles, error))
    {
      return false;
    }
    for (std::size_t i = 0; i < tiles.size(); ++i)
    {
      grid.Enter(i, tiles[i]);
      std::vector<double>().swap(tiles[i].Heights);
    }
    grid.Triangulate(surface);
    return true;
  }
  catch (const std::exception& exception)
  {
    error = ToMessage(paths.front(), exception.what());
  }
  return false;
}
