// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTTriangleStream.h"

//------------------------------------------------------------------------------
vtkMTTriangleStream::~vtkMTTriangleStream() = default;
