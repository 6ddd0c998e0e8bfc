// SPDX-License-Identifier: BSD-3-Clause
// GeoTIFF through GDAL, where it was found when this was configured.
#include "vtkMTHeightTile.h"

#ifdef MT_HAS_GDAL

#include "vtkMTGdalLibrary.h"

#include <cmath>
#include <limits>
#include <memory>

namespace
{
using Gdal = vtkMTGdalLibrary;

struct Close
{
  const Gdal& Library;
  void operator()(void* dataset) const { this->Library.GDALClose(dataset); }
};

// Errors are taken from GDAL, which then prints none.
class Quiet
{
public:
  explicit Quiet(const Gdal& gdal)
    : Library(gdal)
  {
    this->Library.CPLPushErrorHandler(this->Library.CPLQuietErrorHandler);
    this->Library.CPLErrorReset();
  }
  ~Quiet() { this->Library.CPLPopErrorHandler(); }
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;

private:
  const Gdal& Library;
};

std::string GetMessage(const Gdal& gdal, const char* otherwise)
{
  const std::string message = gdal.CPLGetLastErrorMsg();
  return message.empty() ? otherwise : message;
}

// Degrees, or else metres per unit of the projection; with the name of the system where coordinates stay as they are.
bool FindUnit(const Gdal& gdal, GDALDatasetH dataset, bool& isGeographic, double& unit, std::string& crs)
{
  OGRSpatialReferenceH system = gdal.GDALGetSpatialRef(dataset);
  isGeographic = system && gdal.OSRIsGeographic(system) != 0;
  unit = system && !isGeographic ? gdal.OSRGetLinearUnits(system, nullptr) : 1.0;
  const char* authority = system ? gdal.OSRGetAuthorityName(system, nullptr) : nullptr;
  const char* code = system ? gdal.OSRGetAuthorityCode(system, nullptr) : nullptr;
  char* text = nullptr;
  if (authority && code && unit == 1.0)
  {
    crs = std::string(authority) + ':' + code;
  }
  else if (system && unit == 1.0 && gdal.OSRExportToWkt(system, &text) == OGRERR_NONE && text)
  {
    crs = text;
  }
  gdal.VSIFree(text);
  return unit > 0.0;
}

// Metres per unit of the heights: metres where the file names no other.
double GetHeightUnit(const Gdal& gdal, GDALRasterBandH band)
{
  const std::string unit = gdal.GDALGetRasterUnitType(band);
  const bool isSurvey = unit == "us-ft" || unit == "US survey foot" || unit == "ftUS";
  return isSurvey ? 1200.0 / 3937.0 : unit == "ft" || unit == "foot" || unit == "feet" ? 0.3048 : 1.0;
}

// Reads rows of heights, and which of them are void: by the value for none, and by a mask where the file has one.
class Band
{
public:
  Band(const Gdal& gdal, GDALRasterBandH band, std::size_t columns)
    : Library(gdal)
    , Raster(band)
    , Values(columns)
  {
    int hasNoData = 0;
    const double noData = gdal.GDALGetRasterNoDataValue(band, &hasNoData);
    this->NoData = hasNoData != 0 ? noData : std::numeric_limits<double>::quiet_NaN();
    this->IsSingle = gdal.GDALGetRasterDataType(band) == GDT_Float32;
    int hasScale = 0;
    int hasOffset = 0;
    const double scale = gdal.GDALGetRasterScale(band, &hasScale);
    const double offset = gdal.GDALGetRasterOffset(band, &hasOffset);
    this->Scale = hasScale != 0 ? scale : 1.0;
    this->Offset = hasOffset != 0 ? offset : 0.0;
    this->Unit = GetHeightUnit(gdal, band);
    if ((gdal.GDALGetMaskFlags(band) & (GMF_PER_DATASET | GMF_ALPHA)) != 0)
    {
      this->Mask.resize(columns);
    }
  }

  bool Read(std::size_t row)
  {
    const Gdal& gdal = this->Library;
    const int columns = static_cast<int>(this->Values.size());
    return gdal.GDALRasterIO(this->Raster, GF_Read, 0, static_cast<int>(row), columns, 1, this->Values.data(), columns,
             1, GDT_Float64, 0, 0) == CE_None &&
      (this->Mask.empty() ||
        gdal.GDALRasterIO(gdal.GDALGetMaskBand(this->Raster), GF_Read, 0, static_cast<int>(row), columns, 1,
          this->Mask.data(), columns, 1, GDT_Byte, 0, 0) == CE_None);
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
  const Gdal& Library;
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
bool ReadHeights(const Gdal& gdal, GDALRasterBandH raster, bool isFromEast, bool isFromSouth, vtkMTHeightTile& tile,
  std::string& error)
{
  Band band(gdal, raster, tile.Columns);
  for (std::size_t r = 0; r < tile.Rows; ++r)
  {
    if (!band.Read(r))
    {
      error = GetMessage(gdal, "its samples cannot be read");
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
  const Gdal* const library = Gdal::Get(error);
  if (!library)
  {
    return false;
  }
  const Gdal& gdal = *library;
  const Quiet quiet(gdal);
  const std::unique_ptr<void, Close> dataset(gdal.GDALOpen(this->Path.c_str(), GA_ReadOnly), Close{ gdal });
  double transform[6];
  if (!dataset || gdal.GDALGetRasterCount(dataset.get()) < 1)
  {
    error = GetMessage(gdal, "is no GeoTIFF");
    return false;
  }
  if (gdal.GDALGetGeoTransform(dataset.get(), transform) != CE_None || transform[2] != 0.0 || transform[4] != 0.0 ||
    transform[1] == 0.0 || transform[5] == 0.0)
  {
    error = "has no place on the Earth, or rows that do not run along a parallel; warp it first (gdalwarp)";
    return false;
  }
  double unit = 1.0;
  this->Columns = static_cast<std::size_t>(gdal.GDALGetRasterXSize(dataset.get()));
  this->Rows = static_cast<std::size_t>(gdal.GDALGetRasterYSize(dataset.get()));
  if (this->Columns < 2 || this->Rows < 2 || !FindUnit(gdal, dataset.get(), this->IsGeographic, unit, this->Crs))
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
  return ReadHeights(gdal, gdal.GDALGetRasterBand(dataset.get(), 1), isFromEast, isFromSouth, *this, error);
}

#else

bool vtkMTHeightTile::ReadGdal(std::string& error)
{
  error = "is no tile that this build reads (it was built without GDAL); 'gdal_translate -of SRTMHGT' makes an .hgt";
  return false;
}

#endif
