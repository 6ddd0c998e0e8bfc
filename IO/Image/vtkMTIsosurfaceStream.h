// SPDX-License-Identifier: BSD-3-Clause
// The isosurface of a volume as a triangle stream, contoured a slab of slices at a time. Not installed.
#ifndef vtkMTIsosurfaceStream_h
#define vtkMTIsosurfaceStream_h

#include "vtkMTTriangleStream.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>

class vtkImageData;

/// A volume of which slabs can be had, as often as they are asked for.
class vtkMTVolumeSlabs
{
public:
  virtual ~vtkMTVolumeSlabs() = default;
  /// VTK's extent of the whole volume, with two slices or more.
  virtual std::array<int, 6> GetExtent() const = 0;
  /// Slices first to last, with active scalars. False on failure, with a message in error.
  virtual bool Read(int first, int last, vtkImageData* slab, std::string& error) = 0;
};

/**
 * Slabs have the slice in which they meet in common, and the points in it by equal coordinates, so the triangles are
 * those of the whole volume's contour, in the same order. Memory is that of one slab beside what the volume itself
 * takes. Every slab is contoured three times: for the counts, the points and the triangles.
 */
namespace vtkMTIsosurfaceStream
{
constexpr std::uint64_t SamplesPerSlab = std::uint64_t(1) << 22;

/// Null on failure, with a message in error; a volume without that isosurface is one.
std::unique_ptr<vtkMTTriangleStream> Open(std::unique_ptr<vtkMTVolumeSlabs> volume, double value, std::string& error,
  std::uint64_t samplesPerSlab = SamplesPerSlab);
}

#endif
