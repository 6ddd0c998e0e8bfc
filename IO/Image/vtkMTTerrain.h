// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTTerrain
 * @brief a triangle mesh of the terrain that tiles of heights make together
 *
 * Tiles: SRTM (.hgt, .hgt.gz; of any size, 1201 x 1201 and 3601 x 3601 as a rule; the south-west corner is in the name,
 * as in N36W005.hgt; -32768 is a void), USGS DEM (.dem, ASCII) and, where GDAL was found when the toolkit was
 * configured, GeoTIFF (.tif, .tiff; the first band; samples that equal the no-data value or are masked are voids; the
 * band's scale and offset are applied). Samples of GeoTIFF are at the middle of their pixels where pixels are areas,
 * and at the places that the file gives where they are points. (DEM files are not read by vtkDEMReader: VTK 9.1's
 * writes beyond its memory where a file is damaged, puts all profiles at the first row, and takes the lowest height for
 * a void.)
 *
 * All tiles of one terrain have one spacing and one reference system and lie on one grid, to 1/100 of a step: what does
 * not is refused. Samples that two tiles share, at their border or where they overlap, are one point. Of several
 * heights at one place the first that is no void counts, in the order in which the tiles were added; the others are
 * counted where they differ ("terrain_disagreeing_samples"). Tiles of which one begins a step behind the other's last
 * samples, as those of areas do, are joined. Places between two tiles, in their row or in their column, that no tile
 * covers are counted ("terrain_gap_samples"). Geographic tiles on both sides of the 180th meridian are neighbours;
 * longitudes then go on beyond 180.
 *
 * Two triangles to a square of four samples that tiles have; where one sample is void, one triangle; none where two are
 * ("terrain_voids" counts void samples). Triangles are counterclockwise from above.
 *
 * Coordinates. Geographic tiles give metres, in a local equirectangular frame about the middle (lon0, lat0) of the box
 * of all tiles, on a sphere of the Earth's mean radius R = 6371008.8 m:
 *
 *   x = R cos(lat0) (lon - lon0) pi / 180 (to the east), y = R (lat - lat0) pi / 180 (to the north), z = scale * height
 *
 * With Degrees on, x is the longitude and y the latitude in degrees, and z as above. Tiles in a projection, such as
 * UTM, keep their coordinates, in metres, whatever Degrees says.
 */
#ifndef vtkMTTerrain_h
#define vtkMTTerrain_h

#include "vtkMTIOImageModule.h" // For export macro
#include "vtkMTWorldFrame.h"

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

class vtkMTSpoolStore;
class vtkMTTriangleStream;
class vtkPolyData;

class VTKMTIOIMAGE_EXPORT vtkMTTerrain
{
public:
  vtkMTTerrain();
  ~vtkMTTerrain();

  /// What heights, in metres, are multiplied by. Default 1; any finite number but 0, or else Make fails.
  double VerticalScale = 1.0;
  /// Whether geographic tiles keep their degrees. Default off.
  bool Degrees = false;

  /// Whether the name is that of a tile that can be read.
  static bool CanRead(const std::string& path);

  /// Where the heights of tiles are kept from AddTile on, one tile being in memory at a time; must outlive this and its
  /// streams. Default: none, all tiles stay in memory.
  vtkMTSpoolStore* Store = nullptr;

  /// False, with the reason in error, when the file is no sound tile or does not lie on the grid of the earlier ones.
  bool AddTile(const std::string& path, std::string& error);

  /// The terrain of the tiles that were added, row by row; needs this object no longer. Its report has what is counted.
  /// Null, with the reason in error, when there is no triangle, or not memory enough.
  std::unique_ptr<vtkMTTriangleStream> MakeStream(std::string& error);

  /// All of it as a mesh. False, with the reason in error, and an empty output in the same cases.
  bool Make(vtkPolyData* output, std::string& error);

  /// In which the points of the tiles so far are: a PROJ string of the equation above, or the tiles' own system.
  vtkMTWorldFrame GetFrame() const;

  /// Of the last Make: what is counted above, and "terrain_tiles".
  const std::map<std::string, std::int64_t>& GetReport() const { return this->Report; }

private:
  vtkMTTerrain(const vtkMTTerrain&) = delete;
  void operator=(const vtkMTTerrain&) = delete;

  bool PutHeights(std::vector<float>& heights, std::uint64_t& firstByte, std::string& error);

  struct Internals;
  std::unique_ptr<Internals> Implementation;
  std::map<std::string, std::int64_t> Report;
};

#endif
