// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTCut.h"

#include "vtkMTGraph.h"

#include <algorithm>

//------------------------------------------------------------------------------
vtkMTCut::vtkMTCut(const vtkMTGraph& graph)
  : Graph(&graph)
  , Refined(graph.Nodes.size(), 0)
{
  if (!graph.Nodes.empty())
  {
    const std::uint32_t source = graph.GetSource();
    this->Refined[source] = 1;
    this->Triangles = graph.GetNumberOfRootTriangles();
    this->ArcCount = graph.Nodes[source].OutCount;
  }
}

//------------------------------------------------------------------------------
bool vtkMTCut::Contains(std::uint32_t arc) const
{
  const vtkMTArc& a = this->Graph->Arcs[arc];
  return this->Refined[a.From] && (!this->Refined[a.To] || this->Graph->Refinement == vtkMTGraph::Add);
}

//------------------------------------------------------------------------------
bool vtkMTCut::CanRefine(std::uint32_t node) const
{
  if (this->Refined[node] || !this->Graph->IsRefinable(node))
  {
    return false;
  }
  const vtkMTArcList entering = this->Graph->GetEntering(node);
  return std::all_of(entering.begin(), entering.end(),
    [this](std::uint32_t arc) { return this->Refined[this->Graph->Arcs[arc].From] != 0; });
}

//------------------------------------------------------------------------------
bool vtkMTCut::Refine(std::uint32_t node)
{
  if (!this->CanRefine(node))
  {
    return false;
  }
  const vtkMTNode& n = this->Graph->Nodes[node];
  const vtkMTArcList replaced = this->Graph->GetReplaced(node);
  for (const std::uint32_t arc : replaced)
  {
    this->Triangles -= this->Graph->Arcs[arc].Triangles;
  }
  for (std::uint32_t i = 0; i < n.OutCount; ++i)
  {
    this->Triangles += this->Graph->Arcs[n.FirstOut + i].Triangles;
  }
  this->ArcCount = this->ArcCount - replaced.size() + n.OutCount;
  this->Refined[node] = 1;
  return true;
}

//------------------------------------------------------------------------------
std::size_t vtkMTCut::RefineWithDependencies(std::uint32_t node)
{
  std::size_t refined = 0;
  if (!this->Graph->IsRefinable(node))
  {
    return refined;
  }
  std::vector<std::uint32_t> stack{ node };
  while (!stack.empty())
  {
    const std::uint32_t top = stack.back();
    const std::size_t depth = stack.size();
    for (const std::uint32_t arc : this->Graph->GetEntering(top))
    {
      const std::uint32_t coarser = this->Graph->Arcs[arc].From;
      if (!this->Refined[top] && !this->Refined[coarser])
      {
        stack.push_back(coarser);
      }
    }
    if (stack.size() == depth)
    {
      refined += this->Refine(top) ? 1 : 0;
      stack.pop_back();
    }
  }
  return refined;
}

//------------------------------------------------------------------------------
bool vtkMTCut::CanCoarsen(std::uint32_t node) const
{
  if (!this->Refined[node] || node == this->Graph->GetSource())
  {
    return false;
  }
  const vtkMTNode& n = this->Graph->Nodes[node];
  for (std::uint32_t i = 0; i < n.OutCount; ++i)
  {
    if (this->Refined[this->Graph->Arcs[n.FirstOut + i].To])
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkMTCut::Coarsen(std::uint32_t node)
{
  if (!this->CanCoarsen(node))
  {
    return false;
  }
  const vtkMTNode& n = this->Graph->Nodes[node];
  const vtkMTArcList replaced = this->Graph->GetReplaced(node);
  for (const std::uint32_t arc : replaced)
  {
    this->Triangles += this->Graph->Arcs[arc].Triangles;
  }
  for (std::uint32_t i = 0; i < n.OutCount; ++i)
  {
    this->Triangles -= this->Graph->Arcs[n.FirstOut + i].Triangles;
  }
  this->ArcCount = this->ArcCount + replaced.size() - n.OutCount;
  this->Refined[node] = 0;
  return true;
}

//------------------------------------------------------------------------------
std::vector<std::uint32_t> vtkMTCut::GetArcs() const
{
  std::vector<std::uint32_t> arcs;
  arcs.reserve(this->ArcCount);
  for (std::uint32_t node = 0; node < this->Refined.size(); ++node)
  {
    if (!this->Refined[node])
    {
      continue; // what is not known is not looked at
    }
    const vtkMTNode& n = this->Graph->Nodes[node];
    for (std::uint32_t arc = n.FirstOut; arc < n.FirstOut + n.OutCount; ++arc)
    {
      if (this->Contains(arc))
      {
        arcs.push_back(arc);
      }
    }
  }
  return arcs;
}

//------------------------------------------------------------------------------
double vtkMTCut::GetDistanceToInput() const
{
  double distance = 0.0;
  for (const std::uint32_t arc : this->GetArcs())
  {
    distance = std::max(distance, this->Graph->GetDistanceToInput(arc));
  }
  return distance;
}

//------------------------------------------------------------------------------
double vtkMTCut::GetDistanceFromInput() const
{
  double distance = 0.0;
  for (const std::uint32_t arc : this->GetArcs())
  {
    distance = std::max(distance, this->Graph->GetDistanceFromInput(arc));
  }
  return distance;
}

//------------------------------------------------------------------------------
double vtkMTCut::GetError() const
{
  double error = 0.0;
  for (std::uint32_t arc : this->GetArcs())
  {
    const std::uint32_t to = this->Graph->Arcs[arc].To;
    error = this->Refined[to] ? error : std::max(error, this->Graph->Nodes[to].Error);
  }
  return error;
}
