// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTVerifyMesh.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkVariant.h"

#include <algorithm>
#include <limits>

vtkMTVerifyMesh::Array& vtkMTVerifyMesh::GetArray(
  const std::string& name, KindType kind, bool isOfCells, int components)
{
  const auto found = std::find_if(this->Arrays.begin(), this->Arrays.end(),
    [&](const Array& array) { return array.Name == name && array.IsOfCells == isOfCells; });
  if (found != this->Arrays.end())
  {
    return *found;
  }
  this->Arrays.emplace_back();
  Array& array = this->Arrays.back();
  array.Name = name;
  array.Kind = kind;
  array.IsOfCells = isOfCells;
  array.Components = components;
  return array;
}

void vtkMTVerifyMesh::Fill()
{
  for (Array& array : this->Arrays)
  {
    const std::size_t tuples = array.IsOfCells ? this->Polygons.size() : this->Points.size();
    array.Values.resize(tuples * array.Components, std::numeric_limits<double>::quiet_NaN());
  }
}

double vtkMTVerifyMesh::GetIndexOfName(Array& array, const std::string& name)
{
  const auto found = std::find(array.Names.begin(), array.Names.end(), name);
  const auto index = found - array.Names.begin();
  if (found == array.Names.end())
  {
    array.Names.push_back(name);
  }
  return static_cast<double>(index);
}

namespace
{
void AddArray(const vtkMTVerifyMesh::Array& from, vtkPolyData* mesh)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(from.Name.c_str());
  array->SetNumberOfComponents(from.Components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(from.Values.size()) / from.Components);
  std::copy(from.Values.begin(), from.Values.end(), array->GetPointer(0));
  if (from.Kind == vtkMTVerifyMesh::Names)
  {
    vtkNew<vtkLookupTable> table;
    table->IndexedLookupOn();
    for (std::size_t i = 0; i < from.Names.size(); ++i)
    {
      table->SetAnnotation(vtkVariant(static_cast<double>(i)), from.Names[i]);
    }
    array->SetLookupTable(table);
  }
  vtkDataSetAttributes* attributes = mesh->GetPointData();
  if (from.IsOfCells)
  {
    attributes = mesh->GetCellData();
  }
  attributes->AddArray(array);
  const int active = from.Kind == vtkMTVerifyMesh::Colors ? vtkDataSetAttributes::SCALARS
    : from.Kind == vtkMTVerifyMesh::Normals               ? vtkDataSetAttributes::NORMALS
    : from.Kind == vtkMTVerifyMesh::Coordinates           ? vtkDataSetAttributes::TCOORDS
                                                          : -1;
  if (active >= 0 && !attributes->GetAbstractAttribute(active))
  {
    attributes->SetActiveAttribute(from.Name.c_str(), active);
  }
}
}

void vtkMTVerifyMesh::Give(vtkPolyData* mesh)
{
  this->Fill();
  mesh->Initialize();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(this->Points.size()));
  for (std::size_t i = 0; i < this->Points.size(); ++i)
  {
    points->SetPoint(static_cast<vtkIdType>(i), this->Points[i].data());
  }
  vtkNew<vtkCellArray> cells;
  for (const std::vector<vtkIdType>& polygon : this->Polygons)
  {
    cells->InsertNextCell(static_cast<vtkIdType>(polygon.size()), polygon.data());
  }
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  for (const Array& array : this->Arrays)
  {
    AddArray(array, mesh);
  }
  *this = vtkMTVerifyMesh();
}
