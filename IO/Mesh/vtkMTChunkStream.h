// SPDX-License-Identifier: BSD-3-Clause
// A triangle stream over a file that is read in chunks, each a small mesh by itself. Not installed.
#ifndef vtkMTChunkStream_h
#define vtkMTChunkStream_h

#include "vtkMTCellCorners.h"
#include "vtkMTPolyDataStream.h"
#include "vtkMTSpoolLookup.h"
#include "vtkMTTriangleStream.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <memory>

/**
 * The chunks go through the format's reader and vtkMTPolyDataStream as the whole file would: so arrays, types, values
 * and triangles are the same whether a file is streamed or read whole. Derived classes say what the chunks are. When a
 * file is opened, they look at every cell (AddCell): how a polygon becomes triangles depends on the places of its
 * corners, which are looked up for all polygons at once (vtkMTSpoolLookup).
 */
class vtkMTChunkStream : public vtkMTTriangleStream
{
public:
  const std::vector<vtkMTArrayInfo>& GetArrays() const override { return this->Arrays; }
  std::uint64_t GetNumberOfPoints() const override { return this->Points; }
  std::uint64_t GetNumberOfTriangles() const override { return this->Triangles; }
  const std::map<std::string, std::int64_t>& GetReport() const override { return this->Report; }
  /// With vertices and lines.
  std::uint64_t GetNumberOfCells() const { return this->FirstCell + this->Cells; }
  bool HasPolygonsOnly() const { return this->FirstCell == 0; }
  bool Rewind() override;
  bool NextPoints(PointBlock& block) override;
  bool NextTriangles(TriangleBlock& block) override;

protected:
  static constexpr std::uint64_t ChunkSize = 65535; // a multiple of three

  /// store: for what is looked up; without one there can be no polygons. memory: bytes, for that.
  explicit vtkMTChunkStream(vtkMTSpoolStore* store = nullptr, std::size_t memory = 0);

  ///@{
  /// The next `count` points as a mesh, or cells with the mesh's cell arrays; the mesh's own cells do not matter.
  virtual bool RewindFile() = 0;
  virtual bool ReadPoints(std::uint64_t count, vtkPolyData* chunk) = 0;
  virtual bool ReadCells(std::uint64_t count, vtkPolyData* chunk, vtkMTCellCorners& corners) = 0;
  ///@}

  ///@{
  /// While the file is opened: every cell once, in order; then FinishCells, which needs RewindFile and ReadPoints.
  bool AddCell(const std::uint64_t* corners, std::size_t count);
  bool FinishCells();
  ///@}
  /// The arrays of points and of cells that chunks have; cells: the arrays of one cell.
  static std::vector<vtkMTArrayInfo> GetArraysOf(vtkPolyData* points, vtkPolyData* cells);

  bool Fail(const std::string& error)
  {
    this->Error = error;
    return false;
  }

  vtkMTSpoolStore* const Store;
  const std::size_t Memory;
  std::vector<vtkMTArrayInfo> Arrays;
  std::map<std::string, std::int64_t> Report;
  std::uint64_t Points = 0;
  std::uint64_t FirstCell = 0; // cells that are numbered before these

private:
  bool BeginPoints();
  bool BeginCells();
  bool AreCellsPlain();
  void TakePlainCells(TriangleBlock& block);
  bool TakeTriangles(TriangleBlock& block);
  void CountCrossedPolygons();
  bool ReadChunk();
  bool AddPlaces();
  bool HasArraysOf(vtkMTArrayInfo::AssociationType association) const;

  std::uint64_t Cells = 0;
  std::uint64_t Triangles = 0;
  std::unique_ptr<vtkMTSpoolLookup> Places; // of the corners of all polygons; null: there are none
  vtkNew<vtkPolyData> Chunk;
  std::unique_ptr<vtkMTPolyDataStream> Stream; // of the chunk
  vtkMTCellCorners Corners;
  std::uint64_t PointsRead = 0; // all chunks together
  std::uint64_t CellsRead = 0;  // all chunks together
  std::uint64_t FirstOfChunk = 0;
};

#endif
