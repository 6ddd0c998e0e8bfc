// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTStlReader.h"

#include "vtkMTFileByteSource.h"
#include "vtkMTTextFormat.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <cstring>
#include <exception>

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
      (whole < count ? ": it is cut off, or no STL file" : "");
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
      error = stream.GetError().empty() ? "is cut off" : stream.GetError();
      return false;
    }
    std::memcpy(to, record + 12, 36); // after the normal
  }
  Fill(output, coordinates);
  return true;
}

//------------------------------------------------------------------------------
// Line by line; what a line begins with says what it is.
class TextReader
{
public:
  explicit TextReader(vtkMTTextFormat::Stream& stream)
    : Stream(stream)
  {
  }

  bool Read(vtkPolyData* output, std::string& error)
  {
    this->Coordinates->SetNumberOfComponents(3);
    std::string_view line;
    std::uint64_t number = 0;
    while (this->Stream.TakeLine(line))
    {
      ++number;
      if (!this->ReadLine(line))
      {
        error = "line " + std::to_string(number) + ": " + this->Error;
        return false;
      }
    }
    if (!this->Stream.GetError().empty() || this->IsInSolid)
    {
      error = !this->Stream.GetError().empty() ? this->Stream.GetError() : "ends before \"endsolid\": it is cut off";
      return false;
    }
    this->Coordinates->Squeeze();
    Fill(output, this->Coordinates);
    return true;
  }

private:
  bool Fail(const std::string& reason)
  {
    this->Error = reason;
    return false;
  }

  bool ReadLine(std::string_view line)
  {
    const std::string_view token = vtkMTTextFormat::NextToken(line);
    const std::string keyword = vtkMTTextFormat::ToLower(token.substr(0, 20));
    if (keyword == "vertex")
    {
      return this->ReadVertex(line);
    }
    if (keyword == "facet" || keyword == "endfacet")
    {
      const bool opens = keyword == "facet";
      const bool isInOrder = this->IsInSolid && this->IsInFacet != opens && (opens || this->Corners == 3);
      this->IsInFacet = opens;
      const int corners = this->Corners;
      this->Corners = 0;
      return isInOrder ||
        this->Fail(opens ? "a facet begins within another or outside a solid"
                         : "a facet ends with " + std::to_string(corners) + " vertices");
    }
    if (keyword == "solid" || keyword == "endsolid")
    {
      const bool opens = keyword == "solid";
      const bool isInOrder = this->IsInSolid != opens && !this->IsInFacet;
      this->IsInSolid = opens;
      return isInOrder || this->Fail("\"" + keyword + "\" is out of place");
    }
    return keyword.empty() || keyword == "outer" || keyword == "endloop" ||
      this->Fail("\"" + keyword + "\" is no keyword of STL");
  }

  bool ReadVertex(std::string_view line)
  {
    float place[3] = { 0.0f, 0.0f, 0.0f };
    for (float& x : place)
    {
      if (!vtkMTTextFormat::ToNumber(vtkMTTextFormat::NextToken(line), x))
      {
        return this->Fail("a vertex does not have three coordinates");
      }
    }
    if (!this->IsInFacet || ++this->Corners > 3 || !vtkMTTextFormat::NextToken(line).empty())
    {
      return this->Fail("a vertex is out of place");
    }
    this->Coordinates->InsertNextTuple(place);
    return true;
  }

  vtkMTTextFormat::Stream& Stream;
  vtkNew<vtkFloatArray> Coordinates;
  bool IsInSolid = false;
  bool IsInFacet = false;
  int Corners = 0;
  std::string Error;
};

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
  std::string_view begin(reinterpret_cast<const char*>(head), HeadSize);
  const bool isSolid = vtkMTTextFormat::ToLower(vtkMTTextFormat::NextToken(begin).substr(0, 6)) == "solid";
  if (!hasSize && isSolid)
  {
    return TextReader(stream).Read(output, error);
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
  const auto bytes = vtkMTFileByteSource::Open(path, error);
  output->Initialize();
  return bytes && Read(*bytes, output, error);
}

bool vtkMTStlReader::Read(const vtkMTByteSource& bytes, vtkPolyData* output, std::string& error)
{
  output->Initialize();
  std::string reason;
  try
  {
    if (ReadBytes(bytes, output, reason))
    {
      return true;
    }
  }
  catch (const std::exception& exception) // no memory
  {
    reason = exception.what();
  }
  output->Initialize();
  error = bytes.GetName() + ": " + reason;
  return false;
}
