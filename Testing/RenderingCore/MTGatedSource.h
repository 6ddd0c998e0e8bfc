// SPDX-License-Identifier: BSD-3-Clause
// A patch source whose reads wait until the test lets them go on, and that notes what was read.
#ifndef MTGatedSource_h
#define MTGatedSource_h

#include "MTTestModel.h"

#include "vtkMTPatchSource.h"

#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

class MTGatedSource : public vtkMTPatchSource
{
public:
  explicit MTGatedSource(std::shared_ptr<const vtkMTPatchSource> model)
    : Model(std::move(model))
  {
  }

  static std::shared_ptr<MTGatedSource> MakeTube() { return std::make_shared<MTGatedSource>(MTTestModel::MakeTube()); }

  const vtkMTGraph& GetGraph() const override { return this->Model->GetGraph(); }
  bool ReadPatch(
    std::uint32_t arc, const std::vector<unsigned char>* arrays, vtkMTPatch& patch, std::string& error) const override
  {
    std::unique_lock<std::mutex> lock(this->Mutex);
    this->Read.push_back(arc);
    this->Changed.notify_all();
    this->Changed.wait(lock, [this] { return this->Open; });
    if (this->Throwing.count(arc))
    {
      throw std::runtime_error("planned exception");
    }
    if (this->Broken.count(arc))
    {
      error = "gate: patch " + std::to_string(arc) + ": planned failure";
      return false;
    }
    lock.unlock();
    return this->Model->ReadPatch(arc, arrays, patch, error);
  }
  std::uint64_t GetPatchSize(std::uint32_t arc) const override { return this->Model->GetPatchSize(arc); }
  std::uint64_t GetDecodeSize(std::uint32_t) const override { return this->DecodeSize; }
  // Far apart, so that nothing is read together, unless Near.
  std::uint64_t GetPatchPlace(std::uint32_t arc) const override { return this->Near ? arc : std::uint64_t(arc) << 32; }
  std::string GetName() const override { return "gate"; }

  void SetOpen(bool open)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Open = open;
    this->Changed.notify_all();
  }
  // Until so many reads have begun.
  void AwaitReads(std::size_t count) const
  {
    std::unique_lock<std::mutex> lock(this->Mutex);
    this->Changed.wait(lock, [this, count] { return this->Read.size() >= count; });
  }
  std::vector<std::uint32_t> GetRead() const
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    return this->Read;
  }

  // To be set before anything is read.
  std::set<std::uint32_t> Broken;
  std::set<std::uint32_t> Throwing;
  bool Near = false;
  std::uint64_t DecodeSize = 0;

private:
  std::shared_ptr<const vtkMTPatchSource> Model;
  mutable std::mutex Mutex;
  mutable std::condition_variable Changed;
  mutable std::vector<std::uint32_t> Read;
  bool Open = true;
};

#endif
