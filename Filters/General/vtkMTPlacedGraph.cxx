// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPlacedGraph.h"

#include "vtkMTGraph.h"
#include "vtkMTPatchSource.h"
#include "vtkMTView.h"
#include "vtkMultiTriangulation.h"

//------------------------------------------------------------------------------
vtkMTPlacedGraph::vtkMTPlacedGraph(vtkMultiTriangulation& model)
  : Graph(&model.GetSource()->GetGraph())
{
  model.GetFrame(this->Placement.Matrix.data());
  this->Stretch = this->Placement.GetStretch();
}

//------------------------------------------------------------------------------
double vtkMTPlacedGraph::GetError(std::uint32_t arc) const
{
  return this->Graph->Nodes[this->Graph->Arcs[arc].To].Error * this->Stretch;
}

//------------------------------------------------------------------------------
double vtkMTPlacedGraph::GetDistanceToInput(std::uint32_t arc) const
{
  return this->Graph->GetDistanceToInput(arc) * this->Stretch;
}

//------------------------------------------------------------------------------
void vtkMTPlacedGraph::GetBox(std::uint32_t arc, double box[6]) const
{
  double own[6];
  this->Graph->Lattice.ToWorld(this->Graph->Arcs[arc].Box, own);
  this->Placement.ToObject(own, box);
}

//------------------------------------------------------------------------------
void vtkMTPlacedGraph::GetReach(std::uint32_t arc, double box[6]) const
{
  this->GetBox(arc, box);
  if (box[0] > box[1])
  {
    return; // a dependency without triangles stands for nothing
  }
  const double error = this->GetError(arc);
  for (int i = 0; i < 3; ++i)
  {
    box[2 * i] -= error;
    box[2 * i + 1] += error;
  }
}

//------------------------------------------------------------------------------
bool vtkMTPlacedGraph::CanBeSeen(const vtkMTView& view, std::uint32_t arc) const
{
  // Views are in the lattice's coordinates.
  const double error = this->Graph->Nodes[this->Graph->Arcs[arc].To].Error;
  double box[6];
  this->Graph->Lattice.ToWorld(this->Graph->Arcs[arc].Box, box);
  for (int i = 0; i < 3 && box[0] <= box[1]; ++i)
  {
    box[2 * i] -= error;
    box[2 * i + 1] += error;
  }
  return view.IsBoxVisible(box);
}
