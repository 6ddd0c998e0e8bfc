// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTPlyReader
 * @brief reads a mesh from PLY, safely
 *
 * Text and binary of either byte order, with these elements and properties; everything else is stepped over:
 *
 * - vertex: x y z (any type; double where one of them is double or a 32-bit integer); nx ny nz -> normals "Normals";
 * red green blue (alpha), or diffuse_red ... and other names of colours (vtkMTPlyColors), of any type -> scalars "RGB"
 * or "RGBA" of bytes; s t, u v or texture_u texture_v -> texture coordinates "TCoords"; every other property that is no
 * list -> a point array of its name and type;
 * - face: list vertex_indices (or vertex_index) of any integer type -> polygons; colours and all others that are
 * no lists -> cell arrays; list texcoord, two values per corner -> texture coordinates of wedges: a point
 * whose corners have different ones becomes several points with the same place;
 * - lines "comment TextureFile NAME" -> field data "TextureFiles";
 * - tristrips: list vertex_indices (or vertex_index), -1 between strips -> strips, whose cell values are 0.
 *
 * A line of the header without a keyword is stepped over and counted. So is a record that cannot be used: a line of
 * text that does not hold what the header announces, or a face with a vertex that does not exist. Such a vertex becomes
 * NaN, such a face one without corners, which keeps the numbers of the others; more than a few of them are an error.
 *
 * Unlike VTK 9.1's vtkPLYReader it survives any bytes: every count is checked against the bytes that are left before
 * anything is allocated, every index against the number of vertices, and an error names the element, the row and the
 * byte.
 */
#ifndef vtkMTPlyReader_h
#define vtkMTPlyReader_h

#include "vtkMTIOMeshModule.h" // For export macro
#include "vtkMTInputReport.h"

#include <string>

class vtkMTByteSource;
class vtkPolyData;

class VTKMTIOMESH_EXPORT vtkMTPlyReader
{
public:
  ///@{
  /// False, with the reason in error, and an empty output when the file cannot be read whole. A file without faces is
  /// not an error. The report gets what was not read as it is in the file.
  static bool Read(const std::string& path, vtkPolyData* output, std::string& error);
  static bool Read(
    const vtkMTByteSource& bytes, vtkPolyData* output, std::string& error, vtkMTInputReport* report = nullptr);
  ///@}
};

#endif
