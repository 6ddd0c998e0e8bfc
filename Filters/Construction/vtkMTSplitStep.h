// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTSplitStep
 * @brief replaces a level's fragments by patches: BMT section 4, the crossing of two partitions
 *
 * Places the regions of Psi_(i+1) by the barycentres of M_i and splits every fragment along them. Its parts are
 * patches: to the sink for the file, and to the spool of patches under their region, with the region's locks.
 */
#ifndef vtkMTSplitStep_h
#define vtkMTSplitStep_h

#include "vtkMTConstructionModule.h" // For export macro
#include "vtkMTLevelStep.h"

#include <utility>

class vtkMTPartition;

class VTKMTCONSTRUCTION_EXPORT vtkMTSplitStep : public vtkMTLevelStep
{
public:
  /// Elements of a crossing below this share of the wanted patch are merged into a neighbour.
  static constexpr double SliverShare = 0.1;

  using vtkMTLevelStep::vtkMTLevelStep;
  bool Run() override;

private:
  /// A fragment's patches on their way to sink and spool.
  struct Result
  {
    std::size_t Triangles = 0;
    std::vector<std::pair<std::uint64_t, std::uint32_t>> Uses;
    std::vector<std::uint32_t> Regions; // of the patches
    std::vector<PatchToWrite> Patches;
    std::vector<Bytes> Records;
    std::vector<Bytes> Finer;       // the same for vtkMTFinerLevels
    std::vector<vtkMTRange> Ranges; // of level 0, of the certified arrays
  };

  std::unique_ptr<vtkMTPartition> MakePartition();
  void FindRanges(const vtkMTPatch& mesh, Result& result) const;
  bool SplitFragment(const vtkMTPartition& partition, std::size_t fragment, Result& result, std::string& error) const;
  bool PutPatches(std::uint32_t toNode, Result& result, std::string& error);
};

#endif
