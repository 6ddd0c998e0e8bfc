// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTStlReader.h"

#include "vtkMTReadWhole.h"
#include "vtkMTStlBinary.h"
#include "vtkMTStlText.h"
#include "vtkMTTextFormat.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <limits>
#include <string_view>
#include <vector>

namespace
{
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

vtkSmartPointer<vtkFloatArray> MakeCoordinates(std::uint64_t triangles)
{
  auto coordinates = vtkSmartPointer<vtkFloatArray>::New();
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(static_cast<vtkIdType>(3 * triangles));
  return coordinates;
}

bool ReadBinary(vtkMTStlBinary& file, vtkPolyData* output, std::string& error)
{
  if (!file.Open(error))
  {
    return false;
  }
  const std::uint64_t count = file.GetNumberOfTriangles();
  const vtkSmartPointer<vtkFloatArray> coordinates = MakeCoordinates(count);
  Fill(output, coordinates);
  return file.ReadCoordinates(0, count, coordinates->GetPointer(0), error) && file.ReadCells(0, count, output, error);
}

bool ReadText(vtkMTStlText& text, vtkPolyData* output, std::string& error)
{
  std::vector<float> values;
  if (!text.Read(std::numeric_limits<std::size_t>::max(), values))
  {
    error = text.GetError();
    return false;
  }
  const std::uint64_t count = values.size() / 9;
  const vtkSmartPointer<vtkFloatArray> coordinates = MakeCoordinates(count);
  std::copy(values.begin(), values.end(), coordinates->GetPointer(0));
  Fill(output, coordinates);
  text.GetSolids().AddIds(0, count, output->GetCellData());
  return true;
}

bool ReadBytes(const vtkMTByteSource& bytes, vtkPolyData* output, std::string& error, vtkMTInputReport& report)
{
  char head[512] = {};
  const std::size_t size = static_cast<std::size_t>(std::min<std::uint64_t>(bytes.GetSize(), sizeof(head)));
  if (size == 0)
  {
    error = "is empty";
    return false;
  }
  if (!bytes.Read(0, size, head, error))
  {
    return false;
  }
  vtkMTStlBinary binary(bytes);
  if (binary.HasSize() || !vtkMTStlText::IsText(std::string_view(head, size)))
  {
    const bool isRead = ReadBinary(binary, output, error);
    vtkMTInputReports::Add(binary.GetReport(), report);
    return isRead;
  }
  vtkMTTextFormat::Stream stream(bytes);
  vtkMTStlText text(stream);
  const bool isRead = ReadText(text, output, error);
  vtkMTInputReports::Add(text.GetReport(), report);
  return isRead;
}
}

bool vtkMTStlReader::Read(const std::string& path, vtkPolyData* output, std::string& error)
{
  return vtkMTReadWhole::ReadFile<vtkMTStlReader>(path, output, error);
}

bool vtkMTStlReader::Read(
  const vtkMTByteSource& bytes, vtkPolyData* output, std::string& error, vtkMTInputReport* report)
{
  vtkMTInputReport unwanted;
  return vtkMTReadWhole::Read(bytes, output, error,
    [&](std::string& reason) { return ReadBytes(bytes, output, reason, report ? *report : unwanted); });
}
