// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPartition.h"

vtkMTPartition::~vtkMTPartition() = default;

void vtkMTPartition::LocateAll(const std::array<double, 3>* points, std::size_t count, std::uint32_t* regions) const
{
  for (std::size_t i = 0; i < count; ++i)
  {
    regions[i] = this->Locate(points[i]);
  }
}

vtkMTBarycentreScan::~vtkMTBarycentreScan() = default;
