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
  return this->Refined[a.From] && !this->Refined[a.To];
}

//------------------------------------------------------------------------------
bool vtkMTCut::CanRefine(std::uint32_t node) const
{
  if (this->Refined[node] || node == this->Graph->GetSink())
  {
    return false;
  }
  const vtkMTNode& n = this->Graph->Nodes[node];
  for (std::uint32_t i = 0; i < n.InCount; ++i)
  {
    if (!this->Refined[this->Graph->Arcs[this->Graph->Entering[n.FirstIn + i]].From])
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkMTCut::Refine(std::uint32_t node)
{
  if (!this->CanRefine(node))
  {
    return false;
  }
  const vtkMTNode& n = this->Graph->Nodes[node];
  for (std::uint32_t i = 0; i < n.InCount; ++i)
  {
    this->Triangles -= this->Graph->Arcs[this->Graph->Entering[n.FirstIn + i]].Triangles;
  }
  for (std::uint32_t i = 0; i < n.OutCount; ++i)
  {
    this->Triangles += this->Graph->Arcs[n.FirstOut + i].Triangles;
  }
  this->ArcCount = this->ArcCount - n.InCount + n.OutCount;
  this->Refined[node] = 1;
  return true;
}

//------------------------------------------------------------------------------
std::size_t vtkMTCut::RefineWithDependencies(std::uint32_t node)
{
  std::size_t refined = 0;
  if (node == this->Graph->GetSink())
  {
    return refined;
  }
  std::vector<std::uint32_t> stack{ node };
  while (!stack.empty())
  {
    const std::uint32_t top = stack.back();
    const std::size_t depth = stack.size();
    const vtkMTNode& n = this->Graph->Nodes[top];
    for (std::uint32_t i = 0; i < n.InCount && !this->Refined[top]; ++i)
    {
      const std::uint32_t coarser = this->Graph->Arcs[this->Graph->Entering[n.FirstIn + i]].From;
      if (!this->Refined[coarser])
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
  for (std::uint32_t i = 0; i < n.InCount; ++i)
  {
    this->Triangles += this->Graph->Arcs[this->Graph->Entering[n.FirstIn + i]].Triangles;
  }
  for (std::uint32_t i = 0; i < n.OutCount; ++i)
  {
    this->Triangles -= this->Graph->Arcs[n.FirstOut + i].Triangles;
  }
  this->ArcCount = this->ArcCount + n.InCount - n.OutCount;
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
    const vtkMTNode& n = this->Graph->Nodes[node];
    for (std::uint32_t i = 0; this->Refined[node] && i < n.OutCount; ++i)
    {
      if (!this->Refined[this->Graph->Arcs[n.FirstOut + i].To])
      {
        arcs.push_back(n.FirstOut + i);
      }
    }
  }
  return arcs;
}

//------------------------------------------------------------------------------
double vtkMTCut::GetError() const
{
  double error = 0.0;
  for (std::uint32_t arc : this->GetArcs())
  {
    error = std::max(error, this->Graph->Nodes[this->Graph->Arcs[arc].To].Error);
  }
  return error;
}
