// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTRegionCut.h"

#include "vtkMTGraph.h"

#include <algorithm>

//------------------------------------------------------------------------------
vtkMTRegionCut::vtkMTRegionCut(const vtkMTGraph& graph, const Want& want, std::uint64_t triangleLimit)
  : Graph(graph)
  , GetWant(want)
  , TriangleLimit(triangleLimit)
  , Cut(graph)
  , Marks(graph.Nodes.size(), 0)
{
}

//------------------------------------------------------------------------------
vtkMTCut vtkMTRegionCut::Find(const vtkMTGraph& graph, const Want& want, std::uint64_t triangleLimit)
{
  vtkMTRegionCut search(graph, want, triangleLimit);
  if (!graph.IsEmpty())
  {
    search.Run();
  }
  return std::move(search.Cut);
}

//------------------------------------------------------------------------------
void vtkMTRegionCut::Enter(std::uint32_t node)
{
  const vtkMTNode& record = this->Graph.Nodes[node];
  for (std::uint32_t arc = record.FirstOut; arc < record.FirstOut + record.OutCount; ++arc)
  {
    const std::uint32_t to = this->Graph.Arcs[arc].To;
    const double want = to != this->Graph.GetSink() && !this->Cut.IsRefined(to) ? this->GetWant(arc) : -1.0;
    if (want >= 0.0)
    {
      this->Heap.push({ want, to });
    }
  }
}

//------------------------------------------------------------------------------
void vtkMTRegionCut::FindClosure(std::uint32_t node)
{
  this->Closure.assign(1, node);
  this->Marks[node] = 1;
  for (std::size_t i = 0; i < this->Closure.size(); ++i)
  {
    const vtkMTNode& record = this->Graph.Nodes[this->Closure[i]];
    for (std::uint32_t k = record.FirstIn; k < record.FirstIn + record.InCount; ++k)
    {
      const std::uint32_t from = this->Graph.Arcs[this->Graph.Entering[k]].From;
      if (!this->Marks[from] && !this->Cut.IsRefined(from))
      {
        this->Marks[from] = 1;
        this->Closure.push_back(from);
      }
    }
  }
  std::sort(this->Closure.begin(), this->Closure.end());
}

//------------------------------------------------------------------------------
// Whether refining the closure keeps to the limit, or takes triangles away.
bool vtkMTRegionCut::Fits() const
{
  std::uint64_t triangles = this->Cut.GetNumberOfTriangles();
  for (const std::uint32_t node : this->Closure)
  {
    const vtkMTNode& record = this->Graph.Nodes[node];
    for (std::uint32_t arc = record.FirstOut; arc < record.FirstOut + record.OutCount; ++arc)
    {
      triangles += this->Marks[this->Graph.Arcs[arc].To] ? 0 : this->Graph.Arcs[arc].Triangles;
    }
  }
  for (const std::uint32_t node : this->Closure)
  {
    const vtkMTNode& record = this->Graph.Nodes[node];
    for (std::uint32_t k = record.FirstIn; k < record.FirstIn + record.InCount; ++k)
    {
      const vtkMTArc& arc = this->Graph.Arcs[this->Graph.Entering[k]];
      triangles -= this->Marks[arc.From] ? 0 : arc.Triangles;
    }
  }
  return triangles <= std::max(this->TriangleLimit, this->Cut.GetNumberOfTriangles());
}

//------------------------------------------------------------------------------
void vtkMTRegionCut::Run()
{
  this->Enter(this->Graph.GetSource());
  bool changed = true;
  while (changed)
  {
    changed = false;
    while (!this->Heap.empty())
    {
      const Candidate candidate = this->Heap.top();
      this->Heap.pop();
      if (this->Cut.IsRefined(candidate.Node))
      {
        continue;
      }
      this->FindClosure(candidate.Node);
      const bool fits = this->TriangleLimit == 0 || this->Fits();
      for (const std::uint32_t node : this->Closure)
      {
        this->Marks[node] = 0;
      }
      if (!fits)
      {
        this->Postponed.push_back(candidate);
        continue;
      }
      changed = true;
      for (const std::uint32_t node : this->Closure)
      {
        this->Cut.Refine(node);
      }
      // Only now: what leads from one node of the closure to another is not in the cut.
      for (const std::uint32_t node : this->Closure)
      {
        this->Enter(node);
      }
    }
    changed = changed && !this->Postponed.empty();
    for (const Candidate& candidate : this->Postponed)
    {
      this->Heap.push(candidate);
    }
    this->Postponed.clear();
  }
}
