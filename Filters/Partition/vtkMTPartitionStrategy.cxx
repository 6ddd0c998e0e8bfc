// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPartitionStrategy.h"

vtkMTPartitionStrategy::vtkMTPartitionStrategy() = default;

vtkMTPartitionStrategy::~vtkMTPartitionStrategy() = default;

void vtkMTPartitionStrategy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "StrategyName: " << this->GetStrategyName() << "\n";
  os << indent << "Settings: " << this->GetSettings() << "\n";
}
