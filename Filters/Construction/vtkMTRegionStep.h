// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTRegionStep
 * @brief one region's simplification: from the patches of its floor to its certified fragment
 *
 * Puts the patches together by identity, locks the points that triangles outside the region use, simplifies, bounds the
 * two-sided distance between floor and fragment, and carries the attributes over. Independent of all other regions.
 */
#ifndef vtkMTRegionStep_h
#define vtkMTRegionStep_h

#include "vtkMTConstructionModule.h" // For export macro
#include "vtkMTPatch.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

class vtkMTSimplifier;

struct VTKMTCONSTRUCTION_EXPORT vtkMTRegionStep
{
  vtkMTPatch Fragment; ///< points that are shared with other regions come first, with their ids
  std::size_t FloorTriangles = 0;
  double StepError = 0.0;                      ///< certified, in steps of the lattice
  double EdgeLength = 0.0;                     ///< mean, in steps
  bool HasFullySharedBorder = false;           ///< BMT section 3.2, condition 3, is violated here
  std::map<std::string, std::int64_t> Blocked; ///< filled when the target was missed

  struct Context
  {
    const vtkMTSimplifier* Simplifier;
    const std::vector<vtkMTArrayInfo>* Arrays;
    const std::vector<std::uint64_t>* LockedIds; ///< sorted
    std::uint32_t FloorLevel;
  };

  /// False on failure, with a message in error. floorPatches are consumed.
  bool Run(std::vector<vtkMTPatch>& floorPatches, const Context& context, std::string& error);
};

#endif
