// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTVerifyTerrainReaders.h"

#include "vtkMTVerifyTerrainTile.h"
#include "vtkMTVerifyVolumeBytes.h"

#include <cctype>
#include <cmath>
#include <cstdlib>
#include <limits>

using namespace vtkMTVerifyVolumeBytes;

namespace
{
/// "N45E006": latitude and longitude of the south-west sample.
bool ParseName(const std::string& path, double& longitude, double& latitude)
{
  const std::size_t slash = path.find_last_of("/\\");
  const std::string name = ToLower(path.substr(slash == std::string::npos ? 0 : slash + 1, 7));
  if (name.size() < 7 || (name[0] != 'n' && name[0] != 's') || (name[3] != 'e' && name[3] != 'w'))
  {
    return false;
  }
  for (const std::size_t i : { 1, 2, 4, 5, 6 })
  {
    if (!std::isdigit(static_cast<unsigned char>(name[i])))
    {
      return false;
    }
  }
  latitude = std::atof(name.substr(1, 2).c_str()) * (name[0] == 's' ? -1 : 1);
  longitude = std::atof(name.substr(4, 3).c_str()) * (name[3] == 'w' ? -1 : 1);
  return true;
}
}

bool vtkMTVerifyTerrainReaders::ReadSrtm(const std::string& path, vtkMTVerifyTerrainTile& tile, std::string& error)
{
  tile.Reader = "the checker's SRTM reader";
  double longitude = 0.0;
  double latitude = 0.0;
  Bytes bytes;
  if (!ParseName(path, longitude, latitude))
  {
    error = "its name does not begin with the tile's place, such as N45E006";
    return false;
  }
  if (!ReadInflated(path, NoLimit, bytes, error))
  {
    return false;
  }
  const auto samples = static_cast<std::int64_t>(bytes.size() / 2);
  const auto side = static_cast<std::int64_t>(std::llround(std::sqrt(static_cast<double>(samples))));
  if (side < 2 || side * side * 2 != static_cast<std::int64_t>(bytes.size()))
  {
    return tile.Refuse(
      "An SRTM tile of " + std::to_string(bytes.size()) + " bytes, which are no square of samples,", error);
  }
  tile.Columns = side;
  tile.Rows = side;
  tile.IsGeographic = true;
  const double step = 1.0 / static_cast<double>(side - 1);
  tile.Origin = { longitude, latitude + 1.0 };
  tile.ColumnStep = { step, 0.0 };
  tile.RowStep = { 0.0, -step };
  tile.Heights.reserve(static_cast<std::size_t>(samples));
  for (std::int64_t i = 0; i < samples; ++i)
  {
    const auto height = Get<std::int16_t>(bytes.data() + 2 * i, true);
    tile.Heights.push_back(height == -32768 ? std::numeric_limits<double>::quiet_NaN() : height);
  }
  return true;
}
