// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTMeshWriter.h"

#include "vtkMTErrorCollector.h"
#include "vtkMTGltfWriter.h"
#include "vtkMTLookupTable.h"
#include "vtkMTOutputFile.h"
#include "vtkMTPlyWriter.h"
#include "vtkMTPolyDataStream.h"
#include "vtkMTSinglePrecision.h"
#include "vtkMTStreamWalk.h"
#include "vtkMTTextFormat.h"

#include "vtkCellData.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkXMLPolyDataWriter.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <exception>
#include <iterator>
#include <limits>

namespace
{
bool Put(vtkMTOutputFile& file, const std::string& text, std::string& error)
{
  error = file.Write(text.data(), text.size()) ? error : file.GetError();
  return file.IsOpen();
}

template <typename Number>
void AppendShortest(std::string& text, Number value)
{
  char digits[64];
  const std::to_chars_result result = std::to_chars(digits, digits + sizeof(digits), value);
  text.append(digits, result.ptr);
}

// With all the digits that a double has: fewer could be taken for single precision by whoever reads them.
void AppendDouble(std::string& text, double value)
{
  char digits[64];
  const std::to_chars_result result =
    std::to_chars(digits, digits + sizeof(digits), value, std::chars_format::general, 17);
  text.append(digits, result.ptr);
}

// Whether any position needs double precision; settles Precision::Automatic.
bool FindPrecision(vtkMTTriangleStream& mesh, vtkMTMeshWriter::Precision precision, bool& isDouble, std::string& error)
{
  isDouble = precision == vtkMTMeshWriter::Precision::Double;
  if (precision != vtkMTMeshWriter::Precision::Automatic)
  {
    return true;
  }
  return vtkMTStreamWalk::Rewind(mesh, error) &&
    vtkMTStreamWalk::ForEachPointBlock(mesh, error,
      [&isDouble](const vtkMTTriangleStream::PointBlock& block)
      {
        for (const auto& p : block.Points)
        {
          isDouble = isDouble ||
            !(vtkMTSinglePrecision::Holds(p[0]) && vtkMTSinglePrecision::Holds(p[1]) &&
              vtkMTSinglePrecision::Holds(p[2]));
        }
        return true;
      });
}

//------------------------------------------------------------------------------
// Opens, lets body write, and publishes.
template <typename Body>
bool Publish(const std::string& path, std::string& error, Body&& body)
{
  vtkMTOutputFile file;
  if (!file.Open(path))
  {
    error = file.GetError();
    return false;
  }
  std::string reason;
  try
  {
    if (!body(file, reason))
    {
      // The file's own messages name it already.
      error = reason == file.GetError() ? reason : path + ": " + reason;
      return false;
    }
  }
  catch (const std::exception& exception)
  {
    error = path + ": " + exception.what();
    return false;
  }
  if (!file.Commit())
  {
    error = file.GetError();
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
struct ObjColumns
{
  int Normals = -1; // index among the point columns
  int TCoords = -1;
  bool NormalsAreDouble = false;
  bool TCoordsAreDouble = false;

  explicit ObjColumns(const std::vector<vtkMTArrayInfo>& arrays)
  {
    int column = 0;
    for (const vtkMTArrayInfo& array : arrays)
    {
      if (array.Association != vtkMTArrayInfo::Point)
      {
        continue;
      }
      const bool isReal = array.Type == VTK_FLOAT || array.Type == VTK_DOUBLE;
      if (isReal && array.Components == 3 && this->Normals < 0 &&
        (array.Attribute == vtkDataSetAttributes::NORMALS || array.Name == "Normals"))
      {
        this->Normals = column;
        this->NormalsAreDouble = array.Type == VTK_DOUBLE;
      }
      if (isReal && array.Components == 2 && this->TCoords < 0 &&
        (array.Attribute == vtkDataSetAttributes::TCOORDS || array.Name == "TCoords"))
      {
        this->TCoords = column;
        this->TCoordsAreDouble = array.Type == VTK_DOUBLE;
      }
      ++column;
    }
  }
};

void AppendTuple(std::string& text, const vtkMTColumn& column, bool isDouble, std::size_t row, std::size_t components)
{
  for (std::size_t i = row * components; i < (row + 1) * components; ++i)
  {
    float single;
    double value;
    if (isDouble)
    {
      std::memcpy(&value, column.data() + i * sizeof(value), sizeof(value));
    }
    else
    {
      std::memcpy(&single, column.data() + i * sizeof(single), sizeof(single));
      value = single;
    }
    text += ' ';
    AppendShortest(text, static_cast<float>(value));
  }
  text += '\n';
}

void AppendObjPoints(
  std::string& text, const vtkMTTriangleStream::PointBlock& block, const ObjColumns& columns, bool isDouble)
{
  for (std::size_t row = 0; row < block.Points.size(); ++row)
  {
    text += 'v';
    for (const double x : block.Points[row])
    {
      text += ' ';
      isDouble ? AppendDouble(text, x) : AppendShortest(text, static_cast<float>(x));
    }
    text += '\n';
    if (columns.TCoords >= 0)
    {
      text += "vt";
      AppendTuple(text, block.Columns[static_cast<std::size_t>(columns.TCoords)], columns.TCoordsAreDouble, row, 2);
    }
    if (columns.Normals >= 0)
    {
      text += "vn";
      AppendTuple(text, block.Columns[static_cast<std::size_t>(columns.Normals)], columns.NormalsAreDouble, row, 3);
    }
  }
}

void AppendObjCorner(std::string& text, std::uint64_t point, const ObjColumns& columns)
{
  const std::string index = std::to_string(point + 1);
  text += ' ' + index;
  if (columns.TCoords >= 0 || columns.Normals >= 0)
  {
    text += '/' + (columns.TCoords >= 0 ? index : std::string());
  }
  if (columns.Normals >= 0)
  {
    text += '/' + index;
  }
}

//------------------------------------------------------------------------------
// Normal and corners, 12 floats, and two bytes of nothing.
void AppendStlTriangle(std::vector<unsigned char>& bytes, const std::array<std::array<double, 3>, 3>& p)
{
  const auto side = [&p](int to, int axis) { return p[to][axis] - p[0][axis]; };
  double normal[3];
  for (int i = 0; i < 3; ++i)
  {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    normal[i] = side(1, j) * side(2, k) - side(1, k) * side(2, j);
  }
  const double length = std::hypot(normal[0], normal[1], normal[2]);
  float record[12];
  for (int i = 0; i < 3; ++i)
  {
    record[i] = length > 0.0 ? static_cast<float>(normal[i] / length) : 0.0f;
    for (int corner = 0; corner < 3; ++corner)
    {
      record[3 + 3 * corner + i] = static_cast<float>(p[corner][i]);
    }
  }
  const unsigned char* from = reinterpret_cast<const unsigned char*>(record);
  bytes.insert(bytes.end(), from, from + sizeof(record));
  bytes.insert(bytes.end(), 2, 0);
}

bool WriteStlTriangles(vtkMTTriangleStream& mesh, const std::vector<std::array<double, 3>>& points,
  vtkMTOutputFile& file, std::string& error)
{
  std::vector<unsigned char> bytes;
  return vtkMTStreamWalk::ForEachTriangleBlock(mesh, error,
    [&](const vtkMTTriangleStream::TriangleBlock& block)
    {
      bytes.clear();
      for (const auto& triangle : block.Triangles)
      {
        if (triangle[0] >= points.size() || triangle[1] >= points.size() || triangle[2] >= points.size())
        {
          error = "a triangle has a corner that does not exist";
          return false;
        }
        AppendStlTriangle(bytes, { points[triangle[0]], points[triangle[1]], points[triangle[2]] });
      }
      error = file.Write(bytes.data(), bytes.size()) ? error : file.GetError();
      return file.IsOpen();
    });
}

bool PutStl(vtkMTTriangleStream& mesh, vtkMTOutputFile& file, std::string& error)
{
  if (mesh.GetNumberOfTriangles() > std::numeric_limits<std::uint32_t>::max())
  {
    error = "STL cannot hold more than 2^32 - 1 triangles";
    return false;
  }
  char head[84] = "Binary STL";
  const std::uint32_t count = static_cast<std::uint32_t>(mesh.GetNumberOfTriangles());
  std::memcpy(head + 80, &count, sizeof(count));
  std::vector<std::array<double, 3>> points;
  const auto keep = [&points](const vtkMTTriangleStream::PointBlock& block)
  {
    points.insert(points.end(), block.Points.begin(), block.Points.end());
    return true;
  };
  return vtkMTStreamWalk::Rewind(mesh, error) && vtkMTStreamWalk::ForEachPointBlock(mesh, error, keep) &&
    Put(file, std::string(head, sizeof(head)), error) && WriteStlTriangles(mesh, points, file, error);
}

//------------------------------------------------------------------------------
bool PutObj(vtkMTTriangleStream& mesh, vtkMTOutputFile& file, std::string& error)
{
  const ObjColumns columns(mesh.GetArrays());
  bool isDouble = false;
  std::string text;
  const auto putPoints = [&](const vtkMTTriangleStream::PointBlock& block)
  {
    text.clear();
    AppendObjPoints(text, block, columns, isDouble);
    return Put(file, text, error);
  };
  const auto putTriangles = [&](const vtkMTTriangleStream::TriangleBlock& block)
  {
    text.clear();
    for (const auto& triangle : block.Triangles)
    {
      text += 'f';
      for (const std::uint64_t point : triangle)
      {
        AppendObjCorner(text, point, columns);
      }
      text += '\n';
    }
    return Put(file, text, error);
  };
  return FindPrecision(mesh, vtkMTMeshWriter::Precision::Automatic, isDouble, error) &&
    vtkMTStreamWalk::Rewind(mesh, error) && vtkMTStreamWalk::ForEachPointBlock(mesh, error, putPoints) &&
    vtkMTStreamWalk::ForEachTriangleBlock(mesh, error, putTriangles);
}

// The arrays that the format has no form for.
std::vector<std::string> FindDropped(const std::vector<vtkMTArrayInfo>& arrays, const std::string& ending)
{
  std::vector<std::string> dropped;
  const ObjColumns kept(arrays);
  int column = 0;
  for (const vtkMTArrayInfo& array : arrays)
  {
    const bool isPoint = array.Association == vtkMTArrayInfo::Point;
    const bool isInObj = isPoint && (column == kept.Normals || column == kept.TCoords);
    if (ending == "stl" || (ending == "obj" && !isInObj))
    {
      dropped.push_back((isPoint ? "point " : "cell ") + array.Name);
    }
    column += isPoint ? 1 : 0;
  }
  return dropped;
}

//------------------------------------------------------------------------------
// VTK's file has no place for the tables of arrays: what their ids are the names of goes into the field data, an array
// NAME_names of pairs for each.
void AddNames(vtkDataSetAttributes* arrays, vtkFieldData* to)
{
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* const array = arrays->GetArray(i);
    const auto names = vtkMTLookupTable::GetNames(array ? array->GetLookupTable() : nullptr);
    if (names.empty())
    {
      continue;
    }
    vtkNew<vtkStringArray> pairs;
    pairs->SetName((std::string(array->GetName()) + "_names").c_str());
    pairs->SetNumberOfComponents(2);
    for (const auto& [value, name] : names)
    {
      pairs->InsertNextValue(value);
      pairs->InsertNextValue(name);
    }
    to->AddArray(pairs);
  }
}

bool WriteVtp(const std::string& path, vtkPolyData* mesh, std::string& error)
{
  return Publish(path, error,
    [mesh](vtkMTOutputFile& file, std::string& reason)
    {
      vtkNew<vtkPolyData> copy;
      copy->ShallowCopy(mesh);
      AddNames(mesh->GetPointData(), copy->GetFieldData());
      AddNames(mesh->GetCellData(), copy->GetFieldData());
      vtkNew<vtkXMLPolyDataWriter> writer;
      vtkMTErrorCollector errors;
      errors.Observe(writer);
      writer->SetInputData(copy);
      writer->SetFileName(file.GetTemporaryName().c_str());
      writer->SetDataModeToAppended();
      writer->EncodeAppendedDataOff();
      writer->SetHeaderTypeToUInt64();
      const bool done = writer->Write() != 0 && writer->GetErrorCode() == vtkErrorCode::NoError && !errors.HasErrors();
      reason = done          ? ""
        : errors.HasErrors() ? errors.GetMessage()
                             : vtkErrorCode::GetStringFromErrorCode(writer->GetErrorCode());
      return done;
    });
}
}

bool vtkMTMeshWriter::CanWrite(const std::string& path)
{
  const std::string ending = vtkMTTextFormat::GetLowerCaseEnding(path);
  static const char* const known[] = { "ply", "stl", "obj", "vtp", "gltf", "glb" };
  return std::find(std::begin(known), std::end(known), ending) != std::end(known);
}

bool vtkMTMeshWriter::Write(
  const std::string& path, vtkPolyData* mesh, std::string& error, std::vector<std::string>* dropped)
{
  if (dropped)
  {
    dropped->clear();
  }
  const std::string ending = vtkMTTextFormat::GetLowerCaseEnding(path);
  if (ending == "vtp")
  {
    return WriteVtp(path, mesh, error);
  }
  if (!CanWrite(path))
  {
    error = path + ": the name must end in .ply, .stl, .obj, .vtp, .gltf or .glb";
    return false;
  }
  vtkMTPolyDataStream stream(mesh);
  if (ending == "gltf" || ending == "glb")
  {
    return WriteGltf(stream, path, ending == "glb", error, dropped);
  }
  if (dropped)
  {
    *dropped = FindDropped(stream.GetArrays(), ending);
  }
  return ending == "ply" ? WritePly(stream, path, error)
    : ending == "stl"    ? WriteStl(stream, path, error)
                         : WriteObj(stream, path, error);
}

bool vtkMTMeshWriter::WritePly(
  vtkMTTriangleStream& mesh, const std::string& path, std::string& error, Precision precision, const Progress& progress)
{
  return Publish(path, error,
    [&](vtkMTOutputFile& file, std::string& reason)
    {
      bool isDouble = false;
      return FindPrecision(mesh, precision, isDouble, reason) &&
        vtkMTPlyWriter(mesh, isDouble, progress).Write(file, reason);
    });
}

bool vtkMTMeshWriter::WriteStl(vtkMTTriangleStream& mesh, const std::string& path, std::string& error)
{
  return Publish(
    path, error, [&mesh](vtkMTOutputFile& file, std::string& reason) { return PutStl(mesh, file, reason); });
}

bool vtkMTMeshWriter::WriteObj(vtkMTTriangleStream& mesh, const std::string& path, std::string& error)
{
  return Publish(
    path, error, [&mesh](vtkMTOutputFile& file, std::string& reason) { return PutObj(mesh, file, reason); });
}

bool vtkMTMeshWriter::WriteGltf(vtkMTTriangleStream& mesh, const std::string& path, bool binary, std::string& error,
  std::vector<std::string>* dropped)
{
  vtkMTGltfWriter writer(mesh, binary);
  if (dropped)
  {
    *dropped = writer.GetDropped();
  }
  return Publish(
    path, error, [&writer](vtkMTOutputFile& file, std::string& reason) { return writer.Write(file, reason); });
}
