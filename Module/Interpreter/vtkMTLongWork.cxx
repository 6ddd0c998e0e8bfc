// SPDX-License-Identifier: BSD-3-Clause
#include "Interpreter/vtkMTLongWork.h"

namespace
{
vtkMTLongWork::Interpreter Installed;
}

void vtkMTLongWork::SetInterpreter(const Interpreter& interpreter)
{
  Installed = interpreter;
}

vtkMTLongWork::vtkMTLongWork()
  : State(Installed.Release ? Installed.Release() : nullptr)
{
}

vtkMTLongWork::~vtkMTLongWork()
{
  if (this->State)
  {
    Installed.Acquire(this->State);
  }
}

bool vtkMTLongWork::IsInterrupted()
{
  return Installed.IsInterrupted && Installed.IsInterrupted();
}
