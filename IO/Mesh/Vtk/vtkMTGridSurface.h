// SPDX-License-Identifier: BSD-3-Clause
// The surface of a dataset. Not installed.
#ifndef vtkMTGridSurface_h
#define vtkMTGridSurface_h

#include "vtkMTInputReport.h"

#include <string>

class vtkDataSet;
class vtkPolyData;

struct vtkMTGridSurface
{
  /// Whether it is polydata or a grid with cells of its own, not an image.
  static bool CanTake(vtkDataSet* dataset);

  /// Polydata as they are; of a grid its surface, when its cells and arrays are sound. False with the reason in error.
  static bool Take(vtkDataSet* dataset, vtkPolyData* output, vtkMTInputReport& report, std::string& error);
};

#endif
