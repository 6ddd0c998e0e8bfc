// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTParaViewSection.h"

#include "vtkDataArraySelection.h"
#include "vtkMTReplica.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkMTParaViewSection);

//------------------------------------------------------------------------------
vtkMTParaViewSection::vtkMTParaViewSection() = default;

//------------------------------------------------------------------------------
vtkMTParaViewSection::~vtkMTParaViewSection() = default;

//------------------------------------------------------------------------------
void vtkMTParaViewSection::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
int vtkMTParaViewSection::GetNumberOfPointArrays()
{
  return this->GetPointArraySelection()->GetNumberOfArrays();
}

//------------------------------------------------------------------------------
const char* vtkMTParaViewSection::GetPointArrayName(int index)
{
  return this->GetPointArraySelection()->GetArrayName(index);
}

//------------------------------------------------------------------------------
int vtkMTParaViewSection::GetPointArrayStatus(const char* name)
{
  return this->GetPointArraySelection()->ArrayIsEnabled(name);
}

//------------------------------------------------------------------------------
void vtkMTParaViewSection::SetPointArrayStatus(const char* name, int status)
{
  this->GetPointArraySelection()->SetArraySetting(name, status);
}

//------------------------------------------------------------------------------
int vtkMTParaViewSection::GetNumberOfCellArrays()
{
  return this->GetCellArraySelection()->GetNumberOfArrays();
}

//------------------------------------------------------------------------------
const char* vtkMTParaViewSection::GetCellArrayName(int index)
{
  return this->GetCellArraySelection()->GetArrayName(index);
}

//------------------------------------------------------------------------------
int vtkMTParaViewSection::GetCellArrayStatus(const char* name)
{
  return this->GetCellArraySelection()->ArrayIsEnabled(name);
}

//------------------------------------------------------------------------------
void vtkMTParaViewSection::SetCellArrayStatus(const char* name, int status)
{
  this->GetCellArraySelection()->SetArraySetting(name, status);
}

//------------------------------------------------------------------------------
int vtkMTParaViewSection::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return vtkMTReplica::MakeEmpty(inputVector, outputVector)
    ? 1
    : this->Superclass::RequestData(request, inputVector, outputVector);
}
