// SPDX-License-Identifier: BSD-3-Clause
// What vtkMTWedgeSplitter does, for more corners than memory holds. Not installed.
#ifndef vtkMTSpoolWedges_h
#define vtkMTSpoolWedges_h

#include "vtkMTRecordSort.h"
#include "vtkMTSpoolQueue.h"
#include "vtkMTWedgeSplitter.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

/**
 * Corners are sorted by their points, which shows the keys of each; what is to become a point of its own is sorted by
 * the corner that brought it up first, which numbers the copies as vtkMTWedgeSplitter does; corners are sorted back.
 */
class vtkMTSpoolWedges
{
public:
  using Key = vtkMTWedgeSplitter::Key;
  static constexpr std::uint64_t None = ~std::uint64_t(0);

  /// memory: bytes, for the sorts.
  vtkMTSpoolWedges(vtkMTSpoolStore& store, std::size_t memory);

  ///@{
  /// All corners in order, then Finish. limits: parts of keys that are not below are taken for None, and counted in
  /// missing. Points without a corner have the key None, None. False with a message in error.
  bool AddCorner(std::uint64_t point, const Key& key, std::string& error);
  bool Finish(std::uint64_t points, const Key& limits, Key& missing, std::string& error);
  ///@}

  std::uint64_t GetNumberOfCopies() const { return this->Copies; }
  vtkMTSpoolQueue Keys;      ///< of every point, copies behind the others
  vtkMTSpoolQueue Originals; ///< 64 bits for each copy: of which point it is one
  vtkMTSpoolQueue Corners;   ///< 64 bits for each corner: its point, or None where there is no such point

private:
  struct CornerOfPoint
  {
    std::uint64_t Point;
    std::uint64_t Number;
    Key Keys;
  };
  struct Copy
  {
    std::uint64_t FirstCorner;
    std::uint64_t Original;
    Key Keys;
  };
  using Pair = std::uint64_t[2]; // sorted by the first

  bool PutPoint(const std::vector<CornerOfPoint>& corners, std::string& error);
  bool PutCornersOfNone(const unsigned char* record, std::string& error);
  bool NumberCopies(std::uint64_t points, std::string& error);
  static bool Add(vtkMTRecordSort& sort, const void* record, std::string& error);

  std::uint64_t Count = 0;
  std::uint64_t Copies = 0;
  std::unique_ptr<vtkMTRecordSort> ByPoint;  // CornerOfPoint
  std::unique_ptr<vtkMTRecordSort> Copied;   // Copy
  std::unique_ptr<vtkMTRecordSort> OfCopies; // first corner of the copy, corner
  std::unique_ptr<vtkMTRecordSort> ByCorner; // corner, point
};

#endif
