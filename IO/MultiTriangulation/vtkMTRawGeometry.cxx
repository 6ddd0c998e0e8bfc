// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTRawGeometry.h"

#include "vtkMTFileFormat.h"
#include "vtkMTGraph.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace
{
using vtkMTFileFormat::GeometryRecord;

std::uint8_t WidthFor(std::uint64_t largest)
{
  return largest <= 0xffu ? 1 : largest <= 0xffffu ? 2 : largest <= 0xffffffffu ? 4 : 8;
}

void AppendNumber(std::vector<unsigned char>& bytes, std::uint64_t value, unsigned width)
{
  unsigned char digits[8];
  std::memcpy(digits, &value, 8);
  bytes.insert(bytes.end(), digits, digits + width);
}

// Calls put(i, value) for count numbers of the given width.
template <typename Number, typename Put>
void ReadNumbersAs(const unsigned char* data, std::size_t count, Put&& put)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    Number value;
    std::memcpy(&value, data + i * sizeof(Number), sizeof(Number));
    put(i, value);
  }
}

template <typename Put>
const unsigned char* ReadNumbers(const unsigned char* data, std::size_t count, unsigned width, Put&& put)
{
  switch (width)
  {
    case 1:
      ReadNumbersAs<std::uint8_t>(data, count, put);
      break;
    case 2:
      ReadNumbersAs<std::uint16_t>(data, count, put);
      break;
    case 4:
      ReadNumbersAs<std::uint32_t>(data, count, put);
      break;
    default:
      ReadNumbersAs<std::uint64_t>(data, count, put);
  }
  return data + count * width;
}

bool IsWidth(unsigned width)
{
  return width == 1 || width == 2 || width == 4;
}

GeometryRecord MakeRecord(const vtkMTPatch& patch)
{
  GeometryRecord record{};
  record.Points = static_cast<std::uint32_t>(patch.Points.size());
  record.Wedges = static_cast<std::uint32_t>(patch.GetNumberOfWedges());
  record.Triangles = static_cast<std::uint32_t>(patch.Triangles.size());
  record.SharedPoints = static_cast<std::uint32_t>(patch.Ids.size());
  std::uint64_t extent = 0;
  for (int axis = 0; axis < 3 && !patch.Points.empty(); ++axis)
  {
    const auto range = std::minmax_element(patch.Points.begin(), patch.Points.end(),
      [axis](const vtkMTPoint& a, const vtkMTPoint& b) { return a[axis] < b[axis]; });
    record.Corner[axis] = (*range.first)[axis];
    extent = std::max(extent, static_cast<std::uint64_t>(std::int64_t((*range.second)[axis]) - record.Corner[axis]));
  }
  record.CoordinateWidth = WidthFor(extent);
  record.IdWidth = 1;
  if (!patch.Ids.empty())
  {
    const auto range = std::minmax_element(patch.Ids.begin(), patch.Ids.end());
    record.FirstId = *range.first;
    record.IdWidth = WidthFor(*range.second - *range.first);
  }
  record.WedgeWidth = patch.WedgePoints.empty() ? 0 : WidthFor(std::max<std::uint32_t>(record.Points, 1) - 1);
  record.IndexWidth = WidthFor(std::max<std::uint32_t>(record.Wedges, 1) - 1);
  return record;
}

bool DecodePoints(
  const unsigned char*& data, const GeometryRecord& record, std::vector<vtkMTPoint>& points, std::string& error)
{
  points.resize(record.Points);
  bool inRange = true;
  data = ReadNumbers(data, std::size_t(3) * record.Points, record.CoordinateWidth,
    [&](std::size_t i, std::uint64_t value)
    {
      const std::int64_t place = record.Corner[i % 3] + static_cast<std::int64_t>(value);
      inRange = inRange && place <= std::numeric_limits<std::int32_t>::max();
      points[i / 3][i % 3] = static_cast<std::int32_t>(place);
    });
  error = inRange ? error : "has a point outside the lattice";
  return inRange;
}

// Numbers that must be below `limit`.
template <typename Put>
bool DecodeIndices(const unsigned char*& data, std::size_t count, unsigned width, std::uint32_t limit, Put&& put)
{
  bool inRange = true;
  data = ReadNumbers(data, count, width,
    [&](std::size_t i, std::uint64_t value)
    {
      inRange = inRange && value < limit;
      put(i, static_cast<std::uint32_t>(value));
    });
  return inRange;
}
}

namespace vtkMTRawGeometry
{
void Encode(const vtkMTPatch& patch, std::vector<unsigned char>& bytes)
{
  const GeometryRecord record = MakeRecord(patch);
  const unsigned char* head = reinterpret_cast<const unsigned char*>(&record);
  bytes.insert(bytes.end(), head, head + sizeof(record));
  for (const vtkMTPoint& point : patch.Points)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const std::int64_t offset = std::int64_t(point[axis]) - record.Corner[axis];
      AppendNumber(bytes, static_cast<std::uint64_t>(offset), record.CoordinateWidth);
    }
  }
  for (const std::uint64_t id : patch.Ids)
  {
    AppendNumber(bytes, id - record.FirstId, record.IdWidth);
  }
  for (const std::uint32_t point : patch.WedgePoints)
  {
    AppendNumber(bytes, point, record.WedgeWidth);
  }
  for (const vtkMTTriangle& triangle : patch.Triangles)
  {
    for (const std::uint32_t wedge : triangle)
    {
      AppendNumber(bytes, wedge, record.IndexWidth);
    }
  }
}

bool Decode(const unsigned char* data, std::uint64_t size, const vtkMTArc& arc, vtkMTPatch& patch, std::string& error)
{
  GeometryRecord record;
  if (size < sizeof(record))
  {
    error = "is too short";
    return false;
  }
  std::memcpy(&record, data, sizeof(record));
  if (record.Points != arc.Points || record.Wedges != arc.Wedges || record.Triangles != arc.Triangles ||
    record.SharedPoints != arc.SharedPoints)
  {
    error = "does not have the numbers of points, wedges and triangles that its arc announces";
    return false;
  }
  const bool hasTable = record.WedgeWidth != 0;
  if (!IsWidth(record.CoordinateWidth) || !(IsWidth(record.IdWidth) || record.IdWidth == 8) ||
    !IsWidth(record.IndexWidth) || (hasTable && !IsWidth(record.WedgeWidth)) ||
    (!hasTable && record.Wedges != record.Points) || record.SharedPoints > record.Points)
  {
    error = "has an impossible header";
    return false;
  }
  const std::uint64_t expected = sizeof(record) + std::uint64_t(3) * record.Points * record.CoordinateWidth +
    std::uint64_t(record.SharedPoints) * record.IdWidth + std::uint64_t(record.Wedges) * record.WedgeWidth +
    std::uint64_t(3) * record.Triangles * record.IndexWidth;
  if (size != expected)
  {
    error = "has " + std::to_string(size) + " bytes where " + std::to_string(expected) + " are expected";
    return false;
  }
  data += sizeof(record);
  if (!DecodePoints(data, record, patch.Points, error))
  {
    return false;
  }
  patch.Ids.resize(record.SharedPoints);
  data = ReadNumbers(data, record.SharedPoints, record.IdWidth,
    [&](std::size_t i, std::uint64_t value) { patch.Ids[i] = record.FirstId + value; });
  patch.WedgePoints.resize(hasTable ? record.Wedges : 0);
  patch.Triangles.resize(record.Triangles);
  if ((hasTable &&
        !DecodeIndices(data, record.Wedges, record.WedgeWidth, record.Points,
          [&](std::size_t i, std::uint32_t point) { patch.WedgePoints[i] = point; })) ||
    !DecodeIndices(data, std::size_t(3) * record.Triangles, record.IndexWidth, record.Wedges,
      [&](std::size_t i, std::uint32_t wedge) { patch.Triangles[i / 3][i % 3] = wedge; }))
  {
    error = "has an index out of range";
    return false;
  }
  return true;
}
}
