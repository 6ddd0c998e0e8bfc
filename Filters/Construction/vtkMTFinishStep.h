// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTFinishStep
 * @brief writes the coarsest patches and makes the DAG of all that was recorded
 *
 * The last fragments are the patches of the arcs that leave the source. The graph gets the settings that had an
 * influence on it, and vtkMTFinishGraph does the rest.
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
