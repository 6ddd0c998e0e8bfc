// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTSpool.h"

vtkMTSpool::~vtkMTSpool() = default;
