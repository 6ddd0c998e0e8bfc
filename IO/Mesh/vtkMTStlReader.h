// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTStlReader
 * @brief reads a mesh from STL, safely
 *
 * A file is binary when its size is the one that its triangle count asks for, or when it does not begin with "solid"
 * or has zero bytes; else it is text. (Many binary files begin with "solid" too.) A binary file that is truncated is
 * refused, and so is a text that ends before "endsolid"; what else is wrong with a file is counted in the report. Every
 * triangle gets three points of its own, as the file has them: what belongs together is for the builder to find out.
 *
 * Cell arrays: the scalars "RGB" (uchar x 3) where triangles have colours (vtkMTStlBinary says how), and "SolidIds"
 * (int) where there are several solids, with their names as the annotations of its lookup table. Normals are left out:
 * they follow from the points.
 */
#ifndef vtkMTStlReader_h
#define vtkMTStlReader_h

#include "vtkMTIOMeshModule.h" // For export macro
#include "vtkMTInputReport.h"

#include <string>

class vtkMTByteSource;
class vtkPolyData;

class VTKMTIOMESH_EXPORT vtkMTStlReader
{
public:
  ///@{
  /// False, with the reason in error, and an empty output when the file cannot be read whole. A file without triangles
  /// is not an error. The report gets what was not read as it is in the file.
  static bool Read(const std::string& path, vtkPolyData* output, std::string& error);
  static bool Read(
    const vtkMTByteSource& bytes, vtkPolyData* output, std::string& error, vtkMTInputReport* report = nullptr);
  ///@}
};

#endif
