// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPatchLoader.h"

#include "vtkMTGraph.h"
#include "vtkMTMemoryLimit.h"
#include "vtkMTPatchSource.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <unordered_set>
#include <utility>

namespace
{
constexpr int MaximumThreads = 64;

struct Batch
{
  std::vector<std::uint32_t> Arcs; // in the order of the store
  std::vector<std::size_t> Bytes;  // what each one takes at most
  std::uint64_t Stored = 0;        // bytes of all of them in the store, and of gaps between them
  std::uint64_t Scratch = 0;       // bytes that decoding the largest of them takes
  std::shared_ptr<const vtkMTPatchLoader::Order> Order;
};

// OpenGL checks no index, and neither does anybody else who draws.
bool IsSound(const vtkMTPatch& patch, const vtkMTArc& arc)
{
  const std::size_t wedges = patch.GetNumberOfWedges();
  const std::size_t points = patch.Points.size();
  return wedges == arc.Wedges && patch.Triangles.size() == arc.Triangles &&
    std::all_of(patch.WedgePoints.begin(), patch.WedgePoints.end(), [points](std::uint32_t i) { return i < points; }) &&
    std::all_of(patch.Triangles.begin(), patch.Triangles.end(),
      [wedges](const vtkMTTriangle& t) { return t[0] < wedges && t[1] < wedges && t[2] < wedges; });
}
}

// Two locks. Mail is the one that the owner takes: it guards a few pointers. Planning is the loader threads' own: one
// at a time looks through what is posted and chooses what to read. Neither is held while a patch is read or decoded.
struct vtkMTPatchLoader::Internals
{
  std::shared_ptr<const vtkMTPatchSource> Source;
  std::shared_ptr<vtkMTMemoryLimit> Memory;
  Settings Options;
  std::vector<std::thread> Threads;

  mutable std::mutex Mail;
  std::condition_variable Work;       // for the loader's threads
  std::condition_variable News;       // for Wait
  std::shared_ptr<const Order> Inbox; // posted and not planned yet
  std::vector<Delivery> Outbox;
  std::uint64_t Version = 0; // counts what may have made something possible: posts, ends of batches
  int Resting = 0;           // threads that found nothing to do at this version
  bool Stopping = false;
  std::unordered_set<std::uint32_t> Started; // being read, or delivered and not taken yet
  std::vector<std::uint32_t> LateTaken;      // taken since the post in the inbox, which may ask for them
  std::chrono::steady_clock::duration LongestLock{ 0 };

  std::mutex Planning;
  std::shared_ptr<const Order> Plan;
  std::vector<std::uint32_t> ByPlace; // indices in the plan, in the order of the store
  std::vector<std::uint32_t> PlaceOf; // where an index is in ByPlace
  std::vector<unsigned char> Done;
  std::size_t Next = 0; // all before are done

  std::atomic<std::uint64_t> Patches{ 0 };
  std::atomic<std::uint64_t> Batches{ 0 };
  std::atomic<std::uint64_t> StoredBytes{ 0 };

  template <typename Function>
  void WithMail(Function&& function)
  {
    const auto start = std::chrono::steady_clock::now();
    {
      const std::lock_guard<std::mutex> lock(this->Mail);
      function();
      this->LongestLock = std::max(this->LongestLock, std::chrono::steady_clock::now() - start);
    }
  }

  // `underway`: what the post asks for and has been started for an earlier one.
  void MakePlan(std::shared_ptr<const Order> order, const std::unordered_set<std::uint32_t>& underway)
  {
    this->Plan = std::move(order);
    const std::vector<std::uint32_t>& arcs = this->Plan->Arcs;
    const std::size_t arcCount = this->Source->GetKnownGraph().Arcs.size();
    this->Next = 0;
    this->Done.assign(arcs.size(), 0);
    std::vector<std::pair<std::uint64_t, std::uint32_t>> places;
    places.reserve(arcs.size());
    for (std::size_t i = 0; i < arcs.size(); ++i)
    {
      const bool inRange = arcs[i] < arcCount;
      this->Done[i] = !inRange || underway.count(arcs[i]) != 0;
      places.emplace_back(!inRange ? ~std::uint64_t(0) : this->Source->GetPatchPlace(arcs[i]), i);
    }
    std::sort(places.begin(), places.end());
    this->ByPlace.resize(arcs.size());
    this->PlaceOf.resize(arcs.size());
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      this->ByPlace[i] = places[i].second;
      this->PlaceOf[places[i].second] = static_cast<std::uint32_t>(i);
    }
  }

  // Adds a request to the batch, with room for it and for what is read before it; false where it cannot be had.
  bool Add(std::size_t index, std::uint64_t gap, Batch& batch)
  {
    const std::uint32_t arc = this->Plan->Arcs[index];
    const std::size_t bytes = vtkMTPatchLoader::GetPatchBytes(this->Source->GetKnownGraph(), arc, this->Plan->Arrays);
    const std::uint64_t stored = gap + this->Source->GetPatchSize(arc);
    const std::uint64_t scratch = std::max(this->Source->GetDecodeSize(arc), batch.Scratch);
    if (!this->Memory->Reserve(bytes + static_cast<std::size_t>(stored + scratch - batch.Scratch)))
    {
      return false;
    }
    batch.Scratch = scratch;
    batch.Arcs.push_back(arc);
    batch.Bytes.push_back(bytes);
    batch.Stored += stored;
    this->Done[index] = 1;
    return true;
  }

  // A patch that will never have room is an error; it must not keep the others waiting.
  bool IsTooLarge(std::size_t index)
  {
    Delivery delivery;
    delivery.Arc = this->Plan->Arcs[index];
    const std::size_t limit = this->Memory->GetLimit();
    const std::size_t bytes =
      vtkMTPatchLoader::GetPatchBytes(this->Source->GetKnownGraph(), delivery.Arc, this->Plan->Arrays) +
      static_cast<std::size_t>(this->Source->GetPatchSize(delivery.Arc) + this->Source->GetDecodeSize(delivery.Arc));
    if (bytes <= limit)
    {
      return false;
    }
    delivery.Error = this->Source->GetName() + ": patch " + std::to_string(delivery.Arc) + " takes " +
      std::to_string(bytes) + " bytes while it is read, more than the limit of " + std::to_string(limit);
    this->Done[index] = 1;
    const std::lock_guard<std::mutex> lock(this->Mail);
    this->Started.insert(delivery.Arc);
    this->Outbox.push_back(std::move(delivery));
    this->News.notify_all();
    return true;
  }

  // Adds what lies beside the batch's first request, on one side of it.
  void AddNeighbours(std::size_t index, bool behind, Batch& batch)
  {
    std::size_t place = this->PlaceOf[index];
    std::uint32_t last = this->Plan->Arcs[index];
    while (behind ? place + 1 < this->ByPlace.size() : place > 0)
    {
      place += behind ? 1 : std::size_t(0) - 1;
      const std::uint32_t neighbour = this->ByPlace[place];
      if (this->Done[neighbour])
      {
        return;
      }
      const std::uint32_t arc = this->Plan->Arcs[neighbour];
      const std::uint32_t low = behind ? last : arc;
      const std::uint32_t high = behind ? arc : last;
      const std::uint64_t end = this->Source->GetPatchPlace(low) + this->Source->GetPatchSize(low);
      const std::uint64_t begin = this->Source->GetPatchPlace(high);
      const std::uint64_t gap = begin > end ? begin - end : 0;
      if (gap > this->Options.LargestGap ||
        batch.Stored + this->Source->GetPatchSize(arc) > this->Options.LargestRead || !this->Add(neighbour, gap, batch))
      {
        return;
      }
      last = arc;
    }
  }

  // Chooses what to read next; false when there is nothing, or no room for it.
  bool Choose(Batch& batch)
  {
    const std::lock_guard<std::mutex> planning(this->Planning);
    std::shared_ptr<const Order> order;
    std::unordered_set<std::uint32_t> underway;
    {
      const std::lock_guard<std::mutex> lock(this->Mail);
      order.swap(this->Inbox);
      if (order)
      {
        underway = this->Started;
        underway.insert(this->LateTaken.begin(), this->LateTaken.end());
        this->LateTaken.clear();
      }
    }
    if (order)
    {
      this->MakePlan(std::move(order), underway);
    }
    while (this->Plan && this->Next < this->Done.size() && (this->Done[this->Next] || this->IsTooLarge(this->Next)))
    {
      ++this->Next;
    }
    if (!this->Plan || this->Next == this->Done.size() || !this->Add(this->Next, 0, batch))
    {
      return false;
    }
    this->AddNeighbours(this->Next, true, batch);
    this->AddNeighbours(this->Next, false, batch);
    batch.Order = this->Plan;
    this->SortByPlace(batch);
    const std::lock_guard<std::mutex> lock(this->Mail);
    this->Started.insert(batch.Arcs.begin(), batch.Arcs.end());
    return true;
  }

  void SortByPlace(Batch& batch) const
  {
    std::vector<std::size_t> order(batch.Arcs.size());
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      order[i] = i;
    }
    std::sort(order.begin(), order.end(),
      [&](std::size_t a, std::size_t b)
      { return this->Source->GetPatchPlace(batch.Arcs[a]) < this->Source->GetPatchPlace(batch.Arcs[b]); });
    Batch sorted;
    for (const std::size_t i : order)
    {
      sorted.Arcs.push_back(batch.Arcs[i]);
      sorted.Bytes.push_back(batch.Bytes[i]);
    }
    batch.Arcs.swap(sorted.Arcs);
    batch.Bytes.swap(sorted.Bytes);
  }

  // Hands a patch over, whose room has been reserved; or tells why there is none, and gives the room back.
  void Deliver(const Batch& batch, std::size_t index, bool read, vtkMTPatch& patch, const std::string& error)
  {
    Delivery delivery;
    delivery.Arc = batch.Arcs[index];
    delivery.Arrays = batch.Order->Arrays;
    const std::size_t reserved = batch.Bytes[index];
    const bool good =
      read && IsSound(patch, this->Source->GetKnownGraph().Arcs[delivery.Arc]) && patch.GetMemorySize() <= reserved;
    if (good)
    {
      delivery.Bytes = patch.GetMemorySize();
      const std::shared_ptr<vtkMTMemoryLimit> memory = this->Memory;
      const std::size_t bytes = delivery.Bytes;
      delivery.Patch = PatchPointer(new vtkMTPatch(std::move(patch)),
        [memory, bytes](const vtkMTPatch* gone)
        {
          delete gone;
          memory->Release(bytes);
        });
    }
    else
    {
      delivery.Error = read
        ? this->Source->GetName() + ": patch " + std::to_string(delivery.Arc) + " is not what the graph says"
        : error;
    }
    this->Memory->Release(reserved - delivery.Bytes);
    ++this->Patches;
    {
      const std::lock_guard<std::mutex> lock(this->Mail);
      this->Outbox.push_back(std::move(delivery));
    }
    this->News.notify_all();
  }

  void Load(const Batch& batch)
  {
    std::size_t delivered = 0;
    std::string error;
    try
    {
      this->Source->ReadPatches(batch.Arcs, batch.Order->Arrays.empty() ? nullptr : &batch.Order->Arrays,
        [&](std::size_t index, bool read, vtkMTPatch& patch, const std::string& reason)
        {
          this->Deliver(batch, index, read, patch, reason);
          delivered = index + 1;
        });
    }
    catch (const std::exception& exception)
    {
      error = exception.what();
    }
    for (; delivered < batch.Arcs.size(); ++delivered)
    {
      vtkMTPatch none;
      this->Deliver(batch, delivered, false, none,
        this->Source->GetName() + ": patch " + std::to_string(batch.Arcs[delivered]) + ": " + error);
    }
    this->Memory->Release(static_cast<std::size_t>(batch.Stored + batch.Scratch));
    ++this->Batches;
    this->StoredBytes += batch.Stored;
  }

  void Run()
  {
    while (true)
    {
      std::uint64_t version = 0;
      {
        const std::lock_guard<std::mutex> lock(this->Mail);
        if (this->Stopping)
        {
          return;
        }
        version = this->Version;
      }
      if (this->LoadSomething())
      {
        {
          const std::lock_guard<std::mutex> lock(this->Mail);
          ++this->Version;
        }
        this->Work.notify_all();
      }
      else
      {
        this->Rest(version);
      }
    }
  }

  bool LoadSomething()
  {
    try
    {
      Batch batch;
      if (this->Choose(batch))
      {
        this->Load(batch);
        return true;
      }
    }
    catch (const std::bad_alloc&)
    {
      // No memory for a list of requests: the next post may be shorter.
    }
    return false;
  }

  // Until something has happened since the given version.
  void Rest(std::uint64_t version)
  {
    std::unique_lock<std::mutex> lock(this->Mail);
    ++this->Resting;
    this->News.notify_all();
    this->Work.wait(lock, [&] { return this->Stopping || this->Version != version; });
    --this->Resting;
  }
};

vtkMTPatchLoader::vtkMTPatchLoader(
  std::shared_ptr<const vtkMTPatchSource> source, std::shared_ptr<vtkMTMemoryLimit> memory)
  : Implementation(std::make_unique<Internals>())
{
  this->Implementation->Source = std::move(source);
  this->Implementation->Memory = std::move(memory);
}

vtkMTPatchLoader::~vtkMTPatchLoader()
{
  this->Stop();
}

bool vtkMTPatchLoader::Start(const Settings& settings, std::string& error)
{
  Internals& self = *this->Implementation;
  this->Stop();
  self.Options = settings;
  self.Stopping = false;
  try
  {
    for (int i = 0; i < std::clamp(settings.Threads, 1, MaximumThreads); ++i)
    {
      self.Threads.emplace_back([&self] { self.Run(); });
    }
  }
  catch (const std::system_error& exception)
  {
    if (self.Threads.empty())
    {
      error = std::string("no thread to load patches can be started: ") + exception.what();
      return false;
    }
  }
  return true;
}

void vtkMTPatchLoader::Stop()
{
  Internals& self = *this->Implementation;
  {
    const std::lock_guard<std::mutex> lock(self.Mail);
    self.Stopping = true;
    self.Work.notify_all();
  }
  for (std::thread& thread : self.Threads)
  {
    thread.join();
  }
  self.Threads.clear();
  self.Inbox.reset();
  self.Plan.reset();
  self.Done.clear();
  self.Next = 0;
}

bool vtkMTPatchLoader::IsRunning() const
{
  return !this->Implementation->Threads.empty();
}

void vtkMTPatchLoader::Post(std::shared_ptr<const Order> order)
{
  Internals& self = *this->Implementation;
  self.WithMail(
    [&]
    {
      self.Inbox.swap(order); // what was there goes when the lock is free again
      self.LateTaken.clear();
      ++self.Version;
    });
  self.Work.notify_all(); // who wakes up must find the lock free
}

void vtkMTPatchLoader::Take(std::vector<Delivery>& deliveries)
{
  Internals& self = *this->Implementation;
  std::vector<Delivery> taken;
  self.WithMail(
    [&]
    {
      taken.swap(self.Outbox);
      for (const Delivery& delivery : taken)
      {
        self.Started.erase(delivery.Arc);
        if (self.Inbox)
        {
          self.LateTaken.push_back(delivery.Arc);
        }
      }
    });
  deliveries.insert(deliveries.end(), std::make_move_iterator(taken.begin()), std::make_move_iterator(taken.end()));
}

bool vtkMTPatchLoader::Wait()
{
  Internals& self = *this->Implementation;
  std::unique_lock<std::mutex> lock(self.Mail);
  const auto threads = static_cast<int>(self.Threads.size());
  self.News.wait(lock, [&] { return !self.Outbox.empty() || (!self.Inbox && self.Resting == threads); });
  return !self.Outbox.empty();
}

std::uint64_t vtkMTPatchLoader::GetNumberOfPatches() const
{
  return this->Implementation->Patches;
}

std::uint64_t vtkMTPatchLoader::GetNumberOfBatches() const
{
  return this->Implementation->Batches;
}

std::uint64_t vtkMTPatchLoader::GetNumberOfStoredBytes() const
{
  return this->Implementation->StoredBytes;
}

double vtkMTPatchLoader::GetLongestLock() const
{
  const std::lock_guard<std::mutex> lock(this->Implementation->Mail);
  return std::chrono::duration<double>(this->Implementation->LongestLock).count();
}

std::size_t vtkMTPatchLoader::GetPatchBytes(
  const vtkMTGraph& graph, std::uint32_t arc, const std::vector<unsigned char>& arrays)
{
  const vtkMTArc& record = graph.Arcs[arc];
  std::size_t bytes = record.Points * sizeof(vtkMTPoint) + record.SharedPoints * sizeof(std::uint64_t) +
    record.Wedges * sizeof(std::uint32_t) + record.Triangles * sizeof(vtkMTTriangle);
  for (std::size_t i = 0; i < graph.Arrays.size(); ++i)
  {
    const bool isWanted = arrays.empty() || (i < arrays.size() && arrays[i]);
    if (isWanted && (graph.IsFinest(arc) || !graph.Arrays[i].IsFinestOnly()))
    {
      const std::size_t tuples =
        graph.Arrays[i].Association == vtkMTArrayInfo::Point ? record.Wedges : record.Triangles;
      bytes += tuples * graph.Arrays[i].GetTupleSize();
    }
  }
  return bytes;
}
