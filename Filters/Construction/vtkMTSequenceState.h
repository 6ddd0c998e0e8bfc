// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTSequenceState
 * @brief what the construction knows between two of its steps: all that must be kept to go on from there
 *
 * A level has two steps. Before the first one the state holds the fragments of mesh M_Level with their barycentres; the
 * step makes patches of them, under the regions of Psi_(Level + 1) and with each region's locks. The second one
 * simplifies these regions to the fragments of M_(Level + 1). Save writes everything but the spools' bytes, which a
 * lasting store keeps; Load takes it back.
 */
#ifndef vtkMTSequenceState_h
#define vtkMTSequenceState_h

#include "vtkMTBarycentreSpool.h"
#include "vtkMTBuildState.h"
#include "vtkMTConstructionModule.h" // For export macro
#include "vtkMTFinerLevels.h"
#include "vtkMTRecordSpool.h"
#include "vtkMTRegionSpool.h"

#include <cstdint>
#include <string>
#include <vector>

class VTKMTCONSTRUCTION_EXPORT vtkMTSequenceState : public vtkMTBuildState
{
public:
  enum StageType : std::uint32_t
  {
    HasFragments = 0,
    HasPatches = 1
  };

  vtkMTSequenceState();
  ~vtkMTSequenceState();

  StageType Stage = HasFragments;
  std::uint64_t FirstArcOfLevel = 0;         ///< of those that leave the nodes of level Level + 1
  std::vector<std::uint32_t> NodeOfFragment; ///< None: of M_0, or an empty region
  std::uint32_t NextRegions = 0;             ///< of Psi_(Level + 1), when there are patches
  std::uint64_t SimplifiedTriangles = 0;
  ///@{
  /// Of made normals, degrees: that which they have, and that which the mesh would choose. Below 0: none are made.
  double FeatureAngle = -1.0;
  double AutomaticFeatureAngle = -1.0;
  ///@}
  std::string DihedralAngles; ///< the figures that it chooses by

  vtkMTRecordSpool Fragments; ///< by region of Psi_Level, a vtkMTCertifiedMesh or none
  vtkMTRegionSpool Patches;   ///< by region of Psi_(Level + 1), with its locks
  vtkMTFinerLevels Finer;     ///< the last levels that were split

  ///@{
  /// Names of the spools of a level.
  static std::string GetFragmentsName(std::uint32_t level) { return "fragments-" + std::to_string(level); }
  static std::string GetPatchesName(std::uint32_t level) { return "patches-" + std::to_string(level); }
  ///@}

  void Save(std::vector<unsigned char>& bytes) const;
  bool Load(vtkMTSpoolStore& store, const std::vector<unsigned char>& bytes, std::string& error);
};

#endif
