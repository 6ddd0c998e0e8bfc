// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTStlBinary.h"

#include "vtkMTByteSource.h"

#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace
{
constexpr std::uint64_t BlockSize = 16384; // records
constexpr std::size_t MostSolids = 65536;

unsigned GetAttribute(const unsigned char* record)
{
  return static_cast<unsigned>(record[48]) | static_cast<unsigned>(record[49]) << 8;
}

unsigned char ToByte(unsigned fiveBits)
{
  return static_cast<unsigned char>(std::lround(static_cast<double>(fiveBits & 31u) * 255.0 / 31.0));
}
}

//------------------------------------------------------------------------------
vtkMTStlBinary::vtkMTStlBinary(const vtkMTByteSource& bytes)
  : Bytes(bytes)
  , IsExact(this->FindSolids())
{
}

bool vtkMTStlBinary::ReadHead(std::uint64_t offset, Solid& solid, std::string& error) const
{
  unsigned char head[HeadSize];
  if (this->Bytes.GetSize() < offset + HeadSize || !this->Bytes.Read(offset, HeadSize, head, error))
  {
    error = error.empty() ? "is too short for an STL file" : error;
    return false;
  }
  std::uint32_t count = 0;
  std::memcpy(&count, head + 80, sizeof(count));
  solid.Offset = offset + HeadSize;
  solid.First = this->Triangles;
  solid.Count = count;
  solid.Head.assign(reinterpret_cast<const char*>(head), 80);
  return true;
}

// One solid after the other, to the last byte.
bool vtkMTStlBinary::FindSolids()
{
  std::string error;
  std::uint64_t offset = 0;
  while (offset < this->Bytes.GetSize())
  {
    Solid solid;
    if (this->Solids.size() == MostSolids || !this->ReadHead(offset, solid, error))
    {
      return false;
    }
    offset = solid.Offset + solid.Count * RecordSize;
    this->Triangles += solid.Count;
    this->Solids.push_back(std::move(solid));
  }
  return offset == this->Bytes.GetSize() && !this->Solids.empty();
}

// Of a single solid whose count is not what the size says.
bool vtkMTStlBinary::FindRecords(std::string& error)
{
  this->Solids.assign(1, Solid());
  this->Triangles = 0;
  Solid& solid = this->Solids.front();
  if (!this->ReadHead(0, solid, error))
  {
    return false;
  }
  constexpr std::uint64_t unknown = 0xffffffffu; // of programs that write the count last, and did not
  const std::uint64_t announced = solid.Count;
  const std::uint64_t left = this->Bytes.GetSize() - HeadSize;
  const std::uint64_t whole = left / RecordSize;
  if (whole < announced && announced != unknown)
  {
    error = "its header announces " + std::to_string(announced) + " triangles, but there are " + std::to_string(whole) +
      ": it is truncated, or no STL file";
    return false;
  }
  const std::uint64_t first = announced == unknown ? 0 : announced;
  const bool goesOn = whole > first && this->AreTriangles(first, whole - first);
  solid.Count = goesOn ? whole : first;
  this->Triangles = solid.Count;
  vtkMTInputReports::Add("wrong_triangle_count", goesOn ? 1 : 0, this->Report);
  vtkMTInputReports::Add("trailing_bytes", left - solid.Count * RecordSize, this->Report);
  return true;
}

// Whether the records hold what triangles do: finite numbers, not zeros alone, and normals that are not long.
bool vtkMTStlBinary::AreTriangles(std::uint64_t first, std::uint64_t count) const
{
  std::string error;
  bool good = true;
  const auto look = [&good](std::uint64_t, const unsigned char* record)
  {
    float values[12];
    std::memcpy(values, record, sizeof(values));
    good = good && std::all_of(values, values + 3, [](float x) { return std::fabs(x) <= 1.5f; }) &&
      std::all_of(values, values + 12, [](float x) { return std::isfinite(x); }) &&
      std::any_of(values + 3, values + 12, [](float x) { return x != 0.0f; });
  };
  return this->ForEachRecord(first, count, error, look) && good;
}

template <class Use>
bool vtkMTStlBinary::ForEachRecord(std::uint64_t first, std::uint64_t count, std::string& error, Use&& use) const
{
  std::vector<unsigned char> block;
  for (const Solid& solid : this->Solids)
  {
    const bool isLast = &solid == &this->Solids.back(); // whose count may not be known yet
    const std::uint64_t end = isLast ? first + count : std::min(first + count, solid.First + solid.Count);
    for (std::uint64_t next = std::max(first, solid.First); next < end;)
    {
      const std::uint64_t records = std::min(BlockSize, end - next);
      block.resize(static_cast<std::size_t>(records * RecordSize));
      const std::uint64_t offset = solid.Offset + (next - solid.First) * RecordSize;
      if (!this->Bytes.Read(offset, block.size(), block.data(), error))
      {
        return false;
      }
      for (std::uint64_t i = 0; i < records; ++i)
      {
        use(next + i, block.data() + i * RecordSize);
      }
      next += records;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkMTStlBinary::Open(std::string& error)
{
  if (!this->IsExact && !this->FindRecords(error))
  {
    return false;
  }
  for (Solid& solid : this->Solids)
  {
    if (!this->LookAtAttributes(solid, error))
    {
      return false;
    }
    this->Names.Add(solid.First, solid.Head);
    this->HasColors = this->HasColors || solid.Dialect != NoColors;
  }
  return true;
}

bool vtkMTStlBinary::LookAtAttributes(Solid& solid, std::string& error)
{
  std::uint64_t marked = 0;
  std::uint64_t other = 0; // than zero
  const auto look = [&](std::uint64_t, const unsigned char* record)
  {
    const unsigned attribute = GetAttribute(record);
    marked += attribute >> 15;
    other += attribute != 0 ? 1 : 0;
  };
  if (!this->ForEachRecord(solid.First, solid.Count, error, look))
  {
    return false;
  }
  const std::size_t whole = solid.Head.find("COLOR=");
  if (whole != std::string::npos && whole + 10 <= solid.Head.size())
  {
    solid.Dialect = Magics;
    solid.HasOwnColors = other > 0; // else they are not set
    std::memcpy(solid.Whole.data(), solid.Head.data() + whole + 6, solid.Whole.size());
    return true;
  }
  solid.Dialect = marked > 0 ? VisCam : NoColors;
  vtkMTInputReports::Add("facets_without_color", marked > 0 ? solid.Count - marked : 0, this->Report);
  vtkMTInputReports::Add("ignored_attributes", marked > 0 ? 0 : other, this->Report);
  return true;
}

vtkMTStlBinary::Color vtkMTStlBinary::GetColor(const Solid& solid, unsigned attribute)
{
  const bool isMarked = attribute >> 15 != 0;
  const Color color{ ToByte(attribute), ToByte(attribute >> 5), ToByte(attribute >> 10) };
  if (solid.Dialect == Magics)
  {
    return isMarked || !solid.HasOwnColors ? solid.Whole : color;
  }
  return isMarked ? Color{ color[2], color[1], color[0] } : solid.Whole;
}

bool vtkMTStlBinary::ReadCoordinates(std::uint64_t first, std::uint64_t count, float* to, std::string& error) const
{
  const auto copy = [to, first](std::uint64_t triangle, const unsigned char* record)
  { std::memcpy(to + 9 * (triangle - first), record + 12, 36); }; // after the normal
  return this->ForEachRecord(first, count, error, copy);
}

bool vtkMTStlBinary::ReadCells(std::uint64_t first, std::uint64_t count, vtkPolyData* to, std::string& error) const
{
  this->Names.AddIds(first, count, to->GetCellData());
  if (!this->HasColors)
  {
    return true;
  }
  const vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("RGB");
  colors->SetNumberOfComponents(3);
  colors->SetNumberOfTuples(static_cast<vtkIdType>(count));
  const Solid* solid = this->Solids.data();
  const auto paint = [&](std::uint64_t triangle, const unsigned char* record)
  {
    while (triangle >= solid->First + solid->Count)
    {
      ++solid;
    }
    colors->SetTypedTuple(static_cast<vtkIdType>(triangle - first), GetColor(*solid, GetAttribute(record)).data());
  };
  to->GetCellData()->SetScalars(colors);
  return this->ForEachRecord(first, count, error, paint);
}
