// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTInputPoints
 * @brief the points of the input in a spool, one record after the other: place, then the values of its point arrays
 *
 * Written in the input's order and read with cursors, which go from the first to the last, a buffer of 1 MiB at a time.
 */
#ifndef vtkMTInputPoints_h
#define vtkMTInputPoints_h

#include "vtkMTConstructionModule.h" // For export macro
#include "vtkMTInputBlock.h"
#include "vtkMTTriangleStream.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

class vtkMTSpool;
class vtkMTSpoolStore;

class VTKMTCONSTRUCTION_EXPORT vtkMTInputPoints
{
public:
  vtkMTInputPoints();
  ~vtkMTInputPoints();

  ///@{
  /// False with a message in error. tupleSizes: bytes of the point arrays' tuples.
  bool Begin(vtkMTSpoolStore& store, const std::vector<std::size_t>& tupleSizes, std::string& error);
  bool Append(const vtkMTTriangleStream::PointBlock& block, std::string& error);
  ///@}
  void Remove();

  std::uint64_t GetNumberOfPoints() const { return this->Points; }
  bool IsSingle() const { return this->Single; } ///< all coordinates are floats
  const std::vector<std::size_t>& GetTupleSizes() const { return this->TupleSizes; }
  /// Bytes of all values of a point together.
  std::size_t GetValueSize() const { return this->RecordSize - sizeof(vtkMTInputBlock::Place); }

  class Cursor
  {
  public:
    /// end: behind the last point that will be asked for.
    Cursor(const vtkMTInputPoints& points, std::uint64_t end);
    /// The point's record until the next call; null on failure. Points must be asked for in order.
    const unsigned char* Get(std::uint64_t point, std::string& error);

  private:
    const vtkMTInputPoints& Input;
    const std::uint64_t End;
    std::vector<unsigned char> Buffer;
    std::uint64_t First = 0;
  };

  ///@{
  /// Of a record.
  static vtkMTInputBlock::Place GetPlace(const unsigned char* record);
  static vtkMTInputBlock::Place GetExactPlace(const unsigned char* record); ///< with the sign of zeros
  static const unsigned char* GetValues(const unsigned char* record) { return record + sizeof(vtkMTInputBlock::Place); }
  ///@}

  ///@{
  /// Whether points can be asked for in any order, and the record of one of them, where that is so: where it lies, or
  /// in the given bytes. May be called by any number of threads at once.
  bool IsInMemory() const;
  const unsigned char* LookUp(std::uint64_t point, std::vector<unsigned char>& bytes, std::string& error) const;
  ///@}
  /// The places of points, where that is so. May be called by any number of threads at once.
  bool LookUp(
    const std::vector<std::uint32_t>& points, std::vector<vtkMTInputBlock::Place>& places, std::string& error) const;

  static constexpr std::uint64_t NoPoint = ~std::uint64_t(0);
  /// Which points blocks ask for, in increasing order.
  struct Requests
  {
    std::vector<std::uint64_t> Keys; ///< point above, block below
    std::uint64_t Before = NoPoint;  ///< the points of the requests before and behind these
    std::uint64_t Behind = NoPoint;
  };
  /// The place of a point on its way to a block that asked for it.
  struct PlaceRecord
  {
    std::uint64_t Key; ///< block above, point below
    vtkMTInputBlock::Place X;
    std::uint64_t IsOpen; ///< whether several blocks ask for it
  };
  /// One place for each request, in their order. May be called by any number of threads at once.
  bool Answer(const Requests& requests, std::vector<PlaceRecord>& places, std::string& error) const;

private:
  std::unique_ptr<vtkMTSpool> Spool;
  std::vector<std::size_t> TupleSizes;
  std::size_t RecordSize = sizeof(vtkMTInputBlock::Place);
  std::vector<unsigned char> Records; // of a block
  std::uint64_t Points = 0;
  bool Single = true;
};

#endif
