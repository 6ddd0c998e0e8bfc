// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTMemorySpoolStore.h"

#include <algorithm>
#include <cstring>
#include <map>
#include <new>

namespace
{
constexpr std::size_t PieceSize = std::size_t(1) << 20;

// What all spools of a store hold; it outlives the store as long as there are spools.
struct Account
{
  std::uint64_t Size = 0;
  std::uint64_t Largest = 0;

  void Add(std::uint64_t size)
  {
    this->Size += size;
    this->Largest = std::max(this->Largest, this->Size);
  }
};

struct Storage
{
  explicit Storage(std::shared_ptr<Account> account)
    : Holder(std::move(account))
  {
  }
  ~Storage() { this->Holder->Size -= this->Size - this->Forgotten; }
  Storage(const Storage&) = delete;
  void operator=(const Storage&) = delete;

  void Append(const unsigned char* from, std::size_t size)
  {
    this->Holder->Add(size);
    while (size > 0)
    {
      const std::size_t begin = this->Size % PieceSize;
      if (begin == 0)
      {
        this->Pieces.emplace_back(new unsigned char[PieceSize]);
        this->Needed.push_back(0);
      }
      const std::size_t count = std::min(size, PieceSize - begin);
      std::memcpy(this->Pieces.back().get() + begin, from, count);
      this->Size += count;
      this->Needed.back() += count;
      from += count;
      size -= count;
    }
  }

  void Read(std::uint64_t offset, std::size_t size, unsigned char* to) const
  {
    while (size > 0)
    {
      const std::size_t begin = offset % PieceSize;
      const std::size_t count = std::min(size, PieceSize - begin);
      std::memcpy(to, this->Pieces[offset / PieceSize].get() + begin, count);
      offset += count;
      to += count;
      size -= count;
    }
  }

  const unsigned char* Find(std::uint64_t offset, std::size_t size) const
  {
    const std::size_t begin = offset % PieceSize;
    const bool isInOne = size <= PieceSize - begin && offset <= this->Size && size <= this->Size - offset;
    return isInOne && size > 0 ? this->Pieces[offset / PieceSize].get() + begin : nullptr;
  }

  // A part goes when all of it has been forgotten.
  void Forget(std::uint64_t offset, std::uint64_t size)
  {
    const std::uint64_t end = std::min(offset + size, this->Size);
    while (offset < end)
    {
      const std::size_t piece = offset / PieceSize;
      const std::uint64_t count = std::min(end, (piece + 1) * std::uint64_t(PieceSize)) - offset;
      this->Needed[piece] -= count;
      this->Forgotten += count;
      this->Holder->Size -= count;
      if (this->Needed[piece] == 0 && (piece + 1 < this->Pieces.size() || this->Size % PieceSize == 0))
      {
        this->Pieces[piece].reset();
      }
      offset += count;
    }
  }

  std::vector<std::unique_ptr<unsigned char[]>> Pieces;
  std::vector<std::uint64_t> Needed; // bytes of each part
  std::uint64_t Forgotten = 0;
  std::uint64_t Size = 0;
  std::shared_ptr<Account> Holder;
};

class MemorySpool : public vtkMTSpool
{
public:
  explicit MemorySpool(std::shared_ptr<Storage> storage)
    : Bytes(std::move(storage))
  {
  }

  bool Append(const void* data, std::size_t size, std::string& error) override
  {
    try
    {
      this->Bytes->Append(static_cast<const unsigned char*>(data), size);
    }
    catch (const std::bad_alloc&)
    {
      error = "there is not enough memory";
      return false;
    }
    return true;
  }

  bool Read(std::uint64_t offset, std::size_t size, void* data, std::string& error) const override
  {
    if (offset > this->Bytes->Size || size > this->Bytes->Size - offset)
    {
      error = "a spool of " + std::to_string(this->Bytes->Size) + " bytes was read at byte " + std::to_string(offset);
      return false;
    }
    this->Bytes->Read(offset, size, static_cast<unsigned char*>(data));
    return true;
  }

  const unsigned char* Find(std::uint64_t offset, std::size_t size) const override
  {
    return this->Bytes->Find(offset, size);
  }

  bool IsInMemory() const override { return true; }
  void Forget(std::uint64_t offset, std::size_t size) override { this->Bytes->Forget(offset, size); }

  std::uint64_t GetSize() const override { return this->Bytes->Size; }

private:
  std::shared_ptr<Storage> Bytes;
};
}

struct vtkMTMemorySpoolStore::Internals
{
  std::shared_ptr<Account> Holder = std::make_shared<Account>();
  std::map<std::string, std::shared_ptr<Storage>> Named;
};

vtkMTMemorySpoolStore::vtkMTMemorySpoolStore()
  : Implementation(std::make_unique<Internals>())
{
}

vtkMTMemorySpoolStore::~vtkMTMemorySpoolStore() = default;

std::unique_ptr<vtkMTSpool> vtkMTMemorySpoolStore::Create(std::string&)
{
  return std::make_unique<MemorySpool>(std::make_shared<Storage>(this->Implementation->Holder));
}

std::unique_ptr<vtkMTSpool> vtkMTMemorySpoolStore::Create(const std::string& name, std::string& error)
{
  const auto storage = std::make_shared<Storage>(this->Implementation->Holder);
  if (!this->Implementation->Named.emplace(name, storage).second)
  {
    error = "there is a spool " + name + " already";
    return nullptr;
  }
  return std::make_unique<MemorySpool>(storage);
}

std::unique_ptr<vtkMTSpool> vtkMTMemorySpoolStore::Open(const std::string& name, std::uint64_t size, std::string& error)
{
  const auto found = this->Implementation->Named.find(name);
  if (found == this->Implementation->Named.end() || found->second->Size != size)
  {
    error = "there is no spool " + name + " of " + std::to_string(size) + " bytes";
    return nullptr;
  }
  return std::make_unique<MemorySpool>(found->second);
}

void vtkMTMemorySpoolStore::Remove(const std::string& name)
{
  this->Implementation->Named.erase(name);
}

bool vtkMTMemorySpoolStore::Commit(const std::vector<unsigned char>&, std::string&)
{
  return true;
}

bool vtkMTMemorySpoolStore::Restore(std::vector<unsigned char>& state, std::string&)
{
  state.clear();
  return true;
}

void vtkMTMemorySpoolStore::Clear()
{
  this->Implementation->Named.clear();
}

std::uint64_t vtkMTMemorySpoolStore::GetSize() const
{
  return this->Implementation->Holder->Size;
}

std::uint64_t vtkMTMemorySpoolStore::GetLargestSize() const
{
  return this->Implementation->Holder->Largest;
}
