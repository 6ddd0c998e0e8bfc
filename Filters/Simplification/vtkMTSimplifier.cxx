// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTSimplifier.h"

vtkMTSimplifier::vtkMTSimplifier() = default;

vtkMTSimplifier::~vtkMTSimplifier() = default;

void vtkMTSimplifier::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Simplifier: " << this->GetSimplifierName() << "\n";
  os << indent << "Settings: " << this->GetSettings() << "\n";
}
