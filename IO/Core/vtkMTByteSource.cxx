// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTByteSource.h"

vtkMTByteSource::~vtkMTByteSource() = default;
