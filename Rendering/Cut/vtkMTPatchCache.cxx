// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPatchCache.h"

#include "vtkMTGraph.h"
#include "vtkMTPatchSource.h"

#include <utility>

vtkMTPatchCache::vtkMTPatchCache(std::shared_ptr<const vtkMTPatchSource> source, std::size_t limit)
  : Source(std::move(source))
  , Limit(limit)
{
}

vtkMTPatchCache::~vtkMTPatchCache() = default;

void vtkMTPatchCache::SetLimit(std::size_t limit)
{
  this->Limit = limit;
  ++this->RequestCount; // nothing is protected any more
  this->MakeRoom(0);
}

void vtkMTPatchCache::Request(const std::vector<std::uint32_t>& arcs)
{
  ++this->RequestCount;
  for (const std::uint32_t arc : arcs)
  {
    if (arc >= this->Source->GetGraph().Arcs.size() || this->Failed.count(arc))
    {
      continue;
    }
    const auto found = this->Entries.find(arc);
    if (found != this->Entries.end() && this->Has(found->second))
    {
      found->second.LastRequest = this->RequestCount;
      this->Order.splice(this->Order.end(), this->Order, found->second.Position);
    }
    else
    {
      this->Read(arc);
    }
  }
}

vtkMTPatchCache::PatchPointer vtkMTPatchCache::Get(std::uint32_t arc) const
{
  const auto found = this->Entries.find(arc);
  return found != this->Entries.end() && this->Has(found->second) ? found->second.Patch : nullptr;
}

std::vector<vtkMTPatchCache::Failure> vtkMTPatchCache::TakeFailures()
{
  return std::exchange(this->Failures, {});
}

bool vtkMTPatchCache::Has(const Entry& entry) const
{
  if (entry.Arrays.empty())
  {
    return true;
  }
  const std::size_t count = this->Source->GetGraph().Arrays.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    const bool wanted = this->Arrays.empty() || this->Arrays[i] != 0;
    if (wanted && !entry.Arrays[i])
    {
      return false;
    }
  }
  return true;
}

void vtkMTPatchCache::Read(std::uint32_t arc)
{
  Entry entry;
  entry.Arrays = this->Arrays;
  const auto found = this->Entries.find(arc);
  if (found != this->Entries.end() && !entry.Arrays.empty())
  {
    // What it had is likely to be wanted again: keep that too.
    for (std::size_t i = 0; i < entry.Arrays.size(); ++i)
    {
      entry.Arrays[i] = entry.Arrays[i] || found->second.Arrays[i];
    }
  }
  this->Drop(arc);

  auto patch = std::make_shared<vtkMTPatch>();
  std::string error;
  ++this->Reads;
  if (!this->Source->ReadPatch(arc, entry.Arrays.empty() ? nullptr : &entry.Arrays, *patch, error))
  {
    this->Fail(arc, error);
    return;
  }
  entry.Bytes = patch->GetMemorySize();
  entry.Patch = std::move(patch);
  if (entry.Bytes > this->Limit)
  {
    this->Fail(arc,
      "patch " + std::to_string(arc) + " takes " + std::to_string(entry.Bytes) + " bytes, more than the limit of " +
        std::to_string(this->Limit));
    return;
  }
  if (this->MakeRoom(entry.Bytes))
  {
    this->Keep(arc, std::move(entry));
  }
}

void vtkMTPatchCache::Keep(std::uint32_t arc, Entry&& entry)
{
  this->Bytes += entry.Bytes;
  entry.LastRequest = this->RequestCount;
  entry.Position = this->Order.insert(this->Order.end(), arc);
  this->Entries.emplace(arc, std::move(entry));
}

bool vtkMTPatchCache::MakeRoom(std::size_t bytes)
{
  while (!this->Order.empty() && this->Bytes + bytes > this->Limit)
  {
    const std::uint32_t oldest = this->Order.front();
    if (this->Entries.at(oldest).LastRequest == this->RequestCount)
    {
      return false;
    }
    this->Drop(oldest);
  }
  return this->Bytes + bytes <= this->Limit;
}

void vtkMTPatchCache::Drop(std::uint32_t arc)
{
  const auto found = this->Entries.find(arc);
  if (found != this->Entries.end())
  {
    this->Bytes -= found->second.Bytes;
    this->Order.erase(found->second.Position);
    this->Entries.erase(found);
  }
}

void vtkMTPatchCache::Fail(std::uint32_t arc, const std::string& what)
{
  this->Failed.insert(arc);
  this->Failures.push_back({ arc, what });
}
