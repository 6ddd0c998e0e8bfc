// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTFinishStep
 * @brief writes the coarsest patches and makes the DAG of all that was recorded
 *
 * The last fragments are the patches of the arcs that leave the source. Nodes go from coarse to fine between source and
 * sink; errors and spheres are saturated, and the sink finishes the model.
 */
#ifndef vtkMTFinishStep_h
#define vtkMTFinishStep_h

#include "vtkMTConstructionModule.h" // For export macro
#include "vtkMTLevelStep.h"

class VTKMTCONSTRUCTION_EXPORT vtkMTFinishStep : public vtkMTLevelStep
{
public:
  using vtkMTLevelStep::vtkMTLevelStep;
  bool Run() override;

private:
  bool WriteRoots();
  bool FinishGraph();
};

#endif
