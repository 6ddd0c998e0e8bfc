// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPartitionAlgorithm.h"

#include "Interpreter/vtkMTLongWork.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMTCellBarycentres.h"
#include "vtkMTCompatibility.h"
#include "vtkMTVoronoiPartition.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <exception>

vtkMTPartitionAlgorithm::vtkMTPartitionAlgorithm()
  : PartitionStrategy(vtkSmartPointer<vtkMTVoronoiPartition>::New())
{
}

vtkMTPartitionAlgorithm::~vtkMTPartitionAlgorithm() = default;

void vtkMTPartitionAlgorithm::SetPartitionStrategy(vtkMTPartitionStrategy* strategy)
{
  if (this->PartitionStrategy != strategy)
  {
    this->PartitionStrategy = strategy;
    this->Modified();
  }
}

vtkMTPartitionStrategy* vtkMTPartitionAlgorithm::GetPartitionStrategy()
{
  return this->PartitionStrategy;
}

vtkMTimeType vtkMTPartitionAlgorithm::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->PartitionStrategy ? std::max(own, this->PartitionStrategy->GetMTime()) : own;
}

std::unique_ptr<vtkMTPartition> vtkMTPartitionAlgorithm::Partition(
  const Barycentres& barycentres, double target, int level, double progress, double progressAfter)
{
  return vtkMTCellBarycentres::Build(*this->PartitionStrategy, barycentres, target, level,
    [this, progress, progressAfter](double share)
    {
      this->UpdateProgress(progress + (progressAfter - progress) * share);
      return !vtkMTIsAborted(this);
    });
}

bool vtkMTPartitionAlgorithm::CountAndAddRegions(vtkPolyData* output)
{
  const Barycentres barycentres = vtkMTCellBarycentres::Make(output);
  const std::size_t notFinite = vtkMTCellBarycentres::CountNotFinite(barycentres);
  if (notFinite > 0)
  {
    vtkWarningMacro(<< notFinite << " cells have no finite barycentre; they are in region 0.");
  }
  return this->AddRegions(barycentres, output);
}

int vtkMTPartitionAlgorithm::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const vtkMTLongWork work;
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  this->Reset();
  this->SetErrorCode(vtkErrorCode::NoError);
  if (!this->PartitionStrategy)
  {
    this->SetErrorCode(vtkErrorCode::UserError);
    vtkErrorMacro("There is no partition strategy.");
    return 0;
  }
  output->ShallowCopy(vtkPolyData::GetData(inputVector[0]));
  try
  {
    if (this->CountAndAddRegions(output))
    {
      this->UpdateProgress(1.0);
      return 1;
    }
    output->Initialize(); // nothing but an abort makes a scan over memory fail
    this->Reset();
    return 1;
  }
  catch (const std::exception& error)
  {
    output->Initialize();
    this->SetErrorCode(vtkErrorCode::UnknownError);
    vtkErrorMacro("The mesh cannot be partitioned: " << error.what());
    return 0;
  }
}

void vtkMTPartitionAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
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
}
