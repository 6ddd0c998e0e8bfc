// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTGdalLibrary
 * @brief GDAL, loaded when the first tile needs it
 *
 * GDAL brings along a hundred libraries, which took half of the time that a program of this toolkit needs to start, and
 * few read GeoTIFF. So nothing is linked with it: its functions are looked up by name in the library that was found
 * when this was configured.
 *
 * Threads: Get may be called by several.
 */
#ifndef vtkMTGdalLibrary_h
#define vtkMTGdalLibrary_h

#include "vtkMTIOImageModule.h" // For export macro

#include <gdal.h>

#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_vsi.h>
#include <gdal_frmts.h>
#include <ogr_srs_api.h>

#include <string>

// The functions that are used.
#define MT_GDAL_FUNCTIONS(use)                                                                                         \
  use(CPLErrorReset) use(VSIFree) use(CPLGetLastErrorMsg) use(CPLPopErrorHandler) use(CPLPushErrorHandler)             \
    use(CPLQuietErrorHandler) use(GDALClose) use(GDALGetGeoTransform) use(GDALGetMaskBand) use(GDALGetMaskFlags)       \
      use(GDALGetRasterBand) use(GDALGetRasterCount) use(GDALGetRasterDataType) use(GDALGetRasterNoDataValue)          \
        use(GDALGetRasterOffset) use(GDALGetRasterScale) use(GDALGetRasterUnitType) use(GDALGetRasterXSize)            \
          use(GDALGetRasterYSize) use(GDALGetSpatialRef) use(GDALOpen) use(GDALRasterIO) use(GDALRegister_GTiff)       \
            use(OSRExportToWkt) use(OSRGetAuthorityCode) use(OSRGetAuthorityName) use(OSRGetLinearUnits)               \
              use(OSRIsGeographic)

struct VTKMTIOIMAGE_EXPORT vtkMTGdalLibrary
{
// NOLINTNEXTLINE(bugprone-macro-parentheses): a member's name takes none
#define MT_GDAL_DECLARE(function) decltype(&::function) function = nullptr;
  MT_GDAL_FUNCTIONS(MT_GDAL_DECLARE)
#undef MT_GDAL_DECLARE

  /// The library by the name that the linker would have used. Null, with a message in error, where it is not there.
  static const vtkMTGdalLibrary* Get(std::string& error);
  /// False, with a message in error, where a library is not there or lacks a function.
  bool Load(const std::string& name, std::string& error);
};

#endif
