// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPolyDataStream.h"

#include "Polygons/vtkMTPolygonTriangulation.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkInformationStringKey.h"
#include "vtkLookupTable.h"
#include "vtkMTLookupTable.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>

namespace
{
constexpr std::size_t BlockSize = 8192;

using Triangle = std::array<std::uint64_t, 3>;

//------------------------------------------------------------------------------
// An array whose values lie in one block of memory, tuple by tuple.
struct Column
{
  vtkSmartPointer<vtkDataArray> Array;
  std::size_t TupleSize = 0;

  void Append(vtkIdType tuple, vtkMTColumn& to) const
  {
    const unsigned char* from =
      static_cast<const unsigned char*>(this->Array->GetVoidPointer(0)) + tuple * this->TupleSize;
    to.insert(to.end(), from, from + this->TupleSize);
  }
};

//------------------------------------------------------------------------------
int FindAttribute(vtkDataSetAttributes* attributes, vtkAbstractArray* array)
{
  for (int i = 0; i < vtkDataSetAttributes::NUM_ATTRIBUTES; ++i)
  {
    if (attributes->GetAbstractAttribute(i) == array)
    {
      return i;
    }
  }
  return -1;
}

//------------------------------------------------------------------------------
std::string GetReasonToLeaveOut(vtkAbstractArray* array, vtkIdType tuples, std::size_t tupleSize)
{
  switch (array->GetDataType())
  {
    case VTK_STRING:
      return "arrays_of_strings";
    case VTK_VARIANT:
      return "arrays_of_variants";
    case VTK_BIT:
      return "arrays_of_bits";
    default:
      break;
  }
  if (tupleSize == 0 || !vtkDataArray::SafeDownCast(array))
  {
    return "arrays_of_other_types";
  }
  return array->GetNumberOfTuples() != tuples ? "arrays_of_wrong_length" : "";
}
}

//------------------------------------------------------------------------------
struct vtkMTPolyDataStream::Internals
{
  vtkSmartPointer<vtkPolyData> Input;
  std::vector<vtkMTArrayInfo> Infos;
  std::vector<Column> PointColumns;
  std::vector<Column> CellColumns;
  std::map<std::string, std::int64_t> Report;
  std::uint64_t Triangles = 0;
  vtkIdType FirstPolyCell = 0;

  vtkIdType NextPoint = 0;
  vtkIdType NextCell = 0;     // counts polygons, then strips
  std::vector<Triangle> Cell; // triangles of the present cell
  std::size_t NextInCell = 0;

  vtkNew<vtkIdList> CellPoints;
  std::vector<vtkMTPolygonTriangulation::Place> CellPlaces;
  vtkMTPolygonTriangulation Polygon;

  vtkIdType GetNumberOfPolys() { return this->Input->GetPolys()->GetNumberOfCells(); }
  vtkIdType GetNumberOfStrips() { return this->Input->GetStrips()->GetNumberOfCells(); }

  void AddArrays(vtkDataSetAttributes* attributes, vtkMTArrayInfo::AssociationType association, vtkIdType tuples);
  static void AddProperties(vtkDataArray* array, vtkMTArrayInfo& info);
  void CountCells();
  void LoadCell();
  void AddStrip();
  void AddPolygon();
  void AddFan(std::size_t first);
  std::size_t GetCellPlaces();
  void AddTriangle(vtkIdType a, vtkIdType b, vtkIdType c)
  {
    this->Cell.push_back(
      { static_cast<std::uint64_t>(a), static_cast<std::uint64_t>(b), static_cast<std::uint64_t>(c) });
  }
};

//------------------------------------------------------------------------------
void vtkMTPolyDataStream::Internals::AddArrays(
  vtkDataSetAttributes* attributes, vtkMTArrayInfo::AssociationType association, vtkIdType tuples)
{
  std::set<std::string> names;
  for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
  {
    const char* name = attributes->GetAbstractArray(i)->GetName();
    names.insert(name ? name : "");
  }
  for (int i = 0, unnamed = 0; i < attributes->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = attributes->GetAbstractArray(i);
    vtkMTArrayInfo info;
    info.Name = array->GetName() ? array->GetName() : "";
    while (info.Name.empty())
    {
      const std::string made = "array_" + std::to_string(unnamed++);
      info.Name = names.insert(made).second ? made : "";
    }
    info.Type = array->GetDataType();
    info.Components = array->GetNumberOfComponents();
    info.Association = association;
    info.Attribute = FindAttribute(attributes, array);
    info.Resampling = info.GetDefaultResampling();
    for (int c = 0; array->HasAComponentName() && c < info.Components; ++c)
    {
      info.ComponentNames.emplace_back(array->GetComponentName(c) ? array->GetComponentName(c) : "");
    }
    this->AddProperties(vtkDataArray::SafeDownCast(array), info);
    const std::string reason = GetReasonToLeaveOut(array, tuples, info.GetTupleSize());
    if (!reason.empty())
    {
      ++this->Report[reason];
      continue;
    }
    Column column;
    column.TupleSize = info.GetTupleSize();
    column.Array = vtkDataArray::SafeDownCast(array);
    if (!array->HasStandardMemoryLayout())
    {
      column.Array.TakeReference(vtkDataArray::CreateDataArray(info.Type));
      column.Array->DeepCopy(array);
    }
    (association == vtkMTArrayInfo::Cell ? this->CellColumns : this->PointColumns).push_back(column);
    this->Infos.push_back(info);
  }
}

//------------------------------------------------------------------------------
void vtkMTPolyDataStream::Internals::AddProperties(vtkDataArray* array, vtkMTArrayInfo& info)
{
  if (array && array->HasInformation() && array->GetInformation()->Has(vtkDataArray::UNITS_LABEL()))
  {
    info.Properties["units"] = array->GetInformation()->Get(vtkDataArray::UNITS_LABEL());
  }
  if (array && array->GetLookupTable())
  {
    info.Properties["lookup_table"] = vtkMTLookupTable::Encode(array->GetLookupTable());
  }
}

//------------------------------------------------------------------------------
void vtkMTPolyDataStream::Internals::CountCells()
{
  const vtkIdType vertices = this->Input->GetVerts()->GetNumberOfCells();
  const vtkIdType lines = this->Input->GetLines()->GetNumberOfCells();
  this->FirstPolyCell = vertices + lines;
  std::int64_t degenerate = 0;
  for (vtkCellArray* cells : { this->Input->GetPolys(), this->Input->GetStrips() })
  {
    for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
    {
      const vtkIdType size = cells->GetCellSize(cell);
      degenerate += size < 3 ? 1 : 0;
      this->Triangles += size < 3 ? 0 : size - 2;
    }
  }
  const std::pair<const char*, std::int64_t> counts[] = { { "vertices", vertices }, { "lines", lines },
    { "degenerate_cells", degenerate } };
  for (const auto& count : counts)
  {
    if (count.second > 0)
    {
      this->Report[count.first] = count.second;
    }
  }
}

//------------------------------------------------------------------------------
// The places of the present cell's points; gives the first that does not exist or is not finite, or their number.
std::size_t vtkMTPolyDataStream::Internals::GetCellPlaces()
{
  const vtkIdType points = this->Input->GetNumberOfPoints();
  this->CellPlaces.resize(static_cast<std::size_t>(this->CellPoints->GetNumberOfIds()));
  for (std::size_t i = 0; i < this->CellPlaces.size(); ++i)
  {
    const vtkIdType id = this->CellPoints->GetId(static_cast<vtkIdType>(i));
    if (id < 0 || id >= points)
    {
      return i;
    }
    auto& place = this->CellPlaces[i];
    this->Input->GetPoint(id, place.data());
    if (!std::isfinite(place[0]) || !std::isfinite(place[1]) || !std::isfinite(place[2]))
    {
      return i;
    }
  }
  return this->CellPlaces.size();
}

//------------------------------------------------------------------------------
void vtkMTPolyDataStream::Internals::AddStrip()
{
  const vtkIdType* ids = this->CellPoints->GetPointer(0);
  for (vtkIdType i = 0; i + 2 < this->CellPoints->GetNumberOfIds(); ++i)
  {
    const bool odd = i % 2 == 1;
    this->AddTriangle(ids[i], odd ? ids[i + 2] : ids[i + 1], odd ? ids[i + 1] : ids[i + 2]);
  }
}

//------------------------------------------------------------------------------
void vtkMTPolyDataStream::Internals::AddFan(std::size_t first)
{
  const std::size_t size = this->CellPlaces.size();
  const vtkIdType* ids = this->CellPoints->GetPointer(0);
  for (std::size_t i = 1; i + 1 < size; ++i)
  {
    this->AddTriangle(ids[first], ids[(first + i) % size], ids[(first + i + 1) % size]);
  }
}

//------------------------------------------------------------------------------
void vtkMTPolyDataStream::Internals::AddPolygon()
{
  const vtkIdType size = this->CellPoints->GetNumberOfIds();
  const vtkIdType* ids = this->CellPoints->GetPointer(0);
  if (size == 3)
  {
    this->AddTriangle(ids[0], ids[1], ids[2]);
  }
  if (size <= 3)
  {
    return;
  }
  const std::size_t bad = this->GetCellPlaces();
  if (bad < this->CellPlaces.size())
  {
    this->AddFan(bad); // all of its triangles have that point and are dropped for it
    return;
  }
  if (!this->Polygon.Triangulate(this->CellPlaces))
  {
    ++this->Report[GetCrossedPolygonsName()];
  }
  for (const vtkMTPolygonTriangulation::Triangle& t : this->Polygon.GetTriangles())
  {
    this->AddTriangle(ids[t[0]], ids[t[1]], ids[t[2]]);
  }
}

//------------------------------------------------------------------------------
void vtkMTPolyDataStream::Internals::LoadCell()
{
  this->Cell.clear();
  this->NextInCell = 0;
  const vtkIdType polys = this->GetNumberOfPolys();
  if (this->NextCell < polys)
  {
    this->Input->GetPolys()->GetCellAtId(this->NextCell, this->CellPoints);
    this->AddPolygon();
  }
  else
  {
    this->Input->GetStrips()->GetCellAtId(this->NextCell - polys, this->CellPoints);
    this->AddStrip();
  }
}

//------------------------------------------------------------------------------
vtkMTPolyDataStream::vtkMTPolyDataStream(vtkPolyData* input)
  : Implementation(new Internals)
{
  Internals& in = *this->Implementation;
  in.Input = input;
  in.AddArrays(input->GetPointData(), vtkMTArrayInfo::Point, input->GetNumberOfPoints());
  in.AddArrays(input->GetCellData(), vtkMTArrayInfo::Cell, input->GetNumberOfCells());
  in.CountCells();
  this->Rewind();
}

//------------------------------------------------------------------------------
vtkMTPolyDataStream::~vtkMTPolyDataStream() = default;

//------------------------------------------------------------------------------
const std::vector<vtkMTArrayInfo>& vtkMTPolyDataStream::GetArrays() const
{
  return this->Implementation->Infos;
}

//------------------------------------------------------------------------------
std::uint64_t vtkMTPolyDataStream::GetNumberOfPoints() const
{
  return static_cast<std::uint64_t>(this->Implementation->Input->GetNumberOfPoints());
}

//------------------------------------------------------------------------------
std::uint64_t vtkMTPolyDataStream::GetNumberOfTriangles() const
{
  return this->Implementation->Triangles;
}

//------------------------------------------------------------------------------
const std::map<std::string, std::int64_t>& vtkMTPolyDataStream::GetReport() const
{
  return this->Implementation->Report;
}

//------------------------------------------------------------------------------
bool vtkMTPolyDataStream::Rewind()
{
  this->Implementation->NextPoint = 0;
  this->Implementation->NextCell = -1;
  this->Implementation->NextInCell = 0;
  this->Implementation->Cell.clear();
  this->Implementation->Report.erase(GetCrossedPolygonsName());
  return true;
}

//------------------------------------------------------------------------------
bool vtkMTPolyDataStream::NextPoints(PointBlock& block)
{
  Internals& in = *this->Implementation;
  const vtkIdType end = std::min(in.NextPoint + static_cast<vtkIdType>(BlockSize), in.Input->GetNumberOfPoints());
  block.Points.resize(end - in.NextPoint);
  block.Columns.assign(in.PointColumns.size(), vtkMTColumn());
  for (vtkIdType i = in.NextPoint; i < end; ++i)
  {
    in.Input->GetPoint(i, block.Points[i - in.NextPoint].data());
    for (std::size_t c = 0; c < in.PointColumns.size(); ++c)
    {
      in.PointColumns[c].Append(i, block.Columns[c]);
    }
  }
  in.NextPoint = end;
  return true;
}

//------------------------------------------------------------------------------
bool vtkMTPolyDataStream::NextTriangles(TriangleBlock& block)
{
  Internals& in = *this->Implementation;
  block.Triangles.clear();
  block.CellIds.clear();
  block.Columns.assign(in.CellColumns.size(), vtkMTColumn());
  const vtkIdType cells = in.GetNumberOfPolys() + in.GetNumberOfStrips();
  while (block.Triangles.size() < BlockSize)
  {
    if (in.NextInCell == in.Cell.size())
    {
      if (in.NextCell + 1 >= cells)
      {
        break;
      }
      ++in.NextCell;
      in.LoadCell();
      continue;
    }
    block.Triangles.push_back(in.Cell[in.NextInCell++]);
    const vtkIdType cellId = in.FirstPolyCell + in.NextCell;
    block.CellIds.push_back(cellId);
    for (std::size_t c = 0; c < in.CellColumns.size(); ++c)
    {
      in.CellColumns[c].Append(cellId, block.Columns[c]);
    }
  }
  return true;
}
