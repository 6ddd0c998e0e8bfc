// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTVerifyVolumeSamples
 * @brief decodes the samples that a volume's header describes
 *
 * Samples keep their type; where the header scales them they become double. All samples are in memory.
 */
#ifndef vtkMTVerifyVolumeSamples_h
#define vtkMTVerifyVolumeSamples_h

#include "vtkMTVerificationModule.h" // For export macro
#include "vtkMTVerifyVolumeHeader.h"

#include "vtkSmartPointer.h"

#include <cstddef>
#include <string>
#include <vector>

class vtkDataArray;

class VTKMTVERIFICATION_EXPORT vtkMTVerifyVolumeSamples
{
public:
  explicit vtkMTVerifyVolumeSamples(const vtkMTVerifyVolumeHeader& header);

  /// Null with the reason in error.
  vtkSmartPointer<vtkDataArray> Read(std::string& error);

private:
  /// Appends up to wanted bytes of samples of one file; fewer are an error, which names the file.
  bool AppendFile(const vtkMTVerifyVolumeHeader::DataFile& file, std::size_t wanted, std::string& error);
  bool Decode(const std::vector<unsigned char>& stored, std::size_t from, std::size_t wanted,
    std::vector<unsigned char>& decoded, std::string& error) const;
  /// Numbers of text, converted to the samples' type in the machine's byte order.
  bool ParseText(const std::vector<unsigned char>& stored, std::size_t from, std::string& error);
  vtkSmartPointer<vtkDataArray> Scale(vtkDataArray* samples) const;

  const vtkMTVerifyVolumeHeader& Header;
  std::size_t SampleSize = 0;
  std::size_t Filled = 0; ///< bytes of Samples that were read
  vtkSmartPointer<vtkDataArray> Samples;
};

#endif
