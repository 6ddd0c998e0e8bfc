// SPDX-License-Identifier: BSD-3-Clause
// Meshes of the report: generated ones, and files. All are triangles and points alone.
#ifndef MTReportMeshes_h
#define MTReportMeshes_h

#include "vtkSmartPointer.h"

#include <string>

class vtkPolyData;

namespace MTReportMeshes
{
using Mesh = vtkSmartPointer<vtkPolyData>;

/// vtkMTFractalSphereSource: rough at every scale.
Mesh MakeFractalSphere(int triangles);
/// A torus of about so many triangles: smooth and closed.
Mesh MakeTorus(int triangles);
/// A height field of about so many triangles: open.
Mesh MakeTerrain(int triangles);
/// Any input that bmt takes. Throws bmtError.
Mesh Read(const std::string& file);
/// A file's name without folder and ending.
std::string GetShortName(const std::string& file);
}

#endif
