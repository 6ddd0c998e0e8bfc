// SPDX-License-Identifier: BSD-3-Clause
// vtkMTTargetCut: cuts without a view, and what a view says about one arc.
#include "vtkMTTargetCut.h"

#include "vtkMTArcProjector.h"
#include "vtkMTArcViews.h"
#include "vtkMTGraph.h"

#include <algorithm>
#include <sstream>
#include <utility>

bool vtkMTTargetCut::ByTriangles(const vtkMTGraph& graph, std::uint64_t triangles, vtkMTCut& cut, std::string& message)
{
  if (triangles < graph.GetNumberOfRootTriangles())
  {
    message = "the coarsest cut has " + std::to_string(graph.GetNumberOfRootTriangles()) +
      " triangles, more than the " + std::to_string(triangles) + " asked for";
    return false;
  }
  Settings settings;
  settings.ModelError = -1.0;
  settings.TriangleLimit = std::max<std::uint64_t>(triangles, 1);
  Input input;
  input.Graph = &graph;
  cut = this->Extract(input, settings).Cut;
  return true;
}

bool vtkMTTargetCut::ByError(const vtkMTGraph& graph, double error, vtkMTCut& cut, std::string& message)
{
  Settings settings;
  settings.ModelError = error;
  Input input;
  input.Graph = &graph;
  Result result = this->Extract(input, settings);
  if (!(result.ModelError <= error))
  {
    std::ostringstream text;
    text << "the finest level has an error of " << result.ModelError << ", more than the " << error << " asked for";
    message = text.str();
    return false;
  }
  cut = std::move(result.Cut);
  return true;
}

bool vtkMTTargetCut::ByLevel(const vtkMTGraph& graph, std::uint32_t level, vtkMTCut& cut, std::string& message)
{
  if (level >= graph.GetNumberOfLevels())
  {
    message = "the model has " + std::to_string(graph.GetNumberOfLevels()) + " levels, there is no level " +
      std::to_string(level);
    return false;
  }
  cut = vtkMTCut(graph);
  for (std::uint32_t node = 1; node < graph.GetSink(); ++node)
  {
    if (graph.Nodes[node].Level > level)
    {
      cut.RefineWithDependencies(node);
    }
  }
  return true;
}

double vtkMTTargetCut::GetPixelError(
  const vtkMTGraph& graph, const vtkMTView& view, std::uint32_t arc, ErrorMetricType choice)
{
  Settings settings;
  settings.ErrorMetric = choice;
  return vtkMTTargetCut::GetPixelError(graph, view, arc, settings);
}

double vtkMTTargetCut::GetPixelError(
  const vtkMTGraph& graph, const vtkMTView& view, std::uint32_t arc, const Settings& settings)
{
  if (settings.ErrorMetric == NormalDeviation || settings.ErrorMetric == Value)
  {
    vtkMTArcViews views;
    views.Begin(graph, { view }, settings);
    return std::max(0.0, views.Look(arc).Wanted);
  }
  const vtkMTArcProjector projector(graph.Lattice, view);
  const vtkMTNode& node = graph.Nodes[graph.Arcs[arc].To];
  const vtkMTArcProjector::Depth depth = projector.GetDepth(vtkMTArcProjector::Box(graph.Arcs[arc].Box));
  return projector.GetPixelError(depth, settings.ErrorMetric == EdgeLength ? node.EdgeLength : node.Error);
}

bool vtkMTTargetCut::IsVisible(const vtkMTGraph& graph, const vtkMTView& view, std::uint32_t arc)
{
  return vtkMTArcProjector(graph.Lattice, view).IsVisible(vtkMTArcProjector::Box(graph.Arcs[arc].Box));
}
