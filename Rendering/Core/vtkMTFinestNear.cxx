// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTFinestNear.h"

#include "vtkMTGraph.h"

#include <algorithm>
#include <cmath>

namespace
{
// Of distances that were computed by different ways.
constexpr double Rounding = 1e-9;
constexpr double CoordinateRounding = 1e-15;
}

vtkMTFinestNear::vtkMTFinestNear(const vtkMTGraph& graph)
  : Graph(graph)
  , Seen(graph.Nodes.size(), 0)
{
}

vtkMTFinestNear::Place vtkMTFinestNear::ToSteps(const vtkMTGraph& graph, const Place& x)
{
  Place steps;
  for (std::size_t i = 0; i < 3; ++i)
  {
    steps[i] = x[i] / graph.Lattice.Step - static_cast<double>(graph.Lattice.Origin[i]);
  }
  return steps;
}

double vtkMTFinestNear::GetDistance2(const std::array<std::int32_t, 6>& box, const Place& x)
{
  double square = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const double outside = std::max({ box[2 * i] - x[i], x[i] - box[2 * i + 1], 0.0 });
    square += outside * outside;
  }
  return square;
}

void vtkMTFinestNear::Begin(const Place& x)
{
  this->X = x;
  this->Steps = ToSteps(this->Graph, x);
  this->Heap.clear();
  if (++this->Turn == 0)
  {
    std::fill(this->Seen.begin(), this->Seen.end(), 0u);
    this->Turn = 1;
  }
  if (!this->Graph.IsEmpty())
  {
    this->Push(0.0, this->Graph.GetSource(), false);
  }
}

void vtkMTFinestNear::Push(double bound, std::uint32_t index, bool isArc)
{
  this->Heap.push_back({ bound, index, isArc });
  std::push_heap(this->Heap.begin(), this->Heap.end(), IsBehind);
}

void vtkMTFinestNear::Expand(std::uint32_t node)
{
  ++this->Nodes;
  const vtkMTNode& record = this->Graph.Nodes[node];
  for (std::uint32_t a = record.FirstOut; a < record.FirstOut + record.OutCount; ++a)
  {
    const vtkMTArc& arc = this->Graph.Arcs[a];
    if (this->Graph.IsFinest(a) && !arc.IsDependency())
    {
      this->Push(std::sqrt(GetDistance2(arc.Box, this->Steps)), a, true);
    }
    if (arc.To == this->Graph.GetSink() || this->Seen[arc.To] == this->Turn)
    {
      continue;
    }
    this->Seen[arc.To] = this->Turn;
    const vtkMTNode& below = this->Graph.Nodes[arc.To];
    double square = 0.0;
    double largest = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const double difference = (this->X[i] - below.Center[i]) / this->Graph.Lattice.Step;
      square += difference * difference;
      largest = std::max({ largest, std::abs(this->X[i]), std::abs(below.Center[i]) });
    }
    const double distance = std::sqrt(square);
    const double radius = below.Radius / this->Graph.Lattice.Step;
    const double slack = Rounding * (distance + radius) + CoordinateRounding * largest / this->Graph.Lattice.Step;
    this->Push(std::max(distance - radius - slack, 0.0), arc.To, false);
  }
}

bool vtkMTFinestNear::Next(double farthest, Found& found)
{
  while (!this->Heap.empty() && this->Heap.front().Bound * (1.0 - Rounding) <= farthest)
  {
    std::pop_heap(this->Heap.begin(), this->Heap.end(), IsBehind);
    const Entry entry = this->Heap.back();
    this->Heap.pop_back();
    if (entry.IsArc)
    {
      found = { entry.Bound, entry.Index };
      return true;
    }
    this->Expand(entry.Index);
  }
  return false;
}

vtkMTFinestNear::Neighbourhood::Neighbourhood(vtkMTFinestNear& near, const Place& x)
  : Near(near)
{
  near.Begin(x);
}
