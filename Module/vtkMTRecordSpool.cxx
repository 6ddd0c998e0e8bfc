// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTRecordSpool.h"

#include "vtkMTRelease.h"
#include <algorithm>
#include <cstring>
#include <limits>

namespace
{
constexpr std::size_t BufferSize = std::size_t(1) << 20;
constexpr std::size_t LargeRecord = std::size_t(1) << 13; // is not copied into the buffer
}

vtkMTRecordSpool::vtkMTRecordSpool() = default;

vtkMTRecordSpool::~vtkMTRecordSpool() = default;

bool vtkMTRecordSpool::Begin(vtkMTSpoolStore& store, const std::string& name, std::size_t keys, std::string& error)
{
  this->Store = &store;
  this->Name = name;
  this->Entries.clear();
  this->Buffer.clear();
  this->First.assign(keys + 1, 0);
  this->Spool = store.Create(name, error);
  return this->Spool != nullptr;
}

bool vtkMTRecordSpool::Put(std::size_t key, const void* data, std::size_t size, std::string& error)
{
  if (key >= this->GetNumberOfKeys() || size > std::numeric_limits<std::uint32_t>::max())
  {
    error = "a record of " + std::to_string(size) + " bytes under key " + std::to_string(key) + " of " +
      std::to_string(this->GetNumberOfKeys());
    return false;
  }
  // At a multiple of 8 bytes, so that lists are there where their values may be.
  const auto end = static_cast<std::size_t>((this->Spool->GetSize() + this->Buffer.size()) % vtkMTBytes::Alignment);
  this->Buffer.resize(this->Buffer.size() + (vtkMTBytes::Alignment - end) % vtkMTBytes::Alignment);
  this->Entries.push_back({ this->Spool->GetSize() + this->Buffer.size(), static_cast<std::uint32_t>(size),
    static_cast<std::uint32_t>(key) });
  if (size >= LargeRecord)
  {
    return this->Flush(error) && this->Spool->Append(data, size, error);
  }
  const unsigned char* bytes = static_cast<const unsigned char*>(data);
  this->Buffer.insert(this->Buffer.end(), bytes, bytes + size);
  return this->Buffer.size() < BufferSize || this->Flush(error);
}

bool vtkMTRecordSpool::Flush(std::string& error)
{
  const bool done = this->Spool->Append(this->Buffer.data(), this->Buffer.size(), error);
  this->Buffer.clear();
  return done;
}

bool vtkMTRecordSpool::Seal(std::string& error)
{
  if (!this->Flush(error))
  {
    return false;
  }
  vtkMTRelease(this->Buffer);
  this->Entries.shrink_to_fit();
  this->SortEntries();
  return true;
}

void vtkMTRecordSpool::SortEntries()
{
  // Offsets say in which order records of one key were put.
  std::sort(this->Entries.begin(), this->Entries.end(),
    [](const Entry& a, const Entry& b) { return a.Key != b.Key ? a.Key < b.Key : a.Offset < b.Offset; });
  std::fill(this->First.begin(), this->First.end(), 0);
  for (const Entry& entry : this->Entries)
  {
    ++this->First[entry.Key + std::size_t(1)];
  }
  for (std::size_t key = 1; key < this->First.size(); ++key)
  {
    this->First[key] += this->First[key - 1];
  }
}

bool vtkMTRecordSpool::Take(const Entry& entry, vtkMTBytes::Record& record, std::string& error) const
{
  if (const unsigned char* bytes = this->Spool->Find(entry.Offset, entry.Size))
  {
    record = { bytes, entry.Size };
    return true;
  }
  return this->Spool->Read(entry.Offset, entry.Size, record.Allocate(entry.Size), error);
}

bool vtkMTRecordSpool::Take(std::size_t key, std::vector<vtkMTBytes::Record>& records, std::string& error) const
{
  records.clear();
  if (key >= this->GetNumberOfKeys())
  {
    error = "a record under key " + std::to_string(key) + " of " + std::to_string(this->GetNumberOfKeys());
    return false;
  }
  for (std::uint32_t i = this->First[key]; i < this->First[key + 1]; ++i)
  {
    records.emplace_back();
    if (!this->Take(this->Entries[i], records.back(), error))
    {
      return false;
    }
  }
  return true;
}

bool vtkMTRecordSpool::Take(std::size_t key, std::size_t place, vtkMTBytes::Record& record, std::string& error) const
{
  if (key >= this->GetNumberOfKeys() || place >= this->First[key + 1] - this->First[key])
  {
    error = "record " + std::to_string(place) + " under key " + std::to_string(key) + " of " +
      std::to_string(this->GetNumberOfKeys());
    return false;
  }
  return this->Take(this->Entries[this->First[key] + place], record, error);
}

void vtkMTRecordSpool::Forget(std::size_t key)
{
  for (std::uint32_t i = this->First[key]; i < this->First[key + 1]; ++i)
  {
    // With what is between it and the next one.
    const Entry& entry = this->Entries[i];
    const std::size_t size = entry.Size + vtkMTBytes::Alignment - 1;
    this->Spool->Forget(entry.Offset, size - size % vtkMTBytes::Alignment);
  }
}

std::uint64_t vtkMTRecordSpool::GetSize(std::size_t key) const
{
  std::uint64_t size = 0;
  for (std::uint32_t i = this->First[key]; i < this->First[key + 1]; ++i)
  {
    size += this->Entries[i].Size;
  }
  return size;
}

void vtkMTRecordSpool::Save(std::vector<unsigned char>& state) const
{
  const std::uint64_t head[3] = { this->Spool->GetSize(), this->GetNumberOfKeys(), this->Entries.size() };
  state.resize(sizeof(head) + this->Entries.size() * sizeof(Entry));
  std::memcpy(state.data(), head, sizeof(head));
  std::copy_n(reinterpret_cast<const unsigned char*>(this->Entries.data()), this->Entries.size() * sizeof(Entry),
    state.data() + sizeof(head));
}

bool vtkMTRecordSpool::Open(
  vtkMTSpoolStore& store, const std::string& name, const std::vector<unsigned char>& state, std::string& error)
{
  std::uint64_t head[3] = { 0, 0, 0 };
  std::memcpy(head, state.data(), std::min(sizeof(head), state.size()));
  if (state.size() < sizeof(head) || state.size() - sizeof(head) != head[2] * sizeof(Entry))
  {
    error = "the records of " + name + " are not those that were kept";
    return false;
  }
  this->Store = &store;
  this->Name = name;
  this->Entries.resize(static_cast<std::size_t>(head[2]));
  std::copy_n(state.data() + sizeof(head), this->Entries.size() * sizeof(Entry),
    reinterpret_cast<unsigned char*>(this->Entries.data()));
  this->First.assign(static_cast<std::size_t>(head[1]) + 1, 0);
  for (const Entry& entry : this->Entries)
  {
    if (entry.Key >= head[1])
    {
      error = "the records of " + name + " are not those that were kept";
      return false;
    }
  }
  this->SortEntries();
  this->Spool = store.Open(name, head[0], error);
  return this->Spool != nullptr;
}

void vtkMTRecordSpool::Remove()
{
  if (this->Spool)
  {
    this->Spool.reset();
    this->Store->Remove(this->Name);
  }
  vtkMTRelease(this->Entries);
  vtkMTRelease(this->First);
  vtkMTRelease(this->Buffer);
}
