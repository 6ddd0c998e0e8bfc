// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTParaViewReader.h"

#include "vtkAlgorithm.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMTWholeRanges.h"
#include "vtkMultiTriangulation.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"

vtkStandardNewMacro(vtkMTParaViewReader);

//------------------------------------------------------------------------------
vtkMTParaViewReader::vtkMTParaViewReader() = default;

//------------------------------------------------------------------------------
vtkMTParaViewReader::~vtkMTParaViewReader() = default;

//------------------------------------------------------------------------------
void vtkMTParaViewReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
// The superclass's looks for consumers to warn.
int vtkMTParaViewReader::ComputePipelineMTime(vtkInformation* request, vtkInformationVector** inputVector,
  vtkInformationVector* outputVector, int port, vtkMTimeType* time)
{
  return this->vtkPolyDataAlgorithm::ComputePipelineMTime( // NOLINT(bugprone-parent-virtual-call)
    request, inputVector, outputVector, port, time);
}

//------------------------------------------------------------------------------
int vtkMTParaViewReader::RequestInformation(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  outputVector->GetInformationObject(0)->Set(CAN_HANDLE_PIECE_REQUEST(), 1);
  return this->Superclass::RequestInformation(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
int vtkMTParaViewReader::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (!this->Superclass::RequestData(request, inputVector, outputVector))
  {
    return 0;
  }
  vtkMultiTriangulation* output = vtkMultiTriangulation::GetData(outputVector);
  vtkInformation* info = outputVector->GetInformationObject(0);
  if (info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()) > 0)
  {
    output->RemoveMesh();
  }
  else
  {
    vtkMTWholeRanges::Announce(*output);
  }
  return 1;
}
