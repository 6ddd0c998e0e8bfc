// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTFinishStep.h"

#include "vtkMTPartitionStrategy.h"
#include "vtkMTRelease.h"
#include "vtkMTSimplifier.h"

#include <algorithm>
#include <cmath>
#include <limits>

bool vtkMTFinishStep::Run()
{
  const vtkMTStageTimes::Scope write(this->Options.Times, vtkMTStageTimes::Write);
  return this->WriteRoots() && this->FinishGraph();
}

bool vtkMTFinishStep::WriteRoots()
{
  for (std::size_t f = 0; f < this->State.NodeOfFragment.size(); ++f)
  {
    vtkMTPatch mesh;
    PatchToWrite patch;
    bool isEmpty = false;
    if (!this->TakeFragment(f, mesh, isEmpty, this->Error))
    {
      return false;
    }
    if (!isEmpty &&
      (!this->PreparePatch(std::move(mesh), patch, this->Error) ||
        !this->WritePatch(std::move(patch), vtkMTBuildState::None, this->State.NodeOfFragment[f], this->Error)))
    {
      return false;
    }
  }
  return true;
}

// Nodes from coarse to fine between source and sink, then everything that follows from them.
bool vtkMTFinishStep::FinishGraph()
{
  vtkMTGraph& graph = this->State.Graph;
  std::vector<std::uint32_t> order(this->State.Nodes.size());
  for (std::uint32_t i = 0; i < order.size(); ++i)
  {
    order[i] = i;
  }
  const auto& nodes = this->State.Nodes;
  std::stable_sort(
    order.begin(), order.end(), [&nodes](std::uint32_t a, std::uint32_t b) { return nodes[a].Level > nodes[b].Level; });
  std::vector<std::uint32_t> place(order.size());
  graph.Nodes.assign(order.size() + 2, vtkMTNode());
  graph.Nodes[0].Level = (nodes.empty() ? 0 : nodes[order[0]].Level) + 1;
  const double step = graph.Lattice.Step;
  for (std::uint32_t i = 0; i < order.size(); ++i)
  {
    const vtkMTBuildState::NodeRecord& record = nodes[order[i]];
    vtkMTNode& node = graph.Nodes[i + 1];
    node.Level = record.Level;
    node.Region = record.Region;
    node.OwnError =
      record.Error > 0.0 ? std::nextafter(record.Error * step, std::numeric_limits<double>::infinity()) : 0.0;
    node.EdgeLength = record.EdgeLength * step;
    place[order[i]] = i + 1;
  }
  graph.Arcs.reserve(this->State.Arcs.size());
  for (const vtkMTBuildState::ArcRecord& record : this->State.Arcs)
  {
    vtkMTArc arc = record.Arc;
    arc.From = record.FromNode == vtkMTBuildState::None ? 0 : place[record.FromNode];
    arc.To = record.ToNode == vtkMTBuildState::None ? graph.GetSink() : place[record.ToNode];
    graph.Arcs.push_back(arc);
  }
  vtkMTRelease(this->State.Arcs);
  const std::vector<std::uint32_t> patchOfArc = graph.Index();
  graph.Saturate(graph.Lattice.MaximumShift);
  graph.Settings["partition"] = this->Options.Partition->GetSettings();
  graph.Settings["simplifier"] = this->Options.Simplifier->GetSettings();
  graph.Settings["patch_triangles"] = std::to_string(this->Options.PatchTriangles);
  if (this->Options.KeepFarOutliers)
  {
    graph.Settings["far_outliers"] = "kept";
  }
  constexpr int reduction = 2; // a region's floor has so many times the triangles of its fragment
  graph.Settings["reduction"] = std::to_string(reduction);
  graph.Settings["floor_triangles"] = std::to_string(std::llround(reduction * this->Options.GetRegionTarget()));
  return this->Sink.Finish(graph, patchOfArc) || this->Fail(this->Sink.GetError());
}
