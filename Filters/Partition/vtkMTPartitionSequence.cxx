// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPartitionSequence.h"

#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkMTCellBarycentres.h"
#include "vtkMTSetMacros.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkMTPartitionSequence);
vtkMTCxxSetClampMacro(vtkMTPartitionSequence, Growth, 1.1, 1024.0);
vtkMTCxxSetClampMacro(vtkMTPartitionSequence, FirstTarget, 1.0, 1e12);

vtkMTPartitionSequence::vtkMTPartitionSequence() = default;

vtkMTPartitionSequence::~vtkMTPartitionSequence() = default;

void vtkMTPartitionSequence::Reset()
{
  this->NumberOfLevels = 0;
}

bool vtkMTPartitionSequence::AddRegions(const Barycentres& barycentres, vtkPolyData* output)
{
  double target = this->FirstTarget;
  double done = 0.1;
  for (bool last = barycentres.empty(); !last; target *= this->Growth)
  {
    // As many levels are left as the target must grow to reach the whole mesh, or one less.
    const double left = std::log(static_cast<double>(barycentres.size()) / target) / std::log(this->Growth);
    const double share = (1.0 - done) / (1.0 + std::max(0.0, std::ceil(left)));
    const auto partition = this->Partition(barycentres, target, this->NumberOfLevels, done, done + share);
    if (!partition)
    {
      return false;
    }
    const auto regions = vtkMTCellBarycentres::MakeRegionArray(
      *partition, barycentres, this->RegionArrayPrefix + std::to_string(this->NumberOfLevels));
    output->GetCellData()->AddArray(regions);
    if (this->NumberOfLevels++ == 0)
    {
      output->GetCellData()->SetActiveScalars(regions->GetName());
    }
    last = partition->GetNumberOfRegions() == 1;
    done += share;
  }
  return true;
}

void vtkMTPartitionSequence::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FirstTarget: " << this->FirstTarget << "\n";
  os << indent << "Growth: " << this->Growth << "\n";
  os << indent << "RegionArrayPrefix: " << this->RegionArrayPrefix << "\n";
  os << indent << "NumberOfLevels: " << this->NumberOfLevels << "\n";
}
