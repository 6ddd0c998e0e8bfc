// SPDX-License-Identifier: BSD-3-Clause
// VTP files as a triangle stream. Not installed.
#ifndef vtkMTVtpStream_h
#define vtkMTVtpStream_h

#include "vtkMTMeshStream.h"

struct vtkMTVtpStream
{
  /// Null unless the file is VTP of one piece, with polygons and without strips. See vtkMTMeshStream::Open.
  static std::unique_ptr<vtkMTTriangleStream> Open(
    const std::string& path, const vtkMTMeshStream::Settings& settings, vtkPolyData* names);
};

#endif
