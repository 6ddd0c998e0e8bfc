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
  explicit MTFaultyStore(vtkMTSpoolStore& store);

  /// The write (reads: the read) with this number, counted from 0, fails; so do all after it.
  std::uint64_t FailingWrite = ~std::uint64_t(0);
  std::uint64_t FailingRead = ~std::uint64_t(0);
  std::uint64_t GetNumberOfWrites() const { return this->Writes; }
  std::uint64_t GetNumberOfReads() const { return this->Reads; }

  std::unique_ptr<vtkMTSpool> Create(std::string& error) override;
  std::unique_ptr<vtkMTSpool> Create(const std::string& name, std::string& error) override;
  std::unique_ptr<vtkMTSpool> Open(const std::string& name, std::uint64_t size, std::string& error) override;
  void Remove(const std::string& name) override;
  bool IsLasting() const override;
  bool Commit(const std::vector<unsigned char>& state, std::string& error) override;
  bool Restore(std::vector<unsigned char>& state, std::string& error) override;
  void Clear() override;
  std::uint64_t GetSize() const override;
  std::uint64_t GetLargestSize() const override;

private:
  class Spool;

  std::unique_ptr<vtkMTSpool> Wrap(std::unique_ptr<vtkMTSpool> spool);
  bool CountWrite(std::string& error);

  vtkMTSpoolStore& Store;
  std::atomic<std::uint64_t> Writes{ 0 };
  std::atomic<std::uint64_t> Reads{ 0 };
};

#endif
