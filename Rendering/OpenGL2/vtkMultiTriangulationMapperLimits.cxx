// SPDX-License-Identifier: BSD-3-Clause
// vtkMultiTriangulationMapper: how many triangles a frame may have.
#include "vtkActor.h"
#include "vtkMTCut.h"
#include "vtkMultiTriangulationMapper.h"
#include "vtkMultiTriangulationMapperInternals.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
constexpr std::uint64_t Unlimited = std::numeric_limits<std::uint64_t>::max();

// A rate is not learnt from frames of so few triangles: they say what the window costs.
constexpr vtkIdType FewTriangles = 1000;

// Four steps to the double, downwards, so that a rate that flickers gives the same cut.
double RoundDown(double x)
{
  return x > 1.0 ? std::exp2(std::floor(4.0 * std::log2(x)) / 4.0) : x;
}
}

//------------------------------------------------------------------------------
double vtkMultiTriangulationMapper::GetCurrentDrawingRate()
{
  return this->DrawingRate > 0.0 ? this->DrawingRate : this->Implementation->MeasuredRate;
}

//------------------------------------------------------------------------------
// The limit of this frame; 0 is none.
std::uint64_t vtkMultiTriangulationMapper::GetTriangleLimitOfFrame(vtkActor* actor)
{
  const std::uint64_t budget = this->TriangleLimit > 0 ? static_cast<std::uint64_t>(this->TriangleLimit) : Unlimited;
  const std::uint64_t retry = this->Implementation->LessTriangles > 0 ? this->Implementation->LessTriangles : Unlimited;
  const std::uint64_t least = std::min({ budget, retry, this->GetTrianglesOfTime(actor->GetAllocatedRenderTime()) });
  return least == Unlimited ? 0 : std::max<std::uint64_t>(least, 1);
}

//------------------------------------------------------------------------------
std::uint64_t vtkMultiTriangulationMapper::GetTrianglesOfTime(double seconds)
{
  const double rate = this->GetCurrentDrawingRate();
  const double triangles = this->DrawingRate > 0.0 ? rate * seconds : RoundDown(rate * seconds);
  // More than there are is no limit, lest a rate that flickers ask for a new cut.
  const bool limits = rate > 0.0 && triangles < static_cast<double>(this->Implementation->Triangles);
  return limits ? static_cast<std::uint64_t>(triangles) : Unlimited;
}

//------------------------------------------------------------------------------
// Bytes; never less than the coarsest cut takes.
std::uint64_t vtkMultiTriangulationMapper::GetGraphicsLimit()
{
  const Internals& self = *this->Implementation;
  const vtkMTGraph& graph = self.Graph();
  const vtkMTNode& source = graph.Nodes[graph.GetSource()];
  std::uint64_t vertices = 0;
  for (std::uint32_t i = 0; i < source.OutCount; ++i)
  {
    vertices += graph.Arcs[source.FirstOut + i].Wedges;
  }
  return std::max(static_cast<std::uint64_t>(this->GraphicsMemoryLimit),
    self.Arena.GetBytesOf(vertices, graph.GetNumberOfRootTriangles()));
}

//------------------------------------------------------------------------------
// In the first pass of a frame: the frame before is over, and what its passes took is known.
void vtkMultiTriangulationMapper::MeasureRate(vtkActor* actor)
{
  Internals& self = *this->Implementation;
  if (actor->GetEstimatedRenderTime() > 0.0)
  {
    return;
  }
  if (this->NumberOfTriangles > FewTriangles && self.DrawSeconds > 0.0)
  {
    const double rate = static_cast<double>(this->NumberOfTriangles) / self.DrawSeconds;
    self.MeasuredRate = self.MeasuredRate > 0.0 ? 0.75 * self.MeasuredRate + 0.25 * rate : rate;
  }
  self.DrawSeconds = 0.0;
}
