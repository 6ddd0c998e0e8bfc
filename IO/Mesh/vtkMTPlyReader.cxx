// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPlyReader.h"

#include "vtkMTFieldNames.h"
#include "vtkMTPlyColors.h"
#include "vtkMTPlyFaces.h"
#include "vtkMTPlyRows.h"
#include "vtkMTPlyVertices.h"
#include "vtkMTReadWhole.h"
#include "vtkMTWedgeSplitter.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cstring>
#include <memory>
#include <vector>

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
  /// By reason, what was not read as it is in the file.
  vtkMTInputReport GetReport() const;

private:
  bool ReadElement(const vtkMTPlyElement& element);
  bool ReadVertices(const vtkMTPlyElement& element);
  bool ReadFaces(const vtkMTPlyElement& element);
  bool ReadStrips(const vtkMTPlyElement& element);
  void AddStrip(std::vector<vtkIdType>& corners);
  bool SkipRows(const vtkMTPlyElement& element);
  void SplitWedges();
  void AddStrips();
  void Finish();

  // Offsets: where each cell ends.
  template <class Offset, class Corner>
  static vtkSmartPointer<vtkCellArray> ToCells(const std::vector<Offset>& ends, const std::vector<Corner>& corners);

  vtkMTTextFormat::Stream Stream;
  vtkMTPlyHeader Header;
  vtkMTPlyRows Rows;
  vtkPolyData* Output;
  std::uint64_t VertexCount = 0;

  vtkMTCellCorners Faces;
  std::unique_ptr<vtkMTPlyFaces> FaceRows; // where there are any
  std::vector<std::size_t> StripEnds;
  std::vector<vtkIdType> StripCorners;
  vtkMTInputReport Report; // of colours
};

vtkMTInputReport Reader::GetReport() const
{
  vtkMTInputReport report = this->Report;
  vtkMTInputReports::Add(this->Header.GetReport(), report);
  vtkMTInputReports::Add(this->Rows.GetReport(), report);
  return report;
}

bool Reader::SkipRows(const vtkMTPlyElement& element)
{
  for (std::uint64_t row = 0; row < element.Count && !element.Properties.empty(); ++row)
  {
    bool isGood = true;
    const auto skip = [this](const vtkMTPlyProperty& property) { return this->Rows.SkipProperty(property); };
    if (!this->Rows.BeginRow() ||
      !this->Rows.EndRow(std::all_of(element.Properties.begin(), element.Properties.end(), skip), isGood))
    {
      return false;
    }
  }
  return true;
}

bool Reader::ReadVertices(const vtkMTPlyElement& element)
{
  vtkMTPlyColors colors(element);
  if (!vtkMTPlyVertices(element, colors, element.Count, this->Output).Read(this->Rows))
  {
    return false;
  }
  colors.Look(this->Output->GetPointData());
  colors.Convert(this->Output->GetPointData());
  colors.Count(element.Count, this->Report);
  return true;
}

bool Reader::ReadFaces(const vtkMTPlyElement& element)
{
  vtkMTPlyColors colors(element);
  vtkCellData* attributes = this->Output->GetCellData();
  this->FaceRows = std::make_unique<vtkMTPlyFaces>(element, colors, element.Count, this->VertexCount, attributes);
  if (!this->FaceRows->Read(this->Rows, this->Faces))
  {
    return false;
  }
  colors.Look(attributes);
  colors.Convert(attributes);
  colors.Count(element.Count, this->Report);
  return true;
}

bool Reader::ReadStrips(const vtkMTPlyElement& element)
{
  const vtkMTPlyProperty* indices = element.FindCorners();
  std::vector<vtkIdType> corners;
  for (std::uint64_t row = 0; row < element.Count; ++row)
  {
    corners.clear();
    bool isGood = true;
    const auto read = [&](const vtkMTPlyProperty& property)
    {
      return &property == indices ? this->Rows.ReadCorners(property, this->VertexCount, corners)
                                  : this->Rows.SkipProperty(property);
    };
    if (!this->Rows.BeginRow() ||
      !this->Rows.EndRow(std::all_of(element.Properties.begin(), element.Properties.end(), read), isGood))
    {
      return false;
    }
    if (isGood)
    {
      this->AddStrip(corners);
    }
  }
  return true;
}

// Where there is a -1 the next one begins.
void Reader::AddStrip(std::vector<vtkIdType>& corners)
{
  corners.push_back(-1);
  for (std::size_t begin = 0, i = 0; i < corners.size(); ++i)
  {
    if (corners[i] < 0)
    {
      if (i - begin >= 3) // a shorter one has no triangle
      {
        this->StripCorners.insert(this->StripCorners.end(), corners.begin() + static_cast<std::ptrdiff_t>(begin),
          corners.begin() + static_cast<std::ptrdiff_t>(i));
        this->StripEnds.push_back(this->StripCorners.size());
      }
      begin = i + 1;
    }
  }
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

template <class Offset, class Corner>
vtkSmartPointer<vtkCellArray> Reader::ToCells(const std::vector<Offset>& ends, const std::vector<Corner>& corners)
{
  const vtkNew<vtkIdTypeArray> offsets;
  offsets->SetNumberOfValues(static_cast<vtkIdType>(ends.size() + 1));
  offsets->SetValue(0, 0);
  std::copy(ends.begin(), ends.end(), offsets->GetPointer(1));
  const vtkNew<vtkIdTypeArray> points;
  points->SetNumberOfValues(static_cast<vtkIdType>(corners.size()));
  std::copy(corners.begin(), corners.end(), points->GetPointer(0));
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, points);
  return cells;
}

// The texture coordinates of corners become those of points.
void Reader::SplitWedges()
{
  const std::vector<double>& coordinates = this->FaceRows->GetTextureCoordinates();
  std::vector<vtkIdType> corners(this->Faces.Points.begin(), this->Faces.Points.end());
  std::vector<vtkMTWedgeSplitter::Key> keys(corners.size());
  if (!keys.empty())
  {
    std::memcpy(keys.data(), coordinates.data(), keys.size() * sizeof(keys[0]));
  }
  const vtkMTWedgeSplitter::Result wedges =
    vtkMTWedgeSplitter::Split(static_cast<std::size_t>(this->Output->GetNumberOfPoints()), corners, keys);
  this->Faces.Points.assign(corners.begin(), corners.end());
  vtkMTWedgeSplitter::AppendCopies(this->Output, wedges.Originals);
  vtkPointData* attributes = this->Output->GetPointData();
  if (vtkDataArray* earlier = attributes->GetArray("TCoords"))
  {
    earlier->SetName("VertexTCoords");
  }
  const int type = this->FaceRows->GetTexture()->Type == VTK_FLOAT ? VTK_FLOAT : VTK_DOUBLE;
  auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  array->SetName("TCoords");
  array->SetNumberOfComponents(2);
  array->SetNumberOfTuples(static_cast<vtkIdType>(wedges.Corners.size()));
  for (std::size_t i = 0; i < wedges.Corners.size(); ++i)
  {
    const double none[2] = { 0.0, 0.0 };
    const std::size_t corner = wedges.Corners[i];
    array->SetTuple(
      static_cast<vtkIdType>(i), corner == vtkMTWedgeSplitter::NoCorner ? none : coordinates.data() + 2 * corner);
  }
  attributes->SetTCoords(array);
}

// Behind the faces; the values of their cells are 0.
void Reader::AddStrips()
{
  const vtkIdType faces = this->Output->GetNumberOfPolys();
  this->Output->SetStrips(ToCells(this->StripEnds, this->StripCorners));
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

void Reader::Finish()
{
  if (this->FaceRows && this->FaceRows->GetTexture())
  {
    this->SplitWedges();
  }
  this->Output->SetPolys(ToCells(this->Faces.Ends, this->Faces.Points));
  vtkMTFieldNames::Add(this->Output, "TextureFiles", this->Header.TextureFiles);
  if (!this->StripEnds.empty())
  {
    this->AddStrips();
  }
}

bool Reader::Read(std::string& error)
{
  if (!this->Header.Parse(this->Stream, error) || !this->Header.CheckIsMesh(error))
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
  if (!this->Rows.CheckIsAtEnd(error))
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

bool vtkMTPlyReader::Read(
  const vtkMTByteSource& bytes, vtkPolyData* output, std::string& error, vtkMTInputReport* report)
{
  const auto read = [&](std::string& reason)
  {
    Reader reader(bytes, output);
    const bool isRead = reader.Read(reason);
    if (report)
    {
      vtkMTInputReports::Add(reader.GetReport(), *report);
    }
    return isRead;
  };
  return vtkMTReadWhole::Read(bytes, output, error, read);
}
