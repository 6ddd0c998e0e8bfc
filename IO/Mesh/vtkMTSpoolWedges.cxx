// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTSpoolWedges.h"

#include <algorithm>
#include <cstring>

vtkMTSpoolWedges::vtkMTSpoolWedges(vtkMTSpoolStore& store, std::size_t memory)
  : Keys(store)
  , Originals(store)
  , Corners(store)
  , ByPoint(std::make_unique<vtkMTRecordSort>(store, sizeof(CornerOfPoint), memory / 2))
  , Copied(std::make_unique<vtkMTRecordSort>(store, sizeof(Copy), memory / 8))
  , OfCopies(std::make_unique<vtkMTRecordSort>(store, sizeof(Pair), memory / 8))
  , ByCorner(std::make_unique<vtkMTRecordSort>(store, sizeof(Pair), memory / 4))
{
}

bool vtkMTSpoolWedges::Add(vtkMTRecordSort& sort, const void* record, std::string& error)
{
  const bool added = sort.Add(record);
  error = added ? error : sort.GetError();
  return added;
}

bool vtkMTSpoolWedges::AddCorner(std::uint64_t point, const Key& key, std::string& error)
{
  const CornerOfPoint corner{ point, this->Count++, key };
  return Add(*this->ByPoint, &corner, error);
}

// The first corner keeps the point; every other key is a copy, named by the first corner that has it.
bool vtkMTSpoolWedges::PutPoint(const std::vector<CornerOfPoint>& corners, std::string& error)
{
  std::vector<Copy> copies;
  for (const CornerOfPoint& corner : corners)
  {
    if (corner.Keys == corners.front().Keys)
    {
      const Pair kept = { corner.Number, corner.Point };
      if (!Add(*this->ByCorner, kept, error))
      {
        return false;
      }
      continue;
    }
    auto copy =
      std::find_if(copies.begin(), copies.end(), [&corner](const Copy& known) { return known.Keys == corner.Keys; });
    if (copy == copies.end())
    {
      copy = copies.insert(copies.end(), { corner.Number, corner.Point, corner.Keys });
    }
    const Pair moved = { copy->FirstCorner, corner.Number };
    if (!Add(*this->OfCopies, moved, error))
    {
      return false;
    }
  }
  return std::all_of(copies.begin(), copies.end(), [&](const Copy& copy) { return Add(*this->Copied, &copy, error); });
}

bool vtkMTSpoolWedges::Finish(std::uint64_t points, const Key& limits, Key& missing, std::string& error)
{
  if (!this->ByPoint->Finish())
  {
    error = this->ByPoint->GetError();
    return false;
  }
  std::vector<CornerOfPoint> corners;
  const unsigned char* record = this->ByPoint->Next();
  for (std::uint64_t point = 0; point < points; ++point)
  {
    corners.clear();
    for (; record && vtkMTRecordSort::GetKey(record) == point; record = this->ByPoint->Next())
    {
      corners.emplace_back();
      std::memcpy(&corners.back(), record, sizeof(CornerOfPoint));
      for (std::size_t i = 0; i < limits.size(); ++i)
      {
        std::uint64_t& part = corners.back().Keys[i];
        missing[i] += part >= limits[i] && part != None ? 1 : 0;
        part = part >= limits[i] ? None : part;
      }
    }
    const Key key = corners.empty() ? Key{ None, None } : corners.front().Keys;
    if (this->ByPoint->HasFailed() || !this->Keys.Put(&key, sizeof(key), error) || !this->PutPoint(corners, error))
    {
      error = this->ByPoint->HasFailed() ? this->ByPoint->GetError() : error;
      return false;
    }
  }
  const bool good = this->PutCornersOfNone(record, error);
  this->ByPoint.reset();
  return good && this->NumberCopies(points, error);
}

// From this record on: corners at points that do not exist.
bool vtkMTSpoolWedges::PutCornersOfNone(const unsigned char* record, std::string& error)
{
  for (; record; record = this->ByPoint->Next())
  {
    CornerOfPoint corner;
    std::memcpy(&corner, record, sizeof(corner));
    const Pair lost = { corner.Number, None };
    if (!Add(*this->ByCorner, lost, error))
    {
      return false;
    }
  }
  error = this->ByPoint->HasFailed() ? this->ByPoint->GetError() : error;
  return !this->ByPoint->HasFailed();
}

bool vtkMTSpoolWedges::NumberCopies(std::uint64_t points, std::string& error)
{
  if (!this->Copied->Finish() || !this->OfCopies->Finish())
  {
    error = this->Copied->GetError() + this->OfCopies->GetError();
    return false;
  }
  const unsigned char* moved = this->OfCopies->Next();
  while (const unsigned char* record = this->Copied->Next())
  {
    Copy copy;
    std::memcpy(&copy, record, sizeof(copy));
    const std::uint64_t number = points + this->Copies++;
    for (; moved && vtkMTRecordSort::GetKey(moved) == copy.FirstCorner; moved = this->OfCopies->Next())
    {
      Pair corner = { 0, number };
      std::memcpy(corner, moved + sizeof(std::uint64_t), sizeof(std::uint64_t));
      if (!Add(*this->ByCorner, corner, error))
      {
        return false;
      }
    }
    if (!this->Keys.Put(&copy.Keys, sizeof(copy.Keys), error) ||
      !this->Originals.Put(&copy.Original, sizeof(copy.Original), error))
    {
      return false;
    }
  }
  const bool sorted = this->ByCorner->Finish();
  while (const unsigned char* record = sorted ? this->ByCorner->Next() : nullptr)
  {
    if (!this->Corners.Put(record + sizeof(std::uint64_t), sizeof(std::uint64_t), error))
    {
      return false;
    }
  }
  for (const vtkMTRecordSort* sort : { this->Copied.get(), this->OfCopies.get(), this->ByCorner.get() })
  {
    error = sort->HasFailed() ? sort->GetError() : error;
  }
  this->Copied.reset();
  this->OfCopies.reset();
  this->ByCorner.reset();
  return error.empty() && this->Keys.Seal(error) && this->Originals.Seal(error) && this->Corners.Seal(error);
}
