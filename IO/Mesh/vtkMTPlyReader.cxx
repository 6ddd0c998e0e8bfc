// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPlyReader.h"

#include "vtkMTFieldNames.h"
#include "vtkMTPlyColumns.h"
#include "vtkMTPlyRows.h"
#include "vtkMTReadWhole.h"
#include "vtkMTWedgeSplitter.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <cmath>
#include <cstring>
#include <limits>

namespace
{
//------------------------------------------------------------------------------
// Reads the elements one after the other into a polydata.
class Reader
{
public:
  Reader(const vtkMTByteSource& bytes, vtkPolyData* output)
    : Stream(bytes)
    , Rows(this->Stream, this->Header)
    , Output(output)
  {
  }

  bool Read(std::string& error);

private:
  bool CheckHeader(std::string& error) const;
  bool ReadElement(const vtkMTPlyElement& element);
  bool ReadVertices(const vtkMTPlyElement& element);
  bool ReadFaces(const vtkMTPlyElement& element);
  bool ReadStrips(const vtkMTPlyElement& element);
  bool SkipRows(const vtkMTPlyElement& element);
  bool SkipProperty(const vtkMTPlyProperty& property);
  bool ReadCorners(const vtkMTPlyProperty& property, bool allowSeparator, std::vector<vtkIdType>& corners);
  bool ReadTextureCoordinates(const vtkMTPlyProperty& property);
  bool CheckIsAtEnd(std::string& error);
  void SplitWedges();
  void Finish();

  static const vtkMTPlyProperty* FindIndices(const vtkMTPlyElement& element)
  {
    const vtkMTPlyProperty* indices = element.Find("vertex_indices");
    return indices ? indices : element.Find("vertex_index");
  }
  static vtkSmartPointer<vtkCellArray> ToCells(
    const std::vector<vtkIdType>& offsets, const std::vector<vtkIdType>& corners);

  vtkMTTextFormat::Stream Stream;
  vtkMTPlyHeader Header;
  vtkMTPlyRows Rows;
  vtkPolyData* Output;
  std::uint64_t VertexCount = 0;

  std::vector<vtkIdType> FaceOffsets{ 0 };
  std::vector<vtkIdType> FaceCorners;
  std::vector<vtkIdType> StripOffsets{ 0 };
  std::vector<vtkIdType> StripCorners;
  bool HasTextureCoordinates = false;
  bool TextureCoordinatesAreDouble = false;
  std::vector<double> TextureCoordinates; // two per face corner; 0 where a face has none
};

bool Reader::CheckHeader(std::string& error) const
{
  const vtkMTPlyElement* vertex = this->Header.Find("vertex");
  if (!vertex)
  {
    error = "has no element vertex";
    return false;
  }
  for (const char* name : { "x", "y", "z" })
  {
    const vtkMTPlyProperty* property = vertex->Find(name);
    if (!property || property->IsList())
    {
      error = std::string("its element vertex has no property ") + name;
      return false;
    }
  }
  for (const char* name : { "face", "tristrips" })
  {
    const vtkMTPlyElement* element = this->Header.Find(name);
    const vtkMTPlyProperty* indices = element ? FindIndices(*element) : nullptr;
    const bool isGood = indices && indices->IsList() && indices->Type != VTK_FLOAT && indices->Type != VTK_DOUBLE;
    if (element && element->Count > 0 && !isGood)
    {
      error = std::string("its element ") + name + " has no list of whole numbers vertex_indices";
      return false;
    }
  }
  return true;
}

bool Reader::SkipProperty(const vtkMTPlyProperty& property)
{
  double value;
  std::uint64_t count = 0;
  return property.IsList() ? this->Rows.ReadCount(property, count) && this->Rows.SkipItems(property, count)
                           : this->Rows.Read(property, value);
}

bool Reader::SkipRows(const vtkMTPlyElement& element)
{
  for (std::uint64_t row = 0; row < element.Count && !element.Properties.empty(); ++row)
  {
    if (!this->Rows.BeginRow())
    {
      return false;
    }
    for (const vtkMTPlyProperty& property : element.Properties)
    {
      if (!this->SkipProperty(property))
      {
        return false;
      }
    }
    if (!this->Rows.EndRow())
    {
      return false;
    }
  }
  return true;
}

bool Reader::ReadVertices(const vtkMTPlyElement& element)
{
  vtkMTPlyColumns columns(element);
  const std::vector<std::string> place = { "x", "y", "z" };
  const int type = columns.FindRealType(place);
  vtkNew<vtkPoints> points;
  points->SetData(columns.Group(place, "Points", type));
  this->Output->SetPoints(points);
  vtkPointData* attributes = this->Output->GetPointData();
  const std::vector<std::string> normal = { "nx", "ny", "nz" };
  attributes->SetNormals(columns.Group(normal, "Normals", columns.FindRealType(normal)));
  columns.AddColors(attributes);
  const std::vector<std::vector<std::string>> pairs = { { "s", "t" }, { "u", "v" }, { "texture_u", "texture_v" },
    { "texture_s", "texture_t" } };
  for (const std::vector<std::string>& pair : pairs)
  {
    if (!attributes->GetTCoords())
    {
      attributes->SetTCoords(columns.Group(pair, "TCoords", columns.FindRealType(pair)));
    }
  }
  columns.AddOthers(attributes);
  for (std::uint64_t row = 0; row < element.Count; ++row)
  {
    if (!this->Rows.BeginRow())
    {
      return false;
    }
    for (std::size_t i = 0; i < element.Properties.size(); ++i)
    {
      const vtkMTPlyProperty& property = element.Properties[i];
      double value = 0.0;
      if (property.IsList() ? !this->SkipProperty(property) : !this->Rows.Read(property, value))
      {
        return false;
      }
      if (!property.IsList())
      {
        columns.Store(i, row, value);
      }
    }
    if (!this->Rows.EndRow())
    {
      return false;
    }
  }
  return true;
}

bool Reader::ReadCorners(const vtkMTPlyProperty& property, bool allowSeparator, std::vector<vtkIdType>& corners)
{
  std::uint64_t count = 0;
  if (!this->Rows.ReadCount(property, count))
  {
    return false;
  }
  for (std::uint64_t i = 0; i < count; ++i)
  {
    double value = 0.0;
    if (!this->Rows.Read(property, value))
    {
      return false;
    }
    const bool isSeparator = allowSeparator && value == -1.0;
    if (!isSeparator && !(value >= 0.0 && value < static_cast<double>(this->VertexCount)))
    {
      return this->Rows.Fail("vertex " + std::to_string(static_cast<std::int64_t>(value)) +
        " does not exist; there are " + std::to_string(this->VertexCount));
    }
    corners.push_back(static_cast<vtkIdType>(value));
  }
  return true;
}

// Those of the face whose corners may come before or after them in the row.
bool Reader::ReadTextureCoordinates(const vtkMTPlyProperty& property)
{
  std::uint64_t count = 0;
  if (!this->Rows.ReadCount(property, count))
  {
    return false;
  }
  for (std::uint64_t i = 0; i < count; ++i)
  {
    double value = 0.0;
    if (!this->Rows.Read(property, value))
    {
      return false;
    }
    this->TextureCoordinates.push_back(value);
  }
  return true;
}

bool Reader::ReadFaces(const vtkMTPlyElement& element)
{
  vtkMTPlyColumns columns(element);
  vtkCellData* attributes = this->Output->GetCellData();
  columns.AddColors(attributes);
  columns.AddOthers(attributes);
  const vtkMTPlyProperty* indices = FindIndices(element);
  const vtkMTPlyProperty* texture = element.Find("texcoord");
  texture = texture && texture->IsList() ? texture : nullptr;
  this->HasTextureCoordinates = texture != nullptr;
  this->TextureCoordinatesAreDouble = texture && texture->Type != VTK_FLOAT;
  for (std::uint64_t row = 0; row < element.Count; ++row)
  {
    if (!this->Rows.BeginRow())
    {
      return false;
    }
    for (std::size_t i = 0; i < element.Properties.size(); ++i)
    {
      const vtkMTPlyProperty& property = element.Properties[i];
      double value = 0.0;
      const bool done = &property == indices ? this->ReadCorners(property, false, this->FaceCorners)
        : &property == texture               ? this->ReadTextureCoordinates(property)
        : property.IsList()                  ? this->SkipProperty(property)
                                             : this->Rows.Read(property, value);
      if (!done)
      {
        return false;
      }
      if (!property.IsList())
      {
        columns.Store(i, row, value);
      }
    }
    const std::size_t wanted = 2 * this->FaceCorners.size();
    const std::size_t before = 2 * static_cast<std::size_t>(this->FaceOffsets.back());
    if (texture && this->TextureCoordinates.size() == before)
    {
      this->TextureCoordinates.resize(wanted, 0.0);
    }
    if (texture && this->TextureCoordinates.size() != wanted)
    {
      return this->Rows.Fail(std::to_string(this->TextureCoordinates.size() - before) + " texture coordinates for " +
        std::to_string((wanted - before) / 2) + " corners");
    }
    this->FaceOffsets.push_back(static_cast<vtkIdType>(this->FaceCorners.size()));
    if (!this->Rows.EndRow())
    {
      return false;
    }
  }
  return true;
}

bool Reader::ReadStrips(const vtkMTPlyElement& element)
{
  const vtkMTPlyProperty* indices = FindIndices(element);
  std::vector<vtkIdType> corners;
  for (std::uint64_t row = 0; row < element.Count; ++row)
  {
    corners.clear();
    if (!this->Rows.BeginRow())
    {
      return false;
    }
    for (const vtkMTPlyProperty& property : element.Properties)
    {
      if (&property == indices ? !this->ReadCorners(property, true, corners) : !this->SkipProperty(property))
      {
        return false;
      }
    }
    corners.push_back(-1);
    for (std::size_t begin = 0, i = 0; i < corners.size(); ++i)
    {
      if (corners[i] < 0)
      {
        if (i - begin >= 3) // a shorter one has no triangle
        {
          this->StripCorners.insert(this->StripCorners.end(), corners.begin() + static_cast<std::ptrdiff_t>(begin),
            corners.begin() + static_cast<std::ptrdiff_t>(i));
          this->StripOffsets.push_back(static_cast<vtkIdType>(this->StripCorners.size()));
        }
        begin = i + 1;
      }
    }
    if (!this->Rows.EndRow())
    {
      return false;
    }
  }
  return true;
}

bool Reader::ReadElement(const vtkMTPlyElement& element)
{
  if (!this->Rows.BeginElement(element))
  {
    return false;
  }
  if (element.Name == "vertex")
  {
    return this->ReadVertices(element);
  }
  if (element.Count > 0 && element.Name == "face")
  {
    return this->ReadFaces(element);
  }
  if (element.Count > 0 && element.Name == "tristrips")
  {
    return this->ReadStrips(element);
  }
  return this->SkipRows(element);
}

// Bytes after the last element mean that a count is wrong; what editors append is no harm.
bool Reader::CheckIsAtEnd(std::string& error)
{
  const std::uint64_t left = this->Stream.GetLeft();
  while (const unsigned char* byte = this->Stream.Take(1))
  {
    if (*byte != ' ' && *byte != '\t' && *byte != '\n' && *byte != '\r' && *byte != 0 && *byte != 0x1a)
    {
      error = "has " + std::to_string(left) + " bytes after the last element that its header announces";
      return false;
    }
  }
  return true;
}

vtkSmartPointer<vtkCellArray> Reader::ToCells(
  const std::vector<vtkIdType>& offsets, const std::vector<vtkIdType>& corners)
{
  const auto copy = [](const std::vector<vtkIdType>& values)
  {
    auto array = vtkSmartPointer<vtkIdTypeArray>::New();
    array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
    std::copy(values.begin(), values.end(), array->GetPointer(0));
    return array;
  };
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(copy(offsets), copy(corners));
  return cells;
}

// The texture coordinates of corners become those of points.
void Reader::SplitWedges()
{
  std::vector<vtkMTWedgeSplitter::Key> keys(this->FaceCorners.size());
  if (!keys.empty())
  {
    std::memcpy(keys.data(), this->TextureCoordinates.data(), keys.size() * sizeof(keys[0]));
  }
  const vtkMTWedgeSplitter::Result wedges =
    vtkMTWedgeSplitter::Split(static_cast<std::size_t>(this->Output->GetNumberOfPoints()), this->FaceCorners, keys);
  vtkMTWedgeSplitter::AppendCopies(this->Output, wedges.Originals);
  vtkPointData* attributes = this->Output->GetPointData();
  if (vtkDataArray* earlier = attributes->GetArray("TCoords"))
  {
    earlier->SetName("VertexTCoords");
  }
  const int type = this->TextureCoordinatesAreDouble ? VTK_DOUBLE : VTK_FLOAT;
  auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  array->SetName("TCoords");
  array->SetNumberOfComponents(2);
  array->SetNumberOfTuples(static_cast<vtkIdType>(wedges.Corners.size()));
  for (std::size_t i = 0; i < wedges.Corners.size(); ++i)
  {
    const double none[2] = { 0.0, 0.0 };
    const std::size_t corner = wedges.Corners[i];
    array->SetTuple(static_cast<vtkIdType>(i),
      corner == vtkMTWedgeSplitter::NoCorner ? none : this->TextureCoordinates.data() + 2 * corner);
  }
  attributes->SetTCoords(array);
}

void Reader::Finish()
{
  if (this->HasTextureCoordinates)
  {
    this->SplitWedges();
  }
  this->Output->SetPolys(ToCells(this->FaceOffsets, this->FaceCorners));
  vtkMTFieldNames::Add(this->Output, "TextureFiles", this->Header.TextureFiles);
  const vtkIdType faces = this->Output->GetNumberOfPolys();
  if (this->StripOffsets.size() > 1)
  {
    this->Output->SetStrips(ToCells(this->StripOffsets, this->StripCorners));
    vtkCellData* attributes = this->Output->GetCellData();
    for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = attributes->GetArray(i);
      const vtkIdType first = faces * array->GetNumberOfComponents();
      array->Resize(faces + this->Output->GetNumberOfStrips());
      array->SetNumberOfTuples(faces + this->Output->GetNumberOfStrips());
      unsigned char* values = static_cast<unsigned char*>(array->GetVoidPointer(0));
      std::memset(values + first * array->GetDataTypeSize(), 0,
        static_cast<std::size_t>((array->GetNumberOfValues() - first) * array->GetDataTypeSize()));
    }
  }
}

bool Reader::Read(std::string& error)
{
  if (!this->Header.Parse(this->Stream, error) || !this->CheckHeader(error))
  {
    return false;
  }
  this->VertexCount = this->Header.Find("vertex")->Count;
  for (const vtkMTPlyElement& element : this->Header.Elements)
  {
    if (!this->ReadElement(element))
    {
      error = this->Rows.GetError();
      return false;
    }
  }
  if (!this->CheckIsAtEnd(error))
  {
    return false;
  }
  this->Finish();
  return true;
}
}

bool vtkMTPlyReader::Read(const std::string& path, vtkPolyData* output, std::string& error)
{
  return vtkMTReadWhole::ReadFile<vtkMTPlyReader>(path, output, error);
}

bool vtkMTPlyReader::Read(const vtkMTByteSource& bytes, vtkPolyData* output, std::string& error)
{
  return vtkMTReadWhole::Read(
    bytes, output, error, [&](std::string& reason) { return Reader(bytes, output).Read(reason); });
}
