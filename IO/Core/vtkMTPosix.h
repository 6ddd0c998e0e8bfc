// SPDX-License-Identifier: BSD-3-Clause
// What the toolkit shares of the operating system's calls. Not installed.
#ifndef vtkMTPosix_h
#define vtkMTPosix_h

#include "vtkMTIOCoreModule.h" // For export macro
#include <cstddef>
#include <cstdint>
#include <string>

namespace vtkMTPosix
{
/// "folder/" of "folder/file"; "./" of "file".
VTKMTIOCORE_EXPORT std::string FolderOf(const std::string& path);

/// A new file, opened for reading and writing, whose name begins with prefix; -1 and errno on failure.
VTKMTIOCORE_EXPORT int CreateUnique(const std::string& prefix, std::string& name);

/// All bytes at the file's position; false and errno on failure.
VTKMTIOCORE_EXPORT bool WriteAll(int descriptor, const void* data, std::size_t size);

/// Bytes of the machine's memory, or of what the control group leaves of it.
VTKMTIOCORE_EXPORT std::uint64_t GetMachineMemory();
}

#endif
