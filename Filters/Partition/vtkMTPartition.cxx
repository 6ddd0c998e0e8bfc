// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPartition.h"

vtkMTPartition::~vtkMTPartition() = default;

vtkMTBarycentreScan::~vtkMTBarycentreScan() = default;
