// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMultiTriangulationTransform.h"

#include "vtkMTPlacement.h"
#include "vtkMultiTriangulation.h"

#include "vtkDemandDrivenPipeline.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationVector.h"
#include "vtkLinearTransform.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"

#include <algorithm>

vtkStandardNewMacro(vtkMultiTriangulationTransform);

//------------------------------------------------------------------------------
vtkMultiTriangulationTransform::vtkMultiTriangulationTransform() = default;
vtkMultiTriangulationTransform::~vtkMultiTriangulationTransform() = default;

//------------------------------------------------------------------------------
void vtkMultiTriangulationTransform::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Transform: " << this->Transform.Get() << "\n";
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationTransform::SetTransform(vtkLinearTransform* transform)
{
  if (this->Transform != transform)
  {
    this->Transform = transform;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkLinearTransform* vtkMultiTriangulationTransform::GetTransform()
{
  return this->Transform;
}

//------------------------------------------------------------------------------
vtkMultiTriangulation* vtkMultiTriangulationTransform::GetOutput()
{
  return vtkMultiTriangulation::SafeDownCast(this->GetOutputDataObject(0));
}

//------------------------------------------------------------------------------
vtkMTimeType vtkMultiTriangulationTransform::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Transform ? this->Transform->GetMTime() : 0);
}

//------------------------------------------------------------------------------
int vtkMultiTriangulationTransform::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkMultiTriangulation");
  return 1;
}

//------------------------------------------------------------------------------
int vtkMultiTriangulationTransform::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkMultiTriangulation");
  return 1;
}

//------------------------------------------------------------------------------
vtkTypeBool vtkMultiTriangulationTransform::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()))
  {
    if (!vtkMultiTriangulation::GetData(outputVector))
    {
      vtkNew<vtkMultiTriangulation> output;
      outputVector->GetInformationObject(0)->Set(vtkDataObject::DATA_OBJECT(), output);
    }
    return 1;
  }
  return this->Superclass::ProcessRequest(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
int vtkMultiTriangulationTransform::ComputePipelineMTime(vtkInformation* request, vtkInformationVector** inputVector,
  vtkInformationVector* outputVector, int port, vtkMTimeType* time)
{
  vtkMultiTriangulation::AnnounceUse(inputVector);
  vtkMultiTriangulation::CheckUse(this, outputVector, port);
  return this->Superclass::ComputePipelineMTime(request, inputVector, outputVector, port, time);
}

//------------------------------------------------------------------------------
int vtkMultiTriangulationTransform::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkMultiTriangulation* input = vtkMultiTriangulation::GetData(inputVector[0]);
  vtkMultiTriangulation* output = vtkMultiTriangulation::GetData(outputVector);
  output->Initialize();
  this->SetErrorCode(vtkErrorCode::NoError);
  if (this->Transform)
  {
    this->Transform->Update();
  }
  if (!this->Transform || !vtkMTPlacement::IsSound(this->Transform->GetMatrix()->GetData()))
  {
    this->SetErrorCode(vtkErrorCode::UserError);
    vtkErrorMacro(<< (this->Transform ? "the transform's matrix is not finite and affine, or has no inverse"
                                      : "there is no transform"));
    return 0;
  }
  output->ShallowCopy(input);
  if (!output->ApplyTransform(this->Transform->GetMatrix()->GetData()))
  {
    output->Initialize();
    this->SetErrorCode(vtkErrorCode::UserError);
    return 0;
  }
  vtkMultiTriangulation::WarnOfUse(this, outputVector);
  return 1;
}
