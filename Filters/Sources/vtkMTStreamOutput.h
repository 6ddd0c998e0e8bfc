// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTStreamOutput
 * @brief fills the polydata of a VTK source from a triangle stream
 */
#ifndef vtkMTStreamOutput_h
#define vtkMTStreamOutput_h

#include <string>

class vtkAlgorithm;
class vtkMTTriangleStream;
class vtkPolyData;

struct vtkMTStreamOutput
{
  /**
   * Points in single precision, and triangles in the order of the stream. The algorithm reports progress and can be
   * aborted. False, with an empty output, when it was aborted and on failure; then error says what failed.
   */
  static bool Fill(vtkMTTriangleStream& stream, vtkAlgorithm* algorithm, vtkPolyData* output, std::string& error);
};

#endif
