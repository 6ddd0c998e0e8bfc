// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTStlReader
 * @brief reads a mesh from STL, safely
 *
 * A file is binary when its size is the one that its triangle count asks for, or when it does not begin with "solid";
 * else it is text. (Many binary files begin with "solid" too.) A binary file that is truncated, or has whole records
 * more than it announces, is refused, and so is a text that ends before "endsolid". Every triangle gets three points of
 * its own, as the file has them: what belongs together is for the builder to find out. Normals and attribute bytes are
 * left out: they follow from the points, or mean something different in every program.
 */
#ifndef vtkMTStlReader_h
#define vtkMTStlReader_h

#include "vtkMTIOMeshModule.h" // For export macro

#include <string>

class vtkMTByteSource;
class vtkPolyData;

class VTKMTIOMESH_EXPORT vtkMTStlReader
{
public:
  ///@{
  /// False, with the reason in error, and an empty output when the file cannot be read whole. A file without triangles
  /// is not an error.
  static bool Read(const std::string& path, vtkPolyData* output, std::string& error);
  static bool Read(const vtkMTByteSource& bytes, vtkPolyData* output, std::string& error);
  ///@}
};

#endif
