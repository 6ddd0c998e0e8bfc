// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTVerifyStlInput
 * @brief reads STL for the verification, after the format's description alone (3D Systems, 1989)
 *
 * Binary where the size of the file is that of a whole number of records, or where no word "facet" follows a "solid";
 * a count that disagrees with the size is overruled by it where the file has more. Facet colours: VisCAM's (bit 15 set,
 * blue lowest) or, where the header has "COLOR=", Magics' (bit 15 clear, red lowest; the header's colour else). Solids
 * of a text file are an array of names.
 */
#ifndef vtkMTVerifyStlInput_h
#define vtkMTVerifyStlInput_h

#include "vtkMTVerificationModule.h" // For export macro

#include <string>

class vtkPolyData;

class VTKMTVERIFICATION_EXPORT vtkMTVerifyStlInput
{
public:
  static bool Read(const std::string& path, vtkPolyData* out, std::string& error);
};

#endif
