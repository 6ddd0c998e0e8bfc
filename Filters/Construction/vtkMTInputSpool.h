// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTInputSpool
 * @brief the input mesh in spools: points one after the other, triangles in blocks that know their points' places
 *
 * Load reads the stream once. The pairs (point, block) are then sorted by point and walked beside the points, which
 * gives every block the places of its points and says which of them several blocks use, whatever the order of the
 * input. Triangles that cannot be part of a surface are dropped and counted, as vtkMTInputMesh says.
 */
#ifndef vtkMTInputSpool_h
#define vtkMTInputSpool_h

#include "vtkMTBuildSettings.h"
#include "vtkMTConstructionModule.h" // For export macro
#include "vtkMTInputBlock.h"
#include "vtkMTRecordSpool.h"

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

class vtkMTRecordSort;
class vtkMTTriangleStream;

class VTKMTCONSTRUCTION_EXPORT vtkMTInputSpool
{
public:
  explicit vtkMTInputSpool(const vtkMTBuildSettings& settings);
  ~vtkMTInputSpool();

  /// Called with every checked block, in order; false stops.
  using Visit = std::function<bool(const vtkMTInputBlock&)>;

  /// Reads the stream and visits all blocks. False with a message in GetError.
  bool Load(vtkMTTriangleStream& stream, const Visit& visit);

  std::uint64_t GetNumberOfPoints() const { return this->Points; }
  std::uint64_t GetNumberOfTriangles() const { return this->Triangles; } ///< those that are kept
  bool IsSingle() const { return this->Single; }                         ///< all coordinates are floats
  std::uint64_t GetInputTriangles() const { return this->InputTriangles; }
  const std::map<std::string, std::int64_t>& GetReport() const { return this->Report; } ///< triangles dropped

  std::size_t GetNumberOfBlocks() const { return this->Blocks.GetNumberOfKeys(); }
  /// Without the triangles that were left out.
  bool ReadBlock(std::size_t index, vtkMTInputBlock& block);

  /// Leaves out, and counts, the triangles for which it says true, from here on. triangles: how many these are.
  using Test = std::function<bool(const vtkMTInputBlock&, const vtkMTInputBlock::Triangle&)>;
  void LeaveOut(const Test& test, const char* reason, std::uint64_t triangles);

  ///@{
  /// Gives up what is not needed any more.
  void ForgetBlocks() { this->Blocks.Remove(); }
  void ForgetPoints() { this->PointSpool.reset(); }
  ///@}

  /// The points from the first to the last, a buffer at a time.
  class PointCursor
  {
  public:
    PointCursor(const vtkMTInputSpool& input);
    /// The point's record, place and values, until the next call; null on failure. Points must be asked for in order.
    const unsigned char* Get(std::uint64_t point, std::string& error);

  private:
    const vtkMTInputSpool& Input;
    std::vector<unsigned char> Buffer;
    std::uint64_t First = 0;
  };

  static vtkMTInputBlock::Place GetPlace(const unsigned char* record);
  static vtkMTInputBlock::Place GetExactPlace(const unsigned char* record); ///< with the sign of zeros
  static const unsigned char* GetValues(const unsigned char* record) { return record + sizeof(vtkMTInputBlock::Place); }
  /// Bytes of all values of a point together.
  std::size_t GetValueSize() const { return this->RecordSize - sizeof(vtkMTInputBlock::Place); }
  const std::vector<std::size_t>& GetPointTupleSizes() const { return this->PointTupleSizes; }
  const std::vector<std::size_t>& GetCellTupleSizes() const { return this->CellTupleSizes; } ///< of the input's arrays

  bool WasAborted() const { return this->Aborted; }
  const std::string& GetError() const { return this->Error; }

private:
  bool Fail(const std::string& error);
  bool Continue(const char* step, std::uint64_t done, std::uint64_t all);
  bool LoadPoints(vtkMTTriangleStream& stream);
  bool LoadTriangles(vtkMTTriangleStream& stream, vtkMTRecordSort& requests);
  bool PutBlock(vtkMTInputBlock& block, vtkMTRecordSort& requests);
  bool FindPlaces(vtkMTRecordSort& requests, vtkMTRecordSort& places);
  bool CheckBlocks(vtkMTRecordSort& places, const Visit& visit);
  bool TakePlaces(std::size_t index, vtkMTRecordSort& places, vtkMTInputBlock& block);
  void Check(vtkMTInputBlock& block);
  void Keep(vtkMTInputBlock& block, const std::function<bool(const vtkMTInputBlock::Triangle&)>& isKept) const;

  const vtkMTBuildSettings& Settings;
  std::string Error;
  bool Aborted = false;
  std::unique_ptr<vtkMTSpool> PointSpool;
  vtkMTRecordSpool RawBlocks; // by number
  vtkMTRecordSpool Blocks;    // the same, checked and with places
  std::size_t RecordSize = 0;
  std::vector<std::size_t> PointTupleSizes;
  std::vector<std::size_t> CellTupleSizes;
  std::uint64_t Points = 0;
  std::uint64_t Triangles = 0;
  std::uint64_t InputTriangles = 0;
  bool Single = true;
  std::map<std::string, std::int64_t> Report;
  Test IsLeftOut;
};

#endif
