// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTMeshWriter
 * @brief writes a triangle mesh as PLY, STL, OBJ or VTP
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
 *
 * PLY and OBJ are written block by block, in memory that does not grow with the mesh; STL needs all points at hand.
 */
#ifndef vtkMTMeshWriter_h
#define vtkMTMeshWriter_h

#include "vtkMTIOModule.h" // For export macro

#include <functional>
#include <string>

class vtkMTTriangleStream;
class vtkPolyData;

class VTKMTIO_EXPORT vtkMTMeshWriter
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
  /// False, with the reason in error, when the file could not be written; an earlier one is then untouched.
  static bool Write(const std::string& path, vtkPolyData* mesh, std::string& error);
  static bool WritePly(vtkMTTriangleStream& mesh, const std::string& path, std::string& error,
    Precision precision = Precision::Automatic, const Progress& progress = {});
  static bool WriteStl(vtkMTTriangleStream& mesh, const std::string& path, std::string& error);
  static bool WriteObj(vtkMTTriangleStream& mesh, const std::string& path, std::string& error);
  ///@}
};

#endif
