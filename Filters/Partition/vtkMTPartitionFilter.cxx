// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPartitionFilter.h"

#include "vtkCellData.h"
#include "vtkErrorCode.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMTCellBarycentres.h"
#include "vtkMTVoronoiPartition.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <exception>

vtkStandardNewMacro(vtkMTPartitionFilter);

vtkMTPartitionFilter::vtkMTPartitionFilter()
  : PartitionStrategy(vtkSmartPointer<vtkMTVoronoiPartition>::New())
{
}

vtkMTPartitionFilter::~vtkMTPartitionFilter() = default;

void vtkMTPartitionFilter::SetPartitionStrategy(vtkMTPartitionStrategy* strategy)
{
  if (this->PartitionStrategy != strategy)
  {
    this->PartitionStrategy = strategy;
    this->Modified();
  }
}

vtkMTPartitionStrategy* vtkMTPartitionFilter::GetPartitionStrategy()
{
  return this->PartitionStrategy;
}

vtkMTimeType vtkMTPartitionFilter::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->PartitionStrategy ? std::max(own, this->PartitionStrategy->GetMTime()) : own;
}

int vtkMTPartitionFilter::Partition(vtkPolyData* output)
{
  const auto barycentres = vtkMTCellBarycentres::Make(output);
  const std::size_t notFinite = vtkMTCellBarycentres::CountNotFinite(barycentres);
  if (notFinite > 0)
  {
    vtkWarningMacro(<< notFinite << " cells have no finite barycentre; they are in region 0.");
  }
  this->UpdateProgress(0.2);
  const auto partition =
    vtkMTCellBarycentres::Build(*this->PartitionStrategy, barycentres, this->TargetTriangles, this->Level,
      [this](double share)
      {
        this->UpdateProgress(0.2 + 0.7 * share);
        return !this->GetAbortExecute();
      });
  if (!partition)
  {
    output->Initialize(); // nothing but an abort makes a scan over memory fail
    return 1;
  }
  this->NumberOfRegions = barycentres.empty() ? 0 : static_cast<vtkIdType>(partition->GetNumberOfRegions());
  output->GetCellData()->SetScalars(
    vtkMTCellBarycentres::MakeRegionArray(*partition, barycentres, this->RegionArrayName));
  this->UpdateProgress(1.0);
  return 1;
}

int vtkMTPartitionFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  this->NumberOfRegions = 0;
  this->SetErrorCode(vtkErrorCode::NoError);
  if (!this->PartitionStrategy)
  {
    this->SetErrorCode(vtkErrorCode::UserError);
    vtkErrorMacro("There is no partition strategy.");
    return 0;
  }
  output->ShallowCopy(input);
  try
  {
    return this->Partition(output);
  }
  catch (const std::exception& error)
  {
    output->Initialize();
    this->SetErrorCode(vtkErrorCode::UnknownError);
    vtkErrorMacro("The mesh cannot be partitioned: " << error.what());
    return 0;
  }
}

void vtkMTPartitionFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PartitionStrategy: ";
  if (this->PartitionStrategy)
  {
    os << "\n";
    this->PartitionStrategy->PrintSelf(os, indent.GetNextIndent());
  }
  else
  {
    os << "(none)\n";
  }
  os << indent << "TargetTriangles: " << this->TargetTriangles << "\n";
  os << indent << "Level: " << this->Level << "\n";
  os << indent << "RegionArrayName: " << this->RegionArrayName << "\n";
  os << indent << "NumberOfRegions: " << this->NumberOfRegions << "\n";
}
