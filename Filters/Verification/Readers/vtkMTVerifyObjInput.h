// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTVerifyObjInput
 * @brief reads Wavefront OBJ for the verification, after the format's description alone (Wavefront, appendix B1)
 *
 * Polygons with texture coordinates, normals, colours behind the coordinates ("v x y z r g b" and "... r g b a"),
 * groups and materials. A corner's texture coordinate or normal that the file does not have is NaN; a face with fewer
 * than three corners is none. Everything else is ignored.
 */
#ifndef vtkMTVerifyObjInput_h
#define vtkMTVerifyObjInput_h

#include "vtkMTVerificationModule.h" // For export macro

#include <string>

class vtkPolyData;

class VTKMTVERIFICATION_EXPORT vtkMTVerifyObjInput
{
public:
  static bool Read(const std::string& path, vtkPolyData* out, std::string& error);
};

#endif
