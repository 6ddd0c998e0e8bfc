// SPDX-License-Identifier: BSD-3-Clause
// A grid of heights with its place on the Earth, as one file gives it. Not installed.
#ifndef vtkMTHeightTile_h
#define vtkMTHeightTile_h

#include <cstddef>
#include <string>
#include <vector>

struct vtkMTHeightTile
{
  std::string Path;
  bool IsGeographic = true; ///< places in degrees; otherwise in metres of some projection
  std::string Crs;          ///< its coordinates' reference system ("EPSG:32610", WKT); empty where it is not known
  double West = 0.0;        ///< of the first sample in a row
  double South = 0.0;       ///< of the first row
  double StepX = 1.0;
  double StepY = 1.0;
  std::size_t Columns = 0;
  std::size_t Rows = 0;
  std::vector<float> Heights; ///< metres, row by row from the south; NaN where there is a void

  /// Whether the name is that of a tile: .hgt, .hgt.gz, .dem, and .tif or .tiff where GDAL is built in.
  static bool CanRead(const std::string& path);
  /// False, with a reason that does not name the file, when it is not a sound tile.
  bool Read(const std::string& path, std::string& error);

private:
  bool ReadSrtm(std::string& error);
  bool ReadDem(std::string& error);
  bool ReadGdal(std::string& error);
};

#endif
