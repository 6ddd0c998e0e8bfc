// SPDX-License-Identifier: BSD-3-Clause
// OBJ files as a triangle stream. Not installed.
#ifndef vtkMTObjStream_h
#define vtkMTObjStream_h

#include "vtkMTMeshStream.h"

struct vtkMTObjStream
{
  /// Null unless the file is OBJ with faces, and sound. See vtkMTMeshStream::Open.
  static std::unique_ptr<vtkMTTriangleStream> Open(
    const std::string& path, const vtkMTMeshStream::Settings& settings, vtkPolyData* names);
};

#endif
