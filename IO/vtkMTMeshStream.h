// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTMeshStream
 * @brief mesh files as triangle streams that are never in memory whole
 *
 * PLY (text, and binary of either byte order) and binary STL are read in pieces of 65535 points or triangles; points,
 * arrays and triangles are those that vtkMTMeshReader and vtkMTPolyDataStream would give for the whole file. A PLY file
 * is read through once when it is opened, to see that it is whole and that all of its faces are triangles: polygons
 * need their points' places, texture coordinates of wedges need all faces, and strips need their points, so such files
 * are not streamed. Other formats are not streamed either.
 */
#ifndef vtkMTMeshStream_h
#define vtkMTMeshStream_h

#include "vtkMTIOModule.h" // For export macro
#include "vtkMTTriangleStream.h"

#include <memory>
#include <string>

struct VTKMTIO_EXPORT vtkMTMeshStream
{
  /**
   * Null when the file is of a kind that is not streamed, or is damaged: vtkMTMeshReader reads it whole, or says what
   * is wrong with it. The file must not change while the stream lives.
   */
  static std::unique_ptr<vtkMTTriangleStream> Open(const std::string& path);
};

#endif
