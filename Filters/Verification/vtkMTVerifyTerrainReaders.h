// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTVerifyTerrainReaders
 * @brief the checker's readers of one tile of terrain each
 *
 * GeoTIFF (OGC 19-008r4): a sample's place follows from ModelTransformation, or from the first ModelTiepoint and
 * ModelPixelScale; raster coordinates of sample (column, row) are (column + 1/2, row + 1/2) for pixel-is-area, which is
 * the default, and (column, row) for pixel-is-point. GDAL_NODATA names the void value, and NaN is one.
 *
 * SRTM: big-endian 16-bit rows from the north, -32768 void; the name is the south-west sample's place.
 *
 * USGS DEM: ASCII in records of 1024 bytes; a header, then profiles from south to north, the westernmost first.
 * Profiles may begin at different heights; what no profile has is void, as are -32767 and below.
 */
#ifndef vtkMTVerifyTerrainReaders_h
#define vtkMTVerifyTerrainReaders_h

#include "vtkMTVerificationModule.h" // For export macro

#include <string>

struct vtkMTVerifyTerrainTile;

namespace vtkMTVerifyTerrainReaders
{
///@{
/// False with the reason in error.
VTKMTVERIFICATION_EXPORT bool ReadGeoTiff(const std::string& path, vtkMTVerifyTerrainTile& tile, std::string& error);
VTKMTVERIFICATION_EXPORT bool ReadSrtm(const std::string& path, vtkMTVerifyTerrainTile& tile, std::string& error);
VTKMTVERIFICATION_EXPORT bool ReadDem(const std::string& path, vtkMTVerifyTerrainTile& tile, std::string& error);
///@}
}

#endif
