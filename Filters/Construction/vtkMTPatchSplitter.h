// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTPatchSplitter
 * @brief splits one region's fragment into the patches of the crossing with the next partition
 *
 * Identity: points that the fragment shares with other fragments have their ids already (they come first in the
 * fragment); points that the split makes shared get new ones, unique by level, region and a number within the fragment,
 * which runs along the borders of the patches (vtkMTBorderOrder). Everything else stays without.
 */
#ifndef vtkMTPatchSplitter_h
#define vtkMTPatchSplitter_h

#include "vtkMTConstructionModule.h" // For export macro
#include "vtkMTPatch.h"

#include <cstdint>
#include <utility>
#include <vector>

struct VTKMTCONSTRUCTION_EXPORT vtkMTPatchSplitter
{
  struct Part
  {
    std::uint32_t Region; ///< of the next partition
    vtkMTPatch Patch;
    std::vector<std::uint32_t> Triangles; ///< of the fragment: what the patch's were, in their order
  };
  std::vector<Part> Parts; ///< sorted by region
  /// For every shared point, old or new, and every next region whose triangles use it here: its id and that region.
  std::vector<std::pair<std::uint64_t, std::uint32_t>> Uses;

  /// regions: per triangle of the fragment.
  static vtkMTPatchSplitter Split(const vtkMTPatch& fragment, const std::vector<std::uint32_t>& regions,
    std::uint32_t level, std::uint32_t fragmentRegion);

  ///@{
  /// Ids: the level's and the region's where the point became shared; for those that are shared from the start,
  /// InputLevel and the first region that has them (vtkMTSharedIds). Until these are known: the input's number.
  static std::uint64_t MakeId(std::uint32_t level, std::uint32_t region, std::uint32_t number)
  {
    return (std::uint64_t(level) << 58) | (std::uint64_t(region) << 32) | number;
  }
  static constexpr std::uint32_t InputLevel = 62;
  static std::uint64_t MakeInputId(std::uint64_t point) { return (std::uint64_t(InputLevel) << 58) | point; }
  static bool WasMadeOnLevel(std::uint64_t id, std::uint32_t level) { return (id >> 58) == level; }
  static constexpr std::uint32_t MaximumRegions = 1u << 26;
  ///@}

  /**
   * The part of a mesh that the given triangles (in increasing order) make. Points and wedges keep their order, except
   * that points with isShared[point] come first; ids[point] is taken for those. scratch must hold as many entries of
   * None as mesh has wedges and points together; it is left so.
   */
  static vtkMTPatch Extract(const vtkMTPatch& mesh, const std::vector<std::uint32_t>& triangles,
    const std::vector<unsigned char>& isShared, const std::vector<std::uint64_t>& ids,
    const std::vector<std::size_t>& pointTupleSizes, const std::vector<std::size_t>& cellTupleSizes,
    std::vector<std::uint32_t>& scratch);
  static constexpr std::uint32_t None = ~std::uint32_t(0);
};

#endif
