// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTVolumeHeader
 * @brief what the header of a MetaImage, NRRD or NIfTI file says: how samples are stored, what they mean, where they
 * are
 *
 * VTK's readers leave out what these formats are for: the frame. So headers are read here, by the specifications:
 *
 * - MetaImage (.mhd, .mha): row i of TransformMatrix is the direction of axis i, times ElementSpacing (or ElementSize);
 *   Offset is the place of the first sample. Values are ElementToIntensityFunctionSlope x + ...Offset.
 * - NRRD (.nrrd, .nhdr): "space directions" and "space origin" in the declared space; without them "spacings" and "axis
 *   mins", which are borders of cells unless the axis is centred on nodes (teem's default).
 * - NIfTI-1 and -2 (.nii, .nii.gz, .hdr with .img, both also gzipped): sform where its code is positive, else qform
 *   where its code is, else voxel sizes alone; x to the right, y to the front, z up. Values are scl_slope x + scl_inter
 *   where scl_slope is finite and not 0.
 *
 * No axis is turned to the convention of another format. Axes that are not of space are passed over: the first
 * component and the first frame count. The report says what is ignored or made up ("volume_ignored_...",
 * "volume_filled_spacings").
 */
#ifndef vtkMTVolumeHeader_h
#define vtkMTVolumeHeader_h

#include "vtkMTVolumePlace.h"

#include "vtkType.h"

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

class vtkMTByteSource;

struct vtkMTVolumeHeader
{
  enum EncodingType
  {
    Raw,
    Deflated, ///< zlib's or gzip's form, in one or several members
    Text,
    Hexadecimal
  };
  struct File
  {
    std::string Path;
    std::uint64_t Offset = 0; ///< where the samples, encoded or not, begin
    bool IsAtEnd = false;     ///< instead: they are the last bytes
  };

  /// By the ending of the name; of .hdr and .img, with or without .gz, also by the header's size.
  static bool CanRead(const std::string& path);
  /// False, with a reason that does not name the file, when it is no sound volume.
  bool Read(const std::string& path, std::string& error);

  std::string Path;                               ///< of the header
  int Type = VTK_VOID;                            ///< of elements: VTK's number
  std::array<std::uint64_t, 3> Size{};            ///< samples along i, j, k
  std::array<std::uint64_t, 3> Stride{ 0, 0, 0 }; ///< from one sample to the next, in elements; the last is largest
  std::uint64_t Elements = 0;                     ///< in all files
  std::vector<File> Files;                        ///< one behind the other, with equally many elements each
  EncodingType Encoding = Raw;
  std::uint64_t DecodedSkip = 0; ///< bytes to leave out after decoding
  bool IsBigEndian = false;
  double Slope = 1.0; ///< a value is slope x element + intercept
  double Intercept = 0.0;
  vtkMTVolumePlace Place;
  std::map<std::string, std::int64_t> Report;

private:
  bool ReadMetaImage(const std::string& path, const vtkMTByteSource& source, std::string& error);
  bool ReadNrrd(const std::string& path, const vtkMTByteSource& source, std::string& error);
  bool ReadNifti(const std::string& path, std::string& error);

  struct MetaImage;
  struct Nrrd;
  struct Nifti;

  /// Sizes of all axes, the fastest first, and which of them are i, j and k, in rising order.
  bool SetAxes(const std::vector<double>& sizes, const std::array<std::size_t, 3>& axes, std::string& error);
  bool SkipLines(double lines, std::string& error);
  bool Check(std::string& error) const;
  /// 1, and counted, where it is not finite or 0.
  double UseSpacing(double spacing);
  static std::string GetPathBeside(const std::string& path, const std::string& name);
  /// Names of a numbered sequence: "slice%03d.raw", the first and the last number, the step.
  static bool ListNumbered(const std::string& path, const std::string& pattern, const std::array<double, 3>& numbers,
    std::vector<File>& files);
};

#endif
