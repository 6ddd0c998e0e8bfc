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

int vtkMTPartitionSequence::CountLevels(std::size_t cells) const
{
  int levels = cells > 0 ? 1 : 0;
  for (double target = this->FirstTarget; target < static_cast<double>(cells); target *= this->Growth)
  {
    ++levels;
  }
  return levels;
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
  const int levels = this->CountLevels(barycentres.size());
  double target = this->FirstTarget;
  for (int level = 0; level < levels; ++level, target *= this->Growth)
  {
    const auto partition = vtkMTCellBarycentres::Build(*this->PartitionStrategy, barycentres, target, level,
      [this, level, levels](double share)
      {
        this->UpdateProgress(0.1 + 0.9 * (level + share) / levels);
        return !this->GetAbortExecute();
      });
    if (!partition)
    {
      output->Initialize(); // nothing but an abort makes a scan over memory fail
      return 1;
    }
    const auto regions = vtkMTCellBarycentres::MakeRegionArray(
      *partition, barycentres, this->RegionArrayPrefix + std::to_string(level));
    output->GetCellData()->AddArray(regions);
    if (level == 0)
    {
      output->GetCellData()->SetActiveScalars(regions->GetName());
    }
  }
  this->NumberOfLevels = levels;
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
