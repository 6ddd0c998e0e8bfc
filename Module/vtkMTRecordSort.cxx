// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTRecordSort.h"

#include "vtkMTRadixSort.h"
#include "vtkMTRelease.h"

#include <algorithm>
#include <queue>

namespace
{
// Per record of a run in memory, beside the record: key and index, twice.
constexpr std::size_t OrderSize = 2 * sizeof(std::pair<std::uint64_t, std::uint32_t>);
constexpr std::size_t LeastRunBuffer = std::size_t(1) << 16;
constexpr std::size_t WriteBuffer = std::size_t(1) << 18;
}

//------------------------------------------------------------------------------
// Runs of sorted records as one.
class vtkMTRecordSort::Merge
{
public:
  Merge(const vtkMTSpool& spool, const std::vector<Run>& runs, std::size_t recordSize, std::size_t memory)
    : Spool(spool)
    , RecordSize(recordSize)
    , BufferSize(std::max<std::size_t>(1, memory / std::max<std::size_t>(1, runs.size()) / recordSize) * recordSize)
  {
    for (const Run& run : runs)
    {
      Input input;
      input.Next = run.Begin;
      input.End = run.End;
      this->Inputs.push_back(std::move(input));
    }
  }

  bool Begin(std::string& error)
  {
    for (std::size_t i = 0; i < this->Inputs.size(); ++i)
    {
      if (!this->Load(i, error))
      {
        return false;
      }
    }
    return true;
  }

  /// Null at the end, and on failure with a message in error.
  const unsigned char* Next(std::string& error)
  {
    if (this->HasLast)
    {
      this->HasLast = false;
      Input& input = this->Inputs[this->Last];
      input.Place += this->RecordSize;
      const bool isEmpty = input.Place == input.Buffer.size();
      if (!(isEmpty ? this->Load(this->Last, error) : this->Enter(this->Last)))
      {
        return nullptr;
      }
    }
    if (this->Heads.empty())
    {
      return nullptr;
    }
    this->Last = this->Heads.top().Input;
    this->Heads.pop();
    this->HasLast = true;
    return this->Inputs[this->Last].Buffer.data() + this->Inputs[this->Last].Place;
  }

  std::size_t GetMemorySize() const
  {
    std::size_t size = 0;
    for (const Input& input : this->Inputs)
    {
      size += input.Buffer.capacity();
    }
    return size;
  }

private:
  struct Input
  {
    std::vector<unsigned char> Buffer;
    std::size_t Place = 0;
    std::uint64_t Next = 0;
    std::uint64_t End = 0;
  };
  struct Head
  {
    std::uint64_t Key;
    std::size_t Input;
    // For a queue that gives its largest: smaller keys first, then earlier runs.
    bool operator<(const Head& other) const { return Key != other.Key ? Key > other.Key : Input > other.Input; }
  };

  bool Load(std::size_t index, std::string& error)
  {
    Input& input = this->Inputs[index];
    const std::size_t size =
      static_cast<std::size_t>(std::min<std::uint64_t>(this->BufferSize, input.End - input.Next));
    input.Place = 0;
    if (size == 0)
    {
      vtkMTRelease(input.Buffer);
      return true;
    }
    input.Buffer.resize(size);
    if (!this->Spool.Read(input.Next, size, input.Buffer.data(), error))
    {
      return false;
    }
    input.Next += size;
    return this->Enter(index);
  }

  bool Enter(std::size_t index)
  {
    const Input& input = this->Inputs[index];
    this->Heads.push({ vtkMTRecordSort::GetKey(input.Buffer.data() + input.Place), index });
    return true;
  }

  const vtkMTSpool& Spool;
  const std::size_t RecordSize;
  const std::size_t BufferSize;
  std::vector<Input> Inputs;
  std::priority_queue<Head> Heads;
  std::size_t Last = 0;
  bool HasLast = false;
};

//------------------------------------------------------------------------------
vtkMTRecordSort::vtkMTRecordSort(vtkMTSpoolStore& store, std::size_t recordSize, std::size_t memory)
  : Store(store)
  , RecordSize(recordSize)
  , Memory(std::max(memory, MinimumMemory))
  , Capacity(std::min<std::size_t>(Memory / (recordSize + OrderSize), 0xffffffffu))
{
}

vtkMTRecordSort::~vtkMTRecordSort() = default;

bool vtkMTRecordSort::Add(const void* records, std::size_t count)
{
  const unsigned char* bytes = static_cast<const unsigned char*>(records);
  const std::size_t all = this->Capacity * this->RecordSize;
  for (std::size_t left = count * this->RecordSize; left > 0;)
  {
    if (this->Buffer.size() >= all && !this->WriteRun())
    {
      return false;
    }
    const std::size_t size = std::min(left, std::max(all - this->Buffer.size(), this->RecordSize));
    if (this->Buffer.size() + size > this->Buffer.capacity())
    {
      // Twice as much, or all at once: never more than half as much again while it is copied.
      const std::size_t twice = std::max(2 * this->Buffer.size(), std::max(size, 64 * this->RecordSize));
      this->Buffer.reserve(2 * twice > all ? std::max(all, size) : twice);
    }
    this->Buffer.insert(this->Buffer.end(), bytes, bytes + size);
    bytes += size;
    left -= size;
  }
  this->Count += count;
  return true;
}

void vtkMTRecordSort::SortBuffer()
{
  const std::size_t count = this->Buffer.size() / this->RecordSize;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> scratch;
  this->Order.resize(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    this->Order[i] = { GetKey(this->Buffer.data() + i * this->RecordSize), static_cast<std::uint32_t>(i) };
  }
  vtkMTRadixSort::Sort(this->Order, scratch, [](const auto& item) { return item.first; });
}

bool vtkMTRecordSort::WriteRun()
{
  if (!this->Spool)
  {
    this->Spool = this->Store.Create(this->Error);
    if (!this->Spool)
    {
      return false;
    }
  }
  this->SortBuffer();
  const std::uint64_t begin = this->Spool->GetSize();
  std::vector<unsigned char> sorted;
  sorted.reserve(WriteBuffer + this->RecordSize);
  for (std::size_t i = 0; i < this->Order.size(); ++i)
  {
    const unsigned char* record = this->Buffer.data() + this->Order[i].second * this->RecordSize;
    sorted.insert(sorted.end(), record, record + this->RecordSize);
    if (sorted.size() >= WriteBuffer || i + 1 == this->Order.size())
    {
      if (!this->Spool->Append(sorted.data(), sorted.size(), this->Error))
      {
        return false;
      }
      sorted.clear();
    }
  }
  this->Runs.push_back({ begin, this->Spool->GetSize() });
  vtkMTRelease(this->Order);
  this->Buffer.clear();
  return true;
}

std::size_t vtkMTRecordSort::GetFanIn() const
{
  return std::max<std::size_t>(2, this->Memory / std::max(LeastRunBuffer, this->RecordSize));
}

bool vtkMTRecordSort::MergeGroups()
{
  const std::size_t fanIn = this->GetFanIn();
  while (this->Runs.size() > fanIn)
  {
    std::unique_ptr<vtkMTSpool> spool = this->Store.Create(this->Error);
    if (!spool)
    {
      return false;
    }
    std::vector<Run> runs;
    for (std::size_t first = 0; first < this->Runs.size(); first += fanIn)
    {
      const std::size_t last = std::min(first + fanIn, this->Runs.size());
      const std::vector<Run> group(this->Runs.begin() + static_cast<std::ptrdiff_t>(first),
        this->Runs.begin() + static_cast<std::ptrdiff_t>(last));
      Merge merge(*this->Spool, group, this->RecordSize, this->Memory);
      const std::uint64_t begin = spool->GetSize();
      std::vector<unsigned char> merged;
      const unsigned char* record = merge.Begin(this->Error) ? merge.Next(this->Error) : nullptr;
      for (; record; record = merge.Next(this->Error))
      {
        merged.insert(merged.end(), record, record + this->RecordSize);
        if (merged.size() >= WriteBuffer)
        {
          if (!spool->Append(merged.data(), merged.size(), this->Error))
          {
            return false;
          }
          merged.clear();
        }
      }
      if (this->HasFailed() || !spool->Append(merged.data(), merged.size(), this->Error))
      {
        return false;
      }
      runs.push_back({ begin, spool->GetSize() });
    }
    this->Runs = std::move(runs);
    this->Spool = std::move(spool);
  }
  return true;
}

bool vtkMTRecordSort::Finish()
{
  if (this->Runs.empty())
  {
    this->SortBuffer();
    return true;
  }
  if ((!this->Buffer.empty() && !this->WriteRun()))
  {
    return false;
  }
  vtkMTRelease(this->Buffer);
  if (!this->MergeGroups())
  {
    return false;
  }
  this->Merger = std::make_unique<Merge>(*this->Spool, this->Runs, this->RecordSize, this->Memory);
  return this->Merger->Begin(this->Error);
}

const unsigned char* vtkMTRecordSort::Next()
{
  if (this->Merger)
  {
    return this->HasFailed() ? nullptr : this->Merger->Next(this->Error);
  }
  if (this->NextInBuffer == this->Order.size())
  {
    return nullptr;
  }
  return this->Buffer.data() + this->Order[this->NextInBuffer++].second * this->RecordSize;
}

std::size_t vtkMTRecordSort::GetMemorySize() const
{
  return this->Buffer.capacity() + this->Order.capacity() * sizeof(this->Order[0]) +
    (this->Merger ? this->Merger->GetMemorySize() : 0);
}
