// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTSpoolStore.h"

vtkMTSpoolStore::~vtkMTSpoolStore() = default;
