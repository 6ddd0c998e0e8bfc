// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTParaViewFileBuilder.h"

#include "vtkCommand.h"
#include "vtkErrorCode.h"
#include "vtkMultiProcessController.h"
#include "vtkMultiTriangulationFileBuilder.h"
#include "vtkObjectFactory.h"

#include <algorithm>

vtkStandardNewMacro(vtkMTParaViewFileBuilder);

//------------------------------------------------------------------------------
vtkMTParaViewFileBuilder::vtkMTParaViewFileBuilder()
  : Builder(vtkSmartPointer<vtkMultiTriangulationFileBuilder>::New())
{
}

//------------------------------------------------------------------------------
vtkMTParaViewFileBuilder::~vtkMTParaViewFileBuilder() = default;

//------------------------------------------------------------------------------
void vtkMTParaViewFileBuilder::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
void vtkMTParaViewFileBuilder::SetBuilder(vtkMultiTriangulationFileBuilder* builder)
{
  if (this->Builder != builder)
  {
    this->Builder = builder;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkMultiTriangulationFileBuilder* vtkMTParaViewFileBuilder::GetBuilder()
{
  return this->Builder;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkMTParaViewFileBuilder::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Builder ? std::max(own, this->Builder->GetMTime()) : own;
}

//------------------------------------------------------------------------------
void vtkMTParaViewFileBuilder::OnProgress(vtkObject*, unsigned long, void*)
{
  this->SetProgressText(this->Builder->GetProgressText());
  this->UpdateProgress(this->Builder->GetProgress());
  this->Builder->SetAbortExecute(this->GetAbortExecute());
}

//------------------------------------------------------------------------------
// Rank 0 builds, and all of them know whether it could.
bool vtkMTParaViewFileBuilder::Build()
{
  if (!this->Builder)
  {
    vtkErrorMacro("There is no builder.");
    return false;
  }
  vtkMultiProcessController* ranks = vtkMultiProcessController::GetGlobalController();
  int built = 1;
  if (!ranks || ranks->GetLocalProcessId() == 0)
  {
    const unsigned long observer =
      this->Builder->AddObserver(vtkCommand::ProgressEvent, this, &vtkMTParaViewFileBuilder::OnProgress);
    this->Builder->Update();
    this->Builder->RemoveObserver(observer);
    built = this->Builder->GetErrorCode() == vtkErrorCode::NoError ? 1 : 0;
  }
  if (ranks && ranks->GetNumberOfProcesses() > 1)
  {
    ranks->Broadcast(&built, 1, 0);
  }
  if (!built)
  {
    vtkErrorMacro(<< "The file was not built: " << this->Builder->GetErrorMessage());
  }
  return built != 0;
}

//------------------------------------------------------------------------------
int vtkMTParaViewFileBuilder::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (!this->Build())
  {
    this->SetErrorCode(
      this->Builder ? this->Builder->GetErrorCode() : static_cast<unsigned long>(vtkErrorCode::UserError));
    return 0;
  }
  this->SetFileName(this->Builder->GetOutputFileName());
  return this->Superclass::RequestData(request, inputVector, outputVector);
}
