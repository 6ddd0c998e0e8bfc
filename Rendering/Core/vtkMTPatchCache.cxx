// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPatchCache.h"

#include "vtkMTGraph.h"
#include "vtkMTMemoryLimit.h"
#include "vtkMTPatchSource.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace
{
constexpr double Unwanted = -std::numeric_limits<double>::infinity();

bool Precedes(const vtkMTPatchCache::Want& a, const vtkMTPatchCache::Want& b)
{
  return a.Priority != b.Priority ? a.Priority > b.Priority : a.Arc < b.Arc;
}
}

vtkMTPatchCache::vtkMTPatchCache(
  std::shared_ptr<const vtkMTPatchSource> source, std::size_t limit, const vtkMTPatchLoader::Settings& settings)
  : Source(std::move(source))
  , Memory(std::make_shared<vtkMTMemoryLimit>(limit))
  , LoaderSettings(settings)
  , Loader(std::make_unique<vtkMTPatchLoader>(this->Source, this->Memory))
{
}

vtkMTPatchCache::~vtkMTPatchCache() = default;

void vtkMTPatchCache::SetLimit(std::size_t limit)
{
  this->Memory->SetLimit(limit);
  while (this->Memory->GetUsed() > limit && !this->Entries.empty())
  {
    const auto least = std::min_element(this->Entries.begin(), this->Entries.end(),
      [](const auto& a, const auto& b)
      { return std::make_pair(a.second.LastWanted, a.first) < std::make_pair(b.second.LastWanted, b.first); });
    this->Drop(least->first);
  }
}

std::size_t vtkMTPatchCache::GetLimit() const
{
  return this->Memory->GetLimit();
}

std::size_t vtkMTPatchCache::GetUsedBytes() const
{
  return this->Memory->GetUsed();
}

std::size_t vtkMTPatchCache::GetMostUsedBytes() const
{
  return this->Memory->GetMostUsed();
}

bool vtkMTPatchCache::Collect()
{
  std::vector<vtkMTPatchLoader::Delivery> deliveries;
  this->Loader->Take(deliveries);
  for (vtkMTPatchLoader::Delivery& delivery : deliveries)
  {
    this->Insert(std::move(delivery));
  }
  return !deliveries.empty();
}

void vtkMTPatchCache::Insert(vtkMTPatchLoader::Delivery&& delivery)
{
  ++this->Reads;
  if (!delivery.Patch)
  {
    this->Fail(delivery.Arc, delivery.Error);
    return;
  }
  this->Drop(delivery.Arc);
  Entry entry;
  entry.Patch = std::move(delivery.Patch);
  entry.Arrays = std::move(delivery.Arrays);
  entry.Bytes = delivery.Bytes;
  entry.Priority = Unwanted;
  entry.LastWanted = this->Tick;
  this->Bytes += entry.Bytes;
  this->Entries.emplace(delivery.Arc, std::move(entry));
}

void vtkMTPatchCache::SetWants(const void* view, std::vector<Want> wants)
{
  this->Wants[view] = std::move(wants);
  this->Order();
}

void vtkMTPatchCache::Forget(const void* view)
{
  if (this->Wants.erase(view) > 0)
  {
    this->Order();
  }
}

// What all views want: the priorities of what is there, and a list of what is to be loaded, the most wanted first.
std::vector<vtkMTPatchCache::Want> vtkMTPatchCache::MergeWants()
{
  ++this->Tick;
  for (auto& each : this->Entries)
  {
    each.second.Priority = Unwanted;
  }
  const std::size_t arcs = this->Source->GetKnownGraph().Arcs.size();
  std::vector<Want> missing;
  for (const auto& view : this->Wants)
  {
    for (const Want& want : view.second)
    {
      const auto found = this->Entries.find(want.Arc);
      if (found != this->Entries.end() && this->Has(found->second))
      {
        found->second.Priority = std::max(found->second.Priority, want.Priority);
        found->second.LastWanted = this->Tick;
      }
      if (want.Load && want.Arc < arcs && !this->Failed.count(want.Arc) &&
        (found == this->Entries.end() || !this->Has(found->second)))
      {
        missing.push_back(want);
      }
    }
  }
  std::sort(missing.begin(), missing.end(), Precedes);
  std::unordered_set<std::uint32_t> seen;
  missing.erase(
    std::remove_if(missing.begin(), missing.end(), [&seen](const Want& want) { return !seen.insert(want.Arc).second; }),
    missing.end());
  return missing;
}

// Where patches are there without one of the arrays, what they have is likely to be wanted again: it is read too.
std::vector<unsigned char> vtkMTPatchCache::GetArraysToRead(const std::vector<Want>& missing) const
{
  std::vector<unsigned char> arrays = this->Arrays;
  for (const Want& want : missing)
  {
    const auto found = this->Entries.find(want.Arc);
    for (std::size_t i = 0; found != this->Entries.end() && i < arrays.size(); ++i)
    {
      arrays[i] = arrays[i] || found->second.Arrays[i];
    }
  }
  return arrays;
}

// Tells the loader what to load, as far as there is room, and makes that room.
void vtkMTPatchCache::Order()
{
  std::vector<Want> missing = this->MergeWants();
  auto order = std::make_shared<vtkMTPatchLoader::Order>();
  order->Arrays = this->GetArraysToRead(missing);

  struct Victim
  {
    double Priority;
    std::uint64_t LastWanted;
    std::uint32_t Arc;
    bool operator<(const Victim& other) const
    {
      return this->Priority != other.Priority  ? this->Priority < other.Priority
        : this->LastWanted != other.LastWanted ? this->LastWanted < other.LastWanted
                                               : this->Arc < other.Arc;
    }
  };
  std::vector<Victim> victims;
  bool sorted = false;
  std::size_t next = 0;
  std::size_t room = 0;
  std::size_t scratch = 0; // one patch's at a time is enough to get on
  const std::size_t limit = this->Memory->GetLimit();
  for (const Want& want : missing)
  {
    const std::size_t decoding = std::max(scratch, static_cast<std::size_t>(this->Source->GetDecodeSize(want.Arc)));
    room += this->GetRoomFor(want.Arc, order->Arrays) + decoding - scratch;
    scratch = decoding;
    if (!sorted && this->Memory->GetUsed() + room > limit)
    {
      sorted = true;
      for (const auto& each : this->Entries)
      {
        victims.push_back({ each.second.Priority, each.second.LastWanted, each.first });
      }
      std::sort(victims.begin(), victims.end());
    }
    while (this->Memory->GetUsed() + room > limit && next < victims.size() && victims[next].Priority < want.Priority)
    {
      this->Drop(victims[next++].Arc);
    }
    // The first one is always ordered: what fills the memory may be on its way back, and what is too large is told so.
    if (this->Memory->GetUsed() + room > limit && !order->Arcs.empty())
    {
      break;
    }
    order->Arcs.push_back(want.Arc);
  }
  this->Post(std::move(order));
}

// To the loader, which is started when there is something to load for the first time.
void vtkMTPatchCache::Post(std::shared_ptr<const vtkMTPatchLoader::Order> order)
{
  this->Missing = order->Arcs.size();
  std::string error;
  if (!order->Arcs.empty() && !this->Loader->IsRunning() && !this->Loader->Start(this->LoaderSettings, error))
  {
    for (const std::uint32_t arc : order->Arcs)
    {
      this->Fail(arc, this->Source->GetName() + ": patch " + std::to_string(arc) + ": " + error);
    }
    this->Missing = 0;
  }
  if (this->Loader->IsRunning())
  {
    this->Loader->Post(std::move(order));
  }
}

std::size_t vtkMTPatchCache::GetRoomFor(std::uint32_t arc, const std::vector<unsigned char>& arrays) const
{
  return vtkMTPatchLoader::GetPatchBytes(this->Source->GetKnownGraph(), arc, arrays) +
    static_cast<std::size_t>(this->Source->GetPatchSize(arc));
}

void vtkMTPatchCache::Request(const std::vector<std::uint32_t>& arcs)
{
  std::vector<Want> wants;
  wants.reserve(arcs.size());
  for (const std::uint32_t arc : arcs)
  {
    wants.push_back({ arc, -static_cast<double>(wants.size()), true });
  }
  this->Wants.clear();
  this->Wants[this] = std::move(wants);
  bool progress = true;
  while (progress)
  {
    this->Collect();
    this->Order();
    // What has come in may have left room for more.
    progress = false;
    while (this->Missing > 0 && this->Loader->Wait())
    {
      progress = this->Collect();
    }
  }
  this->Missing = 0;
  this->Wants.clear();
}

vtkMTPatchCache::PatchPointer vtkMTPatchCache::Get(std::uint32_t arc) const
{
  const auto found = this->Entries.find(arc);
  return found != this->Entries.end() && this->Has(found->second) ? found->second.Patch : nullptr;
}

bool vtkMTPatchCache::Has(std::uint32_t arc) const
{
  const auto found = this->Entries.find(arc);
  return found != this->Entries.end() && this->Has(found->second);
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
  const std::size_t count = this->Source->GetKnownGraph().Arrays.size();
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

void vtkMTPatchCache::Drop(std::uint32_t arc)
{
  const auto found = this->Entries.find(arc);
  if (found != this->Entries.end())
  {
    this->Bytes -= found->second.Bytes;
    this->Entries.erase(found);
  }
}

void vtkMTPatchCache::Fail(std::uint32_t arc, const std::string& what)
{
  if (this->Failed.insert(arc).second)
  {
    this->Failures.push_back({ arc, what });
  }
}
