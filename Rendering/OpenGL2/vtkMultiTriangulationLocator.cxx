// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMultiTriangulationLocator.h"

#include "vtkGenericCell.h"
#include "vtkMTGraph.h"
#include "vtkMTLineHit.h"
#include "vtkMTPatchSource.h"
#include "vtkMTPlacement.h"
#include "vtkMultiTriangulation.h"
#include "vtkMultiTriangulationMapper.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"

#include <algorithm>

vtkStandardNewMacro(vtkMultiTriangulationLocator);

//------------------------------------------------------------------------------
vtkMultiTriangulationLocator::vtkMultiTriangulationLocator() = default;
vtkMultiTriangulationLocator::~vtkMultiTriangulationLocator() = default;

//------------------------------------------------------------------------------
void vtkMultiTriangulationLocator::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mapper: " << this->Mapper.Get() << "\n";
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationLocator::SetMapper(vtkMultiTriangulationMapper* mapper)
{
  if (this->Mapper != mapper)
  {
    this->Mapper = mapper;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkMultiTriangulationMapper* vtkMultiTriangulationLocator::GetMapper()
{
  return this->Mapper;
}

//------------------------------------------------------------------------------
vtkDataSet* vtkMultiTriangulationLocator::GetDataSet()
{
  return this->Mapper ? this->Mapper->GetInput() : nullptr;
}

//------------------------------------------------------------------------------
int vtkMultiTriangulationLocator::IntersectWithLine(const double p1[3], const double p2[3], double vtkNotUsed(tol),
  double& t, double x[3], double pcoords[3], int& subId, vtkIdType& cellId, vtkGenericCell* cell)
{
  this->DistanceToInput = this->DistanceFromInput = 0.0;
  this->InputPointId = -1;
  auto* model = vtkMultiTriangulation::SafeDownCast(this->GetDataSet());
  if (!model || !model->GetSource() || model->GetNumberOfPoints() == 0)
  {
    return 0;
  }
  vtkMTLineHit hit;
  std::string error;
  vtkMTPlacement placement;
  model->GetFrame(placement.Matrix.data());
  const vtkMTPlacement inverse = placement.GetInverse();
  const bool found = hit.Find(
    *model->GetSource(), this->Mapper->GetDrawnArcs(), inverse.ToObject({ p1[0], p1[1], p1[2] }),
    inverse.ToObject({ p2[0], p2[1], p2[2] }),
    [this](std::uint32_t arc) { return this->Mapper->GetPatchInMemory(arc); }, error);
  if (!error.empty())
  {
    vtkErrorMacro(<< model->GetSource()->GetName() << ": " << error);
  }
  if (!found)
  {
    return 0;
  }
  const vtkMTGraph& graph = model->GetSource()->GetGraph();
  this->DistanceToInput = graph.GetDistanceToInput(hit.GetArc()) * placement.GetStretch();
  this->DistanceFromInput = graph.GetDistanceFromInput(hit.GetArc()) * placement.GetStretch();
  t = hit.T;
  subId = 0;
  cellId = hit.InputCell;
  this->InputPointId = hit.InputPoint;
  for (int i = 0; i < 3; ++i)
  {
    x[i] = p1[i] + t * (p2[i] - p1[i]);
    pcoords[i] = i < 2 ? hit.Weights[i] : 0.0;
  }
  cell->SetCellTypeToTriangle();
  for (int i = 0; i < 3; ++i)
  {
    std::array<double, 3> corner = placement.ToObject(hit.Triangle[i]);
    cell->GetPoints()->SetPoint(i, corner.data());
    cell->GetPointIds()->SetId(i, model->FindPoint(corner.data()));
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationLocator::GenerateRepresentation(int vtkNotUsed(level), vtkPolyData* mesh)
{
  if (this->Mapper)
  {
    this->Mapper->GetCut(mesh);
  }
}
