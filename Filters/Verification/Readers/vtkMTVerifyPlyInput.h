// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTVerifyPlyInput
 * @brief reads PLY for the verification, after the format's description alone (Turk, 1994)
 *
 * ASCII and binary of either order of bytes. Faces and strips of triangles become polygons; of the lists of a face only
 * the vertices are read, elements of other names are passed over. Header lines that begin with no keyword are ignored.
 * Colours ("red", "diffuse_red" and so on) are scaled to 0..1 by their type.
 */
#ifndef vtkMTVerifyPlyInput_h
#define vtkMTVerifyPlyInput_h

#include "vtkMTVerificationModule.h" // For export macro

#include <string>

class vtkPolyData;

class VTKMTVERIFICATION_EXPORT vtkMTVerifyPlyInput
{
public:
  static bool Read(const std::string& path, vtkPolyData* out, std::string& error);
};

#endif
