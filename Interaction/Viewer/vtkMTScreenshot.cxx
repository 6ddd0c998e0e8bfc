// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTScreenshot.h"

#include "vtkMTOutputFile.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkRenderWindow.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

namespace
{
// The number in a name of prefix-NUMBER.ending, or 0.
unsigned long GetNumber(const std::string& name, const std::string& prefix, const std::string& ending)
{
  const std::size_t least = prefix.size() + 1 + ending.size();
  if (name.size() <= least || name.compare(0, prefix.size() + 1, prefix + "-") != 0 ||
    name.compare(name.size() - ending.size(), ending.size(), ending) != 0)
  {
    return 0;
  }
  const std::string digits = name.substr(prefix.size() + 1, name.size() - least);
  const bool isNumber =
    digits.size() < 10 && std::all_of(digits.begin(), digits.end(), [](unsigned char c) { return std::isdigit(c); });
  return isNumber ? std::stoul(digits) : 0;
}
}

//------------------------------------------------------------------------------
std::string vtkMTScreenshot::ReserveNext(const std::string& prefix, const std::string& ending, std::string& error)
{
  namespace fs = std::filesystem;
  const fs::path path(prefix);
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  unsigned long number = 0;
  std::error_code code;
  for (fs::directory_iterator entry(folder, code), end; !code && entry != end; entry.increment(code))
  {
    number = std::max(number, GetNumber(entry->path().filename().string(), path.filename().string(), ending));
  }
  for (;;)
  {
    char digits[32];
    std::snprintf(digits, sizeof(digits), "-%04lu", ++number);
    std::string name = prefix + digits + ending;
    if (std::FILE* file = std::fopen(name.c_str(), "wx")) // fails where there is one
    {
      std::fclose(file);
      error.clear();
      return name;
    }
    if (errno != EEXIST)
    {
      error = name + ": cannot be made: " + std::strerror(errno);
      return "";
    }
  }
}

//------------------------------------------------------------------------------
bool vtkMTScreenshot::Write(vtkRenderWindow* window, const std::string& path, std::string& error)
{
  vtkNew<vtkWindowToImageFilter> grabber;
  grabber->SetInput(window);
  grabber->ShouldRerenderOff();
  grabber->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(grabber->GetOutputPort());
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  if (!bytes || bytes->GetNumberOfValues() == 0)
  {
    error = path + ": was not written: the picture could not be made";
    return false;
  }
  vtkMTOutputFile file;
  const bool isWritten = file.Open(path) &&
    file.Write(bytes->GetPointer(0), static_cast<std::size_t>(bytes->GetNumberOfValues())) && file.Commit();
  error = isWritten ? "" : file.GetError();
  return isWritten;
}

//------------------------------------------------------------------------------
std::string vtkMTScreenshot::WriteNext(vtkRenderWindow* window, const std::string& prefix, std::string& error)
{
  std::string path = ReserveNext(prefix, ".png", error);
  if (!path.empty() && !Write(window, path, error))
  {
    std::remove(path.c_str());
    return "";
  }
  return path;
}
