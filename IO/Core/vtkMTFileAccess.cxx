// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTFileAccess.h"

#include <filesystem>

#include <unistd.h>

bool vtkMTFileAccess::CanRead(const std::string& path, std::string& error)
{
  std::error_code code;
  if (!std::filesystem::exists(path, code))
  {
    error = path + ": no such file; check the name";
    return false;
  }
  if (std::filesystem::is_directory(path, code))
  {
    error = path + ": is a folder; name a file";
    return false;
  }
  if (::access(path.c_str(), R_OK) != 0)
  {
    error = path + ": cannot be opened for reading; check its permissions";
    return false;
  }
  return true;
}

bool vtkMTFileAccess::CanWrite(const std::string& path, std::string& error)
{
  std::error_code code;
  if (std::filesystem::is_directory(path, code))
  {
    error = path + ": is a folder; name a file to write";
    return false;
  }
  std::filesystem::path folder = std::filesystem::path(path).parent_path();
  folder = folder.empty() ? "." : folder;
  if (!std::filesystem::is_directory(folder, code))
  {
    error = path + ": its folder does not exist; make it first";
    return false;
  }
  if (::access(folder.c_str(), W_OK) != 0)
  {
    error = path + ": its folder cannot be written to; check its permissions";
    return false;
  }
  return true;
}
