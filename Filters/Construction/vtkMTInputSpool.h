// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTInputSpool
 * @brief the input mesh in spools: points one after the other, triangles in blocks that know their points' places
 *
 * Load reads the stream once. The pairs (point, block) are then sorted by point and walked beside the points, which
 * gives every block the places of its points and tells which of them several blocks use, whatever the order of the
 * input. Where points lie in memory their places are looked up instead, uses are counted, and blocks are kept.
 * Triangles that cannot be part of a surface are dropped and counted, as vtkMTInputMesh says.
 *
 * Threads: the calling one reads the stream, a few blocks ahead, and writes; others do what is between.
 */
#ifndef vtkMTInputSpool_h
#define vtkMTInputSpool_h

#include "vtkMTBuildSettings.h"
#include "vtkMTConstructionModule.h" // For export macro
#include "vtkMTInputBlock.h"
#include "vtkMTInputPoints.h"
#include "vtkMTOrderedWork.h"
#include "vtkMTRecordSpool.h"
#include "vtkMTRelease.h"

#include <functional>
#include <map>
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

  const vtkMTInputPoints& GetPoints() const { return this->Points; }
  std::uint64_t GetNumberOfTriangles() const { return this->Triangles; } ///< those that are kept
  std::uint64_t GetNumberOfInputTriangles() const { return this->InputTriangles; }
  const std::map<std::string, std::int64_t>& GetReport() const { return this->Report; } ///< triangles dropped

  /// Threads for work on blocks: one where the blocks that several work on, with their values, are too much.
  int GetNumberOfThreads() const;

  /// Whether all of it lies in memory: then points can be looked up, and blocks are kept as they are.
  bool IsInMemory() const { return this->Points.IsInMemory(); }
  /// A block that is kept, without places; where that is so.
  const vtkMTInputBlock& GetBlock(std::size_t index) const { return this->Kept[index]; }

  std::size_t GetNumberOfBlocks() const
  {
    return this->IsInMemory() ? this->Kept.size() : this->Blocks.GetNumberOfKeys();
  }
  /// Bytes of the block as it is stored, with places; 0: it is empty.
  std::uint64_t GetBlockSize(std::size_t index) const
  {
    return this->IsInMemory() ? this->Kept[index].GetMemorySize() : this->Blocks.GetSize(index);
  }
  /// Without the triangles that were left out. May be called by any number of threads at once.
  bool ReadBlock(std::size_t index, vtkMTInputBlock& block, std::string& error) const;

  /// Leaves out, and counts, the triangles for which it gives true, from here on. triangles: how many these are. False
  /// with a message in GetError.
  using Test = std::function<bool(const vtkMTInputBlock&, const vtkMTInputBlock::Triangle&)>;
  bool LeaveOut(const Test& test, const char* reason, std::uint64_t triangles);

  ///@{
  /// Gives up what is not needed any more.
  void ForgetBlocks()
  {
    this->Blocks.Remove();
    vtkMTRelease(this->Kept);
  }
  void ForgetPoints() { this->Points.Remove(); }
  ///@}

  const std::vector<std::size_t>& GetCellTupleSizes() const { return this->CellTupleSizes; } ///< of the input's arrays

  bool WasAborted() const { return this->Aborted; }
  const std::string& GetError() const { return this->Error; }

private:
  struct Reading;
  // A block that has been read: first its triangles, then their points and the block's bytes, and what was dropped.
  struct BlockWork
  {
    vtkMTInputBlock Block;
    std::vector<unsigned char> Bytes;
    std::map<std::string, std::int64_t> Report;
  };
  struct AnsweredRequests;

  bool Fail(const std::string& error);
  bool Continue(const char* step, std::uint64_t done, std::uint64_t all);
  bool LoadPoints(vtkMTTriangleStream& stream);
  bool LoadTriangles(vtkMTTriangleStream& stream, const std::function<bool(BlockWork&, std::string&)>& work,
    const std::function<bool(std::size_t, BlockWork&)>& take);
  bool LoadSorted(vtkMTTriangleStream& stream, const Visit& visit);
  bool LoadRaw(vtkMTTriangleStream& stream, vtkMTRecordSort& requests);
  bool LoadChecked(vtkMTTriangleStream& stream, const Visit& visit);
  bool FillBlock(Reading& reading, vtkMTInputBlock& block);
  void AddTriangles(Reading& reading, vtkMTInputBlock& block);
  bool PutRaw(std::size_t number, const BlockWork& raw, vtkMTRecordSort& requests);
  bool FindPlaces(vtkMTRecordSort& requests, vtkMTRecordSort& places);
  bool CheckBlocks(vtkMTRecordSort& places, const Visit& visit);
  bool FetchBlock(std::size_t index, vtkMTRecordSort& places, BlockWork& checked, std::string& error) const;
  static void Check(BlockWork& checked);
  void CountChecked(const BlockWork& checked);
  void Keep(vtkMTInputBlock& block);
  bool Run(std::size_t count, const vtkMTOrderedWork::Budget& budget, const vtkMTOrderedWork::Work& fetch,
    const vtkMTOrderedWork::Work& work, const vtkMTOrderedWork::Work& take);

  const vtkMTBuildSettings& Settings;
  std::string Error;
  bool Aborted = false;
  vtkMTInputPoints Points;
  vtkMTRecordSpool RawBlocks; // by number
  vtkMTRecordSpool Blocks;    // the same, checked and with places
  ///@{
  /// Where all lies in memory: the blocks, without places, and in how many of them each point is; 2: or more.
  std::vector<vtkMTInputBlock> Kept;
  std::vector<unsigned char> Uses;
  ///@}
  std::vector<std::size_t> CellTupleSizes;
  std::uint64_t ReadTriangles = 0;
  std::uint64_t Triangles = 0; // that are kept
  std::uint64_t InputTriangles = 0;
  std::map<std::string, std::int64_t> Report;
  Test IsLeftOut;
};

#endif
