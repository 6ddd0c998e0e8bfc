// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTVtpStream.h"

#include "vtkMTChunkStream.h"
#include "vtkMTXmlArrays.h"

#include "vtkAbstractArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkXMLDataElement.h"

#include <algorithm>
#include <cstring>
#include <filesystem>

namespace
{
// What changes from one time step to the next, or that VTK's reader makes something else of.
bool IsSpecial(vtkXMLDataElement* array)
{
  const char* name = array->GetAttribute("Name");
  return array->GetAttribute("TimeStep") || (name && std::strcmp(name, "vtkGhostLevels") == 0);
}

//------------------------------------------------------------------------------
// The arrays of points or of cells.
class Attributes
{
public:
  // False when there is an array that is not read by ranges.
  bool Find(vtkXMLDataElement* element)
  {
    this->Element = element;
    for (int i = 0; element && i < element->GetNumberOfNestedElements(); ++i)
    {
      vtkXMLDataElement* array = element->GetNestedElement(i);
      const char* name = array->GetAttribute("Name");
      const auto made = vtkMTXmlArrays::MakeArray(array);
      if (!vtkDataArray::SafeDownCast(made) || made->GetDataType() == VTK_BIT || IsSpecial(array))
      {
        return false;
      }
      const auto hasName = [name](vtkXMLDataElement* other)
      { return std::strcmp(other->GetAttribute("Name"), name) == 0; };
      if (name && std::none_of(this->Arrays.begin(), this->Arrays.end(), hasName)) // as VTK's reader does
      {
        this->Arrays.push_back(array);
      }
    }
    return true;
  }

  bool Read(
    vtkMTXmlArrays& file, std::uint64_t first, std::uint64_t count, vtkDataSetAttributes* to, std::string& error)
  {
    for (vtkXMLDataElement* element : this->Arrays)
    {
      const auto array = vtkMTXmlArrays::MakeArray(element);
      if (!file.Read(element, first, count, vtkDataArray::SafeDownCast(array), error))
      {
        return false;
      }
      to->AddArray(array);
    }
    for (int i = 0; this->Element && i < vtkDataSetAttributes::NUM_ATTRIBUTES; ++i)
    {
      const char* name = this->Element->GetAttribute(vtkDataSetAttributes::GetAttributeTypeAsString(i));
      if (name)
      {
        to->SetActiveAttribute(name, i);
      }
    }
    return true;
  }

private:
  vtkXMLDataElement* Element = nullptr;
  std::vector<vtkXMLDataElement*> Arrays;
};

//------------------------------------------------------------------------------
class Stream : public vtkMTChunkStream
{
public:
  Stream(vtkMTSpoolStore* store, std::size_t memory)
    : vtkMTChunkStream(store, memory)
  {
  }

  bool Open(const std::string& path)
  {
    if (!this->File.Open(path, this->Error) || !this->FindParts() || !this->LookAtPolygons() || !this->FinishCells())
    {
      return false;
    }
    vtkNew<vtkPolyData> points;
    vtkNew<vtkPolyData> cells;
    vtkMTCellCorners corners;
    const bool isRead =
      this->HasLastPoint() && this->RewindFile() && this->ReadPoints(1, points) && this->ReadCells(1, cells, corners);
    this->Arrays = GetArraysOf(points, cells);
    return isRead && this->Rewind();
  }

private:
  static std::uint64_t GetCount(vtkXMLDataElement* piece, const char* name)
  {
    vtkTypeInt64 count = 0;
    return piece->GetScalarAttribute(name, count) && count > 0 ? static_cast<std::uint64_t>(count) : 0;
  }

  void CountOthers(const char* name, std::uint64_t count)
  {
    this->FirstCell += count;
    if (count > 0)
    {
      this->Report[name] = static_cast<std::int64_t>(count);
    }
  }

  bool FindParts()
  {
    vtkXMLDataElement* root = this->File.GetRoot();
    vtkXMLDataElement* whole = root->FindNestedElementWithName("PolyData");
    const bool isPolyData = std::strcmp(root->GetName(), "VTKFile") == 0 && whole && !whole->GetAttribute("TimeValues");
    vtkXMLDataElement* piece = nullptr;
    int pieces = 0;
    for (int i = 0; isPolyData && i < whole->GetNumberOfNestedElements(); ++i)
    {
      if (std::strcmp(whole->GetNestedElement(i)->GetName(), "Piece") == 0)
      {
        piece = whole->GetNestedElement(i);
        ++pieces;
      }
    }
    if (pieces != 1 || GetCount(piece, "NumberOfStrips") > 0)
    {
      return false;
    }
    this->Points = GetCount(piece, "NumberOfPoints");
    this->Polygons = GetCount(piece, "NumberOfPolys");
    this->CountOthers("vertices", GetCount(piece, "NumberOfVerts"));
    this->CountOthers("lines", GetCount(piece, "NumberOfLines"));
    return this->FindArrays(piece);
  }

  bool FindArrays(vtkXMLDataElement* piece)
  {
    vtkXMLDataElement* points = piece->FindNestedElementWithName("Points");
    vtkXMLDataElement* polys = piece->FindNestedElementWithName("Polys");
    if (this->Points == 0 || this->Polygons == 0 || !points || points->GetNumberOfNestedElements() != 1 || !polys)
    {
      return false;
    }
    this->Places = points->GetNestedElement(0);
    this->Offsets = polys->FindNestedElementWithNameAndAttribute("DataArray", "Name", "offsets");
    this->Connectivity = polys->FindNestedElementWithNameAndAttribute("DataArray", "Name", "connectivity");
    const auto places = vtkMTXmlArrays::MakeArray(this->Places);
    return this->Offsets && this->Connectivity && !IsSpecial(this->Places) && !IsSpecial(this->Offsets) &&
      !IsSpecial(this->Connectivity) && vtkDataArray::SafeDownCast(places) && places->GetNumberOfComponents() == 3 &&
      this->OfPoints.Find(piece->FindNestedElementWithName("PointData")) &&
      this->OfCells.Find(piece->FindNestedElementWithName("CellData"));
  }

  // The number of points is only a claim of the file; room is planned by it. Text is read in order only.
  bool HasLastPoint()
  {
    const char* format = this->Places->GetAttribute("format");
    if (!this->Places->GetAttribute("offset") && (!format || std::strcmp(format, "binary") != 0))
    {
      return true;
    }
    const auto made = vtkMTXmlArrays::MakeArray(this->Places);
    vtkDataArray* array = vtkDataArray::SafeDownCast(made);
    return array && this->File.Read(this->Places, this->Points - 1, 1, array, this->Error);
  }

  bool LookAtPolygons()
  {
    this->RewindFile();
    vtkMTCellCorners corners;
    for (std::uint64_t read = 0; read < this->Polygons; read += ChunkSize)
    {
      corners = vtkMTCellCorners();
      if (!this->ReadPolygons(std::min(ChunkSize, this->Polygons - read), corners))
      {
        return false;
      }
      std::size_t begin = 0;
      for (const std::size_t end : corners.Ends)
      {
        if (!this->AddCell(corners.Points.data() + begin, end - begin))
        {
          return false;
        }
        begin = end;
      }
    }
    return true;
  }

  // Whole numbers, whatever their type.
  bool ReadNumbers(vtkXMLDataElement* element, std::uint64_t first, std::uint64_t count, vtkIdTypeArray* numbers)
  {
    const auto made = vtkMTXmlArrays::MakeArray(element);
    vtkDataArray* array = vtkDataArray::SafeDownCast(made);
    if (!array || array->GetNumberOfComponents() != 1 || !this->File.Read(element, first, count, array, this->Error))
    {
      return false;
    }
    numbers->DeepCopy(array);
    return true;
  }

  bool ReadPolygons(std::uint64_t count, vtkMTCellCorners& corners)
  {
    vtkNew<vtkIdTypeArray> ends;
    vtkNew<vtkIdTypeArray> points;
    if (!this->ReadNumbers(this->Offsets, this->NextPolygon, count, ends))
    {
      return false;
    }
    std::uint64_t last = this->NextCorner;
    for (vtkIdType i = 0; i < ends->GetNumberOfTuples(); ++i)
    {
      const auto end = static_cast<std::uint64_t>(ends->GetValue(i));
      // A damaged offset must not ask for more memory than any sound chunk.
      if (end < last || end - this->NextCorner > MostCorners)
      {
        return this->Fail("its cells are impossible");
      }
      last = end;
      corners.Ends.push_back(static_cast<std::size_t>(end - this->NextCorner));
    }
    if (!this->ReadNumbers(this->Connectivity, this->NextCorner, last - this->NextCorner, points))
    {
      return false;
    }
    corners.Points.assign(points->GetPointer(0), points->GetPointer(0) + points->GetNumberOfTuples());
    this->NextPolygon += count;
    this->NextCorner = last;
    return std::all_of(corners.Points.begin(), corners.Points.end(),
             [this](std::uint64_t point) { return point < this->Points; }) ||
      this->Fail("a cell has a point that does not exist");
  }

  bool RewindFile() override
  {
    this->NextPoint = 0;
    this->NextPolygon = 0;
    this->NextCorner = 0;
    return true;
  }

  bool ReadPoints(std::uint64_t count, vtkPolyData* chunk) override
  {
    const auto made = vtkMTXmlArrays::MakeArray(this->Places);
    vtkDataArray* places = vtkDataArray::SafeDownCast(made);
    if (!this->File.Read(this->Places, this->NextPoint, count, places, this->Error) ||
      !this->OfPoints.Read(this->File, this->NextPoint, count, chunk->GetPointData(), this->Error))
    {
      return false;
    }
    vtkNew<vtkPoints> points;
    points->SetData(places);
    chunk->SetPoints(points);
    this->NextPoint += count;
    return true;
  }

  bool ReadCells(std::uint64_t count, vtkPolyData* chunk, vtkMTCellCorners& corners) override
  {
    // The values of vertices and lines come first.
    return this->OfCells.Read(
             this->File, this->FirstCell + this->NextPolygon, count, chunk->GetCellData(), this->Error) &&
      this->ReadPolygons(count, corners);
  }

  static constexpr std::uint64_t MostCorners = std::uint64_t(1) << 23; // in a chunk

  vtkMTXmlArrays File;
  vtkXMLDataElement* Places = nullptr;
  vtkXMLDataElement* Offsets = nullptr;
  vtkXMLDataElement* Connectivity = nullptr;
  Attributes OfPoints;
  Attributes OfCells;
  std::uint64_t Polygons = 0;
  std::uint64_t NextPoint = 0;
  std::uint64_t NextPolygon = 0;
  std::uint64_t NextCorner = 0;
};
}

std::unique_ptr<vtkMTTriangleStream> vtkMTVtpStream::Open(
  const std::string& path, const vtkMTMeshStream::Settings& settings, vtkPolyData*)
{
  std::error_code code;
  const std::uint64_t size = std::filesystem::file_size(path, code);
  if (code || size < settings.LeastSize)
  {
    return nullptr;
  }
  auto stream = std::make_unique<Stream>(settings.Store, settings.Memory / 2);
  return stream->Open(path) ? std::unique_ptr<vtkMTTriangleStream>(std::move(stream)) : nullptr;
}
