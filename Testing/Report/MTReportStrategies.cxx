// SPDX-License-Identifier: BSD-3-Clause
#include "MTReportStrategies.h"

#include "vtkMTHexagonPartition.h"
#include "vtkMTKdPartition.h"
#include "vtkMTQuadPartition.h"
#include "vtkMTRegularPartition.h"
#include "vtkMTVoronoiPartition.h"

namespace
{
vtkSmartPointer<vtkMTPartitionStrategy> MakeVoronoi(int seedPlacement)
{
  auto strategy = vtkSmartPointer<vtkMTVoronoiPartition>::New();
  strategy->SetSeedPlacement(seedPlacement);
  return strategy;
}
}

const std::vector<MTReportStrategy>& MTReportGetStrategies()
{
  static const std::vector<MTReportStrategy> strategies{
    { "Voronoi, seeds along a curve", MakeVoronoi(vtkMTVoronoiPartition::ALONG_CURVE) },
    { "Voronoi, radius scan", MakeVoronoi(vtkMTVoronoiPartition::RADIUS_SCAN) },
    { "regular", vtkSmartPointer<vtkMTRegularPartition>::New() },
    { "k-d tree", vtkSmartPointer<vtkMTKdPartition>::New() },
    { "quads", vtkSmartPointer<vtkMTQuadPartition>::New() },
    { "hexagons", vtkSmartPointer<vtkMTHexagonPartition>::New() },
  };
  return strategies;
}
