// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTFinishGraph.h"

#include "vtkMTBuildState.h"
#include "vtkMTPatchSink.h"
#include "vtkMTRelease.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace
{
// Gives the node of every record.
std::vector<std::uint32_t> MakeNodes(const std::vector<vtkMTBuildState::NodeRecord>& records, vtkMTGraph& graph)
{
  std::vector<std::uint32_t> order(records.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
    [&records](std::uint32_t a, std::uint32_t b) { return records[a].Level > records[b].Level; });
  std::vector<std::uint32_t> nodeOf(order.size());
  graph.Nodes.assign(order.size() + 2, vtkMTNode());
  graph.Nodes[0].Level = (records.empty() ? 0 : records[order[0]].Level) + 1;
  const double step = graph.Lattice.Step;
  vtkMTMeasure largest{ vtkMTMeasure::NormalDeviation, std::vector<double>(graph.Nodes.size(), 0.0) };
  vtkMTMeasure mean{ vtkMTMeasure::MeanNormalDeviation, largest.Values };
  for (std::uint32_t i = 0; i < order.size(); ++i)
  {
    const vtkMTBuildState::NodeRecord& record = records[order[i]];
    vtkMTNode& node = graph.Nodes[i + 1];
    node.Level = record.Level;
    node.Region = record.Region;
    node.OwnError =
      record.Error > 0.0 ? std::nextafter(record.Error * step, std::numeric_limits<double>::infinity()) : 0.0;
    node.EdgeLength = record.EdgeLength * step;
    largest.Values[i + 1] = record.NormalDeviation;
    mean.Values[i + 1] = record.MeanNormalDeviation;
    nodeOf[order[i]] = i + 1;
  }
  if (!records.empty() && records[0].NormalDeviation >= 0.0)
  {
    graph.Measures.push_back(std::move(largest));
    graph.Measures.push_back(std::move(mean));
  }
  return nodeOf;
}

// No two values differ by more than the range of all. What is not certified, as a value that is no number, has the
// largest number there is.
void AddValueMeasures(const vtkMTBuildState& state, const std::vector<std::uint32_t>& nodeOf, vtkMTGraph& graph)
{
  constexpr double most = std::numeric_limits<double>::max();
  const std::size_t arrays = state.CertifiedArrays.size();
  for (std::size_t a = 0; a < arrays; ++a)
  {
    vtkMTMeasure measure{ vtkMTMeasure::GetValueDeviationName(state.CertifiedArrays[a]),
      std::vector<double>(graph.Nodes.size(), 0.0) };
    for (std::size_t node = 0; node < nodeOf.size(); ++node)
    {
      const double deviation = state.NodeValueDeviations[node * arrays + a];
      const double range = state.CertifiedRanges[a].Maximum - state.CertifiedRanges[a].Minimum;
      measure.Values[nodeOf[node]] = deviation < range ? deviation : (std::isfinite(deviation) ? range : most);
    }
    graph.Measures.push_back(std::move(measure));
  }
}
}

bool vtkMTFinishGraph::Run(vtkMTBuildState& state, vtkMTPatchSink& sink, std::string& error)
{
  vtkMTGraph& graph = state.Graph;
  const std::vector<std::uint32_t> nodeOf = MakeNodes(state.Nodes, graph);
  AddValueMeasures(state, nodeOf, graph);
  graph.Arcs.reserve(state.Arcs.size());
  for (const vtkMTBuildState::ArcRecord& record : state.Arcs)
  {
    vtkMTArc arc = record.Arc;
    arc.From = record.FromNode == vtkMTBuildState::None ? 0 : nodeOf[record.FromNode];
    arc.To = record.ToNode == vtkMTBuildState::None ? graph.GetSink() : nodeOf[record.ToNode];
    graph.Arcs.push_back(arc);
  }
  vtkMTRelease(state.Nodes);
  vtkMTRelease(state.Arcs);
  const std::vector<std::uint32_t> patchOfArc = graph.Index();
  graph.Saturate(graph.Lattice.MaximumShift);
  const bool finished = sink.Finish(graph, patchOfArc);
  error = finished ? error : sink.GetError();
  return finished;
}
