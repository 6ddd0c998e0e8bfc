// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTMeshStream
 * @brief mesh files as triangle streams that are never in memory whole
 *
 * PLY (text, and binary of either byte order), STL (binary and text), OBJ and VTP (inline or appended, as text, raw,
 * base64, compressed or not) are read in chunks of 65535 points or cells; points, arrays and triangles are those that
 * vtkMTMeshReader and vtkMTPolyDataStream would give for the whole file. A file is read through once when it is opened,
 * to see that it is whole and what its cells are. What needs more than a look at one chunk is done by external sorting
 * (vtkMTRecordSort) in a spool store: the places of polygons' corners, by which they are triangulated, and the
 * wedges of OBJ, whose corners have texture coordinates and normals of their own.
 *
 * Not streamed are PLY files with triangle strips, other elements or texture coordinates of corners, VTP files of
 * several pieces, with strips or of several time steps, and all other formats.
 */
#ifndef vtkMTMeshStream_h
#define vtkMTMeshStream_h

#include "vtkMTIOMeshModule.h" // For export macro
#include "vtkMTTriangleStream.h"
#include "vtkSmartPointer.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

class vtkMTSpoolStore;
class vtkPolyData;

struct VTKMTIOMESH_EXPORT vtkMTMeshStream
{
  struct Settings
  {
    /// For temporary data; must outlive the stream. Default: none; then OBJ and polygons are not streamed.
    vtkMTSpoolStore* Store = nullptr;
    /// Bytes for sorting while a file is opened. Default 64 MiB.
    std::size_t Memory = std::size_t(64) << 20;
    /// Text STL, OBJ and VTP files smaller than this, in bytes, are not streamed: reading them whole is faster.
    /// Default 0.
    std::uint64_t LeastSize = 0;
  };

  /**
   * Null when the file is of a kind that is not streamed, or is damaged: vtkMTMeshReader reads it whole, or says what
   * is wrong with it. The file must not change while the stream lives. names: gets the field data that the whole file
   * would have (names of textures and materials); without it files that have some are not streamed.
   */
  static std::unique_ptr<vtkMTTriangleStream> Open(const std::string& path, vtkPolyData* names = nullptr);
  static std::unique_ptr<vtkMTTriangleStream> Open(
    const std::string& path, const Settings& settings, vtkPolyData* names = nullptr);
  /**
   * Several files as one stream, which gives what vtkMTMeshMerge gives of the whole files. names: one for each file.
   * cells: gets the number of cells of each. Null also where their arrays differ or one has vertices or lines.
   */
  static std::unique_ptr<vtkMTTriangleStream> OpenAll(const std::vector<std::string>& paths, const Settings& settings,
    const std::vector<vtkSmartPointer<vtkPolyData>>& names, std::vector<std::uint64_t>& cells);
};

#endif
