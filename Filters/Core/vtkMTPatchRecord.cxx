// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPatchRecord.h"

#include "vtkMTBytes.h"

#include <algorithm>

namespace
{
bool IsZero(const vtkMTColumn& column)
{
  return !column.empty() && std::all_of(column.begin(), column.end(), [](unsigned char byte) { return byte == 0; });
}

void PutColumns(vtkMTBytes::Writer& writer, const std::vector<vtkMTColumn>& columns)
{
  writer.Put(static_cast<std::uint32_t>(columns.size()));
  for (const vtkMTColumn& column : columns)
  {
    const bool isZero = IsZero(column);
    writer.Put<std::uint64_t>(isZero ? column.size() : 0);
    if (!isZero)
    {
      writer.PutList(column);
    }
  }
}

void TakeColumns(vtkMTBytes::Reader& reader, std::vector<vtkMTColumn>& columns, std::size_t largestColumn)
{
  columns.resize(std::min<std::size_t>(reader.Take<std::uint32_t>(), 65536));
  for (vtkMTColumn& column : columns)
  {
    const auto zeros = reader.Take<std::uint64_t>();
    if (zeros > 0)
    {
      column.assign(static_cast<std::size_t>(std::min<std::uint64_t>(zeros, largestColumn)), 0);
    }
    else
    {
      reader.TakeList(column);
    }
  }
}
}

void vtkMTPatchRecord::Put(const vtkMTPatch& patch, vtkMTBytes::Writer& writer)
{
  writer.PutList(patch.Points);
  writer.PutList(patch.Ids);
  writer.PutList(patch.WedgePoints);
  writer.PutList(patch.Triangles);
  PutColumns(writer, patch.PointColumns);
  PutColumns(writer, patch.CellColumns);
}

bool vtkMTPatchRecord::Take(vtkMTBytes::Reader& reader, vtkMTPatch& patch)
{
  constexpr std::size_t largestTuple = 1024;
  reader.TakeList(patch.Points);
  reader.TakeList(patch.Ids);
  reader.TakeList(patch.WedgePoints);
  reader.TakeList(patch.Triangles);
  TakeColumns(reader, patch.PointColumns, largestTuple * patch.GetNumberOfWedges());
  TakeColumns(reader, patch.CellColumns, largestTuple * patch.Triangles.size());
  return reader.IsSound();
}

vtkMTPatchRecord::Shape vtkMTPatchRecord::TakeShape(vtkMTBytes::Reader& reader)
{
  Shape shape;
  shape.Points = reader.TakeView<vtkMTPoint>();
  reader.TakeView<std::uint64_t>(); // ids
  shape.WedgePoints = reader.TakeView<std::uint32_t>();
  shape.Triangles = reader.TakeView<vtkMTTriangle>();
  return shape;
}

void vtkMTPatchRecord::Encode(const vtkMTPatch& patch, std::vector<unsigned char>& bytes)
{
  bytes.clear();
  bytes.reserve(patch.GetMemorySize() + 256);
  vtkMTBytes::Writer writer(bytes);
  Put(patch, writer);
}

bool vtkMTPatchRecord::Decode(const vtkMTBytes::Record& bytes, vtkMTPatch& patch, std::string& error)
{
  vtkMTBytes::Reader reader(bytes);
  if (!Take(reader, patch) || !reader.IsAtEnd())
  {
    error = "temporary data does not hold the patch that was written";
    return false;
  }
  return true;
}
