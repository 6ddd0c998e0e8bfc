// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTMeshReader.h"

#include "vtkMTErrorCollector.h"
#include "vtkMTFileByteSource.h"
#include "vtkMTGltfReader.h"
#include "vtkMTLegacyCheck.h"
#include "vtkMTObjReader.h"
#include "vtkMTPlyReader.h"
#include "vtkMTStlReader.h"
#include "vtkMTTextFormat.h"

#include "vtkCellArray.h"
#include "vtkErrorCode.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataReader.h"
#include "vtkXMLPolyDataReader.h"

#include <algorithm>
#include <cstring>
#include <exception>

namespace
{
enum class Format
{
  Unknown,
  Ply,
  Stl,
  Obj,
  Vtp,
  Legacy,
  Gltf
};

//------------------------------------------------------------------------------
// Which format
bool BeginsWith(std::string_view text, std::string_view begin)
{
  return text.substr(0, begin.size()) == begin;
}

Format FromContent(std::string_view begin)
{
  if (BeginsWith(begin, "ply\n") || BeginsWith(begin, "ply\r") || BeginsWith(begin, "ply "))
  {
    return Format::Ply;
  }
  if (BeginsWith(begin, "glTF"))
  {
    return Format::Gltf;
  }
  if (BeginsWith(begin, "# vtk DataFile"))
  {
    return Format::Legacy;
  }
  return begin.find("<VTKFile") != std::string_view::npos ? Format::Vtp : Format::Unknown;
}

Format FromEnding(const std::string& ending)
{
  static const std::pair<const char*, Format> formats[] = { { "ply", Format::Ply }, { "stl", Format::Stl },
    { "obj", Format::Obj }, { "vtp", Format::Vtp }, { "vtk", Format::Legacy }, { "gltf", Format::Gltf },
    { "glb", Format::Gltf } };
  for (const auto& format : formats)
  {
    if (ending == format.first)
    {
      return format.second;
    }
  }
  return Format::Unknown;
}

//------------------------------------------------------------------------------
// VTK's readers
template <typename Reader>
bool Update(Reader* reader, const std::string& path, vtkMTErrorCollector& errors, std::string& error)
{
  errors.Observe(static_cast<vtkAlgorithm*>(reader));
  reader->SetFileName(path.c_str());
  reader->Update();
  if (errors.HasErrors() || reader->GetErrorCode() != vtkErrorCode::NoError)
  {
    error = errors.HasErrors() ? errors.GetMessage() : vtkErrorCode::GetStringFromErrorCode(reader->GetErrorCode());
    return false;
  }
  return true;
}

bool ReadVtp(const std::string& path, std::string_view begin, vtkPolyData* output, std::string& error)
{
  if (begin.find("PolyData") == std::string_view::npos)
  {
    error = "holds no polydata; of VTK's XML formats, .vtp is read";
    return false;
  }
  vtkMTErrorCollector errors;
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetReaderErrorObserver(errors.GetCommand());
  reader->SetParserErrorObserver(errors.GetCommand());
  if (!Update(reader.Get(), path, errors, error))
  {
    return false;
  }
  output->ShallowCopy(reader->GetOutput());
  return true;
}

bool ReadLegacy(const vtkMTByteSource& bytes, vtkPolyData* output, std::string& error)
{
  const std::string path = bytes.GetName();
  vtkMTErrorCollector errors;
  errors.ObserveOutputWindow(true); // a file that ends in its arrays is only warned of
  vtkNew<vtkPolyDataReader> reader;
  reader->ReadAllScalarsOn();
  reader->ReadAllVectorsOn();
  reader->ReadAllNormalsOn();
  reader->ReadAllTensorsOn();
  reader->ReadAllColorScalarsOn();
  reader->ReadAllTCoordsOn();
  reader->ReadAllFieldsOn();
  errors.Observe(static_cast<vtkAlgorithm*>(reader.Get()));
  reader->SetFileName(path.c_str());
  if (!reader->IsFilePolyData())
  {
    error = errors.HasErrors() ? errors.GetMessage() : "holds no polydata; of VTK's legacy formats, that one is read";
    return false;
  }
  if (!vtkMTLegacyCheck::Check(bytes, error) || !Update(reader.Get(), path, errors, error))
  {
    return false;
  }
  output->ShallowCopy(reader->GetOutput());
  return true;
}

//------------------------------------------------------------------------------
// VTK's readers do not check indices.
bool CheckCells(vtkCellArray* cells, vtkIdType points, std::string& error)
{
  vtkIdType count = 0;
  const vtkIdType* corners = nullptr;
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    cells->GetCellAtId(i, count, corners);
    if (std::any_of(corners, corners + count, [points](vtkIdType point) { return point < 0 || point >= points; }))
    {
      error = "cell " + std::to_string(i) + " has a point that does not exist";
      return false;
    }
  }
  return true;
}

// Nor do they check offsets, which must be sound before cells can be looked at.
bool CheckOffsets(vtkCellArray* cells, std::string& error)
{
  vtkDataArray* offsets = cells->GetOffsetsArray();
  const vtkIdType size = cells->GetNumberOfConnectivityIds();
  vtkIdType last = 0;
  for (vtkIdType i = 0; i < offsets->GetNumberOfTuples(); ++i)
  {
    const vtkIdType offset =
      cells->IsStorage64Bit() ? cells->GetOffsetsArray64()->GetValue(i) : cells->GetOffsetsArray32()->GetValue(i);
    if (offset < last || offset > size || (i == 0 && offset != 0))
    {
      error = "its cells are impossible";
      return false;
    }
    last = offset;
  }
  return true;
}

bool CheckMesh(vtkPolyData* mesh, std::string& error)
{
  const vtkIdType points = mesh->GetNumberOfPoints();
  for (vtkCellArray* cells : { mesh->GetVerts(), mesh->GetLines(), mesh->GetPolys(), mesh->GetStrips() })
  {
    if (cells && !(CheckOffsets(cells, error) && CheckCells(cells, points, error)))
    {
      return false;
    }
  }
  if (mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips() == 0)
  {
    error = "has no triangles";
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool ReadFormat(
  Format format, const vtkMTByteSource& bytes, std::string_view begin, vtkPolyData* output, std::string& error)
{
  const std::string path = bytes.GetName();
  switch (format)
  {
    case Format::Vtp:
      return ReadVtp(path, begin, output, error);
    case Format::Legacy:
      return ReadLegacy(bytes, output, error);
    default:
      error = "is of no known format; PLY, STL, OBJ, VTP, VTK, glTF and GLB are read";
      return false;
  }
}

bool ReadBytes(const vtkMTByteSource& bytes, vtkPolyData* output, std::string& error, vtkMTMeshReader::Counts* counts)
{
  char buffer[512] = {};
  const std::uint64_t size = bytes.GetSize();
  const std::size_t length = static_cast<std::size_t>(std::min<std::uint64_t>(size, sizeof(buffer)));
  if (size == 0)
  {
    error = bytes.GetName() + ": is empty";
    return false;
  }
  if (!bytes.Read(0, length, buffer, error))
  {
    return false;
  }
  const std::string_view begin(buffer, length);
  Format format = FromContent(begin);
  format = format == Format::Unknown ? FromEnding(vtkMTTextFormat::GetLowerCaseEnding(bytes.GetName())) : format;
  if (format == Format::Gltf)
  {
    return vtkMTGltfReader::Read(bytes, output, error, counts);
  }
  if (format == Format::Ply || format == Format::Stl || format == Format::Obj)
  {
    return format == Format::Ply ? vtkMTPlyReader::Read(bytes, output, error)
      : format == Format::Stl    ? vtkMTStlReader::Read(bytes, output, error)
                                 : vtkMTObjReader::Read(bytes, output, error);
  }
  std::string reason;
  if (!ReadFormat(format, bytes, begin, output, reason))
  {
    error = bytes.GetName() + ": " + reason;
    return false;
  }
  return true;
}
}

bool vtkMTMeshReader::Read(const std::string& path, vtkPolyData* output, std::string& error, Counts* counts)
{
  output->Initialize();
  const auto bytes = vtkMTFileByteSource::Open(path, error);
  if (!bytes)
  {
    return false;
  }
  bool done = false;
  try
  {
    std::string reason;
    done = ReadBytes(*bytes, output, error, counts);
    if (done && !CheckMesh(output, reason))
    {
      done = false;
      error = path + ": " + reason;
    }
  }
  catch (const std::exception& exception) // no memory
  {
    error = path + ": " + exception.what();
  }
  if (!done)
  {
    output->Initialize();
  }
  return done;
}
