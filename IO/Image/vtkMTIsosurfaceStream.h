// SPDX-License-Identifier: BSD-3-Clause
// The isosurface of a volume as a triangle stream, contoured a slab of slices at a time. Not installed.
#ifndef vtkMTIsosurfaceStream_h
#define vtkMTIsosurfaceStream_h

#include "vtkMTTriangleStream.h"
#include "vtkMTVolumeSlabs.h"

#include <cstdint>
#include <memory>
#include <string>

class vtkPolyData;

/**
 * Every slab is contoured among indices. Slabs have the slice in which they meet in common, and the points in it by
 * equal places there, so the triangles are those of the whole volume's contour, in the same order. Points go to the
 * world by the volume's place; where that is left-handed, triangles are reversed. Memory is that of one slab beside
 * what the volume itself takes. Every slab is contoured three times: for the counts, the points and the triangles.
 */
namespace vtkMTIsosurfaceStream
{
constexpr std::uint64_t SamplesPerSlab = std::uint64_t(1) << 22;

/// Null on failure, with a message in error; a volume without that isosurface is one.
std::unique_ptr<vtkMTTriangleStream> Open(std::unique_ptr<vtkMTVolumeSlabs> volume, double value, std::string& error,
  std::uint64_t samplesPerSlab = SamplesPerSlab);

/// All of it at once, from one slab of all slices; gradient normals are float point normals. The same errors.
bool Make(vtkMTVolumeSlabs& volume, double value, bool gradientNormals, vtkPolyData* output, std::string& error);
}

#endif
