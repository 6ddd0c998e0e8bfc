// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTLocks.h"

#include "vtkMTRegionSpool.h"

#include <algorithm>
#include <cstring>

namespace
{
constexpr std::size_t UseSize = sizeof(std::uint64_t) + sizeof(std::uint32_t);

struct Lock
{
  std::uint64_t Region;
  std::uint64_t Id;
};
}

vtkMTLocks::vtkMTLocks(vtkMTSpoolStore& store, std::size_t memory)
  : Uses(store, UseSize, memory / 2)
  , Locked(store, sizeof(Lock), memory / 2)
{
}

bool vtkMTLocks::Add(const std::vector<std::pair<std::uint64_t, std::uint32_t>>& uses, std::string& error)
{
  unsigned char record[UseSize];
  for (const auto& [id, region] : uses)
  {
    std::memcpy(record, &id, sizeof(id));
    std::memcpy(record + sizeof(id), &region, sizeof(region));
    if (!this->Uses.Add(record))
    {
      error = this->Uses.GetError();
      return false;
    }
  }
  return true;
}

bool vtkMTLocks::AddShared(std::uint64_t id, std::vector<std::uint32_t>& regions)
{
  std::sort(regions.begin(), regions.end());
  regions.erase(std::unique(regions.begin(), regions.end()), regions.end());
  bool added = true;
  for (std::size_t i = 0; added && regions.size() > 1 && i < regions.size(); ++i)
  {
    const Lock lock{ regions[i], id };
    added = this->Locked.Add(&lock);
  }
  regions.clear();
  return added;
}

bool vtkMTLocks::Finish(vtkMTRegionSpool& regions, std::string& error)
{
  std::vector<std::uint32_t> users;
  std::uint64_t last = 0;
  bool sorted = this->Uses.Finish();
  while (const unsigned char* record = sorted ? this->Uses.Next() : nullptr)
  {
    const std::uint64_t id = vtkMTRecordSort::GetKey(record);
    sorted = id == last || this->AddShared(last, users);
    last = id;
    std::uint32_t region;
    std::memcpy(&region, record + sizeof(id), sizeof(region));
    users.push_back(region);
  }
  if (!sorted || this->Uses.HasFailed() || !this->AddShared(last, users) || !this->Locked.Finish())
  {
    error = this->Uses.GetError() + this->Locked.GetError();
    return false;
  }
  // Equal keys come in the order in which they were added, which is that of the ids.
  std::vector<std::uint64_t> ids;
  const unsigned char* record = this->Locked.Next();
  for (std::uint64_t region = 0; region < regions.GetNumberOfRegions(); ++region)
  {
    ids.clear();
    for (; record && vtkMTRecordSort::GetKey(record) == region; record = this->Locked.Next())
    {
      ids.emplace_back();
      std::memcpy(&ids.back(), record + sizeof(region), sizeof(std::uint64_t));
    }
    if (this->Locked.HasFailed() || !regions.PutLocks(static_cast<std::size_t>(region), ids, error))
    {
      error = this->Locked.HasFailed() ? this->Locked.GetError() : error;
      return false;
    }
  }
  return true;
}
