// SPDX-License-Identifier: BSD-3-Clause
// What vtkMultiTriangulationFileBuilder keeps, for its sources.
#ifndef vtkMultiTriangulationFileBuilderInternals_h
#define vtkMultiTriangulationFileBuilderInternals_h

#include "vtkMTInputSettings.h"
#include "vtkMultiTriangulationBuilder.h"
#include "vtkMultiTriangulationFileBuilder.h"
#include "vtkNew.h"

#include <atomic>
#include <string>
#include <vector>

struct vtkMultiTriangulationFileBuilder::Internals
{
  vtkMTInputSettings Input;
  std::vector<std::string> Arrays;
  vtkNew<vtkMultiTriangulationBuilder> Builder;
  std::string Identity;
  std::atomic<bool> UsesFolder{ false }; // whether what is in the work folder is this build's; for other threads
};

#endif
