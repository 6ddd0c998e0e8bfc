// SPDX-License-Identifier: BSD-3-Clause
// GeoTIFF through GDAL, where it was found when this was configured.
#include "vtkMTHeightTile.h"

#ifdef MT_HAS_GDAL

#include <cpl_conv.h>
#include <cpl_error.h>
#include <gdal.h>
#include <gdal_frmts.h>
#include <ogr_srs_api.h>

#include <cmath>
#include <limits>
#include <memory>

namespace
{
struct Close
{
  void operator()(void* dataset) const { GDALClose(dataset); }
};

std::string GetMessage(const char* otherwise)
{
  const std::string message = CPLGetLastErrorMsg();
  return message.empty() ? otherwise : message;
}

// Degrees, or else metres per unit of the projection.
bool FindUnit(GDALDatasetH dataset, bool& isGeographic, double& unit)
{
  OGRSpatialReferenceH system = GDALGetSpatialRef(dataset);
  isGeographic = system && OSRIsGeographic(system) != 0;
  unit = system && !isGeographic ? OSRGetLinearUnits(system, nullptr) : 1.0;
  return unit > 0.0;
}

bool ReadBand(GDALRasterBandH band, vtkMTHeightTile& tile, std::string& error)
{
  constexpr float none = std::numeric_limits<float>::quiet_NaN();
  int hasNoData = 0;
  const double noData = GDALGetRasterNoDataValue(band, &hasNoData);
  int hasScale = 0;
  int hasOffset = 0;
  const double scale = GDALGetRasterScale(band, &hasScale);
  const double offset = GDALGetRasterOffset(band, &hasOffset);
  std::vector<double> row(tile.Columns);
  const int columns = static_cast<int>(tile.Columns);
  for (std::size_t r = 0; r < tile.Rows; ++r)
  {
    if (GDALRasterIO(band, GF_Read, 0, static_cast<int>(r), columns, 1, row.data(), columns, 1, GDT_Float64, 0, 0) !=
      CE_None)
    {
      error = GetMessage("its samples cannot be read");
      return false;
    }
    float* heights = tile.Heights.data() + (tile.Rows - 1 - r) * tile.Columns;
    for (std::size_t c = 0; c < tile.Columns; ++c)
    {
      const bool isVoid = !std::isfinite(row[c]) || (hasNoData != 0 && row[c] == noData);
      const double height = row[c] * (hasScale != 0 ? scale : 1.0) + (hasOffset != 0 ? offset : 0.0);
      heights[c] = isVoid ? none : static_cast<float>(height);
    }
  }
  return true;
}
}

bool vtkMTHeightTile::ReadGdal(std::string& error)
{
  static const bool registered = [] { return GDALRegister_GTiff(), true; }();
  static_cast<void>(registered);
  CPLPushErrorHandler(CPLQuietErrorHandler);
  const std::unique_ptr<void, void (*)(void*)> handler(this, [](void*) { CPLPopErrorHandler(); });
  CPLErrorReset();
  const std::unique_ptr<void, Close> dataset(GDALOpen(this->Path.c_str(), GA_ReadOnly));
  double transform[6];
  if (!dataset || GDALGetRasterCount(dataset.get()) < 1)
  {
    error = GetMessage("is no GeoTIFF");
    return false;
  }
  if (GDALGetGeoTransform(dataset.get(), transform) != CE_None || transform[2] != 0.0 || transform[4] != 0.0 ||
    !(transform[1] > 0.0) || !(transform[5] < 0.0))
  {
    error = "has no place on the Earth, or rows that do not run from west to east; warp it first (gdalwarp)";
    return false;
  }
  double unit = 1.0;
  this->Columns = static_cast<std::size_t>(GDALGetRasterXSize(dataset.get()));
  this->Rows = static_cast<std::size_t>(GDALGetRasterYSize(dataset.get()));
  if (this->Columns < 2 || this->Rows < 2 || !FindUnit(dataset.get(), this->IsGeographic, unit))
  {
    error = "is smaller than 2 x 2 samples, or its unit is unknown";
    return false;
  }
  // The transform is that of pixels' corners; samples are at their centres.
  this->StepX = transform[1] * unit;
  this->StepY = -transform[5] * unit;
  this->West = transform[0] * unit + 0.5 * this->StepX;
  this->South = transform[3] * unit - (static_cast<double>(this->Rows) - 0.5) * this->StepY;
  this->Heights.resize(this->Columns * this->Rows);
  return ReadBand(GDALGetRasterBand(dataset.get(), 1), *this, error);
}

#else

bool vtkMTHeightTile::ReadGdal(std::string& error)
{
  error = "is no tile that this build reads (it was built without GDAL); 'gdal_translate -of SRTMHGT' makes an .hgt";
  return false;
}

#endif
