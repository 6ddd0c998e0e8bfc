// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTSharedIds.h"

#include "vtkMTBorderOrder.h"
#include "vtkMTPatchSplitter.h"

#include <cstring>

namespace
{
struct Use
{
  std::uint64_t Id; // the input's
  std::uint32_t Region;
  std::uint32_t Index; // of the region's shared points
  std::uint32_t Place;
  std::uint32_t Padding;
};

struct NewId
{
  std::uint64_t Key; // region above, index below
  std::uint64_t Id;
};
}

vtkMTSharedIds::vtkMTSharedIds(vtkMTSpoolStore& store, std::size_t memory)
  : Uses(store, sizeof(Use), memory / 2)
  , Ids(store, sizeof(NewId), memory / 2)
{
}

std::vector<std::uint32_t> vtkMTSharedIds::FindPlaces(const vtkMTPatch& fragment, const vtkMTHalfedgePairs& pairs)
{
  constexpr std::uint32_t none = ~std::uint32_t(0);
  std::vector<std::uint32_t> places(fragment.Ids.size(), none);
  std::uint32_t next = 0;
  for (const std::uint32_t point : vtkMTBorderOrder::Find(fragment, pairs))
  {
    if (point < places.size())
    {
      places[point] = next++;
    }
  }
  for (std::uint32_t& place : places)
  {
    place = place == none ? next++ : place;
  }
  return places;
}

bool vtkMTSharedIds::Add(
  std::uint32_t region, const std::vector<std::uint64_t>& ids, const std::vector<std::uint32_t>& places)
{
  for (std::uint32_t i = 0; i < ids.size(); ++i)
  {
    const Use use{ ids[i], region, i, places[i], 0 };
    if (!this->Uses.Add(&use))
    {
      this->Error = this->Uses.GetError();
      return false;
    }
  }
  return true;
}

bool vtkMTSharedIds::Solve()
{
  // Equal keys come in the order in which they were added, so the first region is the least.
  Use first{};
  bool isBegun = false;
  bool good = this->Uses.Finish();
  while (const unsigned char* record = good ? this->Uses.Next() : nullptr)
  {
    Use use;
    std::memcpy(&use, record, sizeof(use));
    first = isBegun && use.Id == first.Id ? first : use;
    isBegun = true;
    const NewId newId{ (std::uint64_t(use.Region) << 32) | use.Index,
      vtkMTPatchSplitter::MakeId(vtkMTPatchSplitter::InputLevel, first.Region, first.Place) };
    good = this->Ids.Add(&newId);
  }
  good = good && !this->Uses.HasFailed() && this->Ids.Finish();
  this->Next = good ? this->Ids.Next() : nullptr;
  this->Error = this->Uses.GetError() + this->Ids.GetError();
  return good && this->Error.empty();
}

bool vtkMTSharedIds::Take(std::uint32_t region, std::vector<std::uint64_t>& ids)
{
  for (std::uint32_t i = 0; i < ids.size(); ++i)
  {
    if (!this->Next || vtkMTRecordSort::GetKey(this->Next) != ((std::uint64_t(region) << 32) | i))
    {
      this->Error = this->Ids.HasFailed() ? this->Ids.GetError() : "the identities of shared points are incomplete";
      return false;
    }
    NewId record;
    std::memcpy(&record, this->Next, sizeof(record));
    ids[i] = record.Id;
    this->Next = this->Ids.Next();
  }
  return true;
}
