// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPartitionFilter.h"

#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkMTCellBarycentres.h"
#include "vtkMTSetMacros.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkMTPartitionFilter);
vtkMTCxxSetClampMacro(vtkMTPartitionFilter, TargetTriangles, 1.0, 1e12);

vtkMTPartitionFilter::vtkMTPartitionFilter() = default;

vtkMTPartitionFilter::~vtkMTPartitionFilter() = default;

void vtkMTPartitionFilter::Reset()
{
  this->NumberOfRegions = 0;
}

bool vtkMTPartitionFilter::AddRegions(const Barycentres& barycentres, vtkPolyData* output)
{
  const auto partition = this->Partition(barycentres, this->TargetTriangles, this->Level, 0.2, 0.9);
  if (!partition)
  {
    return false;
  }
  this->NumberOfRegions = barycentres.empty() ? 0 : static_cast<vtkIdType>(partition->GetNumberOfRegions());
  output->GetCellData()->SetScalars(
    vtkMTCellBarycentres::MakeRegionArray(*partition, barycentres, this->RegionArrayName));
  return true;
}

void vtkMTPartitionFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "TargetTriangles: " << this->TargetTriangles << "\n";
  os << indent << "Level: " << this->Level << "\n";
  os << indent << "RegionArrayName: " << this->RegionArrayName << "\n";
  os << indent << "NumberOfRegions: " << this->NumberOfRegions << "\n";
}
