// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTVerifyVolumeMetaImage
 * @brief the header of a MetaImage (.mhd, .mha), after the list of its tags in MetaIO's documentation
 *
 * Row i of TransformMatrix is the direction of axis i in the world, Offset the place of the first sample,
 * ElementSpacing the distance of samples (ElementSize where there is no spacing). ElementToIntensityFunctionSlope and
 * Offset are applied.
 */
#ifndef vtkMTVerifyVolumeMetaImage_h
#define vtkMTVerifyVolumeMetaImage_h

#include "vtkMTVerificationModule.h" // For export macro
#include "vtkMTVerifyVolumeHeader.h"

#include <map>
#include <string>
#include <vector>

class VTKMTVERIFICATION_EXPORT vtkMTVerifyVolumeMetaImage
{
public:
  vtkMTVerifyVolumeMetaImage(const std::string& path, vtkMTVerifyVolumeHeader& header);

  /// False with the reason in error.
  bool Parse(std::string& error);

private:
  bool ReadTags(std::string& error);
  bool ParseType(std::string& error);
  bool ParseSizes(std::string& error);
  bool ParsePlace(std::string& error);
  bool ParseData(std::string& error);
  bool ParseFiles(const std::string& text, std::string& error);
  /// The value of the first of the names that is there, in lower case; or the default.
  std::string Find(const std::vector<std::string>& names, const std::string& otherwise = std::string()) const;
  /// Its value as count numbers or more; false where it is there and is not that.
  bool FindNumbers(
    const std::vector<std::string>& names, std::size_t count, std::vector<double>& numbers, std::string& error) const;
  bool IsTrue(const std::vector<std::string>& names) const;

  std::string Path;
  vtkMTVerifyVolumeHeader& Header;
  std::map<std::string, std::string> Tags; ///< by names in lower case
  std::vector<std::string> Lines;          ///< behind the last tag: names of files, of a LIST
  std::int64_t End = 0;                    ///< where the header ends and LOCAL samples begin
  std::size_t NDims = 0;
};

#endif
