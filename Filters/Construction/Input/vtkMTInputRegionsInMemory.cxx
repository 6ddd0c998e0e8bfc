// SPDX-License-Identifier: BSD-3-Clause
// The part of vtkMTInputRegions for an input that lies in memory.
#include "vtkMTInputRegions.h"

#include "vtkMTInputSpool.h"
#include "vtkMTPointWelding.h"
#include "vtkMTRadixSort.h"

#include <algorithm>
#include <cstring>
#include <numeric>

void vtkMTInputRegions::AddInMemory(const vtkMTInputBlock& block, const std::vector<std::uint32_t>& regions)
{
  if (this->FirstOfBlock.empty())
  {
    this->Users.assign(static_cast<std::size_t>(this->Input.GetPoints().GetNumberOfPoints()), None);
    this->RegionOf.reserve(static_cast<std::size_t>(this->Input.GetNumberOfTriangles()));
  }
  this->FirstOfBlock.push_back(this->RegionOf.size());
  for (std::size_t t = 0; t < regions.size(); ++t)
  {
    for (const std::uint32_t p : block.Triangles[t])
    {
      std::uint32_t& user = this->Users[block.Points[p]];
      user = user == None || user == regions[t] ? regions[t] : Several;
    }
  }
  this->RegionOf.insert(this->RegionOf.end(), regions.begin(), regions.end());
}

// Counts the points that are used as well.
std::vector<vtkMTInputRegions::Root> vtkMTInputRegions::FindRoots(vtkMTPointWelding& stitch)
{
  std::vector<Root> roots;
  for (std::uint32_t point = 0; point < this->Users.size(); ++point)
  {
    if (this->Users[point] != None)
    {
      ++this->UsedPoints;
      const std::uint32_t root = stitch.FindRoot(point);
      if (root != vtkMTPointWelding::None)
      {
        roots.emplace_back(point, root);
      }
    }
  }
  return roots;
}

bool vtkMTInputRegions::RequestStitched(const std::vector<Root>& roots)
{
  if (roots.empty())
  {
    return true;
  }
  this->IsStitched.assign(this->Users.size(), false);
  for (const Root& root : roots)
  {
    this->IsStitched[root.first] = true;
  }
  bool added = true;
  for (std::size_t b = 0; b + 1 < this->FirstOfBlock.size(); ++b)
  {
    const vtkMTInputBlock& block = this->Input.GetBlock(b);
    for (std::size_t t = 0; added && t < block.Triangles.size(); ++t)
    {
      for (const std::uint32_t p : block.Triangles[t])
      {
        const std::uint64_t request =
          (std::uint64_t(block.Points[p]) << 32) | this->RegionOf[this->FirstOfBlock[b] + t];
        added = added && (!this->IsStitched[block.Points[p]] || this->Requests.Add(&request));
      }
    }
  }
  return added || this->Fail(this->Requests.GetError());
}

// Triangles by region, in their order, by counting.
void vtkMTInputRegions::SortInMemory()
{
  this->FirstOfBlock.push_back(this->RegionOf.size());
  const auto largest = std::max_element(this->RegionOf.begin(), this->RegionOf.end());
  this->FirstNumber.assign(largest == this->RegionOf.end() ? 1 : *largest + std::size_t(2), 0);
  for (const std::uint32_t region : this->RegionOf)
  {
    ++this->FirstNumber[region + std::size_t(1)];
  }
  std::partial_sum(this->FirstNumber.begin(), this->FirstNumber.end(), this->FirstNumber.begin());
  this->Numbers.resize(this->RegionOf.size());
  std::vector<std::size_t> next = this->FirstNumber;
  for (std::uint32_t number = 0; number < this->RegionOf.size(); ++number)
  {
    this->Numbers[next[this->RegionOf[number]]++] = number;
  }
  this->Asked.assign(this->Users.size(), None);
}

bool vtkMTInputRegions::TakeInMemory(std::uint32_t region, Region& result)
{
  if (region + std::size_t(1) >= this->FirstNumber.size() ||
    this->FirstNumber[region] == this->FirstNumber[region + std::size_t(1)])
  {
    return true;
  }
  const std::size_t end = this->FirstNumber[region + std::size_t(1)];
  std::size_t i = this->FirstNumber[region];
  result.Triangles.reserve(end - i);
  std::vector<std::uint32_t> points;
  const auto above = std::upper_bound(this->FirstOfBlock.begin(), this->FirstOfBlock.end(), this->Numbers[i]);
  std::size_t b = static_cast<std::size_t>(above - this->FirstOfBlock.begin()) - 1;
  for (; i < end; ++i)
  {
    for (; this->Numbers[i] >= this->FirstOfBlock[b + 1]; ++b)
    {
    }
    const vtkMTInputBlock& block = this->Input.GetBlock(b);
    const std::size_t t = this->Numbers[i] - this->FirstOfBlock[b];
    Triangle record{ region, {}, this->Numbers[i], block.CellIds[t] };
    for (std::size_t c = 0; c < 3; ++c)
    {
      const std::uint32_t point = record.Points[c] = block.Points[block.Triangles[t][c]];
      if (this->Asked[point] != region)
      {
        this->Asked[point] = region;
        points.push_back(point);
      }
    }
    result.Triangles.push_back(record);
    for (std::size_t c = 0; c < block.Columns.size(); ++c)
    {
      const std::size_t size = this->Input.GetCellTupleSizes()[c];
      const unsigned char* values = block.Columns[c].data() + t * size;
      result.TriangleValues.insert(result.TriangleValues.end(), values, values + size);
    }
  }
  std::vector<std::uint32_t> scratch;
  vtkMTRadixSort::Sort(points, scratch, [](std::uint32_t point) { return std::uint64_t(point); });
  return this->TakePointsInMemory(region, points, result);
}

bool vtkMTInputRegions::TakePointsInMemory(
  std::uint32_t region, const std::vector<std::uint32_t>& points, Region& result)
{
  std::vector<unsigned char> bytes;
  std::vector<unsigned char> values(this->ValueSize);
  result.Points.reserve(points.size());
  for (const std::uint32_t point : points)
  {
    Point record{ (std::uint64_t(region) << 32) | point, point, point, {}, this->Users[point] == Several ? 1u : 0u };
    if (!this->IsStitched.empty() && this->IsStitched[point])
    {
      if (!this->NextPoint || vtkMTRecordSort::GetKey(this->NextPoint) != record.Key)
      {
        return this->Fail("the stitched points of a region are incomplete");
      }
      std::memcpy(&record, this->NextPoint, sizeof(record));
      result.Points.push_back(record);
      result.PointValues.insert(
        result.PointValues.end(), this->NextPoint + sizeof(record), this->NextPoint + this->PointSize);
      this->NextPoint = this->Points.Next();
      continue;
    }
    const unsigned char* found = this->Input.GetPoints().LookUp(point, bytes, this->Error);
    if (!found)
    {
      return false;
    }
    this->MakePoint(found, record, values);
    result.Points.push_back(record);
    result.PointValues.insert(result.PointValues.end(), values.begin(), values.end());
  }
  return true;
}
