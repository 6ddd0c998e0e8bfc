// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTCutMesh.h"

#include "vtkMTAssembler.h"
#include "vtkMTGraph.h"
#include "vtkMTMeshToPolyData.h"
#include "vtkMTPatchSource.h"
#include "vtkMTPlacement.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

//------------------------------------------------------------------------------
bool vtkMTCutMesh::Make(const vtkMTPatchSource& source, vtkPolyData* output, std::string& error,
  std::vector<std::uint32_t>* wedgePoints) const
{
  const vtkMTGraph& graph = source.GetKnownGraph();
  vtkMTAssembler assembler(graph.Arrays);
  vtkMTPatch patch;
  error.clear();
  for (std::size_t i = 0; i < this->Arcs.size(); ++i)
  {
    if (this->Progress && !this->Progress(static_cast<double>(i) / static_cast<double>(this->Arcs.size())))
    {
      return false;
    }
    if (graph.Arcs[this->Arcs[i]].IsDependency())
    {
      continue;
    }
    if (!source.ReadPatch(this->Arcs[i], this->Arrays, patch, error))
    {
      return false;
    }
    if (!assembler.Add(patch))
    {
      error = "patch " + std::to_string(this->Arcs[i]) + ": " + assembler.GetError();
      return false;
    }
  }
  vtkMTPatch mesh = assembler.TakeMesh();
  this->AddUnknown(graph, mesh);
  if (!vtkMTMeshToPolyData::Convert(mesh, graph.Lattice, graph.Arrays, output))
  {
    error = source.GetName() + ": the exact points are farther from the lattice than the model's largest shift";
    return false;
  }
  if (this->Placement)
  {
    this->Placement->Apply(output);
  }
  if (this->GenerateDistances)
  {
    this->AddDistances(graph, output);
  }
  if (wedgePoints)
  {
    wedgePoints->resize(mesh.GetNumberOfWedges());
    for (std::uint32_t w = 0; w < wedgePoints->size(); ++w)
    {
      (*wedgePoints)[w] = mesh.GetPointOfWedge(w);
    }
  }
  return true;
}

//------------------------------------------------------------------------------
// Where none of the patches is of the finest level, an array that only that level has is there all the same.
void vtkMTCutMesh::AddUnknown(const vtkMTGraph& graph, vtkMTPatch& mesh) const
{
  std::size_t next[2] = { 0, 0 };
  for (std::size_t i = 0; i < graph.Arrays.size(); ++i)
  {
    const vtkMTArrayInfo& array = graph.Arrays[i];
    const bool ofCells = array.Association == vtkMTArrayInfo::Cell;
    vtkMTColumn& column = (ofCells ? mesh.CellColumns : mesh.PointColumns)[next[ofCells]++];
    const bool isWanted = !this->Arrays || (*this->Arrays)[i];
    if (isWanted && array.IsFinestOnly() && array.Role != vtkMTArrayInfo::ExactPoints && column.empty())
    {
      column = array.MakeUnknown(ofCells ? mesh.Triangles.size() : mesh.GetNumberOfWedges());
    }
  }
}

//------------------------------------------------------------------------------
// The triangles of the arcs lie one after the other.
void vtkMTCutMesh::AddDistances(const vtkMTGraph& graph, vtkPolyData* output) const
{
  vtkNew<vtkDoubleArray> toInput;
  vtkNew<vtkDoubleArray> fromInput;
  toInput->SetName(DistanceToInputName);
  fromInput->SetName(DistanceFromInputName);
  toInput->SetNumberOfValues(output->GetNumberOfPolys());
  fromInput->SetNumberOfValues(output->GetNumberOfPolys());
  const double stretch = this->Placement ? this->Placement->GetStretch() : 1.0;
  vtkIdType cell = 0;
  for (const std::uint32_t arc : this->Arcs)
  {
    const double to = graph.GetDistanceToInput(arc) * stretch;
    const double from = graph.GetDistanceFromInput(arc) * stretch;
    for (const vtkIdType end = cell + graph.Arcs[arc].Triangles; cell < end; ++cell)
    {
      toInput->SetValue(cell, to);
      fromInput->SetValue(cell, from);
    }
  }
  output->GetCellData()->AddArray(toInput);
  output->GetCellData()->AddArray(fromInput);
}
