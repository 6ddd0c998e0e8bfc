// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTVerifyVtkInput
 * @brief reads VTK's own formats for the verification, by VTK's readers
 *
 * .vtp, .vtu, .vtm and legacy .vtk; of unstructured and structured grids the surface (vtkDataSetSurfaceFilter), of
 * several blocks all, one after the other: arrays that a block lacks are NaN there. GetReader names the class that
 * read. Nothing is done about broken indices here.
 */
#ifndef vtkMTVerifyVtkInput_h
#define vtkMTVerifyVtkInput_h

#include "vtkMTVerificationModule.h" // For export macro

#include <string>
#include <vector>

class vtkPolyData;

class VTKMTVERIFICATION_EXPORT vtkMTVerifyVtkInput
{
public:
  static bool Read(const std::string& path, vtkPolyData* out, std::string& error);
  /// By the ending of the name; null where it is none of these formats.
  static const char* GetReader(const std::string& ending);
  /// One after the other. Arrays are matched by name and components and become doubles; with addPart, cells get an
  /// array PartId, and an earlier one is called InputPartId.
  static void Append(const std::vector<vtkPolyData*>& parts, bool addPart, vtkPolyData* out);
};

#endif
