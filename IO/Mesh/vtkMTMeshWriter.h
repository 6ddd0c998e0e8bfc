// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTMeshWriter
 * @brief writes a triangle mesh as PLY, STL, OBJ, VTP or glTF
 *
 * The ending of the name, in upper or lower case, chooses the format; the file is published whole or not at all
 * (vtkMTOutputFile). Polygons and strips become triangles (vtkMTPolyDataStream), except in VTP, which keeps the
 * polydata as it is. What each format carries:
 *
 * - PLY (binary, little-endian): positions in single precision where that loses nothing, else in double; every point
 *   and cell array. Normals become nx ny nz, the first array of 3 or 4 bytes red green blue (alpha), 2D texture
 * coordinates s t, all other components a property of their own type each. PLY has no 64-bit integers: they become int,
 * uint or double, whichever holds every value; where none does that is an error.
 * - STL (binary): positions in single precision, and the normals of the triangles.
 * - OBJ: positions in digits that read back as they were, normals and 2D texture coordinates in single precision.
 * - VTP: everything.
 * - glTF 2.0, as .glb (binary, at most 4 GB) or as .gltf (JSON with the data in it, a third larger): one mesh of
 *   positions, normals (NORMAL, of unit length), 2D texture coordinates (TEXCOORD_0, counted from the top as glTF
 *   does), the first array of 3 or 4 bytes (COLOR_0), and single-precision point arrays of at most 4 components
 *   ("_" and their names), all in single precision; where that would lose digits of the positions they are relative
 *   to the middle of the bounds, which is the node's translation.
 *
 * PLY, OBJ and glTF are written block by block, in memory that does not grow with the mesh; STL needs all points in
 * memory.
 */
#ifndef vtkMTMeshWriter_h
#define vtkMTMeshWriter_h

#include "vtkMTIOMeshModule.h" // For export macro

#include <functional>
#include <string>
#include <vector>

class vtkMTTriangleStream;
class vtkPolyData;

class VTKMTIOMESH_EXPORT vtkMTMeshWriter
{
public:
  enum class Precision
  {
    Automatic, ///< one more pass over the points finds out whether single precision is enough
    Single,    ///< for streams that are known to give single precision
    Double
  };
  /// Called now and then with the fraction that is done, from the calling thread.
  using Progress = std::function<void(double)>;

  /// Whether the name has an ending that Write knows.
  static bool CanWrite(const std::string& path);

  ///@{
  /// False, with the reason in error, when the file could not be written; an earlier one is then untouched. dropped
  /// gets the arrays that the format has no form for, as "point NAME" or "cell NAME".
  static bool Write(
    const std::string& path, vtkPolyData* mesh, std::string& error, std::vector<std::string>* dropped = nullptr);
  static bool WritePly(vtkMTTriangleStream& mesh, const std::string& path, std::string& error,
    Precision precision = Precision::Automatic, const Progress& progress = {});
  static bool WriteStl(vtkMTTriangleStream& mesh, const std::string& path, std::string& error);
  static bool WriteObj(vtkMTTriangleStream& mesh, const std::string& path, std::string& error);
  static bool WriteGltf(vtkMTTriangleStream& mesh, const std::string& path, bool binary, std::string& error,
    std::vector<std::string>* dropped = nullptr);
  ///@}
};

#endif
