// SPDX-License-Identifier: BSD-3-Clause
// A spool store that fails: every operation is counted, and one of them goes wrong.
#ifndef MTFaultyStore_h
#define MTFaultyStore_h

#include "vtkMTSpoolStore.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

class MTFaultyStore : public vtkMTSpoolStore
{
public:
  explicit MTFaultyStore(vtkMTSpoolStore& store)
    : Store(store)
  {
  }

  /// The write (reads: the read) with this number, counted from 0, fails; so do all after it.
  std::uint64_t FailingWrite = ~std::uint64_t(0);
  std::uint64_t FailingRead = ~std::uint64_t(0);
  std::uint64_t GetNumberOfWrites() const { return this->Writes; }
  std::uint64_t GetNumberOfReads() const { return this->Reads; }

  std::unique_ptr<vtkMTSpool> Create(std::string& error) override { return this->Wrap(this->Store.Create(error)); }
  std::unique_ptr<vtkMTSpool> Create(const std::string& name, std::string& error) override
  {
    return this->CountWrite(error) ? this->Wrap(this->Store.Create(name, error)) : nullptr;
  }
  std::unique_ptr<vtkMTSpool> Open(const std::string& name, std::uint64_t size, std::string& error) override
  {
    return this->Wrap(this->Store.Open(name, size, error));
  }
  void Remove(const std::string& name) override { this->Store.Remove(name); }
  bool IsLasting() const override { return this->Store.IsLasting(); }
  bool Commit(const std::vector<unsigned char>& state, std::string& error) override
  {
    return this->CountWrite(error) && this->Store.Commit(state, error);
  }
  bool Restore(std::vector<unsigned char>& state, std::string& error) override
  {
    return this->Store.Restore(state, error);
  }
  void Clear() override { this->Store.Clear(); }
  std::uint64_t GetSize() const override { return this->Store.GetSize(); }
  std::uint64_t GetLargestSize() const override { return this->Store.GetLargestSize(); }

private:
  class Spool : public vtkMTSpool
  {
  public:
    Spool(MTFaultyStore& store, std::unique_ptr<vtkMTSpool> spool)
      : Store(store)
      , Bytes(std::move(spool))
    {
    }
    bool Append(const void* data, std::size_t size, std::string& error) override
    {
      return this->Store.CountWrite(error) && this->Bytes->Append(data, size, error);
    }
    bool Read(std::uint64_t offset, std::size_t size, void* data, std::string& error) const override
    {
      if (this->Store.Reads++ >= this->Store.FailingRead)
      {
        error = "planned failure of a read";
        return false;
      }
      return this->Bytes->Read(offset, size, data, error);
    }
    std::uint64_t GetSize() const override { return this->Bytes->GetSize(); }

  private:
    MTFaultyStore& Store;
    std::unique_ptr<vtkMTSpool> Bytes;
  };

  std::unique_ptr<vtkMTSpool> Wrap(std::unique_ptr<vtkMTSpool> spool)
  {
    return spool ? std::make_unique<Spool>(*this, std::move(spool)) : nullptr;
  }

  bool CountWrite(std::string& error)
  {
    if (this->Writes++ >= this->FailingWrite)
    {
      error = "planned failure: no space left";
      return false;
    }
    return true;
  }

  vtkMTSpoolStore& Store;
  std::atomic<std::uint64_t> Writes{ 0 };
  std::atomic<std::uint64_t> Reads{ 0 };
};

#endif
