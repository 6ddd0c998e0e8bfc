// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTMeshToPolyData.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationStringKey.h"
#include "vtkLookupTable.h"
#include "vtkMTExactPoints.h"
#include "vtkMTLattice.h"
#include "vtkMTLookupTable.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <cstring>

namespace
{
//------------------------------------------------------------------------------
void AddProperties(const vtkMTArrayInfo& info, vtkDataArray* array)
{
  const auto units = info.Properties.find("units");
  if (units != info.Properties.end())
  {
    array->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), units->second.c_str());
  }
  const auto table = info.Properties.find("lookup_table");
  if (table != info.Properties.end())
  {
    array->SetLookupTable(vtkMTLookupTable::Decode(table->second));
  }
}

//------------------------------------------------------------------------------
void AddArray(
  const vtkMTArrayInfo& info, const vtkMTColumn& column, std::size_t tuples, vtkDataSetAttributes* attributes)
{
  const std::size_t size = info.GetTupleSize();
  // An empty column was not asked for; any other wrong length is a broken patch, which the validator reports.
  if (size == 0 || column.size() != tuples * size || info.Role == vtkMTArrayInfo::ExactPoints)
  {
    return;
  }
  vtkSmartPointer<vtkDataArray> array;
  array.TakeReference(vtkDataArray::CreateDataArray(info.Type));
  array->SetName(info.Name.c_str());
  array->SetNumberOfComponents(info.Components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(tuples));
  if (!column.empty())
  {
    std::memcpy(array->GetVoidPointer(0), column.data(), column.size());
  }
  for (std::size_t i = 0; i < info.ComponentNames.size(); ++i)
  {
    array->SetComponentName(static_cast<vtkIdType>(i), info.ComponentNames[i].c_str());
  }
  AddProperties(info, array);
  const int index = attributes->AddArray(array);
  if (info.Attribute >= 0 && info.Attribute < vtkDataSetAttributes::NUM_ATTRIBUTES)
  {
    attributes->SetActiveAttribute(index, info.Attribute);
  }
}

//------------------------------------------------------------------------------
// The array that the points are taken from; null when they are on the lattice. column is its place.
const vtkMTArrayInfo* FindExactPoints(
  const vtkMTPatch& mesh, const std::vector<vtkMTArrayInfo>& arrays, std::size_t& column)
{
  column = 0;
  for (const vtkMTArrayInfo& info : arrays)
  {
    if (vtkMTExactPoints::IsSound(info) && column < mesh.PointColumns.size() &&
      mesh.PointColumns[column].size() == mesh.GetNumberOfWedges() * info.GetTupleSize())
    {
      return &info;
    }
    column += info.Association == vtkMTArrayInfo::Point ? 1 : 0;
  }
  return nullptr;
}

//------------------------------------------------------------------------------
bool FillPoints(
  const vtkMTPatch& mesh, const vtkMTLattice& lattice, const std::vector<vtkMTArrayInfo>& arrays, vtkPoints* points)
{
  std::size_t column = 0;
  const vtkMTArrayInfo* exact = FindExactPoints(mesh, arrays, column);
  points->SetDataType(exact && vtkMTExactPoints::IsSingle(*exact) ? VTK_FLOAT : VTK_DOUBLE);
  const std::size_t wedges = mesh.GetNumberOfWedges();
  points->SetNumberOfPoints(static_cast<vtkIdType>(wedges));
  for (std::uint32_t w = 0; w < wedges; ++w)
  {
    const vtkMTPoint& point = mesh.Points[mesh.GetPointOfWedge(w)];
    std::array<double, 3> place = lattice.ToWorld(point);
    if (exact &&
      !vtkMTExactPoints::Decode(
        *exact, lattice, point, mesh.PointColumns[column].data() + w * exact->GetTupleSize(), place))
    {
      return false;
    }
    points->SetPoint(w, place.data());
  }
  return true;
}
}

//------------------------------------------------------------------------------
bool vtkMTMeshToPolyData::Convert(
  const vtkMTPatch& mesh, const vtkMTLattice& lattice, const std::vector<vtkMTArrayInfo>& arrays, vtkPolyData* output)
{
  output->Initialize();
  const std::size_t wedges = mesh.GetNumberOfWedges();
  vtkNew<vtkPoints> points;
  if (!FillPoints(mesh, lattice, arrays, points))
  {
    return false;
  }
  output->SetPoints(points);

  const vtkIdType triangles = static_cast<vtkIdType>(mesh.Triangles.size());
  vtkNew<vtkIdTypeArray> connectivity;
  vtkNew<vtkIdTypeArray> offsets;
  connectivity->SetNumberOfValues(3 * triangles);
  offsets->SetNumberOfValues(triangles + 1);
  for (vtkIdType t = 0; t < triangles; ++t)
  {
    offsets->SetValue(t, 3 * t);
    for (int i = 0; i < 3; ++i)
    {
      connectivity->SetValue(3 * t + i, mesh.Triangles[t][i]);
    }
  }
  offsets->SetValue(triangles, 3 * triangles);
  vtkNew<vtkCellArray> polys;
  polys->SetData(offsets, connectivity);
  output->SetPolys(polys);

  std::size_t pointColumn = 0;
  std::size_t cellColumn = 0;
  for (const vtkMTArrayInfo& info : arrays)
  {
    if (info.Association == vtkMTArrayInfo::Cell)
    {
      if (cellColumn < mesh.CellColumns.size())
      {
        AddArray(info, mesh.CellColumns[cellColumn], mesh.Triangles.size(), output->GetCellData());
      }
      ++cellColumn;
    }
    else
    {
      if (pointColumn < mesh.PointColumns.size())
      {
        AddArray(info, mesh.PointColumns[pointColumn], wedges, output->GetPointData());
      }
      ++pointColumn;
    }
  }
  return true;
}
