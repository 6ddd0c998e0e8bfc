// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTVerifyVolumeHeader
 * @brief what a volume's header says of its samples and of their place, whatever the format
 */
#ifndef vtkMTVerifyVolumeHeader_h
#define vtkMTVerifyVolumeHeader_h

#include "vtkMTVerificationModule.h" // For export macro
#include "vtkMTVerifyVolumeInput.h"

#include "vtkType.h"

#include <cstdint>
#include <string>
#include <vector>

struct VTKMTVERIFICATION_EXPORT vtkMTVerifyVolumeHeader
{
  enum class Encodings
  {
    Raw,
    Deflate, ///< zlib's or gzip's format
    Ascii,   ///< numbers between blanks
    Hex      ///< two hexadecimal digits a byte
  };

  /// A file of samples. The samples follow each other over all files, each with the same number of them.
  struct DataFile
  {
    std::string Path;
    std::int64_t Offset = 0; ///< bytes at the file's head that are passed over before decoding
  };

  vtkMTVerifyVolumeInput::Facts Facts;
  std::vector<DataFile> Files;
  Encodings Encoding = Encodings::Raw;
  std::int64_t LineSkip = 0; ///< lines that are passed over behind Offset
  std::int64_t ByteSkip = 0; ///< bytes that are passed over after decoding; -1: the samples are the last bytes
  int Type = VTK_VOID;       ///< of the samples as they are stored
  bool IsBigEndian = false;
  double Slope = 1.0; ///< value = Slope * sample + Intercept
  double Intercept = 0.0;

  ///@{
  /**
   * Takes the sizes, of which the first three are the volume's (where fewer are given, or one is less than 2, there is
   * no volume to contour). Where more are given all but the first of several volumes is left out, with a note. False
   * with the reason in error.
   */
  bool SetSizes(const std::vector<std::int64_t>& sizes, std::string& error);
  std::int64_t GetNumberOfSamples() const;
  /// How many volumes follow one another in the files; the first one is read.
  std::int64_t Volumes = 1;
  ///@}

  /// Sets the columns of IndexToWorld: the steps along the three axes, and the place of the first sample.
  void SetAxis(int axis, double x, double y, double z);
  void SetOrigin(double x, double y, double z);

  /// Ends reading for a form that is not read here; false.
  bool Refuse(const std::string& form, std::string& error);
};

#endif
