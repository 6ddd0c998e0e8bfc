// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTSharedIds
 * @brief numbers the points that several regions of the input share, in the order in which they will be stored
 *
 * The input numbers its points in any order; stored as these numbers, the identities of a border would take a few bytes
 * each. The first region that has a shared point numbers it instead, by its place along that region's border
 * (vtkMTBorderOrder), so that they run along the borders of all patches. Sorting the pairs (point, region) by point
 * shows which region is the first one, sorting back by region gives each its new ones. Both are external sorts.
 */
#ifndef vtkMTSharedIds_h
#define vtkMTSharedIds_h

#include "vtkMTConstructionModule.h" // For export macro
#include "vtkMTPatch.h"
#include "vtkMTRecordSort.h"

#include <cstdint>
#include <string>
#include <vector>

struct vtkMTHalfedgePairs;

class VTKMTCONSTRUCTION_EXPORT vtkMTSharedIds
{
public:
  /// memory: bytes, for both sorts together.
  vtkMTSharedIds(vtkMTSpoolStore& store, std::size_t memory);

  /// For each of a fragment's shared points its place along the border, those that are not on it last. pairs:
  /// of its edges.
  static std::vector<std::uint32_t> FindPlaces(const vtkMTPatch& fragment, const vtkMTHalfedgePairs& pairs);

  ///@{
  /// Add with the identities and places of all regions' shared points, in increasing order of region; then Solve; then
  /// Take in increasing order of region, which replaces the identities. False with a message in GetError.
  bool Add(std::uint32_t region, const std::vector<std::uint64_t>& ids, const std::vector<std::uint32_t>& places);
  bool Solve();
  bool Take(std::uint32_t region, std::vector<std::uint64_t>& ids);
  ///@}

  const std::string& GetError() const { return this->Error; }

private:
  vtkMTRecordSort Uses;
  vtkMTRecordSort Ids;
  const unsigned char* Next = nullptr;
  std::string Error;
};

#endif
