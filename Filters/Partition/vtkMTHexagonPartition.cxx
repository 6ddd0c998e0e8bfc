// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTHexagonPartition.h"

#include "Domain/vtkMTHexagonFamilies.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkMTHexagonPartition);

vtkMTHexagonPartition::vtkMTHexagonPartition() = default;

vtkMTHexagonPartition::~vtkMTHexagonPartition() = default;

std::unique_ptr<vtkMTDomainFamilies> vtkMTHexagonPartition::MakeFamilies(
  const vtkMTDomain& domain, double largest, bool isOddLevel) const
{
  return std::make_unique<vtkMTHexagonFamilies>(domain, largest, isOddLevel);
}
