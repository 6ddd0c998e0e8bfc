// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTObjReader
 * @brief reads a mesh from Wavefront OBJ, safely
 *
 * Vertices, texture coordinates (two components), normals, vertex colours where all vertices have them, faces and
 * lines, with positive or negative indices. Points are in single precision unless the text says more than that holds. A
 * point whose corners have different texture coordinates or normals becomes several points with the same place; all
 * others stay one, unlike VTK 9.1's vtkOBJReader, which gives every corner a point of its own and crashes on indices
 * out of range.
 *
 * Arrays: points "TCoords" (float x 2), "Normals" (float x 3), "RGB" (float x 3); cells "MaterialIds" (int, counted in
 * the order of the first use, -1 for none) where a material is named, "GroupIds" (int, counted from 0) where there are
 * several groups; field data "MaterialNames" and "MaterialLibraries". Curves and free-form surfaces are stepped over.
 */
#ifndef vtkMTObjReader_h
#define vtkMTObjReader_h

#include "vtkMTIOMeshModule.h" // For export macro

#include <string>

class vtkMTByteSource;
class vtkPolyData;

class VTKMTIOMESH_EXPORT vtkMTObjReader
{
public:
  ///@{
  /// False, with the reason and the line in error, and an empty output when the file is malformed. A file without faces
  /// is not an error.
  static bool Read(const std::string& path, vtkPolyData* output, std::string& error);
  static bool Read(const vtkMTByteSource& bytes, vtkPolyData* output, std::string& error);
  ///@}
};

#endif
