// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTVolumeReader
 * @brief reads an isosurface of a volume as a triangle mesh, in the volume's own world frame
 *
 * The ending of the name, in upper or lower case, chooses the format: .vti and .vtk (legacy, where there are structured
 * points in it) are read by VTK's readers; .mhd and .mha (MetaImage), .nrrd and .nhdr, .nii, .nii.gz and pairs of .hdr
 * and .img (NIfTI) by this folder (vtkMTVolumeHeader has what is understood of their headers). The isosurface is that
 * of vtkFlyingEdges3D (Schroeder, Maynard, Geveci: "Flying Edges", LDAV 2015) of the active point scalars, or of the
 * first point array where none is active; of several components the first, of several frames the first. It carries no
 * scalars: they all are the value.
 *
 * Contours are made among the indices of samples, in single precision, and taken to the world in double precision by
 * what the file says of origin, spacing and directions. No axis is turned to another convention. Where that map has a
 * negative determinant, triangles are reversed ("turned_triangles"), so that they wind counterclockwise about
 * normals that point to lower values, in every file. Normals are left to the builder, which makes them as for any mesh,
 * unless gradient normals are asked for: these go to the world by the inverse transposed matrix.
 *
 * A file that claims more samples than its bytes can hold is refused before memory is asked for.
 */
#ifndef vtkMTVolumeReader_h
#define vtkMTVolumeReader_h

#include "vtkMTIOImageModule.h" // For export macro
#include "vtkMTWorldFrame.h"

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

class vtkMTTriangleStream;
class vtkPolyData;

class VTKMTIOIMAGE_EXPORT vtkMTVolumeReader
{
public:
  /// What is known beside the surface.
  struct Facts
  {
    vtkMTWorldFrame Frame;
    std::map<std::string, std::int64_t> Report; ///< what was ignored, made up or turned, by reason
  };

  /// Whether the name, for .vtk, .hdr and .img also the content, is that of a volume.
  static bool CanRead(const std::string& path);

  /// The other files that a header names or that are its pair; none where the header is not sound.
  static std::vector<std::string> FindOtherFiles(const std::string& path);

  /// The isosurface, its points in double precision. False, with the reason in error, and an empty output when there is
  /// no volume with point scalars; a surface without a triangle is an error that says the range of the scalars.
  static bool ReadIsosurface(const std::string& path, double value, bool gradientNormals, vtkPolyData* output,
    std::string& error, Facts* facts = nullptr);

  /// The same triangles in the same order, contoured a slab of slices at a time, without normals. Of MetaImage, NRRD
  /// and NIfTI without compression only a slab is in memory, of other files the volume. samplesPerSlab: 0 is the
  /// default, 2^22, or a slice with the next where that is more. Null on failure, with the reason in error. The
  /// stream's report has what the facts' report has.
  static std::unique_ptr<vtkMTTriangleStream> StreamIsosurface(const std::string& path, double value,
    std::string& error, std::uint64_t samplesPerSlab = 0, vtkMTWorldFrame* frame = nullptr);
};

#endif
