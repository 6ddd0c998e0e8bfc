// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTObjReader.h"

#include "vtkMTFileByteSource.h"
#include "vtkMTSinglePrecision.h"
#include "vtkMTTextFormat.h"
#include "vtkMTWedgeSplitter.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <limits>
#include <map>

namespace
{
using vtkMTTextFormat::NextToken;

constexpr std::uint64_t None = std::numeric_limits<std::uint64_t>::max();

struct Cells
{
  std::vector<vtkIdType> Offsets{ 0 };
  std::vector<vtkIdType> Corners;
  std::vector<vtkMTWedgeSplitter::Key> Keys; // texture coordinate and normal of each corner, or None
  std::vector<int> Materials;
  std::vector<int> Groups;
};

// Whether the decimal text says more than single precision keeps: whether rounding moves it by more than half of its
// last digit.
bool NeedsDouble(std::string_view token, double value)
{
  const double shift = std::abs(vtkMTSinglePrecision::Round(value) - value);
  if (!(shift > 0.0) || !std::isfinite(shift))
  {
    return false;
  }
  const std::size_t mantissa = std::min(token.find_first_of("eE"), token.size());
  const std::size_t dot = token.substr(0, mantissa).find('.');
  const double decimals = dot == std::string_view::npos ? 0.0 : static_cast<double>(mantissa - dot - 1);
  std::int64_t exponent = 0;
  if (mantissa < token.size())
  {
    vtkMTTextFormat::ToNumber(token.substr(mantissa + 1), exponent);
  }
  return shift > 0.5 * std::pow(10.0, static_cast<double>(exponent) - decimals);
}

class Reader
{
public:
  explicit Reader(const vtkMTByteSource& bytes)
    : Stream(bytes)
  {
  }

  bool Read(vtkPolyData* output, std::string& error)
  {
    std::string_view line;
    while (this->TakeWholeLine(line))
    {
      if (!this->ReadLine(line))
      {
        error = "line " + std::to_string(this->LineNumber) + ": " + this->Error;
        return false;
      }
    }
    error = this->Stream.GetError();
    if (!error.empty() || !this->CheckIndices(error))
    {
      return false;
    }
    this->Finish(output);
    return true;
  }

private:
  bool Fail(const std::string& reason)
  {
    this->Error = reason;
    return false;
  }

  bool TakeWholeLine(std::string_view& line);
  bool ReadLine(std::string_view line);
  bool ReadVertex(std::string_view line);
  bool ReadNumbers(std::string_view line, std::size_t least, std::size_t count, std::vector<float>& values);
  bool ReadCell(std::string_view line, std::size_t least, Cells& cells);
  bool ReadCorner(std::string_view token, Cells& cells);
  bool ReadIndex(std::string_view& token, std::size_t count, std::uint64_t& index);
  bool CheckIndices(std::string& error) const;
  void UseMaterial(std::string_view line);
  void UseLibraries(std::string_view line);
  void Finish(vtkPolyData* output);
  void FinishPoints(vtkPolyData* output) const;
  void FinishCells(vtkPolyData* output) const;

  vtkMTTextFormat::Stream Stream;
  std::uint64_t LineNumber = 0;
  std::string Joined; // lines that end in a backslash, with what follows
  std::string Error;

  std::vector<double> Points;
  bool IsDouble = false;
  std::vector<float> Colors; // three per point while every point has some
  std::vector<float> TextureCoordinates;
  std::vector<float> Normals;
  Cells Lines;
  Cells Faces;
  std::map<std::string, int> Materials;
  std::vector<std::string> MaterialNames;
  std::vector<std::string> Libraries;
  int Material = -1;
  int Group = -1;
};

bool Reader::TakeWholeLine(std::string_view& line)
{
  this->Joined.clear();
  while (this->Stream.TakeLine(line))
  {
    ++this->LineNumber;
    const bool goesOn = !line.empty() && line.back() == '\\';
    if (!goesOn && this->Joined.empty())
    {
      return true;
    }
    this->Joined.append(line.substr(0, line.size() - (goesOn ? 1 : 0)));
    if (!goesOn || this->Joined.size() > vtkMTTextFormat::Stream::LargestLine)
    {
      line = this->Joined;
      return true;
    }
  }
  line = this->Joined;
  return !this->Joined.empty() && this->Stream.GetError().empty();
}

bool Reader::ReadLine(std::string_view line)
{
  const std::string_view keyword = NextToken(line);
  if (keyword == "v")
  {
    return this->ReadVertex(line);
  }
  if (keyword == "vt")
  {
    return this->ReadNumbers(line, 1, 2, this->TextureCoordinates);
  }
  if (keyword == "vn")
  {
    return this->ReadNumbers(line, 3, 3, this->Normals);
  }
  if (keyword == "f" || keyword == "fo")
  {
    return this->ReadCell(line, 3, this->Faces);
  }
  if (keyword == "l")
  {
    return this->ReadCell(line, 2, this->Lines);
  }
  if (keyword == "g")
  {
    ++this->Group;
  }
  else if (keyword == "usemtl")
  {
    this->UseMaterial(line);
  }
  else if (keyword == "mtllib")
  {
    this->UseLibraries(line);
  }
  return true;
}

// x y z, x y z w, x y z r g b
bool Reader::ReadVertex(std::string_view line)
{
  double values[7];
  std::size_t count = 0;
  for (std::string_view token = NextToken(line); !token.empty() && token[0] != '#'; token = NextToken(line))
  {
    if (count == 7 || !vtkMTTextFormat::ToNumber(token, values[count]))
    {
      return this->Fail("\"" + std::string(token.substr(0, 40)) + "\" is no coordinate");
    }
    this->IsDouble = this->IsDouble || (count < 3 && NeedsDouble(token, values[count]));
    ++count;
  }
  if (count < 3)
  {
    return this->Fail("a vertex with " + std::to_string(count) + " coordinates");
  }
  const bool hadColors = this->Colors.size() == this->Points.size();
  this->Points.insert(this->Points.end(), values, values + 3);
  if (count >= 6 && hadColors)
  {
    for (std::size_t i = count - 3; i < count; ++i)
    {
      this->Colors.push_back(static_cast<float>(values[i]));
    }
  }
  return true;
}

bool Reader::ReadNumbers(std::string_view line, std::size_t least, std::size_t count, std::vector<float>& values)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::string_view token = NextToken(line);
    float value = 0.0f;
    if ((!token.empty() || i < least) && !vtkMTTextFormat::ToNumber(token, value))
    {
      return this->Fail("\"" + std::string(token.substr(0, 40)) + "\" is no number");
    }
    values.push_back(value);
  }
  return true;
}

// The number before the next slash: counted from 1, or backwards from the latest. An empty one is None.
bool Reader::ReadIndex(std::string_view& token, std::size_t count, std::uint64_t& index)
{
  const std::size_t slash = std::min(token.find('/'), token.size());
  const std::string_view digits = token.substr(0, slash);
  token.remove_prefix(std::min(slash + 1, token.size()));
  index = None;
  if (digits.empty())
  {
    return true;
  }
  std::int64_t number = 0;
  if (!vtkMTTextFormat::ToNumber(digits, number) || number == 0 || number < -static_cast<std::int64_t>(count))
  {
    return false;
  }
  index = number > 0 ? static_cast<std::uint64_t>(number) - 1 : count - static_cast<std::uint64_t>(-number);
  return true;
}

bool Reader::ReadCorner(std::string_view token, Cells& cells)
{
  const std::string_view whole = token;
  std::uint64_t point = None;
  vtkMTWedgeSplitter::Key key;
  if (!this->ReadIndex(token, this->Points.size() / 3, point) || point == None ||
    !this->ReadIndex(token, this->TextureCoordinates.size() / 2, key[0]) ||
    !this->ReadIndex(token, this->Normals.size() / 3, key[1]) || !token.empty())
  {
    return this->Fail("\"" + std::string(whole.substr(0, 40)) + "\" is no corner of a face");
  }
  cells.Corners.push_back(static_cast<vtkIdType>(point));
  cells.Keys.push_back(key);
  return true;
}

bool Reader::ReadCell(std::string_view line, std::size_t least, Cells& cells)
{
  std::size_t count = 0;
  for (std::string_view token = NextToken(line); !token.empty() && token[0] != '#'; token = NextToken(line), ++count)
  {
    if (!this->ReadCorner(token, cells))
    {
      return false;
    }
  }
  if (count < least)
  {
    return this->Fail(std::string(least == 3 ? "a face" : "a line") + " with " + std::to_string(count) + " corners");
  }
  cells.Offsets.push_back(static_cast<vtkIdType>(cells.Corners.size()));
  cells.Materials.push_back(this->Material);
  cells.Groups.push_back(std::max(this->Group, 0));
  return true;
}

void Reader::UseMaterial(std::string_view line)
{
  const std::string name(NextToken(line));
  const auto inserted = this->Materials.emplace(name, static_cast<int>(this->MaterialNames.size()));
  if (inserted.second)
  {
    this->MaterialNames.push_back(name);
  }
  this->Material = inserted.first->second;
}

// One name with blanks in it, or several: the first is what most programs write and mean.
void Reader::UseLibraries(std::string_view line)
{
  const std::size_t first = line.find_first_not_of(" \t");
  const std::size_t last = line.find_last_not_of(" \t");
  if (first != std::string_view::npos)
  {
    const std::string name(line.substr(first, last - first + 1));
    if (std::find(this->Libraries.begin(), this->Libraries.end(), name) == this->Libraries.end())
    {
      this->Libraries.push_back(name);
    }
  }
}

// A face may name what only comes later in the file, so this is known at the end.
bool Reader::CheckIndices(std::string& error) const
{
  const std::uint64_t points = this->Points.size() / 3;
  const std::uint64_t limits[2] = { this->TextureCoordinates.size() / 2, this->Normals.size() / 3 };
  for (const Cells* cells : { &this->Faces, &this->Lines })
  {
    for (std::size_t i = 0; i < cells->Corners.size(); ++i)
    {
      const std::uint64_t point = static_cast<std::uint64_t>(cells->Corners[i]);
      if (point >= points)
      {
        error = "a face uses vertex " + std::to_string(point + 1) + ", but there are " + std::to_string(points);
        return false;
      }
      for (int kind = 0; kind < 2; ++kind)
      {
        const std::uint64_t index = cells->Keys[i][kind];
        if (index != None && index >= limits[kind])
        {
          error = std::string("a face uses ") + (kind == 0 ? "texture coordinate " : "normal ") +
            std::to_string(index + 1) + ", but there are " + std::to_string(limits[kind]);
          return false;
        }
      }
    }
  }
  return true;
}

void Reader::FinishPoints(vtkPolyData* output) const
{
  vtkNew<vtkPoints> points;
  points->SetDataType(this->IsDouble ? VTK_DOUBLE : VTK_FLOAT);
  points->SetNumberOfPoints(static_cast<vtkIdType>(this->Points.size() / 3));
  for (std::size_t i = 0; i + 2 < this->Points.size(); i += 3)
  {
    points->SetPoint(static_cast<vtkIdType>(i / 3), this->Points.data() + i);
  }
  output->SetPoints(points);
  if (!this->Colors.empty() && this->Colors.size() == this->Points.size())
  {
    vtkNew<vtkFloatArray> colors;
    colors->SetName("RGB");
    colors->SetNumberOfComponents(3);
    colors->SetNumberOfTuples(points->GetNumberOfPoints());
    std::copy(this->Colors.begin(), this->Colors.end(), colors->GetPointer(0));
    output->GetPointData()->AddArray(colors);
  }
}

// One value of `all` per point, by the index that the point's corner has; 0 where it has none.
vtkSmartPointer<vtkFloatArray> Pick(const vtkMTWedgeSplitter::Result& wedges,
  const std::vector<vtkMTWedgeSplitter::Key>& keys, std::size_t kind, const std::vector<float>& all, int components,
  const char* name)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(wedges.Corners.size()));
  array->FillValue(0.0f);
  bool isUsed = false;
  for (std::size_t i = 0; i < wedges.Corners.size(); ++i)
  {
    const std::size_t corner = wedges.Corners[i];
    const std::uint64_t index = corner == vtkMTWedgeSplitter::NoCorner ? None : keys[corner][kind];
    if (index != None)
    {
      isUsed = true;
      array->SetTypedTuple(static_cast<vtkIdType>(i), all.data() + index * static_cast<std::size_t>(components));
    }
  }
  return isUsed ? array : nullptr;
}

vtkSmartPointer<vtkCellArray> ToCellArray(const Cells& cells)
{
  const auto copy = [](const std::vector<vtkIdType>& values)
  {
    auto array = vtkSmartPointer<vtkIdTypeArray>::New();
    array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
    std::copy(values.begin(), values.end(), array->GetPointer(0));
    return array;
  };
  auto array = vtkSmartPointer<vtkCellArray>::New();
  array->SetData(copy(cells.Offsets), copy(cells.Corners));
  return array;
}

void Reader::FinishCells(vtkPolyData* output) const
{
  const auto add = [&](const char* name, const std::vector<int>& ofLines, const std::vector<int>& ofFaces)
  {
    vtkNew<vtkIntArray> array; // VTK numbers lines before polygons
    array->SetName(name);
    array->SetNumberOfValues(static_cast<vtkIdType>(ofLines.size() + ofFaces.size()));
    std::copy(ofFaces.begin(), ofFaces.end(), std::copy(ofLines.begin(), ofLines.end(), array->GetPointer(0)));
    output->GetCellData()->AddArray(array);
  };
  const auto addNames = [&](const char* name, const std::vector<std::string>& values)
  {
    vtkNew<vtkStringArray> names;
    names->SetName(name);
    for (const std::string& value : values)
    {
      names->InsertNextValue(value);
    }
    output->GetFieldData()->AddArray(names);
  };
  if (!this->Libraries.empty())
  {
    addNames("MaterialLibraries", this->Libraries);
  }
  if (!this->MaterialNames.empty())
  {
    add("MaterialIds", this->Lines.Materials, this->Faces.Materials);
    addNames("MaterialNames", this->MaterialNames);
  }
  if (this->Group > 0)
  {
    add("GroupIds", this->Lines.Groups, this->Faces.Groups);
  }
}

void Reader::Finish(vtkPolyData* output)
{
  this->FinishPoints(output);
  const vtkMTWedgeSplitter::Result wedges =
    vtkMTWedgeSplitter::Split(this->Points.size() / 3, this->Faces.Corners, this->Faces.Keys);
  vtkMTWedgeSplitter::AppendCopies(output, wedges.Originals);
  output->GetPointData()->SetTCoords(Pick(wedges, this->Faces.Keys, 0, this->TextureCoordinates, 2, "TCoords"));
  output->GetPointData()->SetNormals(Pick(wedges, this->Faces.Keys, 1, this->Normals, 3, "Normals"));
  if (!this->Lines.Corners.empty())
  {
    output->SetLines(ToCellArray(this->Lines));
  }
  output->SetPolys(ToCellArray(this->Faces));
  this->FinishCells(output);
}
}

bool vtkMTObjReader::Read(const std::string& path, vtkPolyData* output, std::string& error)
{
  const auto bytes = vtkMTFileByteSource::Open(path, error);
  output->Initialize();
  return bytes && Read(*bytes, output, error);
}

bool vtkMTObjReader::Read(const vtkMTByteSource& bytes, vtkPolyData* output, std::string& error)
{
  output->Initialize();
  std::string reason;
  try
  {
    if (Reader(bytes).Read(output, reason))
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
