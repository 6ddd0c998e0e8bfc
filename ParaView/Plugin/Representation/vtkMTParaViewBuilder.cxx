// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTParaViewBuilder.h"

#include "vtkMTWholeRanges.h"
#include "vtkMultiTriangulation.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkMTParaViewBuilder);

//------------------------------------------------------------------------------
vtkMTParaViewBuilder::vtkMTParaViewBuilder() = default;

//------------------------------------------------------------------------------
vtkMTParaViewBuilder::~vtkMTParaViewBuilder() = default;

//------------------------------------------------------------------------------
void vtkMTParaViewBuilder::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
// The superclass's looks for consumers to warn, and ParaView has some of its own behind every source.
int vtkMTParaViewBuilder::ComputePipelineMTime(vtkInformation* request, vtkInformationVector** inputVector,
  vtkInformationVector* outputVector, int port, vtkMTimeType* time)
{
  return this->vtkPolyDataAlgorithm::ComputePipelineMTime( // NOLINT(bugprone-parent-virtual-call)
    request, inputVector, outputVector, port, time);
}

//------------------------------------------------------------------------------
int vtkMTParaViewBuilder::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const int done = this->Superclass::RequestData(request, inputVector, outputVector);
  if (vtkMultiTriangulation* output = done ? vtkMultiTriangulation::GetData(outputVector) : nullptr)
  {
    vtkMTWholeRanges::Announce(*output);
  }
  return done;
}
