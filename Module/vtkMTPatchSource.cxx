// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPatchSource.h"

//------------------------------------------------------------------------------
vtkMTPatchSource::~vtkMTPatchSource() = default;
