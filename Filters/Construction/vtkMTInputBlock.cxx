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
  return this->IsDegenerate(triangle) ? "dropped_degenerate" : nullptr;
}

bool vtkMTInputBlock::IsFinite() const
{
  return std::all_of(this->Places.begin(), this->Places.end(),
    [](const Place& x) { return std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]); });
}

// With its values.
void vtkMTInputBlock::Move(std::size_t from, std::size_t to)
{
  this->Triangles[to] = this->Triangles[from];
  this->CellIds[to] = this->CellIds[from];
  for (vtkMTColumn& column : this->Columns)
  {
    const std::size_t size = column.size() / this->Triangles.size();
    std::memcpy(column.data() + to * size, column.data() + from * size, size);
  }
}

void vtkMTInputBlock::Shrink(std::size_t triangles)
{
  const std::size_t count = this->Triangles.size();
  if (triangles == count)
  {
    return;
  }
  this->Triangles.resize(triangles);
  this->CellIds.resize(triangles);
  for (vtkMTColumn& column : this->Columns)
  {
    column.resize(column.size() / count * triangles);
  }
}

std::size_t vtkMTInputBlock::GetMemorySize() const
{
  std::size_t size = this->Points.size() * sizeof(std::uint32_t) + this->Places.size() * sizeof(Place) +
    this->IsOpen.size() + this->Triangles.size() * sizeof(Triangle) + this->CellIds.size() * sizeof(std::int64_t);
  for (const vtkMTColumn& column : this->Columns)
  {
    size += column.size();
  }
  return size;
}

void vtkMTInputBlock::Encode(std::vector<unsigned char>& bytes) const
{
  bytes.clear();
  bytes.reserve(this->GetMemorySize() + 2 * vtkMTBytes::Alignment * (5 + this->Columns.size()));
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
