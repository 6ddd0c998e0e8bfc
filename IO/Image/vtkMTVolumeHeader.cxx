// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTVolumeHeader.h"

#include "vtkMTByteSource.h"
#include "vtkMTFileByteSource.h"
#include "vtkMTTextFormat.h"
#include "vtkMTVolumeFormat.h"

#include "vtkDataArray.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <limits>

bool vtkMTVolumeHeader::Read(const std::string& path, std::string& error)
{
  *this = vtkMTVolumeHeader();
  this->Path = path;
  const std::string ending = vtkMTVolumeFormat::GetEnding(path);
  bool good = false;
  if (ending == "mhd" || ending == "mha" || ending == "nrrd" || ending == "nhdr")
  {
    const auto source = vtkMTFileByteSource::Open(path, error);
    good =
      source && (ending[0] == 'm' ? this->ReadMetaImage(path, *source, error) : this->ReadNrrd(path, *source, error));
  }
  else
  {
    good = this->ReadNifti(path, error);
  }
  return good && this->Check(error);
}

bool vtkMTVolumeHeader::SetAxes(
  const std::vector<double>& sizes, const std::array<std::size_t, 3>& axes, std::string& error)
{
  constexpr double most = 1e15; // elements: beyond any file, within every integer here
  double product = 1.0;
  std::int64_t components = 1;
  std::int64_t frames = 1;
  for (std::size_t axis = 0; axis < sizes.size(); ++axis)
  {
    const auto place = std::find(axes.begin(), axes.end(), axis);
    const bool isOfSpace = place != axes.end();
    if (!(sizes[axis] >= 1.0) || sizes[axis] != std::floor(sizes[axis]) || (product *= sizes[axis]) > most)
    {
      error = "its header has a size that is no number of samples";
      return false;
    }
    const auto size = static_cast<std::uint64_t>(sizes[axis]);
    if (isOfSpace)
    {
      this->Size[static_cast<std::size_t>(place - axes.begin())] = size;
      this->Stride[static_cast<std::size_t>(place - axes.begin())] =
        static_cast<std::uint64_t>(product) / static_cast<std::uint64_t>(sizes[axis]);
    }
    else
    {
      (axis < axes[0] ? components : frames) *= static_cast<std::int64_t>(size);
    }
  }
  this->Elements = static_cast<std::uint64_t>(product);
  const auto count = [this](const char* name, std::int64_t number)
  {
    if (number > 1)
    {
      this->Report[name] = number - 1;
    }
  };
  count("volume_ignored_components", components);
  count("volume_ignored_frames", frames);
  return true;
}

bool vtkMTVolumeHeader::Check(std::string& error) const
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if (this->Size[axis] < 2 || this->Size[axis] > std::numeric_limits<int>::max())
    {
      error = "is no volume: it has " + std::to_string(this->Size[axis]) + " samples along axis " +
        std::to_string(axis) + "; two or more are needed";
      return false;
    }
  }
  if (this->Files.empty() || this->Elements % this->Files.size() != 0)
  {
    error = "its " + std::to_string(this->Files.size()) + " data files cannot hold equally many samples";
    return false;
  }
  if (!std::isfinite(this->Slope) || !std::isfinite(this->Intercept) || this->Slope == 0.0)
  {
    error = "its header scales values by what is no finite number other than 0";
    return false;
  }
  if (!this->Place.IsSound())
  {
    error = "its header's directions span no space: one of them is 0, not finite, or in a plane with the others";
    return false;
  }
  return true;
}

double vtkMTVolumeHeader::UseSpacing(double spacing)
{
  if (std::isfinite(spacing) && spacing != 0.0)
  {
    return spacing;
  }
  ++this->Report["volume_filled_spacings"];
  return 1.0;
}

std::string vtkMTVolumeHeader::GetPathBeside(const std::string& path, const std::string& name)
{
  return (std::filesystem::path(path).parent_path() / std::filesystem::path(name)).string();
}

bool vtkMTVolumeHeader::ListNumbered(
  const std::string& path, const std::string& pattern, const std::array<double, 3>& numbers, std::vector<File>& files)
{
  // One %d, %i or %u with a width, and nothing else that printf would take for an argument.
  const std::size_t percent = pattern.find('%');
  const std::size_t letter = pattern.find_first_not_of("0123456789", percent + 1);
  const bool isPattern = percent != std::string::npos && letter != std::string::npos && letter < percent + 5 &&
    std::string("diu").find(pattern[letter]) != std::string::npos &&
    pattern.find('%', percent + 1) == std::string::npos;
  const double count = (numbers[1] - numbers[0]) / numbers[2];
  if (!isPattern || !(count >= 0.0 && count < 1e6))
  {
    return false;
  }
  const std::string digits = pattern.substr(percent + 1, letter - percent - 1);
  const int width = digits.empty() ? 0 : std::stoi(digits);
  for (double number = numbers[0]; numbers[2] > 0.0 ? number <= numbers[1] : number >= numbers[1]; number += numbers[2])
  {
    char text[64];
    std::snprintf(
      text, sizeof(text), !digits.empty() && digits[0] == '0' ? "%0*d" : "%*d", width, static_cast<int>(number));
    files.push_back({ GetPathBeside(path, pattern.substr(0, percent) + text + pattern.substr(letter + 1)) });
  }
  return true;
}
