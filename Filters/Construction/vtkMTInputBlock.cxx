// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTInputBlock.h"

#include "vtkMTBytes.h"
#include "vtkMTRadixSort.h"

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

bool vtkMTInputBlock::Decode(const std::vector<unsigned char>& bytes, std::string& error)
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
