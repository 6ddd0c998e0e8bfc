// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTVerifyTerrainReaders.h"

#include "vtkMTVerifyTerrainTile.h"
#include "vtkMTVerifyVolumeBytes.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

using namespace vtkMTVerifyVolumeBytes;

namespace
{
constexpr std::size_t RecordSize = 1024;
/// Of a profile's values in its first record and in those that follow; each has six letters.
constexpr std::size_t ValueSize = 6, FirstValue = 144, FirstCount = 146, NextCount = 170;

struct Profile
{
  double X = 0.0;
  double Y = 0.0; ///< of the southernmost value
  std::vector<double> Heights;
};

struct Header
{
  int Reference = 0; ///< 0: geographic
  int GroundUnits = 0;
  int HeightUnits = 0;
  double Resolution[3] = { 0.0, 0.0, 0.0 };
  std::int64_t Profiles = 0;
};

/// A number of fixed columns; Fortran writes exponents with D.
double GetField(const Bytes& bytes, std::size_t at, std::size_t size)
{
  std::string text(
    bytes.begin() + static_cast<std::ptrdiff_t>(at), bytes.begin() + static_cast<std::ptrdiff_t>(at + size));
  std::replace(text.begin(), text.end(), 'D', 'E');
  return std::atof(text.c_str());
}

bool ParseHeader(const Bytes& bytes, Header& header, vtkMTVerifyTerrainTile& tile, std::string& error)
{
  if (bytes.size() < 2 * RecordSize)
  {
    error = "it has no header and profile of 1024 bytes";
    return false;
  }
  header.Reference = static_cast<int>(GetField(bytes, 156, 6));
  header.GroundUnits = static_cast<int>(GetField(bytes, 528, 6));
  header.HeightUnits = static_cast<int>(GetField(bytes, 534, 6));
  for (std::size_t i = 0; i < 3; ++i)
  {
    header.Resolution[i] = GetField(bytes, 816 + 12 * i, 12);
  }
  header.Profiles = static_cast<std::int64_t>(GetField(bytes, 858, 6));
  if (!(header.Resolution[0] > 0 && header.Resolution[1] > 0 && header.Resolution[2] > 0 && header.Profiles > 0))
  {
    error = "its header has no resolution or no profiles";
    return false;
  }
  tile.IsGeographic = header.Reference == 0;
  if (tile.IsGeographic && header.GroundUnits != 0 && header.GroundUnits != 3)
  {
    return tile.Refuse("A geographic DEM in units " + std::to_string(header.GroundUnits), error);
  }
  if (header.HeightUnits == 1)
  {
    tile.Notes.emplace_back("Heights are in feet, and are kept so.");
  }
  return true;
}

bool ParseProfile(const Bytes& bytes, const Header& header, std::size_t& at, Profile& profile, std::string& error)
{
  const double count = at + RecordSize <= bytes.size() ? GetField(bytes, at + 12, 6) : 0.0;
  if (!(count >= 1.0 && count * ValueSize <= static_cast<double>(bytes.size())))
  {
    error = "a profile is damaged or missing";
    return false;
  }
  const auto values = static_cast<std::size_t>(count);
  profile.X = GetField(bytes, at + 24, 24);
  profile.Y = GetField(bytes, at + 48, 24);
  const double datum = GetField(bytes, at + 72, 24);
  for (std::size_t i = 0, left = FirstCount, place = at + FirstValue; i < values; ++i, --left, place += ValueSize)
  {
    if (left == 0)
    {
      at += RecordSize;
      place = at;
      left = NextCount;
    }
    if (place + ValueSize > bytes.size())
    {
      error = "its last profile ends early";
      return false;
    }
    const double value = GetField(bytes, place, ValueSize);
    profile.Heights.push_back(
      value <= -32767 ? std::numeric_limits<double>::quiet_NaN() : datum + header.Resolution[2] * value);
  }
  at += RecordSize;
  return true;
}

/// Enters the profiles as columns of one grid, whose first row is the northernmost.
bool Enter(const std::vector<Profile>& profiles, const Header& header, vtkMTVerifyTerrainTile& tile, std::string& error)
{
  const double dx = header.Resolution[0];
  const double dy = header.Resolution[1];
  double west = profiles.front().X, south = profiles.front().Y, east = west, north = south;
  for (const Profile& profile : profiles)
  {
    west = std::min(west, profile.X);
    east = std::max(east, profile.X);
    south = std::min(south, profile.Y);
    north = std::max(north, profile.Y + dy * static_cast<double>(profile.Heights.size() - 1));
  }
  const double columns = std::round((east - west) / dx) + 1;
  const double rows = std::round((north - south) / dy) + 1;
  if (!(columns * rows < 1e9))
  {
    error = "its profiles are too far from each other";
    return false;
  }
  tile.Columns = static_cast<std::int64_t>(columns);
  tile.Rows = static_cast<std::int64_t>(rows);
  tile.Heights.assign(static_cast<std::size_t>(columns * rows), std::numeric_limits<double>::quiet_NaN());
  for (const Profile& profile : profiles)
  {
    const std::int64_t column = std::llround((profile.X - west) / dx);
    const std::int64_t first = tile.Rows - 1 - std::llround((profile.Y - south) / dy);
    for (std::size_t i = 0; i < profile.Heights.size(); ++i)
    {
      const std::int64_t row = first - static_cast<std::int64_t>(i);
      tile.Heights[static_cast<std::size_t>(row * tile.Columns + column)] = profile.Heights[i];
    }
  }
  const double unit = !tile.IsGeographic ? 1.0 : header.GroundUnits == 3 ? 1.0 / 3600.0 : 180.0 / vtkMath::Pi();
  tile.Origin = { unit * west, unit * (south + dy * (rows - 1)) };
  tile.ColumnStep = { unit * dx, 0.0 };
  tile.RowStep = { 0.0, -unit * dy };
  return true;
}
}

bool vtkMTVerifyTerrainReaders::ReadDem(const std::string& path, vtkMTVerifyTerrainTile& tile, std::string& error)
{
  tile.Reader = "the checker's USGS DEM reader";
  Bytes bytes;
  Header header;
  if (!ReadInflated(path, NoLimit, bytes, error) || !ParseHeader(bytes, header, tile, error))
  {
    return false;
  }
  std::vector<Profile> profiles;
  std::size_t at = RecordSize;
  for (std::int64_t i = 0; i < header.Profiles; ++i)
  {
    profiles.emplace_back();
    if (!ParseProfile(bytes, header, at, profiles.back(), error))
    {
      return false;
    }
  }
  return Enter(profiles, header, tile, error);
}
