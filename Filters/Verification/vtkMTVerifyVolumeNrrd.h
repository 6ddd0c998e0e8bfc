// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTVerifyVolumeNrrd
 * @brief the header of a NRRD file (.nrrd, .nhdr), after the "Definition of NRRD File Format"
 *
 * With space directions these are the steps from sample to sample in the declared space, and the space origin is the
 * place of the first sample. Without, an axis has its spacing, or that of its minimum and maximum; and the first sample
 * is at the minimum of an axis of nodes, half a step behind it for cells, which is what an axis is taken for where the
 * file does not say. Axes that are none of space (of length 1, or the slowest one) are left out.
 */
#ifndef vtkMTVerifyVolumeNrrd_h
#define vtkMTVerifyVolumeNrrd_h

#include "vtkMTVerificationModule.h" // For export macro
#include "vtkMTVerifyVolumeHeader.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

class VTKMTVERIFICATION_EXPORT vtkMTVerifyVolumeNrrd
{
public:
  vtkMTVerifyVolumeNrrd(const std::string& path, vtkMTVerifyVolumeHeader& header);

  /// False with the reason in error.
  bool Parse(std::string& error);

private:
  bool ReadFields(std::string& error);
  bool ParseType(std::string& error);
  bool ParseAxes(std::string& error);
  bool ChooseAxes(std::string& error);
  bool ParseSpace(std::string& error);
  bool ParseSteps(std::string& error);
  bool ParseData(std::string& error);
  bool ParseFiles(const std::string& text, std::string& error);
  std::string Find(const std::string& name) const;
  /// One number for each axis, NaN where the file has none; false where they are not as many as axes.
  bool FindPerAxis(const std::string& name, std::vector<double>& numbers, std::string& error) const;

  struct Axis
  {
    std::int64_t Size = 0;
    std::vector<double> Direction; ///< empty: none
    bool IsSpatial = true;
  };

  std::string Path;
  vtkMTVerifyVolumeHeader& Header;
  std::map<std::string, std::string> Fields; ///< by names in lower case
  std::vector<std::string> Lines;            ///< names of files, of a LIST
  std::int64_t End = 0;                      ///< where the header ends and attached samples begin
  std::vector<Axis> Axes;
  std::vector<std::size_t> Spatial; ///< the three axes of the volume
};

#endif
