// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTArrayScan.h"

#include <algorithm>

vtkMTArrayScan::vtkMTArrayScan(const std::vector<std::array<double, 3>>& barycentres)
  : Barycentres(barycentres)
{
}

vtkMTArrayScan::~vtkMTArrayScan() = default;

std::size_t vtkMTArrayScan::GetNumberOfTriangles() const
{
  return this->Barycentres.size();
}

bool vtkMTArrayScan::Scan(const Block& block)
{
  // Nothing is copied, so blocks may be large: threads that share one wait for each other at its end.
  constexpr std::size_t blockSize = 65536;
  for (std::size_t begin = 0; begin < this->Barycentres.size(); begin += blockSize)
  {
    block(this->Barycentres.data() + begin, std::min(blockSize, this->Barycentres.size() - begin));
  }
  return true;
}
