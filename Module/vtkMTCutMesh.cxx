// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTCutMesh.h"

#include "vtkMTAssembler.h"
#include "vtkMTGraph.h"
#include "vtkMTMeshToPolyData.h"
#include "vtkMTPatchSource.h"
#include "vtkMTPlacement.h"

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
  const vtkMTPatch& mesh = assembler.GetMesh();
  if (!vtkMTMeshToPolyData::Convert(mesh, graph.Lattice, graph.Arrays, output))
  {
    error = source.GetName() + ": the exact points are farther from the lattice than the model's largest shift";
    return false;
  }
  if (this->Placement)
  {
    this->Placement->Apply(output);
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
