// SPDX-License-Identifier: BSD-3-Clause
// What the toolkit's writers share of the operating system's calls. Not installed.
#ifndef vtkMTPosix_h
#define vtkMTPosix_h

#include <cstddef>
#include <string>

namespace vtkMTPosix
{
/// "folder/" of "folder/file"; "./" of "file".
std::string FolderOf(const std::string& path);

/// A new file, opened for reading and writing, whose name begins with prefix; -1 and errno on failure.
int CreateUnique(const std::string& prefix, std::string& name);

/// All bytes at the file's position; false and errno on failure.
bool WriteAll(int descriptor, const void* data, std::size_t size);
}

#endif
