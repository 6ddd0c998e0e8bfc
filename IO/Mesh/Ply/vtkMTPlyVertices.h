// SPDX-License-Identifier: BSD-3-Clause
// Rows of a PLY file's vertices as the points of a polydata, with their arrays. Not installed.
#ifndef vtkMTPlyVertices_h
#define vtkMTPlyVertices_h

#include "vtkMTPlyColumns.h"

class vtkMTPlyRows;
class vtkPolyData;

/// The whole element or a part of it: whoever reads a file at once and whoever reads it in parts get the same arrays.
class vtkMTPlyVertices
{
public:
  /// Gives the output so many points, and all arrays that the element has, colours as the file has them. The element
  /// must have x, y and z, and outlive this.
  vtkMTPlyVertices(
    const vtkMTPlyElement& element, const vtkMTPlyColors& colors, std::uint64_t count, vtkPolyData* output);

  /// Reads as many rows as there are points; those that cannot be read become NaN. False on failure; the rows say why.
  bool Read(vtkMTPlyRows& rows);

private:
  bool ReadRow(vtkMTPlyRows& rows, std::uint64_t row);

  const vtkMTPlyElement& Element;
  const std::uint64_t Count;
  vtkMTPlyColumns Columns;
};

#endif
