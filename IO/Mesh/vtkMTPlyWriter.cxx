// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPlyWriter.h"

#include "vtkMTOutputFile.h"
#include "vtkMTPlyHeader.h"
#include "vtkMTStreamWalk.h"

#include "vtkDataSetAttributes.h"
#include "vtkType.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace
{
bool IsSignedInteger(int type)
{
  return type == VTK_LONG || type == VTK_LONG_LONG || type == VTK_ID_TYPE;
}

bool IsColor(const vtkMTArrayInfo& array)
{
  return array.Type == VTK_UNSIGNED_CHAR && (array.Components == 3 || array.Components == 4);
}

bool IsNormals(const vtkMTArrayInfo& array)
{
  return (array.Type == VTK_FLOAT || array.Type == VTK_DOUBLE) && array.Components == 3 &&
    (array.Attribute == vtkDataSetAttributes::NORMALS || array.Name == "Normals");
}

bool IsTextureCoordinates(const vtkMTArrayInfo& array)
{
  return (array.Type == VTK_FLOAT || array.Type == VTK_DOUBLE) && array.Components == 2 &&
    (array.Attribute == vtkDataSetAttributes::TCOORDS || array.Name == "TCoords");
}

// The conventional names of the array's components, or none.
std::vector<std::string> ConventionalNames(const vtkMTArrayInfo& array)
{
  if (IsColor(array))
  {
    return { "red", "green", "blue", "alpha" };
  }
  if (array.Association == vtkMTArrayInfo::Point && IsNormals(array))
  {
    return { "nx", "ny", "nz" };
  }
  if (array.Association == vtkMTArrayInfo::Point && IsTextureCoordinates(array))
  {
    return { "s", "t" };
  }
  return {};
}

// Names in a PLY header end at white space.
std::string MakeName(const vtkMTArrayInfo& array, int component)
{
  std::string name = array.Name;
  if (array.Components > 1)
  {
    const std::size_t c = static_cast<std::size_t>(component);
    name += "_" +
      (c < array.ComponentNames.size() && !array.ComponentNames[c].empty() ? array.ComponentNames[c]
                                                                           : std::to_string(component));
  }
  for (char& c : name)
  {
    c = static_cast<unsigned char>(c) <= ' ' ? '_' : c;
  }
  return name.empty() ? "array" : name;
}

bool IsReserved(const std::string& name)
{
  static const char* const reserved[] = { "x", "y", "z", "nx", "ny", "nz", "red", "green", "blue", "alpha", "s", "t",
    "u", "v", "vertex_indices", "vertex_index" };
  return std::find(std::begin(reserved), std::end(reserved), name) != std::end(reserved);
}

std::int64_t Load64(const vtkMTColumn& column, std::size_t offset)
{
  std::int64_t value;
  std::memcpy(&value, column.data() + offset, sizeof(value));
  return value;
}

template <typename Number>
void Store(std::vector<unsigned char>& bytes, std::size_t offset, Number value)
{
  std::memcpy(bytes.data() + offset, &value, sizeof(value));
}
}

vtkMTPlyWriter::vtkMTPlyWriter(vtkMTTriangleStream& mesh, bool isDouble, const vtkMTMeshWriter::Progress& progress)
  : Mesh(mesh)
  , Progress(progress)
  , IsDouble(isDouble)
{
  std::size_t columns[2] = { 0, 0 };
  for (const vtkMTArrayInfo& array : mesh.GetArrays())
  {
    this->AddProperties(array, columns[array.Association]++,
      array.Association == vtkMTArrayInfo::Point ? this->PointProperties : this->CellProperties);
  }
}

vtkMTPlyWriter::~vtkMTPlyWriter() = default;

void vtkMTPlyWriter::AddProperties(const vtkMTArrayInfo& array, std::size_t column, std::vector<Property>& properties)
{
  const auto isTaken = [&properties](const std::string& name)
  {
    return std::any_of(
      properties.begin(), properties.end(), [&name](const Property& property) { return property.Name == name; });
  };
  std::vector<std::string> names = ConventionalNames(array);
  if (!names.empty() && isTaken(names[0]))
  {
    names.clear();
  }
  const std::size_t size = array.GetTupleSize() / static_cast<std::size_t>(array.Components);
  for (int component = 0; component < array.Components; ++component)
  {
    const std::size_t c = static_cast<std::size_t>(component);
    Property property;
    property.Name = c < names.size() ? names[c] : MakeName(array, component);
    while (names.empty() && (IsReserved(property.Name) || isTaken(property.Name)))
    {
      property.Name += "_";
    }
    property.Type = vtkMTPlyHeader::GetTypeName(array.Type);
    property.Is64 = property.Type.empty() && size == 8;
    property.IsSigned = IsSignedInteger(array.Type);
    if (property.Type.empty() && size == 4)
    {
      property.Type = property.IsSigned ? "int" : "uint";
    }
    property.Column = column;
    property.TupleSize = array.GetTupleSize();
    property.Offset = c * size;
    property.Size = size;
    property.PlySize = size;
    properties.push_back(std::move(property));
  }
}

void vtkMTPlyWriter::SurveyColumns(
  const std::vector<vtkMTColumn>& columns, std::size_t rows, std::vector<Property>& properties)
{
  constexpr std::int64_t exact = std::int64_t(1) << 53;
  for (Property& property : properties)
  {
    for (std::size_t row = 0; property.Is64 && row < rows; ++row)
    {
      const std::int64_t value = Load64(columns[property.Column], row * property.TupleSize + property.Offset);
      const bool tooLarge = !property.IsSigned && value < 0; // an unsigned one beyond 2^63
      property.FitsInt = property.FitsInt && !tooLarge && value >= VTK_INT_MIN && value <= VTK_INT_MAX;
      property.FitsUInt = property.FitsUInt && value >= 0 && value <= std::int64_t(0xffffffff);
      property.FitsDouble = property.FitsDouble && !tooLarge && value >= -exact && value <= exact;
    }
  }
}

bool vtkMTPlyWriter::ChooseTypes(std::vector<Property>& properties, std::string& error)
{
  for (Property& property : properties)
  {
    if (!property.Is64)
    {
      continue;
    }
    property.Type = property.FitsInt ? "int" : property.FitsUInt ? "uint" : "double";
    property.PlySize = property.Type == "double" ? 8 : 4;
    if (!property.FitsInt && !property.FitsUInt && !property.FitsDouble)
    {
      error = "array \"" + property.Name + "\" has integers that no type of PLY can hold";
      return false;
    }
  }
  return true;
}

bool vtkMTPlyWriter::Survey(std::string& error)
{
  const auto has64 = [](const std::vector<Property>& properties)
  { return std::any_of(properties.begin(), properties.end(), [](const Property& property) { return property.Is64; }); };
  const bool ofPoints = has64(this->PointProperties);
  const bool ofCells = has64(this->CellProperties);
  if ((ofPoints || ofCells) && !vtkMTStreamWalk::Rewind(this->Mesh, error))
  {
    return false;
  }
  const auto surveyPoints = [this](const vtkMTTriangleStream::PointBlock& block)
  {
    this->SurveyColumns(block.Columns, block.Points.size(), this->PointProperties);
    return true;
  };
  const auto surveyCells = [this](const vtkMTTriangleStream::TriangleBlock& block)
  {
    this->SurveyColumns(block.Columns, block.Triangles.size(), this->CellProperties);
    return true;
  };
  return (!ofPoints || vtkMTStreamWalk::ForEachPointBlock(this->Mesh, error, surveyPoints)) &&
    (!ofCells || vtkMTStreamWalk::ForEachTriangleBlock(this->Mesh, error, surveyCells)) &&
    this->ChooseTypes(this->PointProperties, error) && this->ChooseTypes(this->CellProperties, error);
}

std::string vtkMTPlyWriter::MakeHeader() const
{
  const std::string real = this->IsDouble ? "double" : "float";
  std::string header = "ply\nformat binary_little_endian 1.0\nelement vertex " +
    std::to_string(this->Mesh.GetNumberOfPoints()) + "\nproperty " + real + " x\nproperty " + real + " y\nproperty " +
    real + " z\n";
  for (const Property& property : this->PointProperties)
  {
    header += "property " + property.Type + " " + property.Name + "\n";
  }
  const bool isLarge = this->Mesh.GetNumberOfPoints() > 0x7fffffffu;
  header += "element face " + std::to_string(this->Mesh.GetNumberOfTriangles()) + "\nproperty list uchar " +
    (isLarge ? "uint" : "int") + " vertex_indices\n";
  for (const Property& property : this->CellProperties)
  {
    header += "property " + property.Type + " " + property.Name + "\n";
  }
  return header + "end_header\n";
}

namespace
{
// Copies one property into its place in all rows; Properties is the writer's own type.
template <typename Property>
void PutColumn(std::vector<unsigned char>& bytes, std::size_t rowSize, std::size_t place, std::size_t rows,
  const Property& property, const vtkMTColumn& column)
{
  for (std::size_t row = 0; row < rows; ++row)
  {
    const std::size_t from = row * property.TupleSize + property.Offset;
    const std::size_t to = row * rowSize + place;
    if (!property.Is64)
    {
      std::memcpy(bytes.data() + to, column.data() + from, property.Size);
    }
    else if (property.PlySize == 4)
    {
      Store(bytes, to, static_cast<std::uint32_t>(Load64(column, from))); // the same bits for int
    }
    else
    {
      Store(bytes, to, static_cast<double>(Load64(column, from)));
    }
  }
}

template <typename Property>
std::size_t RowSize(std::size_t fixed, const std::vector<Property>& properties)
{
  for (const Property& property : properties)
  {
    fixed += property.PlySize;
  }
  return fixed;
}

template <typename Property>
bool PutColumns(std::vector<unsigned char>& bytes, std::size_t rowSize, std::size_t place, std::size_t rows,
  const std::vector<Property>& properties, const std::vector<vtkMTColumn>& columns)
{
  for (const Property& property : properties)
  {
    if (property.Column >= columns.size() || columns[property.Column].size() < rows * property.TupleSize)
    {
      return false;
    }
    PutColumn(bytes, rowSize, place, rows, property, columns[property.Column]);
    place += property.PlySize;
  }
  return true;
}
}

void vtkMTPlyWriter::Report(std::uint64_t done)
{
  if (this->Progress)
  {
    const std::uint64_t all = this->Mesh.GetNumberOfPoints() + this->Mesh.GetNumberOfTriangles();
    this->Progress(all == 0 ? 1.0 : static_cast<double>(done) / static_cast<double>(all));
  }
}

bool vtkMTPlyWriter::WritePoints(vtkMTOutputFile& file, std::string& error)
{
  const std::size_t size = this->IsDouble ? 8 : 4;
  const std::size_t rowSize = RowSize(3 * size, this->PointProperties);
  std::uint64_t done = 0;
  std::vector<unsigned char> bytes;
  const auto write = [&](const vtkMTTriangleStream::PointBlock& block)
  {
    const std::size_t rows = block.Points.size();
    bytes.assign(rows * rowSize, 0);
    for (std::size_t row = 0; row < rows; ++row)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const double x = block.Points[row][axis];
        const std::size_t to = row * rowSize + axis * size;
        this->IsDouble ? Store(bytes, to, x) : Store(bytes, to, static_cast<float>(x));
      }
    }
    if (!PutColumns(bytes, rowSize, 3 * size, rows, this->PointProperties, block.Columns))
    {
      error = "the mesh does not give the point arrays that it announces";
      return false;
    }
    done += rows;
    this->Report(done);
    error = file.Write(bytes.data(), bytes.size()) ? error : file.GetError();
    return file.IsOpen();
  };
  if (!vtkMTStreamWalk::ForEachPointBlock(this->Mesh, error, write))
  {
    return false;
  }
  const bool isComplete = done == this->Mesh.GetNumberOfPoints();
  error = isComplete ? error : "the mesh does not give as many points as it announces";
  return isComplete;
}

bool vtkMTPlyWriter::WriteTriangles(vtkMTOutputFile& file, std::string& error)
{
  constexpr std::size_t fixed = 1 + 3 * 4;
  const std::uint64_t points = this->Mesh.GetNumberOfPoints();
  const std::size_t rowSize = RowSize(fixed, this->CellProperties);
  std::uint64_t done = 0;
  std::vector<unsigned char> bytes;
  const auto write = [&](const vtkMTTriangleStream::TriangleBlock& block)
  {
    const std::size_t rows = block.Triangles.size();
    bytes.assign(rows * rowSize, 3);
    for (std::size_t i = 0; i < 3 * rows; ++i)
    {
      const std::uint64_t point = block.Triangles[i / 3][i % 3];
      if (point >= points)
      {
        error = "triangle " + std::to_string(done + i / 3) + " has a corner that does not exist";
        return false;
      }
      Store(bytes, i / 3 * rowSize + 1 + i % 3 * 4, static_cast<std::uint32_t>(point));
    }
    if (!PutColumns(bytes, rowSize, fixed, rows, this->CellProperties, block.Columns))
    {
      error = "the mesh does not give the cell arrays that it announces";
      return false;
    }
    done += rows;
    this->Report(points + done);
    error = file.Write(bytes.data(), bytes.size()) ? error : file.GetError();
    return file.IsOpen();
  };
  if (!vtkMTStreamWalk::ForEachTriangleBlock(this->Mesh, error, write))
  {
    return false;
  }
  const bool isComplete = done == this->Mesh.GetNumberOfTriangles();
  error = isComplete ? error : "the mesh does not give as many triangles as it announces";
  return isComplete;
}

bool vtkMTPlyWriter::Write(vtkMTOutputFile& file, std::string& error)
{
  if (this->Mesh.GetNumberOfPoints() > 0xffffffffu)
  {
    error = "PLY has no indices for more than 2^32 points";
    return false;
  }
  if (!this->Survey(error) || !vtkMTStreamWalk::Rewind(this->Mesh, error))
  {
    return false;
  }
  const std::string header = this->MakeHeader();
  if (!file.Write(header.data(), header.size()))
  {
    error = file.GetError();
    return false;
  }
  return this->WritePoints(file, error) && this->WriteTriangles(file, error);
}
