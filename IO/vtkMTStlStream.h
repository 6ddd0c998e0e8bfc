// SPDX-License-Identifier: BSD-3-Clause
// Binary STL as a triangle stream. Not installed.
#ifndef vtkMTStlStream_h
#define vtkMTStlStream_h

#include "vtkMTTriangleStream.h"

#include <memory>
#include <string>

struct vtkMTStlStream
{
  /// Null unless the file is named .stl and its size is that of a binary STL file with triangles.
  static std::unique_ptr<vtkMTTriangleStream> Open(const std::string& path);
};

#endif
