// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTInputSpool.h"

#include "vtkMTExactPoints.h"
#include "vtkMTRecordSort.h"
#include "vtkMTStageTimes.h"
#include "vtkMTTriangleStream.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace
{
using Place = vtkMTInputBlock::Place;
constexpr std::uint64_t LargestIndex = 0xfffffffeu;
constexpr std::size_t CursorSize = std::size_t(1) << 20;

// The place of one of a block's points on its way to the block.
struct PlaceRecord
{
  std::uint64_t Key; // block above, point below
  Place X;
  std::uint64_t IsOpen;
};

const char* FindFault(const vtkMTInputBlock& block, const vtkMTInputBlock::Triangle& t)
{
  for (std::uint32_t p : t)
  {
    const Place& x = block.Places[p];
    if (!std::isfinite(x[0]) || !std::isfinite(x[1]) || !std::isfinite(x[2]))
    {
      return "dropped_not_finite";
    }
  }
  for (std::size_t c = 0; c < 3; ++c)
  {
    if (block.Places[t[c]] == block.Places[t[(c + 1) % 3]])
    {
      return "dropped_degenerate";
    }
  }
  return nullptr;
}
}

vtkMTInputSpool::vtkMTInputSpool(const vtkMTBuildSettings& settings)
  : Settings(settings)
{
}

vtkMTInputSpool::~vtkMTInputSpool()
{
  this->RawBlocks.Remove();
  this->Blocks.Remove();
}

bool vtkMTInputSpool::Fail(const std::string& error)
{
  this->Error = error;
  return false;
}

bool vtkMTInputSpool::Continue(const char* step, std::uint64_t done, std::uint64_t all)
{
  this->Aborted = !this->Settings.Report({ 0.0, step, 0, done, all });
  return !this->Aborted || this->Fail("aborted");
}

Place vtkMTInputSpool::GetPlace(const unsigned char* record)
{
  Place place;
  std::memcpy(place.data(), record, sizeof(place));
  for (double& coordinate : place)
  {
    coordinate += 0.0; // minus zero is zero: the same place
  }
  return place;
}

Place vtkMTInputSpool::GetExactPlace(const unsigned char* record)
{
  Place place;
  std::memcpy(place.data(), record, sizeof(place));
  return place;
}

//------------------------------------------------------------------------------
bool vtkMTInputSpool::Load(vtkMTTriangleStream& stream, const Visit& visit)
{
  this->RecordSize = sizeof(Place);
  for (const vtkMTArrayInfo& info : stream.GetArrays())
  {
    const bool isPoint = info.Association == vtkMTArrayInfo::Point;
    (isPoint ? this->PointTupleSizes : this->CellTupleSizes).push_back(info.GetTupleSize());
    this->RecordSize += isPoint ? info.GetTupleSize() : 0;
  }
  if (!stream.Rewind())
  {
    return this->Fail(stream.GetError());
  }
  const std::size_t memory = this->Settings.SortMemory / 2;
  vtkMTRecordSort places(*this->Settings.Store, sizeof(PlaceRecord), memory);
  {
    vtkMTRecordSort requests(*this->Settings.Store, sizeof(std::uint64_t), memory);
    const vtkMTStageTimes::Scope read(this->Settings.Times, vtkMTStageTimes::Read);
    if (!this->LoadPoints(stream) || !this->LoadTriangles(stream, requests))
    {
      return false;
    }
    const vtkMTStageTimes::Scope sort(vtkMTStageTimes::Sort);
    if (!this->FindPlaces(requests, places))
    {
      return false;
    }
  }
  const vtkMTStageTimes::Scope sort(this->Settings.Times, vtkMTStageTimes::Sort);
  return this->CheckBlocks(places, visit);
}

bool vtkMTInputSpool::LoadPoints(vtkMTTriangleStream& stream)
{
  this->PointSpool = this->Settings.Store->Create(this->Error);
  if (!this->PointSpool)
  {
    return false;
  }
  vtkMTTriangleStream::PointBlock block;
  std::vector<unsigned char> records;
  while (stream.NextPoints(block))
  {
    if (block.Points.empty())
    {
      return this->Points <= LargestIndex ||
        this->Fail("the input has more points than the 4294967294 that are supported");
    }
    records.resize(block.Points.size() * this->RecordSize);
    unsigned char* to = records.data();
    for (std::size_t i = 0; i < block.Points.size(); ++i)
    {
      for (const double coordinate : block.Points[i])
      {
        this->Single = this->Single && vtkMTExactPoints::IsSingle(coordinate);
      }
      std::memcpy(to, block.Points[i].data(), sizeof(Place));
      to += sizeof(Place);
      for (std::size_t c = 0; c < this->PointTupleSizes.size(); ++c)
      {
        const std::size_t size = this->PointTupleSizes[c];
        std::memcpy(to, block.Columns[c].data() + i * size, size);
        to += size;
      }
    }
    this->Points += block.Points.size();
    if (!this->PointSpool->Append(records.data(), records.size(), this->Error) ||
      !this->Continue("reading points", this->Points, stream.GetNumberOfPoints()))
    {
      return false;
    }
  }
  return this->Fail(stream.GetError());
}

bool vtkMTInputSpool::LoadTriangles(vtkMTTriangleStream& stream, vtkMTRecordSort& requests)
{
  // Blocks are numbered as they come: as many keys as there can be, and no fewer than there are.
  const std::uint64_t most = stream.GetNumberOfTriangles() / vtkMTInputBlock::Size + 1;
  if (!this->RawBlocks.Begin(*this->Settings.Store, "input-triangles", static_cast<std::size_t>(most), this->Error))
  {
    return false;
  }
  vtkMTTriangleStream::TriangleBlock read;
  vtkMTInputBlock block;
  block.Columns.resize(this->CellTupleSizes.size());
  while (stream.NextTriangles(read))
  {
    if (read.Triangles.empty())
    {
      this->Triangles += block.Triangles.size();
      return this->PutBlock(block, requests) && this->RawBlocks.Seal(this->Error);
    }
    this->InputTriangles += read.Triangles.size();
    for (std::size_t t = 0; t < read.Triangles.size(); ++t)
    {
      const auto& corners = read.Triangles[t];
      if (corners[0] >= this->Points || corners[1] >= this->Points || corners[2] >= this->Points)
      {
        ++this->Report["dropped_index_out_of_range"];
        continue;
      }
      block.Triangles.push_back({ static_cast<std::uint32_t>(corners[0]), static_cast<std::uint32_t>(corners[1]),
        static_cast<std::uint32_t>(corners[2]) });
      block.CellIds.push_back(read.CellIds[t]);
      for (std::size_t c = 0; c < block.Columns.size(); ++c)
      {
        const std::size_t size = this->CellTupleSizes[c];
        const unsigned char* tuple = read.Columns[c].data() + t * size;
        block.Columns[c].insert(block.Columns[c].end(), tuple, tuple + size);
      }
      if (block.Triangles.size() == vtkMTInputBlock::Size)
      {
        this->Triangles += block.Triangles.size();
        if (!this->PutBlock(block, requests))
        {
          return false;
        }
      }
    }
    if (!this->Continue("reading triangles", this->InputTriangles, stream.GetNumberOfTriangles()))
    {
      return false;
    }
  }
  return this->Fail(stream.GetError());
}

// Empties the block.
bool vtkMTInputSpool::PutBlock(vtkMTInputBlock& block, vtkMTRecordSort& requests)
{
  if (this->Triangles > LargestIndex)
  {
    return this->Fail("the input has more triangles than the 4294967294 that are supported");
  }
  const std::uint64_t number = block.Triangles.empty() ? 0 : (this->Triangles - 1) / vtkMTInputBlock::Size;
  if (!block.Triangles.empty())
  {
    block.FindPoints();
    for (const std::uint32_t point : block.Points)
    {
      const std::uint64_t request = (std::uint64_t(point) << 32) | number;
      if (!requests.Add(&request))
      {
        return this->Fail(requests.GetError());
      }
    }
    std::vector<unsigned char> bytes;
    block.Encode(bytes);
    if (!this->RawBlocks.Put(static_cast<std::size_t>(number), bytes.data(), bytes.size(), this->Error))
    {
      return false;
    }
  }
  block.Triangles.clear();
  block.CellIds.clear();
  for (vtkMTColumn& column : block.Columns)
  {
    column.clear();
  }
  return true;
}

// Every request is answered with the point's place, on the way back to its block.
bool vtkMTInputSpool::FindPlaces(vtkMTRecordSort& requests, vtkMTRecordSort& places)
{
  if (!requests.Finish())
  {
    return this->Fail(requests.GetError());
  }
  PointCursor cursor(*this);
  std::uint64_t last = ~std::uint64_t(0);
  std::uint64_t done = 0;
  const unsigned char* record = requests.Next();
  while (record)
  {
    const std::uint64_t request = vtkMTRecordSort::GetKey(record);
    const std::uint64_t point = request >> 32;
    record = requests.Next();
    const bool isOpen = point == last || (record && vtkMTRecordSort::GetKey(record) >> 32 == point);
    last = point;
    const unsigned char* bytes = cursor.Get(point, this->Error);
    if (!bytes)
    {
      return false;
    }
    const PlaceRecord place{ (request << 32) | point, GetPlace(bytes), isOpen ? 1u : 0u };
    if (!places.Add(&place))
    {
      return this->Fail(places.GetError());
    }
    if (++done % vtkMTInputBlock::Size == 0 && !this->Continue("sorting points", done, requests.GetNumberOfRecords()))
    {
      return false;
    }
  }
  return (!requests.HasFailed() && places.Finish()) || this->Fail(requests.GetError() + places.GetError());
}

//------------------------------------------------------------------------------
bool vtkMTInputSpool::CheckBlocks(vtkMTRecordSort& places, const Visit& visit)
{
  const std::size_t count = this->RawBlocks.GetNumberOfKeys();
  if (!this->Blocks.Begin(*this->Settings.Store, "checked-triangles", count, this->Error))
  {
    return false;
  }
  const std::uint64_t all = this->Triangles;
  std::vector<unsigned char> bytes;
  this->Triangles = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    std::vector<std::vector<unsigned char>> records;
    if (!this->RawBlocks.Take(i, records, this->Error))
    {
      return false;
    }
    if (records.empty())
    {
      continue;
    }
    vtkMTInputBlock block;
    if (!block.Decode(records[0], this->Error) || !this->TakePlaces(i, places, block))
    {
      return false;
    }
    this->Check(block);
    this->Triangles += block.Triangles.size();
    block.Encode(bytes);
    if (!this->Blocks.Put(i, bytes.data(), bytes.size(), this->Error) || !visit(block) ||
      !this->Continue("checking triangles", this->Triangles, all))
    {
      return false;
    }
  }
  this->RawBlocks.Remove();
  return this->Blocks.Seal(this->Error);
}

bool vtkMTInputSpool::TakePlaces(std::size_t index, vtkMTRecordSort& places, vtkMTInputBlock& block)
{
  for (const std::uint32_t point : block.Points)
  {
    const unsigned char* record = places.Next();
    if (!record)
    {
      return this->Fail(places.HasFailed() ? places.GetError() : "the places of the input's points are incomplete");
    }
    PlaceRecord place;
    std::memcpy(&place, record, sizeof(place));
    if (place.Key != ((std::uint64_t(index) << 32) | point))
    {
      return this->Fail("the places of the input's points are not in order");
    }
    block.Places.push_back(place.X);
    block.IsOpen.push_back(place.IsOpen != 0 ? 1 : 0);
  }
  return true;
}

void vtkMTInputSpool::Check(vtkMTInputBlock& block)
{
  this->Keep(block,
    [this, &block](const vtkMTInputBlock::Triangle& t)
    {
      const char* fault = FindFault(block, t);
      if (fault)
      {
        ++this->Report[fault];
      }
      return !fault;
    });
}

void vtkMTInputSpool::Keep(
  vtkMTInputBlock& block, const std::function<bool(const vtkMTInputBlock::Triangle&)>& isKept) const
{
  std::size_t kept = 0;
  for (std::size_t t = 0; t < block.Triangles.size(); ++t)
  {
    if (!isKept(block.Triangles[t]))
    {
      continue;
    }
    block.Triangles[kept] = block.Triangles[t];
    block.CellIds[kept] = block.CellIds[t];
    for (std::size_t c = 0; c < block.Columns.size() && kept != t; ++c)
    {
      const std::size_t size = this->CellTupleSizes[c];
      std::memcpy(block.Columns[c].data() + kept * size, block.Columns[c].data() + t * size, size);
    }
    ++kept;
  }
  block.Triangles.resize(kept);
  block.CellIds.resize(kept);
  for (std::size_t c = 0; c < block.Columns.size(); ++c)
  {
    block.Columns[c].resize(kept * this->CellTupleSizes[c]);
  }
}

void vtkMTInputSpool::LeaveOut(const Test& test, const char* reason, std::uint64_t triangles)
{
  if (triangles > 0)
  {
    this->IsLeftOut = test;
    this->Triangles -= triangles;
    this->Report[reason] += static_cast<std::int64_t>(triangles);
  }
}

bool vtkMTInputSpool::ReadBlock(std::size_t index, vtkMTInputBlock& block)
{
  std::vector<std::vector<unsigned char>> records;
  block = vtkMTInputBlock();
  if (!this->Blocks.Take(index, records, this->Error) || (!records.empty() && !block.Decode(records[0], this->Error)))
  {
    return false;
  }
  if (this->IsLeftOut)
  {
    this->Keep(block, [this, &block](const vtkMTInputBlock::Triangle& t) { return !this->IsLeftOut(block, t); });
  }
  return true;
}

//------------------------------------------------------------------------------
vtkMTInputSpool::PointCursor::PointCursor(const vtkMTInputSpool& input)
  : Input(input)
{
}

const unsigned char* vtkMTInputSpool::PointCursor::Get(std::uint64_t point, std::string& error)
{
  const std::size_t size = this->Input.RecordSize;
  if (point < this->First || point >= this->First + this->Buffer.size() / size)
  {
    const std::uint64_t count =
      std::min<std::uint64_t>(std::max<std::size_t>(1, CursorSize / size), this->Input.Points - point);
    this->First = point;
    this->Buffer.resize(static_cast<std::size_t>(count) * size);
    if (!this->Input.PointSpool->Read(point * size, this->Buffer.size(), this->Buffer.data(), error))
    {
      return nullptr;
    }
  }
  return this->Buffer.data() + (point - this->First) * size;
}
