// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTMeshReader
 * @brief reads a mesh file of whatever format into polydata
 *
 * The content decides where it is unmistakable (PLY, GLB, VTK's own formats, XML), else the ending of the name, in
 * upper or lower case:
 *
 * - PLY: vtkMTPlyReader; STL: vtkMTStlReader; OBJ: vtkMTObjReader;
 * - VTP, and VTK's legacy format (.vtk) with a polydata in it: VTK's readers;
 * - glTF and GLB: vtkMTGltfReader; all meshes of the scene, at the places that their nodes give them, as one mesh;
 * texture coordinates are turned to count from the image's bottom, as VTK does.
 *
 * Polygons, strips, lines and vertices stay as they are; vtkMTPolyDataStream makes triangles of them. A mesh without
 * polygons and strips is an error here, and so is everything that a VTK reader reports as one: a part of a file is
 * never taken for the whole.
 */
#ifndef vtkMTMeshReader_h
#define vtkMTMeshReader_h

#include "vtkMTIOMeshModule.h" // For export macro

#include <cstdint>
#include <map>
#include <string>

class vtkPolyData;

class VTKMTIOMESH_EXPORT vtkMTMeshReader
{
public:
  using Counts = std::map<std::string, std::int64_t>;

  /// False, with the reason in error, and an empty output when there is no mesh. What the reader left out or made up is
  /// added to counts, by reason; may be null.
  static bool Read(const std::string& path, vtkPolyData* output, std::string& error, Counts* counts = nullptr);
};

#endif
