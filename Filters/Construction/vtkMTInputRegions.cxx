// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTInputRegions.h"

#include "vtkMTExactPoints.h"
#include "vtkMTInputSpool.h"
#include "vtkMTOrderedWork.h"
#include "vtkMTPointWelding.h"
#include "vtkMTRadixSort.h"
#include "vtkMTRelease.h"
#include "vtkMTStageTimes.h"
#include "vtkMTTrimHeap.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <numeric>

namespace
{
constexpr std::size_t BatchSize = std::size_t(1) << 20; // bytes of points
constexpr std::size_t LeastBatch = 256;

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

// What is behind the fixed part of a record.
template <typename Fixed>
void AppendValues(const unsigned char* record, std::size_t size, std::vector<unsigned char>& values)
{
  if (size > sizeof(Fixed))
  {
    values.insert(values.end(), record + sizeof(Fixed), record + size);
  }
}
}

vtkMTInputRegions::vtkMTInputRegions(
  const vtkMTBuildSettings& settings, const vtkMTInputSpool& input, const vtkMTArrayInfo* exact, std::size_t memory)
  : Settings(settings)
  , Input(input)
  , Exact(exact)
  , ValueSize(input.GetPoints().GetValueSize() + (exact ? exact->GetTupleSize() : 0))
  , TriangleSize(sizeof(Triangle) + Sum(input.GetCellTupleSizes()))
  , PointSize(sizeof(Point) + ValueSize)
  , Triangles(*settings.Store, TriangleSize, memory / 4)
  , Requests(*settings.Store, sizeof(std::uint64_t), memory / 4)
  , Stitched(*settings.Store, PointSize, memory / 4)
  , Points(*settings.Store, PointSize, memory / 4)
  , Record(PointSize)
{
}

vtkMTInputRegions::~vtkMTInputRegions() = default;

bool vtkMTInputRegions::Fail(const std::string& error)
{
  this->Error = error;
  return false;
}

vtkMTInputRegions::BlockRecords vtkMTInputRegions::MakeRecords(
  const vtkMTInputBlock& block, const std::vector<std::uint32_t>& regions) const
{
  BlockRecords result;
  if (this->Input.IsInMemory())
  {
    result.Regions = regions;
    return result;
  }
  result.Count = block.Triangles.size();
  result.Triangles.reset(new unsigned char[result.Count * this->TriangleSize]);
  result.Requests.reserve(block.Points.size() + block.Points.size() / 8);
  constexpr std::uint32_t none = ~std::uint32_t(0);
  std::vector<std::uint32_t> lastRegion(block.Points.size(), none); // that asked for the point
  unsigned char* to = result.Triangles.get();
  for (std::size_t t = 0; t < result.Count; ++t)
  {
    const std::uint32_t region = regions[t];
    Triangle record{ region, {}, static_cast<std::uint32_t>(t), block.CellIds[t] };
    for (int c = 0; c < 3; ++c)
    {
      const std::uint32_t p = block.Triangles[t][c];
      record.Points[c] = block.Points[p];
      if (lastRegion[p] != region)
      {
        lastRegion[p] = region;
        result.Requests.push_back((std::uint64_t(record.Points[c]) << 32) | region);
      }
    }
    std::memcpy(to, &record, sizeof(record));
    to += sizeof(record);
    for (std::size_t i = 0; i < block.Columns.size(); ++i)
    {
      const std::size_t size = this->Input.GetCellTupleSizes()[i];
      std::memcpy(to, block.Columns[i].data() + t * size, size);
      to += size;
    }
  }
  return result;
}

bool vtkMTInputRegions::Add(const vtkMTInputBlock& block, BlockRecords&& records)
{
  if (this->Input.IsInMemory())
  {
    this->AddInMemory(block, records.Regions);
    return true;
  }
  for (std::size_t t = 0; t < records.Count; ++t)
  {
    unsigned char* number = records.Triangles.get() + t * this->TriangleSize + offsetof(Triangle, Number);
    const std::uint32_t value = Read<std::uint32_t>(number) + static_cast<std::uint32_t>(this->NextNumber);
    std::memcpy(number, &value, sizeof(value));
  }
  this->NextNumber += records.Count;
  return (this->Triangles.Add(records.Triangles.get(), records.Count) &&
           this->Requests.Add(records.Requests.data(), records.Requests.size())) ||
    this->Fail(this->Triangles.GetError() + this->Requests.GetError());
}

//------------------------------------------------------------------------------
// Some points, the regions that have them, and the records that come of it.
struct vtkMTInputRegions::PointBatch
{
  std::vector<std::uint32_t> Points;
  std::vector<std::uint32_t> Roots;
  std::vector<std::size_t> End; // of each point's regions
  std::vector<std::uint32_t> Regions;
  std::unique_ptr<unsigned char[]> Single; // records
  std::size_t SingleCount = 0;
  std::vector<unsigned char> Stitched;
};

bool vtkMTInputRegions::FindPoints(vtkMTPointWelding& stitch, const vtkMTLattice& lattice)
{
  this->Lattice = lattice;
  const auto findRoot = [&stitch](std::uint32_t point) { return stitch.FindRoot(point); };
  if (!this->Input.IsInMemory())
  {
    return this->FindRequested(findRoot) || this->Fail(this->Error + stitch.GetError());
  }
  const std::vector<Root> roots = this->FindRoots(stitch);
  const std::uint64_t used = this->UsedPoints;
  this->SortInMemory();
  auto next = roots.begin();
  const auto findAgain = [&next](std::uint32_t point)
  {
    for (; next->first < point; ++next)
    {
    }
    return next->second; // only stitched points are requested
  };
  const bool found = stitch.GetError().empty() && this->RequestStitched(roots) && this->FindRequested(findAgain);
  this->UsedPoints = used;
  vtkMTRelease(this->RegionOf);
  return found || this->Fail(this->Error + stitch.GetError());
}

bool vtkMTInputRegions::FindRequested(const FindRoot& findRoot)
{
  if (!this->Requests.Finish())
  {
    return this->Fail(this->Requests.GetError());
  }
  this->NextRequest = this->Requests.Next();
  const vtkMTTrimHeap trim(this->Settings.MemoryLimit);
  std::vector<PointBatch> slots(vtkMTOrderedWork::GetNumberOfSlots(this->Settings.Threads));
  std::string error;
  const bool found = vtkMTOrderedWork::Run(
    static_cast<std::size_t>(this->Requests.GetNumberOfRecords() / this->GetBatch() + 1), this->Settings.Threads,
    [&](std::size_t, std::size_t slot, std::string& message)
    {
      const vtkMTStageTimes::Scope sort(this->Settings.Times, vtkMTStageTimes::Sort);
      return this->FetchPoints(findRoot, slots[slot], message);
    },
    [&](std::size_t, std::size_t slot, std::string& message)
    {
      const vtkMTStageTimes::Scope sort(this->Settings.Times, vtkMTStageTimes::Sort);
      return this->MakePoints(slots[slot], message);
    },
    [&](std::size_t, std::size_t slot, std::string&) { return this->PutPoints(slots[slot]); }, error);
  if (!found)
  {
    this->Error = error.empty() ? this->Error : error;
    return false;
  }
  bool good = this->SolveStitched() && this->Points.Finish() && this->Triangles.Finish();
  this->NextPoint = good ? this->Points.Next() : nullptr;
  this->NextTriangle = good ? this->Triangles.Next() : nullptr;
  good = good && !this->Points.HasFailed() && !this->Triangles.HasFailed();
  return good || this->Fail(this->Stitched.GetError() + this->Points.GetError() + this->Triangles.GetError());
}

// Requests that are walked at a time.
std::size_t vtkMTInputRegions::GetBatch() const
{
  return std::max(LeastBatch, BatchSize / this->PointSize);
}

bool vtkMTInputRegions::FetchPoints(const FindRoot& findRoot, PointBatch& batch, std::string& error)
{
  batch = PointBatch();
  const unsigned char*& record = this->NextRequest;
  while (record && batch.Regions.size() < this->GetBatch())
  {
    const std::uint32_t point = static_cast<std::uint32_t>(vtkMTRecordSort::GetKey(record) >> 32);
    const std::size_t begin = batch.Regions.size();
    for (; record && vtkMTRecordSort::GetKey(record) >> 32 == point; record = this->Requests.Next())
    {
      const std::uint32_t region = static_cast<std::uint32_t>(vtkMTRecordSort::GetKey(record));
      if (batch.Regions.size() == begin || batch.Regions.back() != region)
      {
        batch.Regions.push_back(region);
      }
    }
    batch.Points.push_back(point);
    batch.Roots.push_back(findRoot(point));
    batch.End.push_back(batch.Regions.size());
  }
  error = this->Requests.GetError();
  return error.empty();
}

bool vtkMTInputRegions::MakePoints(PointBatch& batch, std::string& error) const
{
  if (batch.Points.empty())
  {
    return true;
  }
  vtkMTInputPoints::Cursor cursor(this->Input.GetPoints(), std::uint64_t(batch.Points.back()) + 1);
  std::vector<unsigned char> values(this->ValueSize);
  batch.Single.reset(new unsigned char[batch.Regions.size() * this->PointSize]);
  std::size_t begin = 0;
  for (std::size_t i = 0; i < batch.Points.size(); ++i)
  {
    const unsigned char* bytes = cursor.Get(batch.Points[i], error);
    if (!bytes)
    {
      return false;
    }
    const std::uint32_t point = batch.Points[i];
    Point record{ 0, point, point, {}, batch.End[i] - begin > 1 ? 1u : 0u };
    this->MakePoint(bytes, record, values);
    const bool isStitched = batch.Roots[i] != vtkMTPointWelding::None;
    for (; begin < batch.End[i]; ++begin)
    {
      const std::uint32_t region = batch.Regions[begin];
      record.Key = isStitched ? (std::uint64_t(batch.Roots[i]) << 32) | region : (std::uint64_t(region) << 32) | point;
      if (isStitched)
      {
        const unsigned char* fixed = reinterpret_cast<const unsigned char*>(&record);
        batch.Stitched.insert(batch.Stitched.end(), fixed, fixed + sizeof(record));
        batch.Stitched.insert(batch.Stitched.end(), values.begin(), values.end());
        continue;
      }
      unsigned char* to = batch.Single.get() + batch.SingleCount++ * this->PointSize;
      std::memcpy(to, &record, sizeof(record));
      std::copy_n(values.data(), values.size(), to + sizeof(record));
    }
  }
  return true;
}

// Its place and its values.
void vtkMTInputRegions::MakePoint(const unsigned char* bytes, Point& record, std::vector<unsigned char>& values) const
{
  const std::size_t size = this->Input.GetPoints().GetValueSize();
  record.X = this->Lattice.Snap(vtkMTInputPoints::GetPlace(bytes).data());
  std::copy_n(vtkMTInputPoints::GetValues(bytes), size, values.begin());
  if (this->Exact)
  {
    vtkMTExactPoints::Encode(
      *this->Exact, this->Lattice, record.X, vtkMTInputPoints::GetExactPlace(bytes), values.data() + size);
  }
}

bool vtkMTInputRegions::PutPoints(const PointBatch& batch)
{
  if (!this->Points.Add(batch.Single.get(), batch.SingleCount) ||
    !this->Stitched.Add(batch.Stitched.data(), batch.Stitched.size() / this->PointSize))
  {
    return this->Fail(this->Points.GetError() + this->Stitched.GetError());
  }
  this->UsedPoints += batch.Points.size();
  this->Aborted = !this->Settings.Report(
    { 0.0, "sorting points into regions", 0, this->UsedPoints, this->Input.GetPoints().GetNumberOfPoints() });
  return !this->Aborted || this->Fail("aborted");
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
  result = Region();
  if (this->Input.IsInMemory())
  {
    return this->TakeInMemory(region, result);
  }
  for (; this->NextTriangle && vtkMTRecordSort::GetKey(this->NextTriangle) == region;
       this->NextTriangle = this->Triangles.Next())
  {
    result.Triangles.push_back(Read<Triangle>(this->NextTriangle));
    AppendValues<Triangle>(this->NextTriangle, this->TriangleSize, result.TriangleValues);
  }
  for (; this->NextPoint && vtkMTRecordSort::GetKey(this->NextPoint) >> 32 == region;
       this->NextPoint = this->Points.Next())
  {
    result.Points.push_back(Read<Point>(this->NextPoint));
    AppendValues<Point>(this->NextPoint, this->PointSize, result.PointValues);
  }
  return (!this->Triangles.HasFailed() && !this->Points.HasFailed()) ||
    this->Fail(this->Triangles.GetError() + this->Points.GetError());
}
