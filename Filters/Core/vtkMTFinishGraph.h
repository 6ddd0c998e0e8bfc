// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTFinishGraph
 * @brief makes the DAG of all that a builder recorded, and has the sink finish the model
 *
 * Nodes go from coarse to fine between source and sink, in the order in which they were recorded within a level; arcs
 * are indexed, errors and spheres saturated (the lattice's largest shift counts as the error of the finest arcs).
 */
#ifndef vtkMTFinishGraph_h
#define vtkMTFinishGraph_h

#include "vtkMTFiltersCoreModule.h" // For export macro

#include <string>

class vtkMTBuildState;
class vtkMTPatchSink;

struct VTKMTFILTERSCORE_EXPORT vtkMTFinishGraph
{
  /// The state's graph has its lattice, arrays, reports and settings; its records are used up. False with a message in
  /// error.
  static bool Run(vtkMTBuildState& state, vtkMTPatchSink& sink, std::string& error);
};

#endif
