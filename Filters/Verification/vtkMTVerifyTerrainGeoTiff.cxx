// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTVerifyTerrainReaders.h"

#include "vtkMTVerifyTerrainTiff.h"
#include "vtkMTVerifyTerrainTiffSamples.h"
#include "vtkMTVerifyTerrainTile.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>

namespace
{
constexpr int ModelPixelScale = 33550, ModelTiepoint = 33922, ModelTransformation = 34264, GeoKeyDirectory = 34735,
              GdalMetadata = 42112, GdalNoData = 42113;
constexpr int ModelType = 1024, RasterType = 1025, GeographicType = 2048, AngularUnits = 2054, ProjectedType = 3072;

/// The keys whose value is in the directory itself.
std::map<int, int> GetKeys(const vtkMTVerifyTerrainTiff& tiff)
{
  std::map<int, int> keys;
  const std::vector<double> words = tiff.GetNumbers(GeoKeyDirectory);
  for (std::size_t i = 4; i + 3 < words.size() && i / 4 <= words[3]; i += 4)
  {
    if (words[i + 1] == 0.0)
    {
      keys.emplace(static_cast<int>(words[i]), static_cast<int>(words[i + 3]));
    }
  }
  return keys;
}

bool FindFrame(std::map<int, int>& keys, vtkMTVerifyTerrainTile& tile, std::string& error)
{
  const int model = keys[ModelType];
  tile.IsGeographic = model == 2 || (model == 0 && keys.count(GeographicType) && !keys.count(ProjectedType));
  if (model > 2)
  {
    return tile.Refuse("GeoTIFF's model type " + std::to_string(model), error);
  }
  const int units = keys[AngularUnits];
  if (tile.IsGeographic && units != 0 && units != 9102)
  {
    return tile.Refuse("GeoTIFF in angular units " + std::to_string(units) + ", not degrees,", error);
  }
  return true;
}

/// From raster coordinates to the model's: x = m[0] i + m[1] j + m[2], y = m[3] i + m[4] j + m[5].
bool FindMap(const vtkMTVerifyTerrainTiff& tiff, double (&m)[6], vtkMTVerifyTerrainTile& tile, std::string& error)
{
  const std::vector<double> matrix = tiff.GetNumbers(ModelTransformation);
  const std::vector<double> scale = tiff.GetNumbers(ModelPixelScale);
  const std::vector<double> tie = tiff.GetNumbers(ModelTiepoint);
  if (matrix.size() >= 16)
  {
    const double values[6] = { matrix[0], matrix[1], matrix[3], matrix[4], matrix[5], matrix[7] };
    std::copy_n(values, 6, m);
  }
  else if (scale.size() >= 2 && tie.size() >= 6)
  {
    const double values[6] = { scale[0], 0.0, tie[3] - tie[0] * scale[0], 0.0, -scale[1], tie[4] + tie[1] * scale[1] };
    std::copy_n(values, 6, m);
  }
  else
  {
    return tile.Refuse("TIFF without GeoTIFF's tags for the place of its samples", error);
  }
  const double determinant = m[0] * m[4] - m[1] * m[3];
  if (!(std::isfinite(determinant) && determinant != 0.0 && std::isfinite(m[2]) && std::isfinite(m[5])))
  {
    error = "its map from pixels to the ground has no inverse";
    return false;
  }
  return true;
}

void VoidNoData(const vtkMTVerifyTerrainTiff& tiff, vtkMTVerifyTerrainTile& tile)
{
  const std::string text = tiff.GetText(GdalNoData);
  char* end = nullptr;
  const double noData = std::strtod(text.c_str(), &end);
  const bool isSingle = tiff.GetNumber(339, 1) == 3 && tiff.GetNumber(258, 1) == 32;
  for (double& height : tile.Heights)
  {
    // The text may have more digits than a sample of single precision holds.
    const bool isNoData = end != text.c_str() &&
      (height == noData || (isSingle && static_cast<float>(height) == static_cast<float>(noData)));
    height = isNoData || !std::isfinite(height) ? std::numeric_limits<double>::quiet_NaN() : height;
  }
}
}

bool vtkMTVerifyTerrainReaders::ReadGeoTiff(const std::string& path, vtkMTVerifyTerrainTile& tile, std::string& error)
{
  tile.Reader = "the checker's GeoTIFF reader";
  vtkMTVerifyTerrainTiff tiff;
  if (!tiff.Open(path, error))
  {
    return false;
  }
  std::map<int, int> keys = GetKeys(tiff);
  double m[6];
  if (!FindFrame(keys, tile, error) || !FindMap(tiff, m, tile, error) ||
    !vtkMTVerifyTerrainTiffSamples(tiff, tile).Read(error))
  {
    return false;
  }
  const double half = keys[RasterType] == 2 ? 0.0 : 0.5;
  tile.Origin = { (m[0] + m[1]) * half + m[2], (m[3] + m[4]) * half + m[5] };
  tile.ColumnStep = { m[0], m[3] };
  tile.RowStep = { m[1], m[4] };
  VoidNoData(tiff, tile);
  if (tiff.GetText(GdalMetadata).find("role=\"scale\"") != std::string::npos)
  {
    tile.Notes.emplace_back("GDAL's scale and offset of values are ignored.");
  }
  return true;
}
