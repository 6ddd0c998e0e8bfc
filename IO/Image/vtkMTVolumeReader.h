// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTVolumeReader
 * @brief reads a volume, or an isosurface of it as a triangle mesh
 *
 * The ending of the name, in upper or lower case, chooses the reader of VTK: .vti, .mhd and .mha (MetaImage), .nrrd and
 * .nhdr, .nii and .nii.gz (NIfTI), and .vtk (legacy) where there are structured points in it. The isosurface is that of
 * vtkFlyingEdges3D (Schroeder, Maynard, Geveci: "Flying Edges", LDAV 2015) of the active point scalars, or of the first
 * point array where none is active; of several components the first. It carries no scalars: they all are the value.
 * Normals are left to the builder, which makes them as for any mesh, unless gradient normals are asked for.
 *
 * What VTK's readers say is an error is one here; a file that claims more samples than its bytes can hold is refused
 * before memory is asked for.
 */
#ifndef vtkMTVolumeReader_h
#define vtkMTVolumeReader_h

#include "vtkMTIOImageModule.h" // For export macro

#include <cstdint>
#include <memory>
#include <string>

class vtkImageData;
class vtkMTTriangleStream;
class vtkPolyData;

class VTKMTIOIMAGE_EXPORT vtkMTVolumeReader
{
public:
  /// Whether the name, for .vtk also the content, is that of a volume.
  static bool CanRead(const std::string& path);

  /// False, with the reason in error, and an empty output when there is no volume with point scalars.
  static bool ReadVolume(const std::string& path, vtkImageData* output, std::string& error);

  /// The same for the isosurface; one without a triangle is an error that says the range of the scalars.
  static bool ReadIsosurface(
    const std::string& path, double value, bool gradientNormals, vtkPolyData* output, std::string& error);

  /// The same triangles in the same order, contoured a slab of slices at a time, without normals. Of MetaImage and NRRD
  /// without compression only a slab is in memory, of other formats the volume. samplesPerSlab: 0 is the default, 2^22,
  /// or a slice with the next where that is more. Null on failure, with the reason in error.
  static std::unique_ptr<vtkMTTriangleStream> StreamIsosurface(
    const std::string& path, double value, std::string& error, std::uint64_t samplesPerSlab = 0);
};

#endif
