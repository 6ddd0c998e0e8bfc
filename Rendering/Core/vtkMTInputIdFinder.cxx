// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTInputIdFinder.h"

#include "vtkMTFinestNear.h"
#include "vtkMTFinestPatches.h"
#include "vtkMTGraph.h"
#include "vtkMTPatchSource.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <limits>
#include <mutex>
#include <system_error>
#include <thread>
#include <unordered_set>

namespace
{
constexpr std::size_t GroupSize = 64; // places on one patch that are looked at together
constexpr std::size_t ReadSize = 16;  // patches that it reads at a time
constexpr double ShareOfLocating = 0.2;
constexpr double Rounding = 1e-9; // of distances that were computed by different ways
constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr std::uint32_t None = ~std::uint32_t(0);
}

class vtkMTInputIdFinder::Internals
{
public:
  Internals(const vtkMTPatchSource& source, vtkMTArrayInfo::RoleType role, const Settings& settings)
    : Source(source)
    , Threads(std::clamp(settings.Threads, 1, 64))
  {
    const std::vector<vtkMTArrayInfo>& arrays = source.GetKnownGraph().Arrays;
    const auto found = std::find_if(arrays.begin(), arrays.end(),
      [role](const vtkMTArrayInfo& info)
      { return info.Role == role && info.Type == VTK_ID_TYPE && info.Components == 1; });
    this->IsThere = found != arrays.end();
    this->OfPoints = role == vtkMTArrayInfo::InputPointIds;
    this->Array = static_cast<std::size_t>(found - arrays.begin());
    this->MemoryLimit = settings.MemoryLimit;
  }

  bool Find(const std::vector<Query>& queries, std::vector<vtkIdType>& ids, const Progress& progress)
  {
    ids.assign(queries.size(), Unknown);
    this->Error.clear();
    if (queries.empty())
    {
      return true;
    }
    const vtkMTGraph& graph = this->Source.GetGraph();
    if (!this->IsThere || !graph.IsWhole())
    {
      this->Error = this->IsThere ? this->Source.GetGraphError() : "the model keeps no such ids";
      return false;
    }
    if (!this->Patches)
    {
      this->Patches = std::make_unique<vtkMTFinestPatches>(this->Source, this->Array, this->MemoryLimit);
    }
    this->Stop = false;
    this->Located = this->Found = 0;
    this->Report = progress;
    this->Total = queries.size();
    this->MakeGroups(queries);
    const std::vector<std::uint32_t> nearest = this->FindNearest(queries);
    const std::size_t groups = this->Begins.size() - 1;
    for (std::size_t begin = 0; begin < groups && !this->Stop;)
    {
      const std::size_t end = this->Fetch(nearest, begin);
      this->ForAll(
        end - begin, [&](std::size_t i, vtkMTFinestNear& near) { this->FindGroup(begin + i, queries, near, ids); });
      begin = end;
    }
    return this->Error.empty() && !this->Stop;
  }

  const vtkMTPatchSource& Source;
  const int Threads;
  bool IsThere = false;
  bool OfPoints = false;
  std::size_t Array = 0;
  std::size_t MemoryLimit = 0;
  Resident GetResident;
  std::unique_ptr<vtkMTFinestPatches> Patches;
  std::string Error;

private:
  // Places on one patch that follow each other are near each other.
  void MakeGroups(const std::vector<Query>& queries)
  {
    this->Begins.assign(1, 0);
    for (std::size_t i = 1; i < queries.size(); ++i)
    {
      if (queries[i].Arc != queries[i - 1].Arc || i - this->Begins.back() == GroupSize)
      {
        this->Begins.push_back(i);
      }
    }
    this->Begins.push_back(queries.size());
  }

  Place GetMiddle(std::size_t group, const std::vector<Query>& queries) const
  {
    const std::size_t count = this->Begins[group + 1] - this->Begins[group];
    Place middle{};
    for (std::size_t i = this->Begins[group]; i < this->Begins[group + 1]; ++i)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        middle[k] += queries[i].X[k] / static_cast<double>(count);
      }
    }
    return middle;
  }

  // The patch whose box is nearest to each place: where the nearest triangle is, as a rule.
  std::vector<std::uint32_t> FindNearest(const std::vector<Query>& queries)
  {
    const vtkMTGraph& graph = this->Source.GetGraph();
    std::vector<std::uint32_t> nearest(queries.size(), 0);
    this->ForAll(this->Begins.size() - 1,
      [&](std::size_t group, vtkMTFinestNear& near)
      {
        vtkMTFinestNear::Neighbourhood around(near, this->GetMiddle(group, queries));
        for (std::size_t i = this->Begins[group]; i < this->Begins[group + 1]; ++i)
        {
          const Place x = vtkMTFinestNear::ToSteps(graph, queries[i].X);
          double least2 = Infinity;
          const auto visit = [&](std::uint32_t arc)
          {
            const double distance2 = vtkMTFinestNear::GetDistance2(graph.Arcs[arc].Box, x);
            nearest[i] = distance2 < least2 ? arc : nearest[i];
            least2 = std::min(least2, distance2);
          };
          around.ForAll(
            x, [&least2] { return least2; }, visit);
          ++this->Located;
        }
      });
    return nearest;
  }

  // Has the patches read that places of the groups from begin on are nearest to, as many as fit. Gives the end of these
  // groups.
  std::size_t Fetch(const std::vector<std::uint32_t>& nearest, std::size_t begin)
  {
    std::unordered_set<std::uint32_t> chosen;
    std::size_t bytes = 0;
    std::size_t end = begin;
    for (; end + 1 < this->Begins.size() && (end == begin || bytes < this->MemoryLimit / 4 * 3); ++end)
    {
      for (std::size_t i = this->Begins[end]; i < this->Begins[end + 1]; ++i)
      {
        bytes += chosen.insert(nearest[i]).second ? this->Patches->GetBytes(nearest[i]) : 0;
      }
    }
    std::vector<std::uint32_t> arcs;
    for (const std::uint32_t arc : chosen)
    {
      const std::shared_ptr<const vtkMTPatch> resident = this->GetResident ? this->GetResident(arc) : nullptr;
      if (resident)
      {
        this->Patches->Add(arc, resident);
      }
      if (!this->Patches->Has(arc))
      {
        arcs.push_back(arc);
      }
    }
    std::sort(arcs.begin(), arcs.end(),
      [this](std::uint32_t a, std::uint32_t b)
      { return this->Source.GetPatchPlace(a) < this->Source.GetPatchPlace(b); });
    const std::size_t reads = (arcs.size() + ReadSize - 1) / ReadSize;
    this->ForAll(reads,
      [&](std::size_t i, vtkMTFinestNear&)
      {
        const auto from = arcs.begin() + static_cast<std::ptrdiff_t>(i * ReadSize);
        const auto to = arcs.begin() + static_cast<std::ptrdiff_t>(std::min((i + 1) * ReadSize, arcs.size()));
        this->Patches->Read({ from, to });
      });
    return end;
  }

  void FindGroup(
    std::size_t group, const std::vector<Query>& queries, vtkMTFinestNear& near, std::vector<vtkIdType>& ids)
  {
    vtkMTFinestNear::Neighbourhood around(near, this->GetMiddle(group, queries));
    std::uint32_t last = None; // where the place before found its triangle
    for (std::size_t i = this->Begins[group]; i < this->Begins[group + 1] && !this->Stop; ++i)
    {
      ids[i] = this->FindOne(queries[i], around, last);
      ++this->Found;
    }
  }

  vtkIdType FindOne(const Query& query, vtkMTFinestNear::Neighbourhood& around, std::uint32_t& last)
  {
    const vtkMTGraph& graph = this->Source.GetGraph();
    vtkMTFinestPatches::Search search;
    search.X = vtkMTFinestNear::ToSteps(graph, query.X);
    search.Direction = query.Direction;
    search.HasDirection =
      !this->OfPoints && std::any_of(query.Direction.begin(), query.Direction.end(), [](double x) { return x != 0.0; });
    // A step more, for what is rounded on the way.
    const double reach = graph.GetDistanceToInput(query.Arc) / graph.Lattice.Step + 1.0;
    search.Reach2 = reach * reach;
    bool good = true;
    const std::uint32_t first = last;
    const auto look = [&](std::uint32_t arc)
    {
      const double bound2 = vtkMTFinestNear::GetDistance2(graph.Arcs[arc].Box, search.X) * (1.0 - Rounding);
      if (good && bound2 <= search.GetFarthest2())
      {
        const vtkIdType before = search.GetId();
        good = this->LookInto(arc, search);
        last = search.GetId() != before ? arc : last;
      }
    };
    if (first != None)
    {
      look(first);
    }
    around.ForAll(
      search.X, [&] { return good ? search.GetFarthest2() : 0.0; },
      [&](std::uint32_t arc)
      {
        if (arc != first)
        {
          look(arc);
        }
      });
    return good ? search.GetId() : Unknown;
  }

  bool LookInto(std::uint32_t arc, vtkMTFinestPatches::Search& search)
  {
    std::string error;
    const vtkMTFinestPatches::PatchPointer patch = this->Patches->Get(arc, error);
    if (patch)
    {
      patch->Find(search);
      return true;
    }
    this->Fail(error);
    return false;
  }

  void Fail(const std::string& error)
  {
    const std::lock_guard<std::mutex> lock(this->Lock);
    this->Error = this->Error.empty() ? error : this->Error;
  }

  //----------------------------------------------------------------------------
  using Work = std::function<void(std::size_t, vtkMTFinestNear&)>;

  // Takes one index after the other until there is none.
  void Run(std::size_t count, const Work& work, std::atomic<std::size_t>& next, vtkMTFinestNear& near, bool reports)
  {
    try
    {
      for (std::size_t i = next++; i < count && !this->Stop; i = next++)
      {
        work(i, near);
        if (reports)
        {
          this->TellProgress();
        }
      }
    }
    catch (const std::exception& exception)
    {
      this->Fail(exception.what());
      this->Stop = true;
    }
  }

  void TellProgress()
  {
    const double done =
      ShareOfLocating * static_cast<double>(this->Located) + (1.0 - ShareOfLocating) * static_cast<double>(this->Found);
    if (this->Report && !this->Report(done / static_cast<double>(std::max<std::size_t>(this->Total, 1))))
    {
      this->Stop = true;
    }
  }

  // Calls work for every index, by several threads where there is more than one. The calling one tells progress
  // meanwhile.
  void ForAll(std::size_t count, const Work& work)
  {
    const std::size_t wanted = std::min(count, static_cast<std::size_t>(this->Threads));
    while (this->Nears.size() < std::max<std::size_t>(wanted, 1))
    {
      this->Nears.push_back(std::make_unique<vtkMTFinestNear>(this->Source.GetGraph()));
    }
    std::atomic<std::size_t> next{ 0 };
    std::size_t running = 0;
    std::condition_variable ended;
    std::vector<std::thread> threads;
    const auto run = [&](std::size_t thread)
    {
      this->Run(count, work, next, *this->Nears[thread], false);
      const std::lock_guard<std::mutex> lock(this->Lock);
      --running;
      ended.notify_all();
    };
    std::unique_lock<std::mutex> lock(this->Lock);
    try
    {
      while (wanted > 1 && threads.size() < wanted)
      {
        threads.emplace_back(run, threads.size());
        ++running;
      }
    }
    catch (const std::system_error&)
    {
      // Those that there are do it, or the calling one.
    }
    while (running > 0)
    {
      ended.wait_for(lock, std::chrono::milliseconds(20));
      lock.unlock();
      this->TellProgress();
      lock.lock();
    }
    lock.unlock();
    std::for_each(threads.begin(), threads.end(), [](std::thread& thread) { thread.join(); });
    this->Run(count, work, next, *this->Nears[0], true);
  }

  std::vector<std::size_t> Begins;                     // of groups of queries, and the end of the last one
  std::vector<std::unique_ptr<vtkMTFinestNear>> Nears; // one for each thread
  std::mutex Lock;
  std::atomic<bool> Stop{ false };
  std::atomic<std::size_t> Located{ 0 };
  std::atomic<std::size_t> Found{ 0 };
  std::size_t Total = 0;
  Progress Report;

public:
  std::uint64_t GetNumberOfNodes() const
  {
    std::uint64_t nodes = 0;
    for (const auto& near : this->Nears)
    {
      nodes += near->GetNumberOfNodes();
    }
    return nodes;
  }
};

//------------------------------------------------------------------------------
vtkMTInputIdFinder::vtkMTInputIdFinder(const vtkMTPatchSource& source, vtkMTArrayInfo::RoleType role)
  : vtkMTInputIdFinder(source, role, Settings())
{
}

vtkMTInputIdFinder::vtkMTInputIdFinder(
  const vtkMTPatchSource& source, vtkMTArrayInfo::RoleType role, const Settings& settings)
  : Implementation(std::make_unique<Internals>(source, role, settings))
{
}

vtkMTInputIdFinder::~vtkMTInputIdFinder() = default;

bool vtkMTInputIdFinder::HasIds() const
{
  return this->Implementation->IsThere;
}

void vtkMTInputIdFinder::SetResident(const Resident& resident)
{
  this->Implementation->GetResident = resident;
}

bool vtkMTInputIdFinder::Find(
  const std::vector<Query>& queries, std::vector<vtkIdType>& ids, std::string& error, const Progress& progress)
{
  const bool found = this->Implementation->Find(queries, ids, progress);
  error = this->Implementation->Error;
  return found;
}

std::uint64_t vtkMTInputIdFinder::GetNumberOfReads() const
{
  return this->Implementation->Patches ? this->Implementation->Patches->GetNumberOfReads() : 0;
}

std::uint64_t vtkMTInputIdFinder::GetNumberOfNodes() const
{
  return this->Implementation->GetNumberOfNodes();
}
