// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTPatchRecord
 * @brief a patch as bytes, for the spools of the construction
 *
 * Plain and fast: lists one behind the other. Columns of zeros, such as the reach of the input, take no room. Never
 * part of a file: patches are encoded for that by the sink.
 */
#ifndef vtkMTPatchRecord_h
#define vtkMTPatchRecord_h

#include "vtkMTConstructionModule.h" // For export macro
#include "vtkMTPatch.h"

#include <string>
#include <vector>

struct VTKMTCONSTRUCTION_EXPORT vtkMTPatchRecord
{
  /// Replaces what is in bytes.
  static void Encode(const vtkMTPatch& patch, std::vector<unsigned char>& bytes);
  /// False with a message in error when the bytes are not those of a patch.
  static bool Decode(const std::vector<unsigned char>& bytes, vtkMTPatch& patch, std::string& error);
};

#endif
