// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTInputBlock.h"

#include "vtkMTBytes.h"
#include "vtkMTRadixSort.h"

#include <cmath>
#include <cstring>

void vtkMTInputBlock::FindPoints()
{
  // Corners in order of their points: point above, corner below.
  std::vector<std::uint64_t> corners(3 * this->Triangles.size());
  std::vector<std::uint64_t> scratch;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    corners[i] = (std::uint64_t(this->Triangles[i / 3][i % 3]) << 32) | i;
  }
  // Corners are in order already: only the points' digits need sorting.
  vtkMTRadixSort::Sort(corners, scratch, [](std::uint64_t corner) { return corner >> 32; });
  this->Points.clear();
  for (const std::uint64_t corner : corners)
  {
    const std::uint32_t point = static_cast<std::uint32_t>(corner >> 32);
    if (this->Points.empty() || this->Points.back() != point)
    {
      this->Points.push_back(point);
    }
    const std::size_t i = static_cast<std::uint32_t>(corner);
    this->Triangles[i / 3][i % 3] = static_cast<std::uint32_t>(this->Points.size() - 1);
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
    this->Triangles[kept] = this->Triangles[t];
    this->CellIds[kept] = this->CellIds[t];
    for (std::size_t c = 0; c < this->Columns.size() && kept != t; ++c)
    {
      const std::size_t size = this->Columns[c].size() / count;
      std::memcpy(this->Columns[c].data() + kept * size, this->Columns[c].data() + t * size, size);
    }
    ++kept;
  }
  this->Triangles.resize(kept);
  this->CellIds.resize(kept);
  for (vtkMTColumn& column : this->Columns)
  {
    column.resize(count > 0 ? column.size() / count * kept : 0);
  }
}

void vtkMTInputBlock::Encode(std::vector<unsigned char>& bytes) const
{
  bytes.clear();
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
