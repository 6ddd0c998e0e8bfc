// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTChunkStream.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cstring>
#include <numeric>

namespace
{
std::vector<vtkMTArrayInfo> Select(
  const std::vector<vtkMTArrayInfo>& arrays, vtkMTArrayInfo::AssociationType association)
{
  std::vector<vtkMTArrayInfo> selected;
  std::copy_if(arrays.begin(), arrays.end(), std::back_inserter(selected),
    [association](const vtkMTArrayInfo& info) { return info.Association == association; });
  return selected;
}
}

vtkMTChunkStream::vtkMTChunkStream(vtkMTSpoolStore* store, std::size_t memory)
  : Store(store)
  , Memory(memory)
{
}

//------------------------------------------------------------------------------
bool vtkMTChunkStream::AddCell(const std::uint64_t* corners, std::size_t count)
{
  ++this->Cells;
  if (count < 3)
  {
    ++this->Report["degenerate_cells"];
    return true;
  }
  this->Triangles += count - 2;
  if (count == 3)
  {
    return true;
  }
  if (!this->Places)
  {
    if (!this->Store)
    {
      return this->Fail("polygons are only read where there is room for temporary data");
    }
    this->Places = std::make_unique<vtkMTSpoolLookup>(*this->Store, 3 * sizeof(double), this->Memory);
  }
  return std::all_of(
    corners, corners + count, [this](std::uint64_t corner) { return this->Places->Request(corner, this->Error); });
}

bool vtkMTChunkStream::FinishCells()
{
  if (!this->Places)
  {
    return true;
  }
  if (!this->RewindFile())
  {
    return false;
  }
  for (std::uint64_t read = 0; read < this->Points; read += ChunkSize)
  {
    const std::uint64_t count = std::min(ChunkSize, this->Points - read);
    this->Chunk->Initialize();
    if (!this->ReadPoints(count, this->Chunk))
    {
      return false;
    }
    for (std::uint64_t i = 0; i < count; ++i)
    {
      double place[3];
      this->Chunk->GetPoint(static_cast<vtkIdType>(i), place);
      if (!this->Places->PassBy(place, this->Error))
      {
        return false;
      }
    }
  }
  return this->Places->Finish(this->Error);
}

std::vector<vtkMTArrayInfo> vtkMTChunkStream::GetArraysOf(vtkPolyData* points, vtkPolyData* cells)
{
  std::vector<vtkMTArrayInfo> arrays = Select(vtkMTPolyDataStream(points).GetArrays(), vtkMTArrayInfo::Point);
  vtkNew<vtkPolyData> one; // arrays without a cell would be left out
  one->GetCellData()->ShallowCopy(cells->GetCellData());
  vtkNew<vtkCellArray> polys;
  polys->InsertNextCell({ 0, 0, 0 });
  one->SetPolys(polys);
  const std::vector<vtkMTArrayInfo> ofCells = Select(vtkMTPolyDataStream(one).GetArrays(), vtkMTArrayInfo::Cell);
  arrays.insert(arrays.end(), ofCells.begin(), ofCells.end());
  return arrays;
}

//------------------------------------------------------------------------------
bool vtkMTChunkStream::Rewind()
{
  this->Error.clear();
  this->Stream.reset();
  this->PointsRead = 0;
  this->CellsRead = 0;
  this->Report.erase(vtkMTPolyDataStream::GetCrossedPolygonsName());
  if (this->Places)
  {
    this->Places->Rewind();
  }
  return this->RewindFile();
}

// A file that says other things later than at its beginning must not be believed.
bool vtkMTChunkStream::HasArraysOf(vtkMTArrayInfo::AssociationType association) const
{
  return Select(this->Stream->GetArrays(), association) == Select(this->Arrays, association);
}

bool vtkMTChunkStream::BeginPoints()
{
  this->Chunk->GetCellData()->Initialize();
  this->Chunk->SetPolys(nullptr);
  this->Stream = std::make_unique<vtkMTPolyDataStream>(this->Chunk);
  return this->HasArraysOf(vtkMTArrayInfo::Point) || this->Fail("its arrays change within the file");
}

bool vtkMTChunkStream::NextPoints(PointBlock& block)
{
  block = PointBlock();
  for (;;)
  {
    if (this->Stream)
    {
      if (!this->Stream->NextPoints(block))
      {
        return this->Fail(this->Stream->GetError());
      }
      if (!block.Points.empty())
      {
        return true;
      }
      this->Stream.reset();
    }
    if (this->PointsRead == this->Points)
    {
      return true;
    }
    const std::uint64_t count = std::min(ChunkSize, this->Points - this->PointsRead);
    this->Chunk->Initialize();
    if (!this->ReadPoints(count, this->Chunk) || !this->BeginPoints())
    {
      return false;
    }
    this->PointsRead += count;
  }
}

// Every corner is a point by itself; polygons have theirs where they belong.
bool vtkMTChunkStream::AddPlaces()
{
  vtkNew<vtkDoubleArray> places;
  places->SetNumberOfComponents(3);
  places->SetNumberOfTuples(static_cast<vtkIdType>(this->Corners.Points.size()));
  double* to = places->GetPointer(0);
  std::size_t begin = 0;
  for (const std::size_t end : this->Corners.Ends)
  {
    for (std::size_t i = begin; i < end && end - begin > 3; ++i)
    {
      const unsigned char* place = this->Places ? this->Places->Next(this->Error) : nullptr;
      if (!place)
      {
        return this->Fail(this->Error.empty() ? "the file has changed" : this->Error);
      }
      std::memcpy(to + 3 * i, place, 3 * sizeof(double));
    }
    begin = end;
  }
  vtkNew<vtkPoints> points;
  points->SetData(places);
  this->Chunk->SetPoints(points);
  return true;
}

bool vtkMTChunkStream::BeginCells()
{
  this->Chunk->GetPointData()->Initialize();
  vtkNew<vtkIdTypeArray> offsets;
  vtkNew<vtkIdTypeArray> corners;
  offsets->SetNumberOfValues(static_cast<vtkIdType>(this->Corners.Ends.size() + 1));
  offsets->SetValue(0, 0);
  std::copy(this->Corners.Ends.begin(), this->Corners.Ends.end(), offsets->GetPointer(1));
  corners->SetNumberOfValues(static_cast<vtkIdType>(this->Corners.Points.size()));
  std::iota(corners->GetPointer(0), corners->GetPointer(0) + corners->GetNumberOfValues(), vtkIdType(0));
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, corners);
  this->Chunk->SetPolys(cells);
  if (!this->AddPlaces())
  {
    return false;
  }
  this->Stream = std::make_unique<vtkMTPolyDataStream>(this->Chunk);
  return this->HasArraysOf(vtkMTArrayInfo::Cell) || this->Fail("its arrays change within the file");
}

// Whether the cells of the chunk are triangles, all of them, and have no arrays.
bool vtkMTChunkStream::AreCellsPlain()
{
  std::size_t end = 0;
  return Select(this->Arrays, vtkMTArrayInfo::Cell).empty() && this->Chunk->GetCellData()->GetNumberOfArrays() == 0 &&
    std::all_of(
      this->Corners.Ends.begin(), this->Corners.Ends.end(), [&end](std::size_t next) { return next == (end += 3); });
}

// They are a block as they are.
void vtkMTChunkStream::TakePlainCells(TriangleBlock& block)
{
  const std::size_t count = this->Corners.Ends.size();
  block.Triangles.resize(count);
  block.CellIds.resize(count);
  for (std::size_t t = 0; t < count; ++t)
  {
    const std::uint64_t* corners = this->Corners.Points.data() + 3 * t;
    block.Triangles[t] = { corners[0], corners[1], corners[2] };
    block.CellIds[t] = static_cast<std::int64_t>(this->FirstCell + this->FirstOfChunk + t);
  }
}

// The next triangles of the chunk, by points of the whole file; none at its end.
bool vtkMTChunkStream::TakeTriangles(TriangleBlock& block)
{
  if (!this->Stream->NextTriangles(block))
  {
    return this->Fail(this->Stream->GetError());
  }
  for (std::size_t t = 0; t < block.Triangles.size(); ++t)
  {
    for (std::uint64_t& corner : block.Triangles[t])
    {
      corner = this->Corners.Points[static_cast<std::size_t>(corner)];
    }
    block.CellIds[t] += static_cast<std::int64_t>(this->FirstCell + this->FirstOfChunk);
  }
  return true;
}

void vtkMTChunkStream::CountCrossedPolygons()
{
  const char* name = vtkMTPolyDataStream::GetCrossedPolygonsName();
  const auto counted = this->Stream->GetReport().find(name);
  if (counted != this->Stream->GetReport().end())
  {
    this->Report[name] += counted->second;
  }
}

bool vtkMTChunkStream::ReadChunk()
{
  const std::uint64_t count = std::min(ChunkSize, this->Cells - this->CellsRead);
  this->Chunk->Initialize();
  this->Corners = vtkMTCellCorners();
  this->FirstOfChunk = this->CellsRead;
  this->CellsRead += count;
  return this->ReadCells(count, this->Chunk, this->Corners);
}

bool vtkMTChunkStream::NextTriangles(TriangleBlock& block)
{
  PointBlock skipped;
  while (this->PointsRead < this->Points)
  {
    if (!this->NextPoints(skipped))
    {
      return false;
    }
  }
  if (this->CellsRead == 0)
  {
    this->Stream.reset(); // of the last points
  }
  block = TriangleBlock();
  for (;;)
  {
    if (this->Stream)
    {
      const bool good = this->TakeTriangles(block);
      if (!good || !block.Triangles.empty())
      {
        return good;
      }
      this->CountCrossedPolygons();
      this->Stream.reset();
    }
    if (this->CellsRead == this->Cells)
    {
      return true;
    }
    if (!this->ReadChunk())
    {
      return false;
    }
    if (this->AreCellsPlain())
    {
      this->TakePlainCells(block);
      return true;
    }
    if (!this->BeginCells())
    {
      return false;
    }
  }
}
