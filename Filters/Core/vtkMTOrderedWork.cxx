// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTOrderedWork.h"

#include "vtkMTStageTimes.h"

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace
{
bool Guard(const vtkMTOrderedWork::Work& work, std::size_t index, std::size_t slot, std::string& error)
{
  try
  {
    return work(index, slot, error);
  }
  catch (const std::exception& e)
  {
    error = std::string("out of memory or an internal fault: ") + e.what();
    return false;
  }
}

class Crew
{
public:
  Crew(std::size_t count, std::size_t slots, const vtkMTOrderedWork::Budget& budget,
    const vtkMTOrderedWork::Work& fetch, const vtkMTOrderedWork::Work& work)
    : Count(count)
    , Limit(budget)
    , Results(slots)
    , DoFetch(fetch)
    , DoWork(work)
  {
  }

  ~Crew() { this->Stop(); }

  void Start(int threads)
  {
    try
    {
      for (int i = 0; i < threads; ++i)
      {
        this->Threads.emplace_back([this] { this->WorkOn(); });
      }
    }
    catch (const std::system_error&) // fewer threads do as well
    {
    }
  }
  bool HasThreads() const { return !this->Threads.empty(); }

  // Waits for the result of the next index. False when its work failed.
  bool Await(std::size_t index, std::string& error)
  {
    const vtkMTStageTimes::Scope waiting(nullptr, vtkMTStageTimes::Read); // the time is charged to those who work
    std::unique_lock<std::mutex> lock(this->Mutex);
    Result& result = this->Results[index % this->Results.size()];
    this->HasResult.wait(lock, [&result] { return result.IsDone; });
    error = result.Error;
    return result.IsGood;
  }

  void Release(std::size_t index)
  {
    {
      const std::lock_guard<std::mutex> lock(this->Mutex);
      Result& result = this->Results[index % this->Results.size()];
      this->AtWork -= result.Cost;
      result = Result();
      ++this->Taken;
    }
    this->HasRoom.notify_one();
  }

private:
  struct Result
  {
    bool IsDone = false;
    bool IsGood = false;
    std::string Error;
    std::uint64_t Cost = 0;
  };

  std::uint64_t GetCost(std::size_t index) const { return this->Limit.Memory > 0 ? this->Limit.Cost(index) : 0; }

  // Whether the next index may be begun.
  bool HasRoomForNext() const
  {
    return this->Next < this->Taken + this->Results.size() &&
      (this->AtWork == 0 || this->Limit.Memory == 0 || this->AtWork + this->GetCost(this->Next) <= this->Limit.Memory);
  }

  void WorkOn()
  {
    std::unique_lock<std::mutex> turn(this->Turn, std::defer_lock);
    for (;;)
    {
      // Whoever has the turn takes the next index and fetches for it; the others queue up behind.
      turn.lock();
      std::unique_lock<std::mutex> lock(this->Mutex);
      this->HasRoom.wait(
        lock, [this] { return this->IsStopped || this->Next == this->Count || this->HasRoomForNext(); });
      if (this->IsStopped || this->Next == this->Count)
      {
        return;
      }
      const std::size_t index = this->Next++;
      const std::size_t slot = index % this->Results.size();
      const std::uint64_t cost = this->GetCost(index);
      this->AtWork += cost;
      lock.unlock();
      std::string error;
      bool good = !this->DoFetch || Guard(this->DoFetch, index, slot, error);
      turn.unlock();
      good = good && Guard(this->DoWork, index, slot, error);
      lock.lock();
      this->Results[slot] = { true, good, error, cost };
      this->HasResult.notify_one();
    }
  }

  void Stop()
  {
    {
      const std::lock_guard<std::mutex> lock(this->Mutex);
      this->IsStopped = true;
    }
    this->HasRoom.notify_all();
    for (std::thread& thread : this->Threads)
    {
      thread.join();
    }
  }

  const std::size_t Count;
  const vtkMTOrderedWork::Budget& Limit;
  std::uint64_t AtWork = 0; // cost of what is begun and not yet taken
  std::mutex Turn;
  std::mutex Mutex;
  std::condition_variable HasResult;
  std::condition_variable HasRoom;
  std::vector<Result> Results;
  std::size_t Next = 0;
  std::size_t Taken = 0;
  bool IsStopped = false;
  const vtkMTOrderedWork::Work& DoFetch;
  const vtkMTOrderedWork::Work& DoWork;
  std::vector<std::thread> Threads;
};
}

bool vtkMTOrderedWork::Run(std::size_t count, int threads, const Budget& budget, const Work& fetch, const Work& work,
  const Work& take, std::string& error)
{
  const std::size_t slots = GetNumberOfSlots(threads);
  Crew crew(count, slots, budget, fetch, work);
  if (threads > 1 && count > 1)
  {
    crew.Start(static_cast<int>(std::min<std::size_t>(static_cast<std::size_t>(threads), count)));
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::size_t slot = i % slots;
    const bool worked = crew.HasThreads() ? crew.Await(i, error)
                                          : (!fetch || Guard(fetch, i, slot, error)) && Guard(work, i, slot, error);
    if (!worked || !Guard(take, i, slot, error))
    {
      return false;
    }
    if (crew.HasThreads())
    {
      crew.Release(i);
    }
  }
  return true;
}

bool vtkMTOrderedWork::Run(std::size_t count, int threads, const Work& work, const Work& take, std::string& error)
{
  return Run(count, threads, Budget(), Work(), work, take, error);
}

bool vtkMTOrderedWork::Run(
  std::size_t count, int threads, const Budget& budget, const Work& work, const Work& take, std::string& error)
{
  return Run(count, threads, budget, Work(), work, take, error);
}

bool vtkMTOrderedWork::Run(
  std::size_t count, int threads, const Work& fetch, const Work& work, const Work& take, std::string& error)
{
  return Run(count, threads, Budget(), fetch, work, take, error);
}
