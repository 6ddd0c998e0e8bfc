// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTVerifyVolumeHeader.h"

#include <cstddef>

bool vtkMTVerifyVolumeHeader::SetSizes(const std::vector<std::int64_t>& sizes, std::string& error)
{
  constexpr std::int64_t most = std::int64_t(1) << 40;
  std::int64_t product = 1;
  for (const std::int64_t size : sizes)
  {
    if (size < 1 || size > VTK_INT_MAX || product > most / size)
    {
      error = "its numbers of samples are out of range";
      return false;
    }
    product *= size;
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if (axis >= sizes.size() || sizes[axis] < 2)
    {
      error = "it has no volume to contour: an axis has fewer than 2 samples";
      return false;
    }
    this->Facts.Dimensions[axis] = static_cast<int>(sizes[axis]);
  }
  this->Volumes = product / this->GetNumberOfSamples();
  if (this->Volumes > 1)
  {
    this->Facts.Notes.push_back("The first of " + std::to_string(this->Volumes) + " volumes is taken.");
  }
  return true;
}

std::int64_t vtkMTVerifyVolumeHeader::GetNumberOfSamples() const
{
  const auto& sizes = this->Facts.Dimensions;
  return std::int64_t(sizes[0]) * sizes[1] * sizes[2];
}

void vtkMTVerifyVolumeHeader::SetAxis(int axis, double x, double y, double z)
{
  const double values[3] = { x, y, z };
  for (int row = 0; row < 3; ++row)
  {
    this->Facts.IndexToWorld[static_cast<std::size_t>(4 * row + axis)] = values[row];
  }
}

void vtkMTVerifyVolumeHeader::SetOrigin(double x, double y, double z)
{
  this->SetAxis(3, x, y, z);
}

bool vtkMTVerifyVolumeHeader::Refuse(const std::string& form, std::string& error)
{
  this->Facts.IsUnsupported = true;
  error = form + " is not read by the checker";
  return false;
}
