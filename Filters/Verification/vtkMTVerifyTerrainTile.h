// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTVerifyTerrainTile
 * @brief a tile of terrain as a file has it: heights of samples, and where these lie
 */
#ifndef vtkMTVerifyTerrainTile_h
#define vtkMTVerifyTerrainTile_h

#include "vtkMTVerificationModule.h" // For export macro

#include <array>
#include <cstdint>
#include <string>
#include <vector>

struct VTKMTVERIFICATION_EXPORT vtkMTVerifyTerrainTile
{
  std::string Path;
  std::int64_t Columns = 0;
  std::int64_t Rows = 0;
  std::vector<double> Heights; ///< row after row; NaN: void
  ///@{
  /// Sample (column, row) is at Origin + column * ColumnStep + row * RowStep; longitude first, in degrees.
  std::array<double, 2> Origin{ { 0.0, 0.0 } };
  std::array<double, 2> ColumnStep{ { 1.0, 0.0 } };
  std::array<double, 2> RowStep{ { 0.0, -1.0 } };
  ///@}
  bool IsGeographic = false;
  bool IsUnsupported = false; ///< reading failed since the form is not read here
  std::string Reader;
  std::vector<std::string> Notes;

  /// Ends reading for a form that is not read here; false.
  bool Refuse(const std::string& form, std::string& error)
  {
    this->IsUnsupported = true;
    error = form + " is not read by the checker";
    return false;
  }
};

#endif
