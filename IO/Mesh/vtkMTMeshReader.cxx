// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTMeshReader.h"

#include "Obj/vtkMTObjReader.h"
#include "vtkMTFileByteSource.h"
#include "vtkMTGltfReader.h"
#include "vtkMTGzipByteSource.h"
#include "vtkMTInputReport.h"
#include "vtkMTMeshFormat.h"
#include "vtkMTOffReader.h"
#include "vtkMTPlyReader.h"
#include "vtkMTStlReader.h"
#include "vtkMTTextFormat.h"
#include "vtkMTVtkReader.h"

#include "vtkCellArray.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <exception>
#include <memory>
#include <new>
#include <string_view>
#include <utility>

namespace
{
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
    error = points > 0 ? "has no triangles; points alone are not supported yet" : "has no triangles";
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
// Those whose readers say what is wrong without the file's name.
bool ReadUnnamed(vtkMTMeshFormat::FormatType format, const vtkMTByteSource& bytes, bool isCompressed,
  vtkPolyData* output, std::string& error, vtkMTInputReport& report)
{
  switch (format)
  {
    case vtkMTMeshFormat::Xml:
      return vtkMTVtkReader::ReadXml(bytes, isCompressed, output, error, report);
    case vtkMTMeshFormat::Legacy:
      return vtkMTVtkReader::ReadLegacy(bytes, isCompressed, output, error, report);
    case vtkMTMeshFormat::Points:
      error = "is of a format of points; points without triangles are not supported yet";
      return false;
    default:
      error = "is of no known format; PLY, STL, OBJ, OFF, VTP, VTU, VTM, VTK, glTF and GLB are read";
      return false;
  }
}

bool ReadBytes(
  const vtkMTByteSource& bytes, bool isCompressed, vtkPolyData* output, std::string& error, vtkMTInputReport& report)
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
  if (vtkMTTextFormat::IsUtf16(begin))
  {
    error = bytes.GetName() + ": is text in UTF-16; save it as UTF-8";
    return false;
  }
  const vtkMTMeshFormat::FormatType format = vtkMTMeshFormat::Find(begin, bytes.GetName());
  switch (format)
  {
    case vtkMTMeshFormat::Ply:
      return vtkMTPlyReader::Read(bytes, output, error, &report);
    case vtkMTMeshFormat::Stl:
      return vtkMTStlReader::Read(bytes, output, error, &report);
    case vtkMTMeshFormat::Obj:
      return vtkMTObjReader::Read(bytes, output, error, &report);
    case vtkMTMeshFormat::Off:
      return vtkMTOffReader::Read(bytes, output, error, &report);
    case vtkMTMeshFormat::Glb:
    case vtkMTMeshFormat::Gltf:
      return vtkMTGltfReader::Read(bytes, output, error, &report);
    default:
      break;
  }
  std::string reason;
  if (!ReadUnnamed(format, bytes, isCompressed, output, reason, report))
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
  vtkMTInputReport report;
  bool done = false;
  try
  {
    std::unique_ptr<vtkMTByteSource> bytes = vtkMTFileByteSource::Open(path, error);
    const bool isCompressed = bytes && vtkMTGzipByteSource::IsGzip(*bytes);
    bytes = isCompressed ? vtkMTGzipByteSource::Open(std::move(bytes), error) : std::move(bytes);
    done = bytes && ReadBytes(*bytes, isCompressed, output, error, report);
    std::string reason;
    if (done && !CheckMesh(output, reason))
    {
      done = false;
      error = path + ": " + reason;
    }
  }
  catch (const std::bad_alloc&)
  {
    done = false;
    error = path + ": takes more memory than there is";
  }
  catch (const std::exception& exception)
  {
    done = false;
    error = path + ": " + exception.what();
  }
  if (!done)
  {
    output->Initialize();
  }
  else if (counts)
  {
    vtkMTInputReports::Add(report, *counts);
  }
  return done;
}
