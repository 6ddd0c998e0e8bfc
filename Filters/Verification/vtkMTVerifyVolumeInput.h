// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTVerifyVolumeInput
 * @brief the isosurface of a volume file, made for checking a model and by other ways than the builder's
 *
 * Headers of MetaImage (.mhd, .mha), NRRD (.nrrd, .nhdr) and NIfTI-1 and -2 (.nii, .nii.gz, .hdr with .img) are parsed,
 * and their samples decoded, by code of this folder that follows the specifications of these formats. VTK's XML image
 * data and its legacy structured points are read by VTK's own readers. Samples are scaled as the header requires, as
 * double, contoured by vtkFlyingEdges3D in index space, and every point is mapped by the whole affine map from indices
 * to the world. That is the file's own frame: NIfTI's (right, anterior, superior; the sform where its code is above 0,
 * else the qform, else voxel sizes alone), MetaImage's axes as they are written, NRRD's declared space. No axis is
 * turned to the convention of another format.
 *
 * Triangles turn counterclockwise about normals that point to lower values, also where the map's determinant is
 * negative: what is brighter than all around it has a positive signed volume.
 *
 * Of several volumes in one file (NIfTI's time points) the first is taken, which Facts::Notes says. What is not one
 * value for each sample (vectors, colours, complex numbers), and encodings that are not decoded here (bzip2, 128 bits),
 * are Facts::IsUnsupported: no verdict about the model follows from that.
 */
#ifndef vtkMTVerifyVolumeInput_h
#define vtkMTVerifyVolumeInput_h

#include "vtkMTVerificationModule.h" // For export macro

#include <array>
#include <string>
#include <vector>

class vtkPolyData;

class VTKMTVERIFICATION_EXPORT vtkMTVerifyVolumeInput
{
public:
  struct Options
  {
    double IsoValue = 0.0; ///< in the scaled values; must not be NaN
  };

  /// What the file holds, besides the surface.
  struct Facts
  {
    std::string Reader;         ///< what read the file, as a report names it
    bool IsUnsupported = false; ///< read failed since this class does not know the form, not since the file is damaged
    std::array<int, 3> Dimensions{ { 0, 0, 0 } }; ///< samples along the axes, the fastest first
    /// From the indices (i, j, k, 1) of a sample to the world; rows one after the other, the last one 0 0 0 1.
    std::array<double, 16> IndexToWorld{ { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 } };
    std::array<double, 2> Range{ { 0.0, 0.0 } }; ///< smallest and largest scaled value; NaN is left out
    bool IsLeftHanded = false;                   ///< whether the determinant of the map is negative
    std::string Frame;                           ///< the frame that the file declares, or empty
    std::vector<std::string> Notes;              ///< what was ignored or chosen, a sentence each
  };

  /// Whether the ending of the name, in upper or lower case, is one that Read knows.
  static bool CanRead(const std::string& path);

  ///@{
  /**
   * Makes the surface: points as double, triangles, no arrays. A surface without triangles is no failure. False with
   * the reason in error, which names the file; facts then say as much as was found out.
   */
  static bool Read(const std::string& path, const Options& options, vtkPolyData* surface, std::string& error);
  static bool Read(
    const std::string& path, const Options& options, vtkPolyData* surface, Facts& facts, std::string& error);
  ///@}
};

#endif
