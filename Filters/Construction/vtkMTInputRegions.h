// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTInputRegions
 * @brief sorts the input's triangles and points into the regions of Psi_0
 *
 * Triangles are sorted by region. The pairs (point, region) are sorted by point and walked beside the points and their
 * stitched identities: a point that several regions have is shared. Points that were stitched make a detour over their
 * identity, since all of them together tell who shares it and which of them are one wedge: those with equal values.
 * Sorted by region, the result is what each region needs of its points. All sorts are external and stable.
 *
 * Where the input lies in memory, triangles stay where they are: only their numbers are put in order of region, by
 * counting, and points that were not stitched are looked up when their region is taken. The records are the same.
 */
#ifndef vtkMTInputRegions_h
#define vtkMTInputRegions_h

#include "vtkMTBuildSettings.h"
#include "vtkMTConstructionModule.h" // For export macro
#include "vtkMTInputBlock.h"
#include "vtkMTLattice.h"
#include "vtkMTRecordSort.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

class vtkMTInputSpool;
class vtkMTPointWelding;

class VTKMTCONSTRUCTION_EXPORT vtkMTInputRegions
{
public:
  /// What a region needs of a triangle: input's point indices, its number among all that are kept, values behind it.
  struct Triangle
  {
    std::uint64_t Region;
    std::uint32_t Points[3];
    std::uint32_t Number;
    std::int64_t CellId;
  };

  /// And of a point: its identity, the point that stands for its wedge; its values behind it.
  struct Point
  {
    std::uint64_t Key; ///< region above, input's index below
    std::uint32_t Root;
    std::uint32_t Wedge;
    vtkMTPoint X;
    std::uint32_t IsShared;
  };

  /// What one region has, and the values of all of them, one behind the other.
  struct Region
  {
    std::vector<Triangle> Triangles;
    std::vector<Point> Points;
    std::vector<unsigned char> TriangleValues;
    std::vector<unsigned char> PointValues;
  };

  /// exact: null, or the array that is to be made behind the points' values. memory: bytes, for all sorts together.
  vtkMTInputRegions(
    const vtkMTBuildSettings& settings, const vtkMTInputSpool& input, const vtkMTArrayInfo* exact, std::size_t memory);
  ~vtkMTInputRegions();

  /// A block's records: triangles, their numbers counted within the block, and pairs of point and region, some of them
  /// several times; of an input in memory the regions alone.
  struct BlockRecords
  {
    std::vector<std::uint32_t> Regions;

    std::unique_ptr<unsigned char[]> Triangles;
    std::size_t Count = 0; // of triangles
    std::vector<std::uint64_t> Requests;
  };
  /// May be called by any thread. regions: of the block's triangles.
  BlockRecords MakeRecords(const vtkMTInputBlock& block, const std::vector<std::uint32_t>& regions) const;

  ///@{
  /// All blocks in order, then FindPoints, then regions in increasing order. False with a message in GetError.
  bool Add(const vtkMTInputBlock& block, BlockRecords&& records);
  bool FindPoints(vtkMTPointWelding& stitch, const vtkMTLattice& lattice);
  bool Take(std::uint32_t region, Region& result);
  ///@}

  std::uint64_t GetNumberOfUsedPoints() const { return this->UsedPoints; } ///< of the input's
  std::uint64_t GetNumberOfSeamWedges() const { return this->SeamWedges; } ///< wedges beyond the first of each point
  bool WasAborted() const { return this->Aborted; }
  const std::string& GetError() const { return this->Error; }

private:
  struct PointBatch;
  using Root = std::pair<std::uint32_t, std::uint32_t>;               // a stitched point and its identity
  using FindRoot = std::function<std::uint32_t(std::uint32_t point)>; // asked for in increasing order

  bool Fail(const std::string& error);
  void AddInMemory(const vtkMTInputBlock& block, const std::vector<std::uint32_t>& regions);
  std::vector<Root> FindRoots(vtkMTPointWelding& stitch);
  bool RequestStitched(const std::vector<Root>& roots);
  void SortInMemory();
  bool TakeInMemory(std::uint32_t region, Region& result);
  bool TakePointsInMemory(std::uint32_t region, const std::vector<std::uint32_t>& points, Region& result);
  bool FindRequested(const FindRoot& findRoot);
  void MakePoint(const unsigned char* bytes, Point& record, std::vector<unsigned char>& values) const;
  std::size_t GetBatch() const;
  bool FetchPoints(const FindRoot& findRoot, PointBatch& batch, std::string& error);
  bool MakePoints(PointBatch& batch, std::string& error) const;
  bool PutPoints(const PointBatch& batch);
  bool SolveStitched();
  bool SolveIdentity(std::uint32_t root, std::vector<unsigned char>& records);

  const vtkMTBuildSettings& Settings;
  const vtkMTInputSpool& Input;
  const vtkMTArrayInfo* const Exact;
  const std::size_t ValueSize; // with that of the exact points
  const std::size_t TriangleSize;
  const std::size_t PointSize;
  vtkMTLattice Lattice;
  std::string Error;
  bool Aborted = false;
  vtkMTRecordSort Triangles; // by region
  vtkMTRecordSort Requests;  // point above, region below
  vtkMTRecordSort Stitched;  // identity above, region below
  vtkMTRecordSort Points;    // region above, point below
  std::vector<unsigned char> Record;
  const unsigned char* NextRequest = nullptr;
  const unsigned char* NextTriangle = nullptr;
  const unsigned char* NextPoint = nullptr;
  std::uint64_t NextNumber = 0;
  ///@{
  /// Of an input in memory.
  static constexpr std::uint32_t None = ~std::uint32_t(0);
  static constexpr std::uint32_t Several = None - 1;
  std::vector<std::uint32_t> Users;      // of each point: its region; None, or Several
  std::vector<std::uint32_t> Asked;      // the last region that was taken and has the point
  std::vector<bool> IsStitched;          // by point; empty where none is
  std::vector<std::uint32_t> RegionOf;   // of each triangle
  std::vector<std::uint32_t> Numbers;    // of triangles, in order of region
  std::vector<std::size_t> FirstNumber;  // of each region's, and their end
  std::vector<std::size_t> FirstOfBlock; // the number of each block's first triangle, and the end
  ///@}
  std::uint64_t UsedPoints = 0;
  std::uint64_t SeamWedges = 0;
};

#endif
