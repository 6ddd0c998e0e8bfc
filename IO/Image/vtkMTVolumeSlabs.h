// SPDX-License-Identifier: BSD-3-Clause
// A volume of which slabs of slices can be read, as often as wanted. Not installed.
#ifndef vtkMTVolumeSlabs_h
#define vtkMTVolumeSlabs_h

#include "vtkMTVolumePlace.h"

#include <array>
#include <cstdint>
#include <map>
#include <string>

class vtkImageData;

class vtkMTVolumeSlabs
{
public:
  virtual ~vtkMTVolumeSlabs() = default;

  /// VTK's extent of the whole volume, with two slices or more.
  const std::array<int, 6>& GetExtent() const { return this->Extent; }
  /// From indices, those of the extent, to the world.
  const vtkMTVolumePlace& GetPlace() const { return this->Place; }
  /// What of the file is ignored or made up, by reason.
  const std::map<std::string, std::int64_t>& GetReport() const { return this->Report; }

  /// Slices first to last, with active scalars, in the frame of the indices: origin 0, spacing 1, no direction. They
  /// may be this object's own memory. False on failure, with a message in error.
  virtual bool Read(int first, int last, vtkImageData* slab, std::string& error) = 0;

protected:
  std::array<int, 6> Extent{ 0, -1, 0, -1, 0, -1 };
  vtkMTVolumePlace Place;
  std::map<std::string, std::int64_t> Report;
};

#endif
