// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTInputSettings
 * @brief what a model is built from: names of files, and what they are to be taken for
 */
#ifndef vtkMTInputSettings_h
#define vtkMTInputSettings_h

#include <optional>
#include <string>
#include <vector>

struct vtkMTInputSettings
{
  std::vector<std::string> Paths;
  std::optional<double> IsoValue; ///< of volumes
  bool GradientNormals = false;   ///< of volumes
  double VerticalScale = 1.0;     ///< of terrain
  bool Degrees = false;           ///< of terrain
};

#endif
