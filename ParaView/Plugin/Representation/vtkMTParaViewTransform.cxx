// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTParaViewTransform.h"

#include "vtkMTReplica.h"
#include "vtkMTWholeRanges.h"
#include "vtkMultiTriangulation.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkMTParaViewTransform);

//------------------------------------------------------------------------------
vtkMTParaViewTransform::vtkMTParaViewTransform() = default;

//------------------------------------------------------------------------------
vtkMTParaViewTransform::~vtkMTParaViewTransform() = default;

//------------------------------------------------------------------------------
void vtkMTParaViewTransform::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
// The superclass's looks for consumers to warn, and ParaView has some of its own behind every source.
int vtkMTParaViewTransform::ComputePipelineMTime(vtkInformation* request, vtkInformationVector** inputVector,
  vtkInformationVector* outputVector, int port, vtkMTimeType* time)
{
  vtkMultiTriangulation::AnnounceUse(inputVector);
  return this->vtkPolyDataAlgorithm::ComputePipelineMTime( // NOLINT(bugprone-parent-virtual-call)
    request, inputVector, outputVector, port, time);
}

//------------------------------------------------------------------------------
int vtkMTParaViewTransform::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const bool replica = vtkMTReplica::Is(vtkPolyData::GetData(inputVector[0]));
  const int done = this->Superclass::RequestData(request, inputVector, outputVector);
  vtkMultiTriangulation* output = done ? vtkMultiTriangulation::GetData(outputVector) : nullptr;
  if (output && replica)
  {
    output->RemoveMesh();
  }
  else if (output)
  {
    vtkMTWholeRanges::Announce(*output);
  }
  return done;
}
