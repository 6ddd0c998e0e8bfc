// SPDX-License-Identifier: BSD-3-Clause
// PLY files of triangles as a triangle stream. Not installed.
#ifndef vtkMTPlyStream_h
#define vtkMTPlyStream_h

#include "vtkMTTriangleStream.h"

#include <memory>
#include <string>

struct vtkMTPlyStream
{
  /// Null unless the file is PLY with the elements vertex and face, whole, and of triangles only.
  static std::unique_ptr<vtkMTTriangleStream> Open(const std::string& path);
};

#endif
