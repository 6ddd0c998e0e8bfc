// SPDX-License-Identifier: BSD-3-Clause
#include "MTReportMeshes.h"

#include "MTTestMeshes.h"
#include "bmtInput.h"
#include "vtkMTFractalSphereSource.h"

#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTriangleFilter.h"

#include <cmath>
#include <filesystem>

namespace
{
MTReportMeshes::Mesh KeepTriangles(vtkPolyData* mesh)
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(mesh);
  triangles->PassVertsOff();
  triangles->PassLinesOff();
  triangles->Update();
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(triangles->GetOutput()->GetPoints());
  result->SetPolys(triangles->GetOutput()->GetPolys());
  return result;
}
}

MTReportMeshes::Mesh MTReportMeshes::MakeFractalSphere(int triangles)
{
  vtkNew<vtkMTFractalSphereSource> source;
  source->SetNumberOfTriangles(triangles);
  source->Update();
  return KeepTriangles(source->GetOutput());
}

MTReportMeshes::Mesh MTReportMeshes::MakeTorus(int triangles)
{
  const int across = static_cast<int>(std::sqrt(triangles / 4.0));
  return KeepTriangles(MTTestMeshes::Torus(2 * across, across));
}

MTReportMeshes::Mesh MTReportMeshes::MakeTerrain(int triangles)
{
  const int side = static_cast<int>(std::sqrt(0.5 * triangles)) + 1;
  return KeepTriangles(MTTestMeshes::Terrain(side, side));
}

MTReportMeshes::Mesh MTReportMeshes::Read(const std::string& file)
{
  vtkNew<vtkPolyData> mesh;
  bmtReadInput(bmtInput(file), mesh);
  return KeepTriangles(mesh);
}

std::string MTReportMeshes::GetShortName(const std::string& file)
{
  return std::filesystem::path(file).stem().string();
}
