// SPDX-License-Identifier: BSD-3-Clause
// The file "state" of a spool store: the names of its spools and the bytes of the last commit. Not installed.
#ifndef vtkMTSpoolState_h
#define vtkMTSpoolState_h

#include "vtkMTIOCoreModule.h" // For export macro
#include <string>
#include <vector>

namespace vtkMTSpoolState
{
VTKMTIOCORE_EXPORT std::string GetPath(const std::string& folder);

/// Replaces the folder's state in one step, and durably. False with a message in error, the old one being as it was.
VTKMTIOCORE_EXPORT bool Write(const std::string& folder, const std::vector<std::string>& names,
  const std::vector<unsigned char>& bytes, std::string& error);

/// False with a message in error when the state cannot be read or is damaged.
VTKMTIOCORE_EXPORT bool Read(
  const std::string& folder, std::vector<std::string>& names, std::vector<unsigned char>& bytes, std::string& error);

VTKMTIOCORE_EXPORT bool SyncFolder(const std::string& folder, std::string& error);
}

#endif
