// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTGridSurface.h"

#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"
#include "vtkSmartPointer.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <map>

namespace
{
//------------------------------------------------------------------------------
// How many points a cell of each type has.
class CellSizes
{
public:
  bool IsSound(int type, vtkIdType size)
  {
    switch (type)
    {
      case VTK_EMPTY_CELL:
      case VTK_POLY_VERTEX:
      case VTK_POLY_LINE:
      case VTK_TRIANGLE_STRIP:
      case VTK_POLYGON:
      case VTK_CONVEX_POINT_SET:
      case VTK_POLYHEDRON:
        return size >= 0;
      case VTK_QUADRATIC_POLYGON:
        return size >= 6 && size % 2 == 0;
      default:
        return this->IsLinearOrQuadratic(type) && size == this->GetSize(type);
    }
  }

  static bool IsKnown(int type)
  {
    return IsLinearOrQuadratic(type) || type == VTK_CONVEX_POINT_SET || type == VTK_POLYHEDRON;
  }

private:
  static bool IsLinearOrQuadratic(int type)
  {
    return (type >= VTK_EMPTY_CELL && type <= VTK_HEXAGONAL_PRISM) ||
      (type >= VTK_QUADRATIC_EDGE && type <= VTK_TRIQUADRATIC_PYRAMID);
  }

  vtkIdType GetSize(int type)
  {
    const auto found = this->Sizes.find(type);
    if (found != this->Sizes.end())
    {
      return found->second;
    }
    const auto cell = vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(type));
    return this->Sizes[type] = cell ? cell->GetNumberOfPoints() : -1;
  }

  std::map<int, vtkIdType> Sizes;
};

bool Fail(const std::string& reason, std::string& error)
{
  error = reason;
  return false;
}

// Offsets in ascending order within the connectivity.
bool AreOffsetsSound(vtkCellArray* cells)
{
  vtkDataArray* offsets = cells->GetOffsetsArray();
  vtkIdType last = 0;
  for (vtkIdType i = 0; i < offsets->GetNumberOfTuples(); ++i)
  {
    const auto offset = static_cast<vtkIdType>(offsets->GetComponent(i, 0));
    if (offset < last || offset > cells->GetNumberOfConnectivityIds())
    {
      return false;
    }
    last = offset;
  }
  return true;
}

// Of a polyhedron: number of faces, and for each its number of points and they.
bool ArePolyhedraSound(vtkUnstructuredGrid* grid)
{
  vtkIdTypeArray* places = grid->GetFaceLocations();
  vtkIdTypeArray* faces = grid->GetFaces();
  if (!places || !faces || places->GetNumberOfValues() < grid->GetNumberOfCells())
  {
    return false;
  }
  const vtkIdType size = faces->GetNumberOfValues();
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    vtkIdType next = grid->GetCellType(cell) == VTK_POLYHEDRON ? places->GetValue(cell) : size;
    if (grid->GetCellType(cell) == VTK_POLYHEDRON && (next < 0 || next >= size))
    {
      return false;
    }
    for (vtkIdType count = next < size ? faces->GetValue(next++) : 0; count > 0; --count)
    {
      const vtkIdType points = next < size ? faces->GetValue(next++) : -1;
      if (points < 0 || points > size - next ||
        std::any_of(faces->GetPointer(next), faces->GetPointer(next) + points,
          [grid](vtkIdType point) { return point < 0 || point >= grid->GetNumberOfPoints(); }))
      {
        return false;
      }
      next += points;
    }
  }
  return true;
}

bool CheckGrid(vtkUnstructuredGrid* grid, std::string& error)
{
  vtkCellArray* cells = grid->GetCells();
  vtkUnsignedCharArray* types = grid->GetCellTypesArray();
  if (!cells || !types || types->GetNumberOfValues() != cells->GetNumberOfCells() || !AreOffsetsSound(cells))
  {
    return grid->GetNumberOfCells() == 0 || Fail("its cells are impossible", error);
  }
  CellSizes sizes;
  bool hasPolyhedra = false;
  const vtkNew<vtkIdList> points;
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    const int type = types->GetValue(cell);
    cells->GetCellAtId(cell, points);
    if (!CellSizes::IsKnown(type))
    {
      return Fail("cell " + std::to_string(cell) + " is of type " + std::to_string(type) +
          "; linear and quadratic cells are read",
        error);
    }
    if (!sizes.IsSound(type, points->GetNumberOfIds()))
    {
      return Fail("cell " + std::to_string(cell) + " has not the points of a cell of its type", error);
    }
    for (vtkIdType i = 0; i < points->GetNumberOfIds(); ++i)
    {
      if (points->GetId(i) < 0 || points->GetId(i) >= grid->GetNumberOfPoints())
      {
        return Fail("cell " + std::to_string(cell) + " has a point that does not exist", error);
      }
    }
    hasPolyhedra = hasPolyhedra || type == VTK_POLYHEDRON;
  }
  return !hasPolyhedra || ArePolyhedraSound(grid) || Fail("its polyhedra are impossible", error);
}

// Whether there are as many points as the dimensions say.
template <class Grid>
bool CheckDimensions(Grid* grid, vtkIdType points, std::string& error)
{
  std::array<int, 3> dimensions{};
  grid->GetDimensions(dimensions.data());
  vtkIdType expected = 1;
  for (const int dimension : dimensions)
  {
    expected = dimension < 0 || expected > points ? -1 : expected * dimension;
  }
  return expected == points || Fail("has not as many points as its dimensions say", error);
}

bool CheckRectilinear(vtkRectilinearGrid* grid, std::string& error)
{
  std::array<int, 3> dimensions{};
  grid->GetDimensions(dimensions.data());
  vtkDataArray* const axes[3] = { grid->GetXCoordinates(), grid->GetYCoordinates(), grid->GetZCoordinates() };
  for (std::size_t i = 0; i < 3; ++i)
  {
    if (!axes[i] || axes[i]->GetNumberOfTuples() != dimensions[i])
    {
      return Fail("has not as many coordinates as its dimensions say", error);
    }
  }
  return true;
}

void DropShortArrays(vtkDataSetAttributes* attributes, vtkIdType tuples, vtkMTInputReport& report)
{
  for (int i = attributes->GetNumberOfArrays(); i-- > 0;)
  {
    if (attributes->GetAbstractArray(i)->GetNumberOfTuples() != tuples)
    {
      attributes->RemoveArray(i);
      vtkMTInputReports::Add("arrays_of_wrong_length", 1, report);
    }
  }
}

bool Check(vtkDataSet* dataset, std::string& error)
{
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(dataset))
  {
    return CheckGrid(grid, error);
  }
  if (auto* grid = vtkStructuredGrid::SafeDownCast(dataset))
  {
    return CheckDimensions(grid, grid->GetPoints() ? grid->GetPoints()->GetNumberOfPoints() : 0, error);
  }
  auto* grid = vtkRectilinearGrid::SafeDownCast(dataset);
  return !grid || CheckRectilinear(grid, error);
}
}

bool vtkMTGridSurface::CanTake(vtkDataSet* dataset)
{
  return vtkPolyData::SafeDownCast(dataset) || vtkUnstructuredGrid::SafeDownCast(dataset) ||
    vtkStructuredGrid::SafeDownCast(dataset) || vtkRectilinearGrid::SafeDownCast(dataset);
}

bool vtkMTGridSurface::Take(vtkDataSet* dataset, vtkPolyData* output, vtkMTInputReport& report, std::string& error)
{
  if (!dataset || !CanTake(dataset))
  {
    return Fail("holds no polydata, and no grid that has a surface", error);
  }
  if (auto* mesh = vtkPolyData::SafeDownCast(dataset))
  {
    output->ShallowCopy(mesh);
    return true;
  }
  if (!Check(dataset, error))
  {
    return false;
  }
  const auto copy = vtkSmartPointer<vtkDataSet>::Take(dataset->NewInstance());
  copy->ShallowCopy(dataset);
  DropShortArrays(copy->GetPointData(), copy->GetNumberOfPoints(), report);
  DropShortArrays(copy->GetCellData(), copy->GetNumberOfCells(), report);
  const vtkNew<vtkDataSetSurfaceFilter> surface;
  surface->SetInputData(copy);
  surface->Update();
  output->ShallowCopy(surface->GetOutput());
  vtkMTInputReports::Add("surfaces_of_grids", 1, report);
  return true;
}
