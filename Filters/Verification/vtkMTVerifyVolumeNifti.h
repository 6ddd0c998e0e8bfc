// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTVerifyVolumeNifti
 * @brief the header of a NIfTI-1 or NIfTI-2 file (.nii, .nii.gz, .hdr with .img), after nifti1.h and nifti2.h
 *
 * The map to the world is the sform's where sform_code is above 0 (method 3), else the qform's where qform_code is
 * (method 2: the quaternion's rotation, the voxel sizes, the third axis reversed where qfac is negative, the offsets),
 * else the voxel sizes alone (method 1). Values are scl_slope * sample + scl_inter where scl_slope is not 0.
 */
#ifndef vtkMTVerifyVolumeNifti_h
#define vtkMTVerifyVolumeNifti_h

#include "vtkMTVerificationModule.h" // For export macro
#include "vtkMTVerifyVolumeHeader.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

class VTKMTVERIFICATION_EXPORT vtkMTVerifyVolumeNifti
{
public:
  vtkMTVerifyVolumeNifti(const std::string& path, vtkMTVerifyVolumeHeader& header);

  /// False with the reason in error.
  bool Parse(std::string& error);

private:
  bool FindVersion(std::string& error);
  bool ParseFiles(std::string& error);
  bool ParseSizes(std::string& error);
  bool ParseType(std::string& error);
  bool ParsePlace(std::string& error);
  void ParseQuaternion(const double (&steps)[3]);
  void ParseRows();
  /// The number at the places that the two versions of the format have for it; real numbers are float or double.
  double GetReal(std::size_t inFirst, std::size_t inSecond, std::size_t index = 0) const;
  /// The same for the sizes (16 or 64 bits) and for codes (16 or 32 bits).
  std::int64_t GetSize(std::size_t index) const;
  std::int64_t GetCode(std::size_t inFirst, std::size_t inSecond) const;

  std::string Path;
  vtkMTVerifyVolumeHeader& Header;
  std::vector<unsigned char> Bytes;
  bool IsSecond = false; ///< NIfTI-2
  bool IsSingle = false; ///< header and samples in one file
};

#endif
