// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTInputSpool.h"

#include "vtkMTRecordSort.h"
#include "vtkMTRelease.h"
#include "vtkMTStageTimes.h"
#include "vtkMTTriangleStream.h"
#include "vtkMTTrimHeap.h"

#include <cstring>
#include <numeric>

namespace
{
using PlaceRecord = vtkMTInputPoints::PlaceRecord;
constexpr std::uint64_t LargestIndex = 0xfffffffeu;
// A triangle of a block with its points, without values; what a slot holds at most, over its block.
constexpr std::uint64_t BytesPerTriangle = 36;
constexpr std::uint64_t CopiesInSlot = 3;
constexpr std::uint64_t NoPoint = vtkMTInputPoints::NoPoint;
constexpr std::size_t RequestsAtOnce = 16384;
// A block that is checked, over its bytes without places.
constexpr std::uint64_t MemoryPerByteOfRaw = 6;
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

int vtkMTInputSpool::GetNumberOfThreads() const
{
  const std::size_t values = std::accumulate(this->CellTupleSizes.begin(), this->CellTupleSizes.end(), std::size_t(0));
  const std::uint64_t block = vtkMTInputBlock::Size * (BytesPerTriangle + values);
  const std::uint64_t needed = CopiesInSlot * vtkMTOrderedWork::GetNumberOfSlots(this->Settings.Threads) * block;
  return this->Settings.BlockMemory == 0 || needed <= this->Settings.BlockMemory ? this->Settings.Threads : 1;
}

bool vtkMTInputSpool::Run(std::size_t count, const vtkMTOrderedWork::Budget& budget,
  const vtkMTOrderedWork::Work& fetch, const vtkMTOrderedWork::Work& work, const vtkMTOrderedWork::Work& take)
{
  std::string error;
  const bool done = vtkMTOrderedWork::Run(count, this->GetNumberOfThreads(), budget, fetch, work, take, error);
  this->Error = error.empty() ? this->Error : error;
  return done;
}

bool vtkMTInputSpool::Continue(const char* step, std::uint64_t done, std::uint64_t all)
{
  this->Aborted = !this->Settings.Report({ 0.0, step, 0, done, all });
  return !this->Aborted || this->Fail("aborted");
}

//------------------------------------------------------------------------------
bool vtkMTInputSpool::Load(vtkMTTriangleStream& stream, const Visit& visit)
{
  for (const vtkMTArrayInfo& info : stream.GetArrays())
  {
    if (info.Association == vtkMTArrayInfo::Cell)
    {
      this->CellTupleSizes.push_back(info.GetTupleSize());
    }
  }
  if (!stream.Rewind())
  {
    return this->Fail(stream.GetError());
  }
  if (!this->LoadPoints(stream))
  {
    return false;
  }
  if (this->Points.IsInMemory())
  {
    return this->LoadChecked(stream, visit);
  }
  const std::size_t memory = this->Settings.SortMemory / 2;
  vtkMTRecordSort places(*this->Settings.Store, sizeof(PlaceRecord), memory);
  {
    vtkMTRecordSort requests(*this->Settings.Store, sizeof(std::uint64_t), memory);
    if (!this->LoadRaw(stream, requests) || !this->FindPlaces(requests, places))
    {
      return false;
    }
  }
  return this->CheckBlocks(places, visit);
}

bool vtkMTInputSpool::LoadPoints(vtkMTTriangleStream& stream)
{
  const vtkMTStageTimes::Scope read(this->Settings.Times, vtkMTStageTimes::Read);
  std::vector<std::size_t> tupleSizes;
  for (const vtkMTArrayInfo& info : stream.GetArrays())
  {
    if (info.Association == vtkMTArrayInfo::Point)
    {
      tupleSizes.push_back(info.GetTupleSize());
    }
  }
  if (!this->Points.Begin(*this->Settings.Store, tupleSizes, this->Error))
  {
    return false;
  }
  vtkMTTriangleStream::PointBlock block;
  while (stream.NextPoints(block))
  {
    const std::uint64_t count = this->Points.GetNumberOfPoints();
    if (block.Points.empty())
    {
      return count <= LargestIndex || this->Fail("the input has more points than the 4294967294 that are supported");
    }
    if (!this->Points.Append(block, this->Error) ||
      !this->Continue("reading points", this->Points.GetNumberOfPoints(), stream.GetNumberOfPoints()))
    {
      return false;
    }
  }
  return this->Fail(stream.GetError());
}

//------------------------------------------------------------------------------
// Blocks of triangles
struct vtkMTInputSpool::Reading
{
  vtkMTTriangleStream& Stream;
  vtkMTTriangleStream::TriangleBlock Read;
  std::size_t Next = 0; // of the triangles that were read
  bool IsAtEnd = false;
};

// A block that has been read: first its triangles, then their points and the block's bytes.
struct vtkMTInputSpool::BlockWork
{
  vtkMTInputBlock Block;
  std::vector<unsigned char> Bytes;
  std::map<std::string, std::int64_t> Report;
};

// Reads all blocks; work by several threads, take in order.
bool vtkMTInputSpool::LoadTriangles(vtkMTTriangleStream& stream, vtkMTRecordSpool& blocks, const char* name,
  const std::function<bool(BlockWork&, std::string&)>& work, const std::function<bool(std::size_t, BlockWork&)>& take)
{
  // Blocks are numbered as they come: as many keys as there can be, and no fewer than there are.
  const std::uint64_t most = stream.GetNumberOfTriangles() / vtkMTInputBlock::Size + 1;
  if (!blocks.Begin(*this->Settings.Store, name, static_cast<std::size_t>(most), this->Error))
  {
    return false;
  }
  // The stream belongs to this thread: a slot is filled before the work that finds it, and as soon as it is free again.
  Reading reading{ stream, {}, 0, false };
  const vtkMTTrimHeap trim(this->Settings.MemoryLimit);
  std::vector<BlockWork> slots(vtkMTOrderedWork::GetNumberOfSlots(this->GetNumberOfThreads()));
  for (BlockWork& slot : slots)
  {
    if (!this->FillBlock(reading, slot.Block))
    {
      return false;
    }
  }
  const auto workOnSlot = [&](std::size_t, std::size_t slot, std::string& error)
  {
    const vtkMTStageTimes::Scope read(this->Settings.Times, vtkMTStageTimes::Read);
    slots[slot].Block.FindPoints();
    return work(slots[slot], error);
  };
  const auto takeSlot = [&](std::size_t index, std::size_t slot, std::string&)
  {
    const bool taken = take(index, slots[slot]);
    vtkMTRelease(slots[slot].Bytes);
    slots[slot].Report.clear();
    return taken && this->FillBlock(reading, slots[slot].Block);
  };
  return this->Run(static_cast<std::size_t>(most), {}, {}, workOnSlot, takeSlot) &&
    (reading.IsAtEnd || this->Fail("the input has more triangles than it was to have")) && blocks.Seal(this->Error);
}

// Without places, which other blocks may have to be asked for.
bool vtkMTInputSpool::LoadRaw(vtkMTTriangleStream& stream, vtkMTRecordSort& requests)
{
  return this->LoadTriangles(
    stream, this->RawBlocks, "input-triangles",
    [](BlockWork& raw, std::string&)
    {
      raw.Block.Encode(raw.Bytes);
      raw.Block.Columns.clear(); // values are in memory once
      return true;
    },
    [&](std::size_t index, BlockWork& raw) { return this->PutRaw(index, raw, requests); });
}

// Where places lie in memory blocks are checked at once, and look them up again when they are read.
bool vtkMTInputSpool::LoadChecked(vtkMTTriangleStream& stream, const Visit& visit)
{
  this->Uses.assign(static_cast<std::size_t>(this->Points.GetNumberOfPoints()), 0);
  return this->LoadTriangles(
    stream, this->Blocks, "checked-triangles",
    [&](BlockWork& checked, std::string& error)
    {
      if (!this->Points.LookUp(checked.Block.Points, checked.Block.Places, error))
      {
        return false;
      }
      this->Check(checked);
      return true;
    },
    [&](std::size_t index, BlockWork& checked)
    {
      for (const std::uint32_t point : checked.Block.Points)
      {
        this->Uses[point] = this->Uses[point] == 0 ? 1 : 2;
      }
      return checked.Bytes.empty() || (this->PutChecked(index, checked) && visit(checked.Block));
    });
}

// Empty when there are no more triangles.
bool vtkMTInputSpool::FillBlock(Reading& reading, vtkMTInputBlock& block)
{
  const vtkMTStageTimes::Scope read(this->Settings.Times, vtkMTStageTimes::Read);
  block.Triangles.clear(); // its memory serves again
  block.CellIds.clear();
  block.Triangles.reserve(vtkMTInputBlock::Size);
  block.CellIds.reserve(vtkMTInputBlock::Size);
  block.Columns.assign(this->CellTupleSizes.size(), vtkMTColumn());
  while (!reading.IsAtEnd && block.Triangles.size() < vtkMTInputBlock::Size)
  {
    if (reading.Next < reading.Read.Triangles.size())
    {
      this->AddTriangles(reading, block);
      continue;
    }
    reading.Next = 0;
    if (!reading.Stream.NextTriangles(reading.Read))
    {
      return this->Fail(reading.Stream.GetError());
    }
    reading.IsAtEnd = reading.Read.Triangles.empty();
    this->InputTriangles += reading.Read.Triangles.size();
    if (!this->Continue("reading triangles", this->InputTriangles, reading.Stream.GetNumberOfTriangles()))
    {
      return false;
    }
  }
  this->ReadTriangles += block.Triangles.size();
  return this->ReadTriangles <= LargestIndex ||
    this->Fail("the input has more triangles than the 4294967294 that are supported");
}

// As many of those that were read as there is room for.
void vtkMTInputSpool::AddTriangles(Reading& reading, vtkMTInputBlock& block)
{
  const vtkMTTriangleStream::TriangleBlock& read = reading.Read;
  const std::uint64_t points = this->Points.GetNumberOfPoints();
  std::uint64_t dropped = 0;
  for (; reading.Next < read.Triangles.size() && block.Triangles.size() < vtkMTInputBlock::Size; ++reading.Next)
  {
    const auto& corners = read.Triangles[reading.Next];
    if (corners[0] >= points || corners[1] >= points || corners[2] >= points)
    {
      ++dropped;
      continue;
    }
    block.Triangles.push_back({ static_cast<std::uint32_t>(corners[0]), static_cast<std::uint32_t>(corners[1]),
      static_cast<std::uint32_t>(corners[2]) });
    block.CellIds.push_back(read.CellIds[reading.Next]);
    for (std::size_t c = 0; c < block.Columns.size(); ++c)
    {
      const std::size_t size = this->CellTupleSizes[c];
      const unsigned char* tuple = read.Columns[c].data() + reading.Next * size;
      block.Columns[c].insert(block.Columns[c].end(), tuple, tuple + size);
    }
  }
  if (dropped > 0)
  {
    this->Report["dropped_index_out_of_range"] += static_cast<std::int64_t>(dropped);
  }
}

bool vtkMTInputSpool::PutRaw(std::size_t number, const BlockWork& raw, vtkMTRecordSort& requests)
{
  if (raw.Block.Triangles.empty())
  {
    return true;
  }
  const vtkMTStageTimes::Scope sort(this->Settings.Times, vtkMTStageTimes::Sort);
  for (const std::uint32_t point : raw.Block.Points)
  {
    const std::uint64_t request = (std::uint64_t(point) << 32) | number;
    if (!requests.Add(&request))
    {
      return this->Fail(requests.GetError());
    }
  }
  return this->RawBlocks.Put(number, raw.Bytes.data(), raw.Bytes.size(), this->Error);
}

//------------------------------------------------------------------------------
// Places of points
struct vtkMTInputSpool::AnsweredRequests
{
  vtkMTInputPoints::Requests Requests;
  std::vector<PlaceRecord> Places;
};

// Every request is answered with the point's place, on the way back to its block.
bool vtkMTInputSpool::FindPlaces(vtkMTRecordSort& requests, vtkMTRecordSort& places)
{
  const vtkMTStageTimes::Scope sort(this->Settings.Times, vtkMTStageTimes::Sort);
  if (!requests.Finish())
  {
    return this->Fail(requests.GetError());
  }
  const vtkMTTrimHeap trim(this->Settings.MemoryLimit);
  std::vector<AnsweredRequests> slots(vtkMTOrderedWork::GetNumberOfSlots(this->GetNumberOfThreads()));
  const unsigned char* record = requests.Next();
  std::uint64_t last = NoPoint;
  const auto fetch = [&](std::size_t, std::size_t slot, std::string& error)
  {
    const vtkMTStageTimes::Scope own(this->Settings.Times, vtkMTStageTimes::Sort);
    vtkMTInputPoints::Requests& taken = slots[slot].Requests;
    taken.Keys.clear();
    taken.Before = last;
    for (; record && taken.Keys.size() < RequestsAtOnce; record = requests.Next())
    {
      taken.Keys.push_back(vtkMTRecordSort::GetKey(record));
      last = taken.Keys.back() >> 32;
    }
    taken.Behind = record ? vtkMTRecordSort::GetKey(record) >> 32 : NoPoint;
    error = requests.GetError();
    return !requests.HasFailed();
  };
  const auto work = [&](std::size_t, std::size_t slot, std::string& error)
  {
    const vtkMTStageTimes::Scope own(this->Settings.Times, vtkMTStageTimes::Sort);
    return this->Points.Answer(slots[slot].Requests, slots[slot].Places, error);
  };
  const auto take = [&](std::size_t index, std::size_t slot, std::string&)
  {
    return (places.Add(slots[slot].Places.data(), slots[slot].Places.size()) || this->Fail(places.GetError())) &&
      this->Continue("sorting points", index * RequestsAtOnce, requests.GetNumberOfRecords());
  };
  const auto count = static_cast<std::size_t>(requests.GetNumberOfRecords() / RequestsAtOnce + 1);
  return this->Run(count, {}, fetch, work, take) && (places.Finish() || this->Fail(places.GetError()));
}

//------------------------------------------------------------------------------
// Checks
bool vtkMTInputSpool::CheckBlocks(vtkMTRecordSort& places, const Visit& visit)
{
  const std::size_t count = this->RawBlocks.GetNumberOfKeys();
  if (!this->Blocks.Begin(*this->Settings.Store, "checked-triangles", count, this->Error))
  {
    return false;
  }
  const vtkMTTrimHeap trim(this->Settings.MemoryLimit);
  std::vector<BlockWork> slots(vtkMTOrderedWork::GetNumberOfSlots(this->GetNumberOfThreads()));
  const vtkMTOrderedWork::Budget budget{ this->Settings.BlockMemory,
    [this](std::size_t index) { return MemoryPerByteOfRaw * this->RawBlocks.GetSize(index); } };
  const auto fetch = [&](std::size_t index, std::size_t slot, std::string& error)
  {
    const vtkMTStageTimes::Scope sort(this->Settings.Times, vtkMTStageTimes::Sort);
    return this->FetchBlock(index, places, slots[slot], error);
  };
  const auto work = [&](std::size_t, std::size_t slot, std::string&)
  {
    const vtkMTStageTimes::Scope sort(this->Settings.Times, vtkMTStageTimes::Sort);
    this->Check(slots[slot]);
    return true;
  };
  const auto take = [&](std::size_t index, std::size_t slot, std::string&)
  {
    const vtkMTStageTimes::Scope sort(this->Settings.Times, vtkMTStageTimes::Sort);
    BlockWork& checked = slots[slot];
    const bool taken = checked.Bytes.empty() ||
      (this->PutChecked(index, checked) && visit(checked.Block) &&
        this->Continue("checking triangles", this->Triangles, this->ReadTriangles));
    checked = BlockWork();
    return taken;
  };
  const bool done = this->Run(count, budget, fetch, work, take);
  this->RawBlocks.Remove();
  return done && this->Blocks.Seal(this->Error);
}

// The block with the places of its points, which are in the blocks' order.
bool vtkMTInputSpool::FetchBlock(
  std::size_t index, vtkMTRecordSort& places, BlockWork& checked, std::string& error) const
{
  std::vector<vtkMTBytes::Record> records;
  vtkMTInputBlock& block = checked.Block;
  if (!this->RawBlocks.Take(index, records, error) || (!records.empty() && !block.Decode(records[0], error)))
  {
    return false;
  }
  block.Places.reserve(block.Points.size());
  block.IsOpen.reserve(block.Points.size());
  for (const std::uint32_t point : block.Points)
  {
    const unsigned char* record = places.Next();
    if (!record)
    {
      error = places.HasFailed() ? places.GetError() : "the places of the input's points are incomplete";
      return false;
    }
    PlaceRecord place;
    std::memcpy(&place, record, sizeof(place));
    if (place.Key != ((std::uint64_t(index) << 32) | point))
    {
      error = "the places of the input's points are not in order";
      return false;
    }
    block.Places.push_back(place.X);
    block.IsOpen.push_back(place.IsOpen != 0 ? 1 : 0);
  }
  return true;
}

void vtkMTInputSpool::Check(BlockWork& checked) const
{
  vtkMTInputBlock& block = checked.Block;
  if (block.Points.empty())
  {
    return;
  }
  block.Keep(
    [&](const vtkMTInputBlock::Triangle& t)
    {
      const char* fault = block.FindFault(t);
      if (fault)
      {
        ++checked.Report[fault];
      }
      return !fault;
    });
  std::vector<vtkMTInputBlock::Place> lookedUp;
  if (this->Points.IsInMemory())
  {
    lookedUp.swap(block.Places);
  }
  block.Encode(checked.Bytes);
  if (this->Points.IsInMemory())
  {
    lookedUp.swap(block.Places);
  }
}

bool vtkMTInputSpool::PutChecked(std::size_t index, const BlockWork& checked)
{
  for (const auto& [reason, triangles] : checked.Report)
  {
    this->Report[reason] += triangles;
  }
  this->Triangles += checked.Block.Triangles.size();
  return this->Blocks.Put(index, checked.Bytes.data(), checked.Bytes.size(), this->Error);
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

bool vtkMTInputSpool::ReadBlock(std::size_t index, vtkMTInputBlock& block, std::string& error) const
{
  std::vector<vtkMTBytes::Record> records;
  block = vtkMTInputBlock();
  if (!this->Blocks.Take(index, records, error) || (!records.empty() && !block.Decode(records[0], error)))
  {
    return false;
  }
  if (!this->Uses.empty())
  {
    block.IsOpen.resize(block.Points.size());
    for (std::size_t p = 0; p < block.Points.size(); ++p)
    {
      block.IsOpen[p] = this->Uses[block.Points[p]] > 1 ? 1 : 0;
    }
    if (!this->Points.LookUp(block.Points, block.Places, error))
    {
      return false;
    }
  }
  if (this->IsLeftOut)
  {
    block.Keep([this, &block](const vtkMTInputBlock::Triangle& t) { return !this->IsLeftOut(block, t); });
  }
  return true;
}
