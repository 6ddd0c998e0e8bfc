// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTFileAccess
 * @brief whether a file can be read or written, before the work begins
 */
#ifndef vtkMTFileAccess_h
#define vtkMTFileAccess_h

#include "vtkMTIOCoreModule.h" // For export macro

#include <string>

struct VTKMTIOCORE_EXPORT vtkMTFileAccess
{
  /// Whether the file can be opened for reading and is no folder. False with the reason, and what to do, in error.
  static bool CanRead(const std::string& path, std::string& error);
  /// Whether a file can be made in the folder of path; nothing is made or changed. False with the reason in error.
  static bool CanWrite(const std::string& path, std::string& error);
};

#endif
