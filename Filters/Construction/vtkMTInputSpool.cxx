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
constexpr std::uint64_t LargestIndex = 0xfffffffeu;
// A triangle of a block with its points, without values; what a slot holds at most, over its block.
constexpr std::uint64_t BytesPerTriangle = 36;
constexpr std::uint64_t CopiesInSlot = 3;

// Blocks are numbered as they come: as many as there can be.
std::size_t GetMostBlocks(const vtkMTTriangleStream& stream)
{
  return static_cast<std::size_t>(stream.GetNumberOfTriangles() / vtkMTInputBlock::Size + 1);
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
  return this->LoadPoints(stream) &&
    (this->Points.IsInMemory() ? this->LoadChecked(stream, visit) : this->LoadSorted(stream, visit));
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

// Reads all blocks; work by several threads, take in order.
bool vtkMTInputSpool::LoadTriangles(vtkMTTriangleStream& stream,
  const std::function<bool(BlockWork&, std::string&)>& work, const std::function<bool(std::size_t, BlockWork&)>& take)
{
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
  return this->Run(GetMostBlocks(stream), {}, {}, workOnSlot, takeSlot) &&
    (reading.IsAtEnd || this->Fail("the input has more triangles than it was to have"));
}

// Without places, which other blocks may have to be asked for.
bool vtkMTInputSpool::LoadRaw(vtkMTTriangleStream& stream, vtkMTRecordSort& requests)
{
  return this->RawBlocks.Begin(*this->Settings.Store, "input-triangles", GetMostBlocks(stream), this->Error) &&
    this->LoadTriangles(
      stream,
      [](BlockWork& raw, std::string&)
      {
        raw.Block.Encode(raw.Bytes);
        raw.Block.Columns.clear(); // values are in memory once
        return true;
      },
      [&](std::size_t index, BlockWork& raw) { return this->PutRaw(index, raw, requests); }) &&
    this->RawBlocks.Seal(this->Error);
}

// Where places lie in memory blocks are checked at once.
bool vtkMTInputSpool::LoadChecked(vtkMTTriangleStream& stream, const Visit& visit)
{
  this->Uses.assign(static_cast<std::size_t>(this->Points.GetNumberOfPoints()), 0);
  return this->LoadTriangles(
    stream,
    [&](BlockWork& checked, std::string& error)
    {
      if (!this->Points.LookUp(checked.Block.Points, checked.Block.Places, error))
      {
        return false;
      }
      Check(checked);
      return true;
    },
    [&](std::size_t, BlockWork& checked)
    {
      if (checked.Block.Points.empty())
      {
        return true;
      }
      for (const std::uint32_t point : checked.Block.Points)
      {
        this->Uses[point] = this->Uses[point] == 0 ? 1 : 2;
      }
      this->CountChecked(checked);
      const bool goesOn = visit(checked.Block);
      this->Keep(checked.Block);
      return goesOn;
    });
}

// Takes what it holds, and no more memory than that.
void vtkMTInputSpool::Keep(vtkMTInputBlock& block)
{
  this->Kept.emplace_back();
  vtkMTInputBlock& kept = this->Kept.back();
  kept.Points = block.Points; // has room for more
  kept.Triangles.swap(block.Triangles);
  kept.CellIds.swap(block.CellIds);
  kept.Columns = std::move(block.Columns);
  kept.Triangles.shrink_to_fit();
  kept.CellIds.shrink_to_fit();
  for (vtkMTColumn& column : kept.Columns)
  {
    column.shrink_to_fit();
  }
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
// Checks
void vtkMTInputSpool::Check(BlockWork& checked)
{
  const bool isFinite = checked.Block.IsFinite(); // as a rule; then there is less to be looked at
  checked.Block.Keep(
    [&checked, isFinite](const vtkMTInputBlock::Triangle& t)
    {
      if (isFinite && !checked.Block.IsDegenerate(t))
      {
        return true;
      }
      const char* fault = checked.Block.FindFault(t);
      if (fault)
      {
        ++checked.Report[fault];
      }
      return !fault;
    });
}

void vtkMTInputSpool::CountChecked(const BlockWork& checked)
{
  for (const auto& [reason, triangles] : checked.Report)
  {
    this->Report[reason] += triangles;
  }
  this->Triangles += checked.Block.Triangles.size();
}

bool vtkMTInputSpool::LeaveOut(const Test& test, const char* reason, std::uint64_t triangles)
{
  if (triangles == 0)
  {
    return true;
  }
  this->Triangles -= triangles;
  this->Report[reason] += static_cast<std::int64_t>(triangles);
  if (!this->IsInMemory())
  {
    this->IsLeftOut = test;
    return true;
  }
  for (vtkMTInputBlock& block : this->Kept)
  {
    if (!this->Points.LookUp(block.Points, block.Places, this->Error))
    {
      return false;
    }
    block.Keep([&](const vtkMTInputBlock::Triangle& t) { return !test(block, t); });
    vtkMTRelease(block.Places);
  }
  return true;
}

bool vtkMTInputSpool::ReadBlock(std::size_t index, vtkMTInputBlock& block, std::string& error) const
{
  if (this->IsInMemory())
  {
    block = this->Kept[index];
    block.IsOpen.resize(block.Points.size());
    for (std::size_t p = 0; p < block.Points.size(); ++p)
    {
      block.IsOpen[p] = this->Uses[block.Points[p]] > 1 ? 1 : 0;
    }
    return this->Points.LookUp(block.Points, block.Places, error);
  }
  std::vector<vtkMTBytes::Record> records;
  block = vtkMTInputBlock();
  if (!this->Blocks.Take(index, records, error) || (!records.empty() && !block.Decode(records[0], error)))
  {
    return false;
  }
  if (this->IsLeftOut)
  {
    block.Keep([this, &block](const vtkMTInputBlock::Triangle& t) { return !this->IsLeftOut(block, t); });
  }
  return true;
}
