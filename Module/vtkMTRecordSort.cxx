// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTRecordSort.h"

#include "vtkMTRelease.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <queue>

namespace
{
// A key and where its record is.
struct Item
{
  std::uint64_t Key;
  std::uint32_t Index;
};

// Per record of a run in memory, beside the record.
constexpr std::size_t OrderSize = 2 * sizeof(Item);
constexpr std::size_t LeastRunBuffer = std::size_t(1) << 16;
constexpr std::size_t ShortList = 1024; // counting takes longer
constexpr std::size_t WriteBuffer = std::size_t(1) << 18;

// The digits by which keys are sorted: from the least bit in which keys differ, so many bits, and so on.
struct Digits
{
  static constexpr unsigned Bits = 11;
  static constexpr std::size_t Values = std::size_t(1) << Bits;

  std::array<unsigned, 64 / Bits + 1> Shifts{};
  unsigned Count = 0;

  explicit Digits(std::uint64_t varying)
  {
    for (unsigned shift = 0; shift < 64 && (varying >> shift) != 0;)
    {
      if (((varying >> shift) & 1) == 0)
      {
        ++shift;
        continue;
      }
      this->Shifts[this->Count++] = shift;
      shift += Bits;
    }
  }
  static std::size_t Get(std::uint64_t key, unsigned shift) { return (key >> shift) & (Values - 1); }
};

// Sorts by one digit: get(i) gives the items in their present order, put(place, item) takes them.
template <typename Get, typename Put>
void SortByDigit(std::size_t count, unsigned shift, Get&& get, Put&& put)
{
  std::array<std::uint32_t, Digits::Values> places{};
  for (std::size_t i = 0; i < count; ++i)
  {
    ++places[Digits::Get(get(i).Key, shift)];
  }
  std::uint32_t sum = 0;
  for (std::uint32_t& place : places)
  {
    const std::uint32_t number = place;
    place = sum;
    sum += number;
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    const Item item = get(i);
    put(places[Digits::Get(item.Key, shift)]++, item);
  }
}
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
  const std::size_t all = std::max<std::size_t>(this->Capacity, 1) * this->RecordSize;
  for (std::size_t left = count * this->RecordSize; left > 0;)
  {
    if (this->BufferSize >= all && !this->WriteRun())
    {
      return false;
    }
    const std::size_t size = std::min(left, all - this->BufferSize);
    if (this->BufferSize + size > this->BufferCapacity && !this->Grow(size))
    {
      return false;
    }
    std::memcpy(this->Buffer.get() + this->BufferSize, bytes, size);
    this->BufferSize += size;
    bytes += size;
    left -= size;
  }
  this->Count += count;
  return true;
}

// So that there is room for more bytes.
bool vtkMTRecordSort::Grow(std::size_t size)
{
  // Twice as much, or all at once: never more than half as much again, should it be copied.
  const std::size_t all = std::max<std::size_t>(this->Capacity, 1) * this->RecordSize;
  const std::size_t twice = std::max(2 * this->BufferSize, std::max(size, 64 * this->RecordSize));
  const std::size_t capacity = std::min(2 * twice > all ? all : std::max(twice, this->BufferSize + size), all);
  auto* grown = static_cast<unsigned char*>(std::realloc(this->Buffer.get(), capacity));
  if (!grown)
  {
    this->Error = "there is not enough memory";
    return false;
  }
  this->Buffer.release(); // realloc has taken it
  this->Buffer.reset(grown);
  this->BufferCapacity = capacity;
  return true;
}

void vtkMTRecordSort::SortBuffer()
{
  const std::size_t count = this->BufferSize / this->RecordSize;
  std::uint64_t ones = 0;
  std::uint64_t zeros = 0;
  std::uint64_t last = 0;
  bool isSorted = true;
  const auto getRecord = [this](std::size_t i) {
    return Item{ GetKey(this->Buffer.get() + i * this->RecordSize), static_cast<std::uint32_t>(i) };
  };
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::uint64_t key = getRecord(i).Key;
    ones |= key;
    zeros |= ~key;
    isSorted = isSorted && last <= key;
    last = key;
  }
  this->Order.reset();
  if (isSorted)
  {
    return;
  }
  this->Order.reset(new std::uint32_t[count]);
  if (count < ShortList)
  {
    std::iota(this->Order.get(), this->Order.get() + count, 0u);
    std::stable_sort(this->Order.get(), this->Order.get() + count,
      [&getRecord](std::uint32_t a, std::uint32_t b) { return getRecord(a).Key < getRecord(b).Key; });
    return;
  }
  const Digits digits(ones & zeros);
  const auto putOrder = [this](std::size_t place, const Item& item) { this->Order[place] = item.Index; };
  if (digits.Count == 1)
  {
    SortByDigit(count, digits.Shifts[0], getRecord, putOrder);
    return;
  }
  std::unique_ptr<Item[]> items(new Item[count]);
  std::unique_ptr<Item[]> scratch(new Item[digits.Count > 2 ? count : 0]);
  const auto getItem = [&items](std::size_t i) { return items[i]; };
  SortByDigit(
    count, digits.Shifts[0], getRecord, [&items](std::size_t place, const Item& item) { items[place] = item; });
  for (unsigned digit = 1; digit + 1 < digits.Count; ++digit)
  {
    SortByDigit(
      count, digits.Shifts[digit], getItem, [&scratch](std::size_t place, const Item& item) { scratch[place] = item; });
    items.swap(scratch);
  }
  SortByDigit(count, digits.Shifts[digits.Count - 1], getItem, putOrder);
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
  const std::size_t count = this->BufferSize / this->RecordSize;
  const std::uint64_t begin = this->Spool->GetSize();
  std::vector<unsigned char> sorted;
  sorted.reserve(WriteBuffer + this->RecordSize);
  for (std::size_t i = 0; i < count; ++i)
  {
    const unsigned char* record = this->GetSorted(i);
    sorted.insert(sorted.end(), record, record + this->RecordSize);
    if (sorted.size() >= WriteBuffer || i + 1 == count)
    {
      if (!this->Spool->Append(sorted.data(), sorted.size(), this->Error))
      {
        return false;
      }
      sorted.clear();
    }
  }
  this->Runs.push_back({ begin, this->Spool->GetSize() });
  this->Order.reset();
  this->BufferSize = 0;
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
  if (this->BufferSize > 0 && !this->WriteRun())
  {
    return false;
  }
  this->Buffer.reset();
  this->BufferCapacity = 0;
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
  if (this->NextInBuffer * this->RecordSize == this->BufferSize)
  {
    return nullptr;
  }
  return this->GetSorted(this->NextInBuffer++);
}

std::size_t vtkMTRecordSort::GetMemorySize() const
{
  return this->BufferCapacity + (this->Order ? this->BufferSize / this->RecordSize * sizeof(std::uint32_t) : 0) +
    (this->Merger ? this->Merger->GetMemorySize() : 0);
}
