// SPDX-License-Identifier: BSD-3-Clause
// STL files as a triangle stream. Not installed.
#ifndef vtkMTStlStream_h
#define vtkMTStlStream_h

#include "vtkMTMeshStream.h"

struct vtkMTStlStream
{
  /// Null unless the file is STL, binary or text, and whole. See vtkMTMeshStream::Open.
  static std::unique_ptr<vtkMTTriangleStream> Open(
    const std::string& path, const vtkMTMeshStream::Settings& settings, vtkPolyData* names);
};

#endif
