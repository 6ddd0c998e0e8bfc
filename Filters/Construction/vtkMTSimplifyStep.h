// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTSimplifyStep
 * @brief replaces a level's patches by fragments
 *
 * For every region of Psi_(i+1), in parallel: its patches are assembled as a floor, simplified and certified
 * (vtkMTRegionStep). The fragment goes to the spool of M_(i+1), and the region becomes a node.
 */
#ifndef vtkMTSimplifyStep_h
#define vtkMTSimplifyStep_h

#include "vtkMTConstructionModule.h" // For export macro
#include "vtkMTLevelStep.h"

#include "vtkMTRegionStep.h"

class VTKMTCONSTRUCTION_EXPORT vtkMTSimplifyStep : public vtkMTLevelStep
{
public:
  using vtkMTLevelStep::vtkMTLevelStep;
  bool Run() override;

private:
  struct Result
  {
    vtkMTRegionStep Step;
    Bytes Record;
  };

  std::vector<std::size_t> CertifiedArrays; // among the graph's arrays
  bool SimplifyRegion(std::size_t region, Result& result, std::string& error) const;
  bool PutFragment(std::uint32_t level, std::size_t region, const Result& result, std::string& error);
};

#endif
