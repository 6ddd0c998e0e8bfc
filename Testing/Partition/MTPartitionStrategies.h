// SPDX-License-Identifier: BSD-3-Clause
// The strategies that are tested, by name.
#ifndef MTPartitionStrategies_h
#define MTPartitionStrategies_h

#include "vtkMTHexagonPartition.h"
#include "vtkMTKdPartition.h"
#include "vtkMTQuadPartition.h"
#include "vtkMTRegularPartition.h"
#include "vtkMTVoronoiPartition.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace MTPartitionTest
{
inline std::vector<std::string> GetStrategyNames()
{
  return { "AlongCurve", "RadiusScan", "Regular", "Kd", "Quad", "Hexagon" };
}

inline vtkSmartPointer<vtkMTPartitionStrategy> MakeStrategy(const std::string& name)
{
  if (name == "Regular")
  {
    return vtkSmartPointer<vtkMTRegularPartition>::New();
  }
  if (name == "Kd")
  {
    return vtkSmartPointer<vtkMTKdPartition>::New();
  }
  if (name == "Quad")
  {
    return vtkSmartPointer<vtkMTQuadPartition>::New();
  }
  if (name == "Hexagon")
  {
    return vtkSmartPointer<vtkMTHexagonPartition>::New();
  }
  const auto strategy = vtkSmartPointer<vtkMTVoronoiPartition>::New();
  strategy->SetSeedPlacement(
    name == "RadiusScan" ? vtkMTVoronoiPartition::RADIUS_SCAN : vtkMTVoronoiPartition::ALONG_CURVE);
  return strategy;
}
}

#endif
