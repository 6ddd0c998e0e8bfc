// SPDX-License-Identifier: BSD-3-Clause
// The ways of placing regions, by name.
#ifndef MTReportStrategies_h
#define MTReportStrategies_h

#include "vtkMTPartitionStrategy.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

struct MTReportStrategy
{
  std::string Name;
  vtkSmartPointer<vtkMTPartitionStrategy> Strategy;
};

/// The default one first.
const std::vector<MTReportStrategy>& MTReportGetStrategies();

#endif
