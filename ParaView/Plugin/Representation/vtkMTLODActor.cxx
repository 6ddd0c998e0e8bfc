// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTLODActor.h"

#include "vtkObjectFactory.h"
#include "vtkRenderer.h"

vtkStandardNewMacro(vtkMTLODActor);

//------------------------------------------------------------------------------
vtkMTLODActor::vtkMTLODActor() = default;

//------------------------------------------------------------------------------
vtkMTLODActor::~vtkMTLODActor() = default;

//------------------------------------------------------------------------------
void vtkMTLODActor::Render(vtkRenderer* renderer, vtkMapper* mapper)
{
  this->Device->SetAllocatedRenderTime(this->AllocatedRenderTime, renderer); // sets the estimate to 0
  this->Device->SetEstimatedRenderTime(this->EstimatedRenderTime);
  this->Superclass::Render(renderer, mapper);
}
