// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTVerifyOffInput
 * @brief reads OFF for the verification, after the format's description alone (Geomview's manual)
 *
 * Text with the keywords OFF, COFF, NOFF, CNOFF, STOFF and so on, or none: coordinates, normals, colours and texture
 * coordinates of vertices in that order; polygons with a colour of three or four numbers, whole ones from 0 to 255 or
 * real ones from 0 to 1. Four-dimensional, n-dimensional and binary files are not read.
 */
#ifndef vtkMTVerifyOffInput_h
#define vtkMTVerifyOffInput_h

#include "vtkMTVerificationModule.h" // For export macro

#include <string>

class vtkPolyData;

class VTKMTVERIFICATION_EXPORT vtkMTVerifyOffInput
{
public:
  static bool Read(const std::string& path, vtkPolyData* out, std::string& error);
};

#endif
