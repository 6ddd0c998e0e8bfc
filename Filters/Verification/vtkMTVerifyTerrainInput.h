// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTVerifyTerrainInput
 * @brief the surface of tiles of terrain, made for checking a model and by other ways than the builder's
 *
 * Tiles are GeoTIFF (.tif, .tiff), SRTM (.hgt, .hgt.gz) and USGS DEM in ASCII (.dem). Of GeoTIFF the directory, its
 * tags, geographic keys and samples are decoded by code of this folder, without GDAL. Every sample has a place: of
 * pixel-is-area tiles the middle of the pixel, of pixel-is-point tiles and of SRTM the raster point itself.
 *
 * All tiles must lie on one grid: the same steps, and offsets that are whole numbers of steps (to 1/50 of a step). They
 * are entered into one array of heights, in the order of the paths, a sample that is already there being kept. So tiles
 * that share samples, that overlap, and that are neighbours one step apart (pixel-is-area) are one surface. Every four
 * neighbouring samples are two triangles, with the diagonal from south-west to north-east; where one of the four is
 * void, the other three are one triangle.
 *
 * Geographic coordinates become metres about the middle (lon0, lat0) of all samples, unless degrees are kept:
 * x = R cos(lat0) (lon - lon0), y = R (lat - lat0) with angles in radians and R = 6371008.8. Others are kept.
 */
#ifndef vtkMTVerifyTerrainInput_h
#define vtkMTVerifyTerrainInput_h

#include "vtkMTVerificationModule.h" // For export macro

#include <array>
#include <cstdint>
#include <string>
#include <vector>

class vtkPolyData;

class VTKMTVERIFICATION_EXPORT vtkMTVerifyTerrainInput
{
public:
  struct Options
  {
    double VerticalScale = 1.0; ///< heights are multiplied by it; must be finite
    bool Degrees = false;       ///< keep longitude and latitude in degrees
  };

  /// What the tiles hold, besides the surface.
  struct Facts
  {
    std::string Reader;         ///< what read the tiles, as a report names it
    bool IsUnsupported = false; ///< Read failed since this class does not know the form, not since a file is damaged
    bool IsGeographic = false;  ///< whether the files' coordinates are longitude and latitude
    std::array<double, 2> Middle{ { 0.0, 0.0 } };       ///< longitude and latitude of the frame's origin, in degrees
    std::array<std::int64_t, 2> Dimensions{ { 0, 0 } }; ///< columns and rows of the grid that holds all tiles
    /// From (column, row, height, 1) to the world; rows one after the other, the last one 0 0 0 1.
    std::array<double, 16> IndexToWorld{ { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 } };
    std::array<double, 2> Range{ { 0.0, 0.0 } };     ///< lowest and highest height of the files, voids left out
    std::array<double, 2> AreaRange{ { 0.0, 0.0 } }; ///< least and largest area for any choice of diagonals
    std::int64_t Samples = 0;                        ///< distinct samples with a height
    std::int64_t Voids = 0;                          ///< distinct samples of tiles that have none
    std::int64_t SharedSamples = 0;                  ///< samples that an earlier tile has too
    std::int64_t DisagreeingSamples = 0;             ///< such samples with another height
    std::vector<std::string> Notes;                  ///< what was ignored or chosen, a sentence each
  };

  /// Whether the ending of the name, in upper or lower case, is one that Read knows.
  static bool CanRead(const std::string& path);

  ///@{
  /**
   * Makes the surface of all tiles: points as double, triangles that are counterclockwise seen from above, no arrays.
   * False with the reason in error, which names the file; facts then say as much as was found out.
   */
  static bool Read(
    const std::vector<std::string>& paths, const Options& options, vtkPolyData* surface, std::string& error);
  static bool Read(const std::vector<std::string>& paths, const Options& options, vtkPolyData* surface, Facts& facts,
    std::string& error);
  ///@}
};

#endif
