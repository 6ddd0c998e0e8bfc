// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTRegionStep
 * @brief one region's simplification: from the patches of its floor to its certified fragment
 *
 * Puts the patches together by identity, locks the points that triangles outside the region use, simplifies, bounds the
 * two-sided distance between floor and fragment and by it that between input and fragment, and carries the attributes
 * over. Independent of all other regions.
 *
 * What is known of the triangles of a level's mesh (vtkMTTriangleDeviation) travels with them as one more cell column
 * behind those of the input's arrays, so that splitting, spooling and assembling need not know of it.
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
struct vtkMTTriangleDeviation;

struct VTKMTCONSTRUCTION_EXPORT vtkMTRegionStep
{
  vtkMTPatch Fragment; ///< points that are shared with other regions come first, with their ids
  std::size_t FloorTriangles = 0;
  double Error = 0.0;                          ///< certified distance of fragment and input, in steps of the lattice
  double EdgeLength = 0.0;                     ///< mean, in steps
  bool HasFullySharedBorder = false;           ///< BMT section 3.2, condition 3, is violated here
  std::map<std::string, std::int64_t> Blocked; ///< filled when the target was missed

  struct Context
  {
    const vtkMTSimplifier* Simplifier;
    const std::vector<vtkMTArrayInfo>* Arrays;   ///< the last one is the reach
    const std::vector<std::uint64_t>* LockedIds; ///< sorted
    std::uint32_t FloorLevel;
  };

  ///@{
  /// The column of reaches: its description, to go behind the input's arrays; of a mesh that is the input itself; taken
  /// off a mesh that is to be stored.
  static vtkMTArrayInfo GetReachInfo();
  static void AppendReachOfInput(vtkMTPatch& mesh);
  static void RemoveReach(vtkMTPatch& mesh) { mesh.CellColumns.pop_back(); }
  ///@}

  /// False on failure, with a message in error. floorPatches are consumed.
  bool Run(std::vector<vtkMTPatch>& floorPatches, const Context& context, std::string& error);

private:
  void RoundPoints(std::vector<vtkMTTriangleDeviation>& reach);
};

#endif
