// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTVtkReader
 * @brief reads what VTK's own formats hold as a mesh: polydata, and the surfaces of other datasets
 *
 * XML: polydata, unstructured, structured and rectilinear grids, and multi-block datasets of those. Legacy: the same
 * without multi-block. Of grids the surface is taken (vtkDataSetSurfaceFilter): faces of one cell alone, and cells that
 * are surfaces themselves. Several blocks become one mesh (vtkMTMeshMerge) whose cell array "PartId" has the names of
 * the blocks as the annotations of its lookup table.
 *
 * VTK's readers do their work, but what they do not look at is checked first: that counts can be true of a file of that
 * size, and before a surface is taken that cells have as many points as their type says, and points that exist.
 */
#ifndef vtkMTVtkReader_h
#define vtkMTVtkReader_h

#include "vtkMTInputReport.h"

#include <string>

class vtkMTByteSource;
class vtkPolyData;

struct vtkMTVtkReader
{
  ///@{
  /// A file by its name; where it is compressed (isCompressed) the bytes are what is in it, and are read into memory.
  /// False with the reason, without the file's name, in error.
  static bool ReadXml(
    const vtkMTByteSource& bytes, bool isCompressed, vtkPolyData* output, std::string& error, vtkMTInputReport& report);
  static bool ReadLegacy(
    const vtkMTByteSource& bytes, bool isCompressed, vtkPolyData* output, std::string& error, vtkMTInputReport& report);
  ///@}
};

#endif
