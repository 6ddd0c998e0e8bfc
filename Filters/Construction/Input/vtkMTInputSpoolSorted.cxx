// SPDX-License-Identifier: BSD-3-Clause
// The part of vtkMTInputSpool for an input that does not lie in memory: places find their blocks by sorting.
#include "vtkMTInputSpool.h"

#include "vtkMTRecordSort.h"
#include "vtkMTStageTimes.h"
#include "vtkMTTrimHeap.h"

#include <cstring>

namespace
{
using PlaceRecord = vtkMTInputPoints::PlaceRecord;
constexpr std::uint64_t NoPoint = vtkMTInputPoints::NoPoint;
constexpr std::size_t RequestsAtOnce = 16384;
// A block that is checked, over its bytes without places.
constexpr std::uint64_t MemoryPerByteOfRaw = 6;
}

bool vtkMTInputSpool::LoadSorted(vtkMTTriangleStream& stream, const Visit& visit)
{
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
    Check(slots[slot]);
    slots[slot].Block.Encode(slots[slot].Bytes);
    return true;
  };
  const auto take = [&](std::size_t index, std::size_t slot, std::string&)
  {
    const vtkMTStageTimes::Scope sort(this->Settings.Times, vtkMTStageTimes::Sort);
    BlockWork& checked = slots[slot];
    bool taken = true;
    if (!checked.Block.Points.empty())
    {
      this->CountChecked(checked);
      taken = this->Blocks.Put(index, checked.Bytes.data(), checked.Bytes.size(), this->Error) &&
        visit(checked.Block) && this->Continue("checking triangles", this->Triangles, this->ReadTriangles);
    }
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
