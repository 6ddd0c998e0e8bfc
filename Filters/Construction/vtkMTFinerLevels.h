// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTFinerLevels
 * @brief the meshes of the last levels, to hold coarser ones against
 *
 * What vtkMTDirectDeviation asks for: the shape of every patch of the last levels and what is known of its triangles,
 * in spools, by region of the next partition as the patches themselves. A region of a level finds its finer mesh by the
 * graph: its floor's patches, those of the floors of the nodes that made them, and so on down to the finest level that
 * is kept; near the triangles in question only.
 *
 * Putting comes from one thread; after Seal, Collect may be called by several.
 */
#ifndef vtkMTFinerLevels_h
#define vtkMTFinerLevels_h

#include "vtkMTBuildState.h"
#include "vtkMTCertifiedMesh.h"
#include "vtkMTConstructionModule.h" // For export macro
#include "vtkMTDirectDeviation.h"
#include "vtkMTRecordSpool.h"

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

class VTKMTCONSTRUCTION_EXPORT vtkMTFinerLevels
{
public:
  using Bytes = std::vector<unsigned char>;

  /// The bytes of a patch for Put; by any thread.
  static void Encode(const vtkMTCertifiedMesh& patch, Bytes& bytes);

  ///@{
  /// Patches of a level, under their regions of the next partition, in the order of their arcs. Levels follow one
  /// another. False with a message in error.
  bool Begin(vtkMTSpoolStore& store, std::uint32_t level, std::size_t regions, std::string& error);
  bool Put(std::size_t region, const Bytes& patch, std::string& error);
  /// With the arcs of that level, which are in place from firstArc on.
  bool Seal(const vtkMTBuildState& state, std::uint64_t firstArc, std::string& error);
  ///@}
  /// Keeps so many levels, the last ones.
  void Keep(std::size_t levels);

  struct Place
  {
    std::uint32_t Region;    ///< of the partition that follows the last level
    std::size_t LevelsBelow; ///< that partition's level: 1 is the last one; at most as many as are kept
  };
  /// A mesh below a region where it is near, as seen from origin.
  bool Collect(const vtkMTBuildState& state, const Place& place, const vtkMTDirectDeviation::Neighbourhood& near,
    const vtkMTPoint& origin, vtkMTDirectDeviation::FinerPart& part, std::string& error) const;

  ///@{
  /// For checkpoints.
  void Save(Bytes& bytes) const;
  /// isLastInRegions: whether the last level's arcs leave regions still, which are not nodes yet.
  bool Open(
    vtkMTSpoolStore& store, const vtkMTBuildState& state, bool isLastInRegions, const Bytes& bytes, std::string& error);
  ///@}

private:
  struct Level
  {
    std::uint32_t Number = 0;
    std::uint64_t FirstArc = 0;
    std::uint64_t EndArc = 0;
    vtkMTRecordSpool Records;
    std::vector<std::uint32_t> First; // per region, one more than regions, into Arcs
    std::vector<std::uint32_t> Arcs;  // by region, of the state's
  };

  static std::string GetName(std::uint32_t level) { return "finer-" + std::to_string(level); }
  std::vector<std::uint32_t> FindRegionsBelow(
    const vtkMTBuildState& state, std::uint32_t region, std::size_t bottom) const;
  static void ListArcs(const vtkMTBuildState& state, bool hasRegions, Level& level);
  static std::uint32_t GetRegion(const vtkMTBuildState& state, const vtkMTBuildState::ArcRecord& arc, bool hasRegions);

  std::deque<Level> Levels; // the finest first
};

#endif
