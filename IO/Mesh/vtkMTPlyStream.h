// SPDX-License-Identifier: BSD-3-Clause
// PLY files as a triangle stream. Not installed.
#ifndef vtkMTPlyStream_h
#define vtkMTPlyStream_h

#include "vtkMTMeshStream.h"

struct vtkMTPlyStream
{
  /// Null unless the file is PLY with the elements vertex and face, and whole. See vtkMTMeshStream::Open.
  static std::unique_ptr<vtkMTTriangleStream> Open(
    const std::string& path, const vtkMTMeshStream::Settings& settings, vtkPolyData* names);
};

#endif
