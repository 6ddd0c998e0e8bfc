// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPartitionSequence.h"

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
#include <cmath>
#include <exception>

vtkStandardNewMacro(vtkMTPartitionSequence);

vtkMTPartitionSequence::vtkMTPartitionSequence()
  : PartitionStrategy(vtkSmartPointer<vtkMTVoronoiPartition>::New())
{
}

vtkMTPartitionSequence::~vtkMTPartitionSequence() = default;

void vtkMTPartitionSequence::SetPartitionStrategy(vtkMTPartitionStrategy* strategy)
{
  if (this->PartitionStrategy != strategy)
  {
    this->PartitionStrategy = strategy;
    this->Modified();
  }
}

vtkMTPartitionStrategy* vtkMTPartitionSequence::GetPartitionStrategy()
{
  return this->PartitionStrategy;
}

vtkMTimeType vtkMTPartitionSequence::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->PartitionStrategy ? std::max(own, this->PartitionStrategy->GetMTime()) : own;
}

void vtkMTPartitionSequence::AddRegions(
  const vtkMTPartition& partition, const std::vector<std::array<double, 3>>& barycentres, vtkPolyData* output)
{
  const auto regions = vtkMTCellBarycentres::MakeRegionArray(
    partition, barycentres, this->RegionArrayPrefix + std::to_string(this->NumberOfLevels));
  output->GetCellData()->AddArray(regions);
  if (this->NumberOfLevels++ == 0)
  {
    output->GetCellData()->SetActiveScalars(regions->GetName());
  }
}

int vtkMTPartitionSequence::Partition(vtkPolyData* output)
{
  const auto barycentres = vtkMTCellBarycentres::Make(output);
  const std::size_t notFinite = vtkMTCellBarycentres::CountNotFinite(barycentres);
  if (notFinite > 0)
  {
    vtkWarningMacro(<< notFinite << " cells have no finite barycentre; they are in region 0.");
  }
  this->UpdateProgress(0.1);
  double target = this->FirstTarget;
  double done = 0.1;
  for (bool last = barycentres.empty(); !last; target *= this->Growth)
  {
    // As many levels are left as the target must grow to reach the whole mesh, or one less.
    const double left = std::log(static_cast<double>(barycentres.size()) / target) / std::log(this->Growth);
    const double share = (1.0 - done) / (1.0 + std::max(0.0, std::ceil(left)));
    const auto partition =
      vtkMTCellBarycentres::Build(*this->PartitionStrategy, barycentres, target, this->NumberOfLevels,
        [this, done, share](double part)
        {
          this->UpdateProgress(done + share * part);
          return !this->GetAbortExecute();
        });
    if (!partition)
    {
      output->Initialize(); // nothing but an abort makes a scan over memory fail
      this->NumberOfLevels = 0;
      return 1;
    }
    this->AddRegions(*partition, barycentres, output);
    last = partition->GetNumberOfRegions() == 1;
    done += share;
  }
  this->UpdateProgress(1.0);
  return 1;
}

int vtkMTPartitionSequence::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  this->NumberOfLevels = 0;
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

void vtkMTPartitionSequence::PrintSelf(ostream& os, vtkIndent indent)
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
  os << indent << "FirstTarget: " << this->FirstTarget << "\n";
  os << indent << "Growth: " << this->Growth << "\n";
  os << indent << "RegionArrayPrefix: " << this->RegionArrayPrefix << "\n";
  os << indent << "NumberOfLevels: " << this->NumberOfLevels << "\n";
}
