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
  constexpr std::size_t blockSize = 8192;
  for (std::size_t begin = 0; begin < this->Barycentres.size(); begin += blockSize)
  {
    block(this->Barycentres.data() + begin, std::min(blockSize, this->Barycentres.size() - begin));
  }
  return true;
}
