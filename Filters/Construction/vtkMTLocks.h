// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTLocks
 * @brief finds the points that each region must leave as they are
 *
 * A point is locked when triangles of several regions use it. Splitting a level's fragments gives, for every shared
 * point, which regions of the next partition use it; sorting these pairs by point shows who has it in common, sorting
 * what is left by region gives each region its list. Both are external sorts: nothing about all points is in memory.
 */
#ifndef vtkMTLocks_h
#define vtkMTLocks_h

#include "vtkMTConstructionModule.h" // For export macro
#include "vtkMTRecordSort.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

class vtkMTRegionSpool;

class VTKMTCONSTRUCTION_EXPORT vtkMTLocks
{
public:
  /// memory: bytes, for both sorts together.
  vtkMTLocks(vtkMTSpoolStore& store, std::size_t memory);

  /// (id, region): triangles of that region use that point. Repetitions do no harm.
  bool Add(const std::vector<std::pair<std::uint64_t, std::uint32_t>>& uses, std::string& error);

  /// Gives every region of the spool its locks.
  bool Finish(vtkMTRegionSpool& regions, std::string& error);

private:
  bool AddShared(std::uint64_t id, std::vector<std::uint32_t>& regions);

  vtkMTRecordSort Uses;
  vtkMTRecordSort Locked;
};

#endif
