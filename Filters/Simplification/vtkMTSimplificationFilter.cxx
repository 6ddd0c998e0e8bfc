// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTSimplificationFilter.h"

#include "Interpreter/vtkMTLongWork.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMTCompatibility.h"
#include "vtkMTLattice.h"
#include "vtkMTSetMacros.h"
#include "vtkNew.h"

#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStaticCellLocator.h"
#include "vtkTriangleFilter.h"

#include <algorithm>
#include <cmath>
#include <string>

vtkStandardNewMacro(vtkMTSimplificationFilter);
vtkMTCxxSetClampMacro(vtkMTSimplificationFilter, TargetReduction, 0.0, 1.0);

namespace
{
// The input's surface as a source of values.
class Sampler
{
public:
  explicit Sampler(vtkPolyData* mesh)
    : Mesh(mesh)
  {
    this->Locator->SetDataSet(mesh);
    this->Locator->BuildLocator();
  }

  vtkIdType FindCell(double x[3], double closest[3])
  {
    vtkIdType cell = -1;
    int subId = 0;
    double squaredDistance = 0.0;
    this->Locator->FindClosestPoint(x, closest, this->Cell, cell, subId, squaredDistance);
    return cell;
  }

  void CopyCell(double x[3], vtkCellData* out, vtkIdType id)
  {
    double closest[3];
    const vtkIdType cell = this->FindCell(x, closest);
    if (cell >= 0)
    {
      out->CopyData(this->Mesh->GetCellData(), cell, id);
    }
  }

  void InterpolatePoint(double x[3], vtkPointData* out, vtkIdType id, vtkIdType origin)
  {
    double closest[3];
    const vtkIdType cell = this->FindCell(x, closest);
    double parametric[3];
    double weights[3];
    double squaredDistance = 0.0;
    int subId = 0;
    if (cell < 0 || this->Cell->EvaluatePosition(closest, nullptr, subId, parametric, squaredDistance, weights) < 0)
    {
      out->CopyData(this->Mesh->GetPointData(), origin, id);
      return;
    }
    out->InterpolatePoint(this->Mesh->GetPointData(), id, this->Cell->GetPointIds(), weights);
  }

private:
  vtkPolyData* Mesh;
  vtkNew<vtkStaticCellLocator> Locator;
  vtkNew<vtkGenericCell> Cell;
};

void Normalize(vtkDataArray* normals)
{
  if (!normals || normals->GetNumberOfComponents() != 3)
  {
    return;
  }
  for (vtkIdType i = 0; i < normals->GetNumberOfTuples(); ++i)
  {
    double n[3];
    normals->GetTuple(i, n);
    const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    if (length > 0.0)
    {
      normals->SetTuple3(i, n[0] / length, n[1] / length, n[2] / length);
    }
  }
}
}

vtkMTSimplificationFilter::vtkMTSimplificationFilter() = default;

vtkMTSimplificationFilter::~vtkMTSimplificationFilter() = default;

void vtkMTSimplificationFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mode: " << this->Mode << "\n";
  os << indent << "TargetReduction: " << this->TargetReduction << "\n";
  os << indent << "TargetTriangles: " << this->TargetTriangles << "\n";
  os << indent << "LockBorder: " << this->LockBorder << "\n";
  os << indent << "LatticeBits: " << this->LatticeBits << "\n";
  os << indent << "NumberOfBlockedEdges: " << this->NumberOfBlockedEdges << "\n";
  os << indent << "NumberOfRemovedComponents: " << this->NumberOfRemovedComponents << "\n";
}

int vtkMTSimplificationFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const vtkMTLongWork work;
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  this->NumberOfBlockedEdges = 0;
  this->NumberOfRemovedComponents = 0;
  if (!input || !output)
  {
    return 0;
  }
  output->GetFieldData()->PassData(input->GetFieldData());

  vtkNew<vtkTriangleFilter> triangulate;
  triangulate->PassVertsOff();
  triangulate->PassLinesOff();
  triangulate->SetInputData(input);
  triangulate->Update();
  vtkPolyData* mesh = triangulate->GetOutput();
  if (mesh->GetNumberOfCells() == 0)
  {
    return 1;
  }
  this->UpdateProgress(0.1);

  vtkMTLattice lattice;
  vtkMTPatch floor;
  if (!this->MakeFloor(mesh, lattice, floor))
  {
    this->SetErrorCode(vtkErrorCode::UserError);
    vtkErrorMacro("The input has points that are not finite numbers.");
    return 0;
  }
  vtkNew<vtkMTEdgeCollapse> simplifier;
  simplifier->SetMode(this->Mode);
  vtkMTSimplification result;
  std::string error;
  if (!simplifier->Simplify(floor, this->MakeLocks(floor), this->GetTarget(floor.Triangles.size()), result, error))
  {
    this->SetErrorCode(vtkErrorCode::UnknownError);
    vtkErrorMacro("Simplification failed: " << error << ".");
    return 0;
  }
  for (const auto& cause : result.Blocked)
  {
    this->NumberOfBlockedEdges += cause.first == "component_triangles" ? 0 : static_cast<vtkIdType>(cause.second);
  }
  this->NumberOfRemovedComponents = static_cast<vtkIdType>(result.RemovedComponents);
  this->UpdateProgress(0.8);
  if (!vtkMTIsAborted(this))
  {
    MakeOutput(mesh, lattice, result, output);
  }
  this->UpdateProgress(1.0);
  return 1;
}

bool vtkMTSimplificationFilter::MakeFloor(vtkPolyData* mesh, vtkMTLattice& lattice, vtkMTPatch& floor)
{
  const vtkIdType points = mesh->GetNumberOfPoints();
  double bounds[6] = { VTK_DOUBLE_MAX, VTK_DOUBLE_MIN, VTK_DOUBLE_MAX, VTK_DOUBLE_MIN, VTK_DOUBLE_MAX, VTK_DOUBLE_MIN };
  for (vtkIdType i = 0; i < points; ++i)
  {
    double x[3];
    mesh->GetPoint(i, x);
    for (int c = 0; c < 3; ++c)
    {
      if (!std::isfinite(x[c]))
      {
        return false;
      }
      bounds[2 * c] = i == 0 ? x[c] : std::min(bounds[2 * c], x[c]);
      bounds[2 * c + 1] = i == 0 ? x[c] : std::max(bounds[2 * c + 1], x[c]);
    }
  }
  lattice = vtkMTLattice::FromBounds(bounds, this->LatticeBits);
  floor.Points.resize(static_cast<std::size_t>(points));
  for (vtkIdType i = 0; i < points; ++i)
  {
    double x[3];
    mesh->GetPoint(i, x);
    floor.Points[static_cast<std::size_t>(i)] = lattice.Snap(x);
  }
  vtkIdType size = 0;
  const vtkIdType* ids = nullptr;
  auto cells = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    cells->GetCurrentCell(size, ids);
    floor.Triangles.push_back(
      { static_cast<std::uint32_t>(ids[0]), static_cast<std::uint32_t>(ids[1]), static_cast<std::uint32_t>(ids[2]) });
  }
  return true;
}

std::vector<unsigned char> vtkMTSimplificationFilter::MakeLocks(const vtkMTPatch& floor) const
{
  std::vector<unsigned char> locked(floor.Points.size(), 0);
  if (!this->LockBorder)
  {
    return locked;
  }
  std::vector<std::array<std::uint32_t, 2>> edges;
  edges.reserve(3 * floor.Triangles.size());
  for (const vtkMTTriangle& t : floor.Triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      edges.push_back({ std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3]) });
    }
  }
  std::sort(edges.begin(), edges.end());
  for (std::size_t i = 0; i < edges.size();)
  {
    const std::size_t begin = i;
    while (i < edges.size() && edges[i] == edges[begin])
    {
      ++i;
    }
    if (i - begin == 1)
    {
      locked[edges[begin][0]] = 1;
      locked[edges[begin][1]] = 1;
    }
  }
  return locked;
}

std::size_t vtkMTSimplificationFilter::GetTarget(std::size_t triangles) const
{
  return this->TargetTriangles > 0
    ? static_cast<std::size_t>(this->TargetTriangles)
    : static_cast<std::size_t>(std::llround((1.0 - this->TargetReduction) * static_cast<double>(triangles)));
}

void vtkMTSimplificationFilter::MakeOutput(
  vtkPolyData* mesh, const vtkMTLattice& lattice, const vtkMTSimplification& result, vtkPolyData* output)
{
  Sampler sampler(mesh);
  // One output point per wedge; here a point of the input is a wedge.
  const auto wedges = static_cast<vtkIdType>(result.WedgePoints.size());
  vtkNew<vtkPoints> points;
  points->SetDataType(mesh->GetPoints()->GetDataType());
  points->SetNumberOfPoints(wedges);
  vtkPointData* pointData = output->GetPointData();
  pointData->InterpolateAllocate(mesh->GetPointData(), wedges);
  for (vtkIdType w = 0; w < wedges; ++w)
  {
    const std::uint32_t p = result.WedgePoints[static_cast<std::size_t>(w)];
    const auto origin = static_cast<vtkIdType>(result.WedgeOrigin[static_cast<std::size_t>(w)]);
    if (!result.Moved[p])
    {
      points->SetPoint(w, mesh->GetPoint(origin));
      pointData->CopyData(mesh->GetPointData(), origin, w);
      continue;
    }
    std::array<double, 3> x = lattice.ToWorld(result.Points[p]);
    points->SetPoint(w, x.data());
    sampler.InterpolatePoint(x.data(), pointData, w, origin);
  }
  Normalize(pointData->GetNormals());

  vtkNew<vtkCellArray> cells;
  const auto triangles = static_cast<vtkIdType>(result.Triangles.size());
  cells->AllocateExact(triangles, 3 * triangles);
  vtkCellData* cellData = output->GetCellData();
  cellData->CopyAllOn(vtkDataSetAttributes::COPYTUPLE);
  cellData->CopyAllocate(mesh->GetCellData(), triangles);
  for (vtkIdType t = 0; t < triangles; ++t)
  {
    const vtkMTTriangle& w = result.Triangles[static_cast<std::size_t>(t)];
    double barycentre[3] = { 0.0, 0.0, 0.0 };
    vtkIdType ids[3];
    for (int i = 0; i < 3; ++i)
    {
      ids[i] = static_cast<vtkIdType>(w[i]);
      double x[3];
      points->GetPoint(ids[i], x);
      for (int c = 0; c < 3; ++c)
      {
        barycentre[c] += x[c] / 3.0;
      }
    }
    cells->InsertNextCell(3, ids);
    if (cellData->GetNumberOfArrays() > 0)
    {
      sampler.CopyCell(barycentre, cellData, t);
    }
  }
  output->SetPoints(points);
  output->SetPolys(cells);
}
