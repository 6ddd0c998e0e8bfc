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

// Degrees, or else metres per unit of the projection; with the name of the system where coordinates stay as they are.
bool FindUnit(GDALDatasetH dataset, bool& isGeographic, double& unit, std::string& crs)
{
  OGRSpatialReferenceH system = GDALGetSpatialRef(dataset);
  isGeographic = system && OSRIsGeographic(system) != 0;
  unit = system && !isGeographic ? OSRGetLinearUnits(system, nullptr) : 1.0;
  const char* authority = system ? OSRGetAuthorityName(system, nullptr) : nullptr;
  const char* code = system ? OSRGetAuthorityCode(system, nullptr) : nullptr;
  char* text = nullptr;
  if (authority && code && unit == 1.0)
  {
    crs = std::string(authority) + ':' + code;
  }
  else if (system && unit == 1.0 && OSRExportToWkt(system, &text) == OGRERR_NONE && text)
  {
    crs = text;
  }
  CPLFree(text);
  return unit > 0.0;
}

// Metres per unit of the heights: metres where the file names no other.
double GetHeightUnit(GDALRasterBandH band)
{
  const std::string unit = GDALGetRasterUnitType(band);
  const bool isSurvey = unit == "us-ft" || unit == "US survey foot" || unit == "ftUS";
  return isSurvey ? 1200.0 / 3937.0 : unit == "ft" || unit == "foot" || unit == "feet" ? 0.3048 : 1.0;
}

// Reads rows of heights, and which of them are void: by the value for none, and by a mask where the file has one.
class Band
{
public:
  explicit Band(GDALRasterBandH band, std::size_t columns)
    : Raster(band)
    , Values(columns)
  {
    int hasNoData = 0;
    const double noData = GDALGetRasterNoDataValue(band, &hasNoData);
    this->NoData = hasNoData != 0 ? noData : std::numeric_limits<double>::quiet_NaN();
    this->IsSingle = GDALGetRasterDataType(band) == GDT_Float32;
    int hasScale = 0;
    int hasOffset = 0;
    const double scale = GDALGetRasterScale(band, &hasScale);
    const double offset = GDALGetRasterOffset(band, &hasOffset);
    this->Scale = hasScale != 0 ? scale : 1.0;
    this->Offset = hasOffset != 0 ? offset : 0.0;
    this->Unit = GetHeightUnit(band);
    if ((GDALGetMaskFlags(band) & (GMF_PER_DATASET | GMF_ALPHA)) != 0)
    {
      this->Mask.resize(columns);
    }
  }

  bool Read(std::size_t row)
  {
    const int columns = static_cast<int>(this->Values.size());
    return GDALRasterIO(this->Raster, GF_Read, 0, static_cast<int>(row), columns, 1, this->Values.data(), columns, 1,
             GDT_Float64, 0, 0) == CE_None &&
      (this->Mask.empty() ||
        GDALRasterIO(GDALGetMaskBand(this->Raster), GF_Read, 0, static_cast<int>(row), columns, 1, this->Mask.data(),
          columns, 1, GDT_Byte, 0, 0) == CE_None);
  }

  float Get(std::size_t column) const
  {
    const double value = this->Values[column];
    // The value for none is text in the file: of single precision it need not be one of its doubles.
    const bool isNone =
      value == this->NoData || (this->IsSingle && static_cast<float>(value) == static_cast<float>(this->NoData));
    const bool isMasked = !this->Mask.empty() && this->Mask[column] == 0;
    return isNone || isMasked || !std::isfinite(value)
      ? std::numeric_limits<float>::quiet_NaN()
      : static_cast<float>((value * this->Scale + this->Offset) * this->Unit);
  }

private:
  GDALRasterBandH Raster;
  std::vector<double> Values;
  std::vector<unsigned char> Mask;
  double NoData;
  double Scale;
  double Offset;
  double Unit;
  bool IsSingle;
};

// Rows from the south, columns from the west, whatever the file's order.
bool ReadHeights(GDALRasterBandH raster, bool isFromEast, bool isFromSouth, vtkMTHeightTile& tile, std::string& error)
{
  Band band(raster, tile.Columns);
  for (std::size_t r = 0; r < tile.Rows; ++r)
  {
    if (!band.Read(r))
    {
      error = GetMessage("its samples cannot be read");
      return false;
    }
    float* heights = tile.Heights.data() + (isFromSouth ? r : tile.Rows - 1 - r) * tile.Columns;
    for (std::size_t c = 0; c < tile.Columns; ++c)
    {
      heights[isFromEast ? tile.Columns - 1 - c : c] = band.Get(c);
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
    transform[1] == 0.0 || transform[5] == 0.0)
  {
    error = "has no place on the Earth, or rows that do not run along a parallel; warp it first (gdalwarp)";
    return false;
  }
  double unit = 1.0;
  this->Columns = static_cast<std::size_t>(GDALGetRasterXSize(dataset.get()));
  this->Rows = static_cast<std::size_t>(GDALGetRasterYSize(dataset.get()));
  if (this->Columns < 2 || this->Rows < 2 || !FindUnit(dataset.get(), this->IsGeographic, unit, this->Crs))
  {
    error = "is smaller than 2 x 2 samples, or its unit is unknown";
    return false;
  }
  // The transform is that of pixels' corners, also where the file gives points (GDAL moves these by half a pixel);
  // samples are at the centres.
  const bool isFromEast = transform[1] < 0.0;
  const bool isFromSouth = transform[5] > 0.0;
  this->StepX = std::abs(transform[1]) * unit;
  this->StepY = std::abs(transform[5]) * unit;
  this->West = transform[0] * unit + (isFromEast ? 0.5 - static_cast<double>(this->Columns) : 0.5) * this->StepX;
  this->South = transform[3] * unit + (isFromSouth ? 0.5 : 0.5 - static_cast<double>(this->Rows)) * this->StepY;
  this->Heights.resize(this->Columns * this->Rows);
  return ReadHeights(GDALGetRasterBand(dataset.get(), 1), isFromEast, isFromSouth, *this, error);
}

#else

bool vtkMTHeightTile::ReadGdal(std::string& error)
{
  error = "is no tile that this build reads (it was built without GDAL); 'gdal_translate -of SRTMHGT' makes an .hgt";
  return false;
}

#endif
