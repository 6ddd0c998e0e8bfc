// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTSelectionIds.h"

#include "vtkDataArray.h"
#include "vtkMTGraph.h"
#include "vtkMTPatchAttributes.h"
#include "vtkMTPatchSource.h"
#include "vtkMTVector.h"

#include <algorithm>
#include <iterator>
#include <thread>
#include <utility>

namespace
{
constexpr std::size_t MostIds = std::size_t(1) << 20;         // that are kept
constexpr std::size_t MostPatchBytes = std::size_t(64) << 20; // of the finest level's patches
constexpr unsigned int MostThreads = 4;
}

vtkMTSelectionIds::vtkMTSelectionIds(std::shared_ptr<const vtkMTPatchSource> source, vtkMTPatchCache& cache, int array,
  const std::vector<unsigned char>& arrays, Memory& memory)
  : Source(std::move(source))
  , Graph(this->Source->GetKnownGraph())
  , Cache(cache)
  , Array(array)
  , Arrays(arrays)
  , Known(memory)
{
  if (memory.Source.lock() != this->Source || memory.Array != array)
  {
    memory.Source = this->Source;
    memory.Array = array;
    memory.Ids.clear();
  }
}

vtkMTSelectionIds::~vtkMTSelectionIds() = default;

void vtkMTSelectionIds::SetPlaces(const vtkMTPatchArena& arena, vtkMTPatchArena::DomainType domain)
{
  this->Places = arena.GetPlaces(domain);
}

// What the pixel is of: arc above, tuple below.
std::uint64_t vtkMTSelectionIds::GetKey(const Pictures& pictures, unsigned int at) const
{
  const std::uint64_t top = pictures.High ? pictures.High[at] : 0;
  const unsigned char* const low = pictures.Low + at;
  const std::uint64_t written = (top << 24) | (std::uint64_t(low[2]) << 16) | (std::uint64_t(low[1]) << 8) | low[0];
  const std::uint64_t place = written / pictures.Primitives;
  const auto next = this->Places.upper_bound(place);
  if (next == this->Places.begin())
  {
    return Nowhere;
  }
  const auto found = std::prev(next);
  return (std::uint64_t(found->second) << 32) | (place - found->first);
}

// Whether the arc's patch has values of the array itself.
bool vtkMTSelectionIds::HasColumn(std::uint32_t arc) const
{
  const vtkMTArrayInfo& array = this->Graph.Arrays[this->Array];
  return !array.IsFinestOnly() || this->Graph.IsFinest(arc);
}

vtkMTPatchCache::PatchPointer vtkMTSelectionIds::GetPatch(std::uint32_t arc, bool withIds)
{
  std::vector<unsigned char> arrays = this->Arrays;
  arrays[this->Array] |= withIds ? 1 : 0;
  this->Cache.SetArrays(arrays);
  this->Cache.Request({ arc });
  return this->Cache.Get(arc);
}

void vtkMTSelectionIds::TakeValues(std::uint32_t arc, const std::vector<std::uint32_t>& tuples)
{
  const vtkMTPatchCache::PatchPointer patch = this->GetPatch(arc, true);
  const vtkSmartPointer<vtkDataArray> values =
    patch ? vtkMTPatchAttributes::GetArray(this->Graph, this->Array, *patch) : nullptr;
  for (const std::uint32_t tuple : tuples)
  {
    if (values && static_cast<vtkIdType>(tuple) < values->GetNumberOfTuples())
    {
      this->Known.Ids[(std::uint64_t(arc) << 32) | tuple] =
        static_cast<vtkIdType>(values->GetComponent(static_cast<vtkIdType>(tuple), 0));
    }
  }
}

void vtkMTSelectionIds::AddQueries(std::uint32_t arc, const std::vector<std::uint32_t>& tuples)
{
  using namespace vtkMTVector;
  const vtkMTArrayInfo::RoleType role = this->Graph.Arrays[this->Array].Role;
  if (role != vtkMTArrayInfo::InputCellIds && role != vtkMTArrayInfo::InputPointIds)
  {
    return; // nothing says what its values would be here
  }
  const vtkMTPatchCache::PatchPointer patch = this->GetPatch(arc, false);
  const bool ofPoints = this->Graph.Arrays[this->Array].Association == vtkMTArrayInfo::Point;
  const std::size_t count = !patch ? 0 : ofPoints ? patch->GetNumberOfWedges() : patch->Triangles.size();
  for (const std::uint32_t tuple : tuples)
  {
    if (tuple >= count)
    {
      continue;
    }
    vtkMTInputIdFinder::Query query;
    query.Arc = arc;
    if (ofPoints)
    {
      query.X = this->Graph.Lattice.ToWorld(patch->Points[patch->GetPointOfWedge(tuple)]);
    }
    else
    {
      std::array<Vector, 3> corners;
      const vtkMTTriangle points = patch->GetPointsOfTriangle(tuple);
      std::transform(points.begin(), points.end(), corners.begin(),
        [&](std::uint32_t point) { return this->Graph.Lattice.ToWorld(patch->Points[point]); });
      query.X = Scale(Add(Add(corners[0], corners[1]), corners[2]), 1.0 / 3.0);
      query.Direction = Cross(Subtract(corners[1], corners[0]), Subtract(corners[2], corners[0]));
    }
    this->Queries.push_back(query);
    this->Keys.push_back((std::uint64_t(arc) << 32) | tuple);
  }
}

// Within the cache's limit: it gives up what the finder needs.
bool vtkMTSelectionIds::FindQueries(const vtkMTInputIdFinder::Progress& progress, std::string& error)
{
  vtkMTInputIdFinder::Settings settings;
  const std::size_t limit = this->Cache.GetLimit();
  settings.MemoryLimit = std::min(limit / 4, MostPatchBytes);
  settings.Threads = static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, MostThreads));
  const bool isShort = limit - std::min(limit, this->Cache.GetUsedBytes()) < settings.MemoryLimit;
  if (isShort)
  {
    this->Cache.SetLimit(limit - settings.MemoryLimit);
  }
  vtkMTInputIdFinder finder(*this->Source, this->Graph.Arrays[this->Array].Role, settings);
  std::vector<vtkIdType> ids;
  const bool found = finder.Find(this->Queries, ids, error, progress);
  if (isShort)
  {
    this->Cache.SetLimit(limit);
  }
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    if (ids[i] != vtkMTInputIdFinder::Unknown)
    {
      this->Known.Ids[this->Keys[i]] = ids[i];
    }
  }
  this->Queries.clear();
  this->Keys.clear();
  return found;
}

bool vtkMTSelectionIds::Find(const std::vector<unsigned int>& offsets, const Pictures& pictures,
  const vtkMTInputIdFinder::Progress& progress, std::string& error)
{
  if (this->Known.Ids.size() > MostIds)
  {
    this->Known.Ids.clear();
  }
  std::vector<std::uint64_t> keys;
  keys.reserve(offsets.size());
  for (const unsigned int at : offsets)
  {
    const std::uint64_t key = this->GetKey(pictures, at);
    if (key != Nowhere && this->Known.Ids.count(key) == 0 && (keys.empty() || keys.back() != key))
    {
      keys.push_back(key);
    }
  }
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  std::vector<std::uint32_t> tuples;
  for (std::size_t i = 0; i < keys.size(); ++i)
  {
    tuples.push_back(static_cast<std::uint32_t>(keys[i]));
    const auto arc = static_cast<std::uint32_t>(keys[i] >> 32);
    if (i + 1 == keys.size() || keys[i + 1] >> 32 != arc)
    {
      this->HasColumn(arc) ? this->TakeValues(arc, tuples) : this->AddQueries(arc, tuples);
      tuples.clear();
    }
  }
  return this->Queries.empty() || this->FindQueries(progress, error);
}

void vtkMTSelectionIds::Translate(const std::vector<unsigned int>& offsets, const Pictures& pictures, bool high,
  unsigned char* target, unsigned char* actors) const
{
  for (const unsigned int at : offsets)
  {
    const auto found = this->Known.Ids.find(this->GetKey(pictures, at));
    if (found == this->Known.Ids.end())
    {
      std::fill_n(actors + at, 3, static_cast<unsigned char>(0));
      continue;
    }
    const std::uint64_t part = high ? static_cast<std::uint64_t>(found->second) >> 24 : found->second;
    target[at] = part & 0xff;
    target[at + 1] = (part >> 8) & 0xff;
    target[at + 2] = (part >> 16) & 0xff;
  }
}
