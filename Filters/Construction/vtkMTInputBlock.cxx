// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTInputBlock.h"

#include "vtkMTBytes.h"
#include "vtkMTRadixSort.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace
{
// Where the points of a block lie close together in the input: a table of all that may be among them.
void FindPointsByTable(std::uint32_t least, std::size_t range, vtkMTInputBlock& block)
{
  std::vector<std::uint32_t> places(range, 0);
  for (const vtkMTInputBlock::Triangle& t : block.Triangles)
  {
    places[t[0] - least] = places[t[1] - least] = places[t[2] - least] = 1;
  }
  std::uint32_t used = 0;
  block.Points.resize(3 * block.Triangles.size() + 1); // one more, as the last may be written in vain
  for (std::size_t p = 0; p < range; ++p)
  {
    block.Points[used] = static_cast<std::uint32_t>(least + p);
    const std::uint32_t isUsed = places[p];
    places[p] = used;
    used += isUsed;
  }
  block.Points.resize(used);
  for (vtkMTInputBlock::Triangle& t : block.Triangles)
  {
    t = { places[t[0] - least], places[t[1] - least], places[t[2] - least] };
  }
}

void FindPointsBySorting(vtkMTInputBlock& block)
{
  // Corners in order of their points: point above, corner below.
  std::vector<std::uint64_t> corners(3 * block.Triangles.size());
  std::vector<std::uint64_t> scratch;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    corners[i] = (std::uint64_t(block.Triangles[i / 3][i % 3]) << 32) | i;
  }
  // Corners are in order already: only the points' digits need sorting.
  vtkMTRadixSort::Sort(corners, scratch, [](std::uint64_t corner) { return corner >> 32; });
  block.Points.clear();
  for (const std::uint64_t corner : corners)
  {
    const std::uint32_t point = static_cast<std::uint32_t>(corner >> 32);
    if (block.Points.empty() || block.Points.back() != point)
    {
      block.Points.push_back(point);
    }
    const std::size_t i = static_cast<std::uint32_t>(corner);
    block.Triangles[i / 3][i % 3] = static_cast<std::uint32_t>(block.Points.size() - 1);
  }
}
}

void vtkMTInputBlock::FindPoints()
{
  this->Points.clear();
  if (this->Triangles.empty())
  {
    return;
  }
  std::uint32_t least = ~std::uint32_t(0);
  std::uint32_t largest = 0;
  for (const Triangle& t : this->Triangles)
  {
    least = std::min(least, std::min(t[0], std::min(t[1], t[2])));
    largest = std::max(largest, std::max(t[0], std::max(t[1], t[2])));
  }
  const std::size_t range = std::size_t(largest) - least + 1;
  if (range <= 3 * this->Triangles.size())
  {
    FindPointsByTable(least, range, *this);
  }
  else
  {
    FindPointsBySorting(*this);
  }
}

std::vector<unsigned char> vtkMTInputBlock::GetUsed() const
{
  std::vector<unsigned char> used(this->Points.size(), 0);
  for (const Triangle& t : this->Triangles)
  {
    used[t[0]] = used[t[1]] = used[t[2]] = 1;
  }
  return used;
}

const char* vtkMTInputBlock::FindFault(const Triangle& triangle) const
{
  for (std::uint32_t p : triangle)
  {
    const Place& x = this->Places[p];
    if (!std::isfinite(x[0]) || !std::isfinite(x[1]) || !std::isfinite(x[2]))
    {
      return "dropped_not_finite";
    }
  }
  for (std::size_t c = 0; c < 3; ++c)
  {
    if (this->Places[triangle[c]] == this->Places[triangle[(c + 1) % 3]])
    {
      return "dropped_degenerate";
    }
  }
  return nullptr;
}

void vtkMTInputBlock::Keep(const std::function<bool(const Triangle&)>& isKept)
{
  const std::size_t count = this->Triangles.size();
  std::size_t kept = 0;
  for (std::size_t t = 0; t < count; ++t)
  {
    if (!isKept(this->Triangles[t]))
    {
      continue;
    }
    if (kept == t) // nothing was dropped yet
    {
      ++kept;
      continue;
    }
    this->Triangles[kept] = this->Triangles[t];
    this->CellIds[kept] = this->CellIds[t];
    for (std::size_t c = 0; c < this->Columns.size(); ++c)
    {
      const std::size_t size = this->Columns[c].size() / count;
      std::memcpy(this->Columns[c].data() + kept * size, this->Columns[c].data() + t * size, size);
    }
    ++kept;
  }
  if (kept == count)
  {
    return;
  }
  this->Triangles.resize(kept);
  this->CellIds.resize(kept);
  for (vtkMTColumn& column : this->Columns)
  {
    column.resize(column.size() / count * kept);
  }
}

void vtkMTInputBlock::Encode(std::vector<unsigned char>& bytes) const
{
  std::size_t size = this->Points.size() * (sizeof(std::uint32_t) + sizeof(Place) + 1) +
    this->Triangles.size() * (sizeof(Triangle) + sizeof(std::int64_t)) + 256;
  for (const vtkMTColumn& column : this->Columns)
  {
    size += column.size() + 2 * vtkMTBytes::Alignment;
  }
  bytes.clear();
  bytes.reserve(size);
  vtkMTBytes::Writer writer(bytes);
  writer.PutList(this->Points);
  writer.PutList(this->Places);
  writer.PutList(this->IsOpen);
  writer.PutList(this->Triangles);
  writer.PutList(this->CellIds);
  for (const vtkMTColumn& column : this->Columns)
  {
    writer.PutList(column);
  }
}

bool vtkMTInputBlock::Decode(const vtkMTBytes::Record& bytes, std::string& error)
{
  vtkMTBytes::Reader reader(bytes);
  reader.TakeList(this->Points);
  reader.TakeList(this->Places);
  reader.TakeList(this->IsOpen);
  reader.TakeList(this->Triangles);
  reader.TakeList(this->CellIds);
  this->Columns.clear();
  while (reader.IsSound() && !reader.IsAtEnd())
  {
    this->Columns.emplace_back();
    reader.TakeList(this->Columns.back());
  }
  error = reader.IsSound() ? error : "temporary data does not hold the triangles that were written";
  return reader.IsSound();
}
