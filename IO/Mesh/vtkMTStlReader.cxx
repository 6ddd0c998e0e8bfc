// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTStlReader.h"

#include "vtkMTReadWhole.h"
#include "vtkMTStlText.h"
#include "vtkMTTextFormat.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace
{
constexpr std::uint64_t HeadSize = 84; // a text of 80 bytes and the number of triangles
constexpr std::uint64_t RecordSize = 50;

// Three points for each triangle, in order.
void Fill(vtkPolyData* output, vtkFloatArray* coordinates)
{
  const vtkIdType count = coordinates->GetNumberOfTuples();
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  vtkNew<vtkIdTypeArray> corners;
  corners->SetNumberOfValues(count);
  vtkNew<vtkIdTypeArray> offsets;
  offsets->SetNumberOfValues(count / 3 + 1);
  for (vtkIdType i = 0; i < count; ++i)
  {
    corners->SetValue(i, i);
  }
  for (vtkIdType i = 0; i <= count / 3; ++i)
  {
    offsets->SetValue(i, 3 * i);
  }
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, corners);
  output->SetPoints(points);
  output->SetPolys(cells);
}

bool ReadBinary(vtkMTTextFormat::Stream& stream, std::uint32_t count, vtkPolyData* output, std::string& error)
{
  const std::uint64_t left = stream.GetLeft();
  const std::uint64_t whole = left / RecordSize;
  if (whole != count)
  {
    error = "its header announces " + std::to_string(count) + " triangles, but there are " + std::to_string(whole) +
      (whole < count ? ": it is truncated, or no STL file" : "");
    return false;
  }
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(vtkIdType(3) * count);
  float* to = coordinates->GetPointer(0);
  for (std::uint32_t i = 0; i < count; ++i, to += 9)
  {
    const unsigned char* record = stream.Take(RecordSize);
    if (!record)
    {
      error = stream.GetError().empty() ? "is truncated" : stream.GetError();
      return false;
    }
    std::memcpy(to, record + 12, 36); // after the normal
  }
  Fill(output, coordinates);
  return true;
}

bool ReadText(vtkMTTextFormat::Stream& stream, vtkPolyData* output, std::string& error)
{
  vtkMTStlText text(stream);
  std::vector<float> values;
  if (!text.Read(std::numeric_limits<std::size_t>::max(), values))
  {
    error = text.GetError();
    return false;
  }
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(static_cast<vtkIdType>(values.size() / 3));
  std::copy(values.begin(), values.end(), coordinates->GetPointer(0));
  Fill(output, coordinates);
  return true;
}

bool ReadBytes(const vtkMTByteSource& bytes, vtkPolyData* output, std::string& error)
{
  vtkMTTextFormat::Stream stream(bytes);
  std::uint32_t count = 0;
  unsigned char head[HeadSize] = {};
  const std::uint64_t size = bytes.GetSize();
  if (!bytes.Read(0, static_cast<std::size_t>(size < HeadSize ? size : HeadSize), head, error))
  {
    return false;
  }
  std::memcpy(&count, head + 80, sizeof(count));
  const bool hasSize = size >= HeadSize && size == HeadSize + count * RecordSize;
  if (!hasSize && vtkMTStlText::IsText(std::string_view(reinterpret_cast<const char*>(head), HeadSize)))
  {
    return ReadText(stream, output, error);
  }
  if (size < HeadSize)
  {
    error = size == 0 ? "is empty" : "is too short for an STL file";
    return false;
  }
  return stream.Skip(HeadSize) && ReadBinary(stream, count, output, error);
}
}

bool vtkMTStlReader::Read(const std::string& path, vtkPolyData* output, std::string& error)
{
  return vtkMTReadWhole::ReadFile<vtkMTStlReader>(path, output, error);
}

bool vtkMTStlReader::Read(const vtkMTByteSource& bytes, vtkPolyData* output, std::string& error)
{
  return vtkMTReadWhole::Read(
    bytes, output, error, [&](std::string& reason) { return ReadBytes(bytes, output, reason); });
}
