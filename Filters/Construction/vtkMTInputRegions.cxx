// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTInputRegions.h"

#include "vtkMTExactPoints.h"
#include "vtkMTInputSpool.h"
#include "vtkMTRadixSort.h"
#include "vtkMTStitch.h"

#include <algorithm>
#include <cstring>
#include <numeric>

namespace
{
std::size_t Sum(const std::vector<std::size_t>& sizes)
{
  return std::accumulate(sizes.begin(), sizes.end(), std::size_t(0));
}

// Of a stitched point, before it is known who shares it: the key has its identity above and the region below, Root the
// input's index.
using StitchedPoint = vtkMTInputRegions::Point;

template <typename Value>
Value Read(const unsigned char* bytes)
{
  Value value;
  std::memcpy(&value, bytes, sizeof(value));
  return value;
}
}

vtkMTInputRegions::vtkMTInputRegions(
  const vtkMTBuildSettings& settings, const vtkMTInputSpool& input, const vtkMTArrayInfo* exact, std::size_t memory)
  : Settings(settings)
  , Input(input)
  , Exact(exact)
  , ValueSize(input.GetValueSize() + (exact ? exact->GetTupleSize() : 0))
  , TriangleSize(sizeof(Triangle) + Sum(input.GetCellTupleSizes()))
  , PointSize(sizeof(Point) + ValueSize)
  , Triangles(*settings.Store, TriangleSize, memory / 4)
  , Requests(*settings.Store, sizeof(std::uint64_t), memory / 4)
  , Stitched(*settings.Store, PointSize, memory / 4)
  , Points(*settings.Store, PointSize, memory / 4)
  , Record(std::max(TriangleSize, PointSize))
{
}

vtkMTInputRegions::~vtkMTInputRegions() = default;

bool vtkMTInputRegions::Fail(const std::string& error)
{
  this->Error = error;
  return false;
}

bool vtkMTInputRegions::Add(const vtkMTInputBlock& block, const std::vector<std::uint32_t>& regions)
{
  std::vector<std::uint64_t> uses; // region above, the block's own index of the point below
  std::vector<std::uint64_t> scratch;
  uses.reserve(3 * block.Triangles.size());
  for (std::size_t t = 0; t < block.Triangles.size(); ++t)
  {
    Triangle record{ regions[t], {}, static_cast<std::uint32_t>(this->NextNumber++), block.CellIds[t] };
    for (int c = 0; c < 3; ++c)
    {
      record.Points[c] = block.Points[block.Triangles[t][c]];
      uses.push_back((std::uint64_t(regions[t]) << 32) | block.Triangles[t][c]);
    }
    std::memcpy(this->Record.data(), &record, sizeof(record));
    unsigned char* to = this->Record.data() + sizeof(record);
    for (std::size_t i = 0; i < block.Columns.size(); ++i)
    {
      const std::size_t size = this->Input.GetCellTupleSizes()[i];
      std::memcpy(to, block.Columns[i].data() + t * size, size);
      to += size;
    }
    if (!this->Triangles.Add(this->Record.data()))
    {
      return this->Fail(this->Triangles.GetError());
    }
  }
  vtkMTRadixSort::Sort(uses, scratch);
  uses.erase(std::unique(uses.begin(), uses.end()), uses.end());
  for (const std::uint64_t use : uses)
  {
    const std::uint64_t request = (std::uint64_t(block.Points[static_cast<std::uint32_t>(use)]) << 32) | (use >> 32);
    if (!this->Requests.Add(&request))
    {
      return this->Fail(this->Requests.GetError());
    }
  }
  return true;
}

bool vtkMTInputRegions::FindPoints(vtkMTStitch& stitch, const vtkMTLattice& lattice)
{
  vtkMTInputSpool::PointCursor cursor(this->Input);
  std::vector<std::uint32_t> regions;
  bool good = this->Requests.Finish();
  const unsigned char* record = good ? this->Requests.Next() : nullptr;
  while (record)
  {
    const std::uint32_t point = static_cast<std::uint32_t>(vtkMTRecordSort::GetKey(record) >> 32);
    regions.clear();
    for (; record && vtkMTRecordSort::GetKey(record) >> 32 == point; record = this->Requests.Next())
    {
      const std::uint32_t region = static_cast<std::uint32_t>(vtkMTRecordSort::GetKey(record));
      if (regions.empty() || regions.back() != region)
      {
        regions.push_back(region);
      }
    }
    const unsigned char* bytes = cursor.Get(point, this->Error);
    if (!bytes || !this->AddPoint(point, regions, bytes, stitch.FindRoot(point), lattice))
    {
      return false;
    }
    if (++this->UsedPoints % vtkMTInputBlock::Size == 0 &&
      !this->Settings.Report(
        { 0.0, "sorting points into regions", 0, this->UsedPoints, this->Input.GetNumberOfPoints() }))
    {
      this->Aborted = true;
      return this->Fail("aborted");
    }
  }
  if (this->Requests.HasFailed() || !stitch.GetError().empty())
  {
    return this->Fail(this->Requests.GetError() + stitch.GetError());
  }
  good = this->SolveStitched() && this->Points.Finish() && this->Triangles.Finish();
  this->NextPoint = good ? this->Points.Next() : nullptr;
  this->NextTriangle = good ? this->Triangles.Next() : nullptr;
  good = good && !this->Points.HasFailed() && !this->Triangles.HasFailed();
  return good || this->Fail(this->Stitched.GetError() + this->Points.GetError() + this->Triangles.GetError());
}

bool vtkMTInputRegions::AddPoint(std::uint32_t point, const std::vector<std::uint32_t>& regions,
  const unsigned char* bytes, std::uint32_t root, const vtkMTLattice& lattice)
{
  const vtkMTInputBlock::Place place = vtkMTInputSpool::GetPlace(bytes);
  const bool isStitched = root != vtkMTStitch::None;
  vtkMTRecordSort& sort = isStitched ? this->Stitched : this->Points;
  Point record{ 0, point, point, lattice.Snap(place.data()), regions.size() > 1 ? 1u : 0u };
  unsigned char* values = this->Record.data() + sizeof(record);
  std::memcpy(values, vtkMTInputSpool::GetValues(bytes), this->Input.GetValueSize());
  if (this->Exact)
  {
    vtkMTExactPoints::Encode(
      *this->Exact, lattice, record.X, vtkMTInputSpool::GetExactPlace(bytes), values + this->Input.GetValueSize());
  }
  for (const std::uint32_t region : regions)
  {
    record.Key = isStitched ? (std::uint64_t(root) << 32) | region : (std::uint64_t(region) << 32) | point;
    std::memcpy(this->Record.data(), &record, sizeof(record));
    if (!sort.Add(this->Record.data()))
    {
      return this->Fail(sort.GetError());
    }
  }
  return true;
}

bool vtkMTInputRegions::SolveStitched()
{
  std::vector<unsigned char> records; // of one identity
  std::uint32_t last = 0;
  bool good = this->Stitched.Finish();
  while (const unsigned char* record = good ? this->Stitched.Next() : nullptr)
  {
    const std::uint32_t root = static_cast<std::uint32_t>(vtkMTRecordSort::GetKey(record) >> 32);
    good = records.empty() || root == last || this->SolveIdentity(last, records);
    last = root;
    records.insert(records.end(), record, record + this->PointSize);
  }
  return good && !this->Stitched.HasFailed() && (records.empty() || this->SolveIdentity(last, records));
}

// Who shares it, and which points are one wedge. Empties the list.
bool vtkMTInputRegions::SolveIdentity(std::uint32_t root, std::vector<unsigned char>& records)
{
  const std::size_t count = records.size() / this->PointSize;
  const auto get = [&](std::size_t i) { return records.data() + i * this->PointSize; };
  // Records are in order of region; by point, the first one with the same values stands for a wedge.
  const auto region = [&](std::size_t i) { return static_cast<std::uint32_t>(vtkMTRecordSort::GetKey(get(i))); };
  const bool isShared = region(0) != region(count - 1);
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t(0));
  const auto compare = [&](std::size_t a, std::size_t b)
  { return std::memcmp(get(a) + sizeof(Point), get(b) + sizeof(Point), this->ValueSize); };
  std::sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b)
    {
      const int difference = compare(a, b);
      return difference != 0 ? difference < 0 : Read<StitchedPoint>(get(a)).Root < Read<StitchedPoint>(get(b)).Root;
    });
  bool added = true;
  std::uint32_t wedge = 0;
  for (std::size_t i = 0; added && i < count; ++i)
  {
    Point record = Read<StitchedPoint>(get(order[i]));
    const std::uint32_t point = record.Root;
    if (i == 0 || compare(order[i - 1], order[i]) != 0)
    {
      wedge = point;
      this->SeamWedges += i > 0 ? 1 : 0;
    }
    record.Key = (std::uint64_t(region(order[i])) << 32) | point;
    record.Root = root;
    record.Wedge = wedge;
    record.IsShared = isShared ? 1 : 0;
    std::memcpy(this->Record.data(), &record, sizeof(record));
    std::memcpy(this->Record.data() + sizeof(record), get(order[i]) + sizeof(record), this->ValueSize);
    added = this->Points.Add(this->Record.data());
  }
  records.clear();
  return added;
}

bool vtkMTInputRegions::Take(std::uint32_t region, Region& result)
{
  result.Triangles.clear();
  result.Points.clear();
  while (this->NextTriangle && vtkMTRecordSort::GetKey(this->NextTriangle) == region)
  {
    result.Triangles.insert(result.Triangles.end(), this->NextTriangle, this->NextTriangle + this->TriangleSize);
    this->NextTriangle = this->Triangles.Next();
  }
  while (this->NextPoint && vtkMTRecordSort::GetKey(this->NextPoint) >> 32 == region)
  {
    result.Points.insert(result.Points.end(), this->NextPoint, this->NextPoint + this->PointSize);
    this->NextPoint = this->Points.Next();
  }
  return (!this->Triangles.HasFailed() && !this->Points.HasFailed()) ||
    this->Fail(this->Triangles.GetError() + this->Points.GetError());
}
