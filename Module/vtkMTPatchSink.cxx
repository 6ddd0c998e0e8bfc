// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPatchSink.h"

//------------------------------------------------------------------------------
vtkMTPatchSink::~vtkMTPatchSink() = default;
