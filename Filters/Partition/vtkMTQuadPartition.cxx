// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTQuadPartition.h"

#include "Domain/vtkMTQuadFamilies.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkMTQuadPartition);

vtkMTQuadPartition::vtkMTQuadPartition() = default;

vtkMTQuadPartition::~vtkMTQuadPartition() = default;

std::unique_ptr<vtkMTDomainFamilies> vtkMTQuadPartition::MakeFamilies(
  const vtkMTDomain& domain, double largest, bool isOddLevel) const
{
  return std::make_unique<vtkMTQuadFamilies>(domain, largest, isOddLevel);
}
