// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPartitionStrategy.h"

#include "vtkMTKdPartition.h"
#include "vtkMTRegularPartition.h"
#include "vtkMTVoronoiPartition.h"

vtkMTPartitionStrategy::vtkMTPartitionStrategy() = default;

vtkMTPartitionStrategy::~vtkMTPartitionStrategy() = default;

vtkSmartPointer<vtkMTPartitionStrategy> vtkMTPartitionStrategy::MakeByName(const std::string& name)
{
  if (name == "v")
  {
    return vtkSmartPointer<vtkMTVoronoiPartition>::New();
  }
  if (name == "regular")
  {
    return vtkSmartPointer<vtkMTRegularPartition>::New();
  }
  if (name == "kd")
  {
    return vtkSmartPointer<vtkMTKdPartition>::New();
  }
  return nullptr;
}

void vtkMTPartitionStrategy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "StrategyName: " << this->GetStrategyName() << "\n";
  os << indent << "Settings: " << this->GetSettings() << "\n";
}
