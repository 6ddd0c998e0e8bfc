// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTInputPoints.h"

#include "vtkMTExactPoints.h"
#include "vtkMTRelease.h"
#include "vtkMTSpoolStore.h"

#include <algorithm>
#include <cstring>
#include <numeric>

namespace
{
using Place = vtkMTInputBlock::Place;
constexpr std::size_t CursorSize = std::size_t(1) << 20;
}

vtkMTInputPoints::vtkMTInputPoints() = default;

vtkMTInputPoints::~vtkMTInputPoints() = default;

bool vtkMTInputPoints::Begin(vtkMTSpoolStore& store, const std::vector<std::size_t>& tupleSizes, std::string& error)
{
  this->TupleSizes = tupleSizes;
  this->RecordSize = std::accumulate(tupleSizes.begin(), tupleSizes.end(), sizeof(Place));
  this->Spool = store.Create(error);
  return this->Spool != nullptr;
}

bool vtkMTInputPoints::Append(const vtkMTTriangleStream::PointBlock& block, std::string& error)
{
  this->Records.resize(block.Points.size() * this->RecordSize);
  unsigned char* to = this->Records.data();
  for (std::size_t i = 0; i < block.Points.size(); ++i)
  {
    for (const double coordinate : block.Points[i])
    {
      this->Single = this->Single && vtkMTExactPoints::IsSingle(coordinate);
    }
    std::memcpy(to, block.Points[i].data(), sizeof(Place));
    to += sizeof(Place);
    for (std::size_t c = 0; c < this->TupleSizes.size(); ++c)
    {
      const std::size_t size = this->TupleSizes[c];
      std::memcpy(to, block.Columns[c].data() + i * size, size);
      to += size;
    }
  }
  this->Points += block.Points.size();
  return this->Spool->Append(this->Records.data(), this->Records.size(), error);
}

void vtkMTInputPoints::Remove()
{
  this->Spool.reset();
  vtkMTRelease(this->Records);
}

Place vtkMTInputPoints::GetPlace(const unsigned char* record)
{
  Place place = GetExactPlace(record);
  for (double& coordinate : place)
  {
    coordinate += 0.0; // minus zero is zero: the same place
  }
  return place;
}

Place vtkMTInputPoints::GetExactPlace(const unsigned char* record)
{
  Place place;
  std::memcpy(place.data(), record, sizeof(place));
  return place;
}

bool vtkMTInputPoints::IsInMemory() const
{
  return this->Spool && this->Spool->IsInMemory();
}

const unsigned char* vtkMTInputPoints::LookUp(
  std::uint64_t point, std::vector<unsigned char>& bytes, std::string& error) const
{
  const std::uint64_t offset = point * this->RecordSize;
  if (const unsigned char* found = this->Spool->Find(offset, this->RecordSize)) // it lies in one part
  {
    return found;
  }
  bytes.resize(this->RecordSize);
  return this->Spool->Read(offset, bytes.size(), bytes.data(), error) ? bytes.data() : nullptr;
}

bool vtkMTInputPoints::LookUp(
  const std::vector<std::uint32_t>& points, std::vector<Place>& places, std::string& error) const
{
  std::vector<unsigned char> bytes;
  places.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const unsigned char* record = this->LookUp(points[i], bytes, error);
    if (!record)
    {
      return false;
    }
    places[i] = GetPlace(record);
  }
  return true;
}

bool vtkMTInputPoints::Answer(const Requests& requests, std::vector<PlaceRecord>& places, std::string& error) const
{
  const std::vector<std::uint64_t>& keys = requests.Keys;
  places.clear();
  places.reserve(keys.size());
  Cursor cursor(*this, keys.empty() ? 0 : (keys.back() >> 32) + 1);
  for (std::size_t i = 0; i < keys.size(); ++i)
  {
    const std::uint64_t point = keys[i] >> 32;
    const std::uint64_t before = i > 0 ? keys[i - 1] >> 32 : requests.Before;
    const std::uint64_t behind = i + 1 < keys.size() ? keys[i + 1] >> 32 : requests.Behind;
    const unsigned char* bytes = cursor.Get(point, error);
    if (!bytes)
    {
      return false;
    }
    const bool isOpen = point == before || point == behind;
    places.push_back({ (keys[i] << 32) | point, GetPlace(bytes), isOpen ? 1u : 0u });
  }
  return true;
}

//------------------------------------------------------------------------------
vtkMTInputPoints::Cursor::Cursor(const vtkMTInputPoints& points, std::uint64_t end)
  : Input(points)
  , End(end)
{
}

const unsigned char* vtkMTInputPoints::Cursor::Get(std::uint64_t point, std::string& error)
{
  const std::size_t size = this->Input.RecordSize;
  if (point < this->First || point >= this->First + this->Buffer.size() / size)
  {
    const std::uint64_t count = std::min<std::uint64_t>(std::max<std::size_t>(1, CursorSize / size), this->End - point);
    this->First = point;
    this->Buffer.resize(static_cast<std::size_t>(count) * size);
    if (!this->Input.Spool->Read(point * size, this->Buffer.size(), this->Buffer.data(), error))
    {
      return nullptr;
    }
  }
  return this->Buffer.data() + (point - this->First) * size;
}
