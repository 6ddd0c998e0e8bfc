// SPDX-License-Identifier: BSD-3-Clause
#include "MTStiffStudy.h"

#include "MTStiffLevels.h"

#include "vtkMTPatchStore.h"
#include "vtkMTPolyDataStream.h"
#include "vtkMultiTriangulationBuilder.h"
#include "vtkMultiTriangulationVerifier.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkType.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <ctime>
#include <limits>

namespace
{
template <class Value>
bool AreValuesFinite(const vtkMTColumn& column)
{
  for (std::size_t i = 0; i + sizeof(Value) <= column.size(); i += sizeof(Value))
  {
    Value value;
    std::memcpy(&value, column.data() + i, sizeof(Value));
    if (!std::isfinite(value))
    {
      return false;
    }
  }
  return true;
}

bool IsGraphFinite(const vtkMTGraph& graph)
{
  bool isFinite = std::isfinite(graph.Lattice.Step) && std::isfinite(graph.Lattice.MaximumShift);
  for (const vtkMTNode& node : graph.Nodes)
  {
    isFinite = isFinite && std::isfinite(node.Error) && std::isfinite(node.OwnError) &&
      std::isfinite(node.EdgeLength) && std::isfinite(node.Radius) && std::isfinite(node.Center[0]) &&
      std::isfinite(node.Center[1]) && std::isfinite(node.Center[2]);
  }
  for (const vtkMTArc& arc : graph.Arcs)
  {
    isFinite = isFinite && std::isfinite(arc.MeanEdgeLength) && std::isfinite(arc.ConeCosine) &&
      std::isfinite(arc.ConeAxis[0]) && std::isfinite(arc.ConeAxis[1]) && std::isfinite(arc.ConeAxis[2]);
  }
  return isFinite;
}

// Arrays of the input are none in these meshes: what there is was made, normals above all.
bool IsFinite(const vtkMTPatchStore& store)
{
  const vtkMTGraph& graph = store.GetGraph();
  bool isFinite = IsGraphFinite(graph);
  for (std::uint32_t arc = 0; arc < graph.Arcs.size() && isFinite; ++arc)
  {
    vtkMTPatch patch;
    std::string error;
    isFinite = store.ReadPatch(arc, nullptr, patch, error);
    std::size_t column = 0;
    for (const vtkMTArrayInfo& array : graph.Arrays)
    {
      if (array.Association != vtkMTArrayInfo::Point || column >= patch.PointColumns.size())
      {
        continue;
      }
      const vtkMTColumn& values = patch.PointColumns[column++];
      isFinite = isFinite && (array.Type != VTK_FLOAT || AreValuesFinite<float>(values)) &&
        (array.Type != VTK_DOUBLE || AreValuesFinite<double>(values));
    }
  }
  return isFinite;
}

void Verify(vtkPolyData* input, const vtkMTPatchStore& store, const MTStiffStudy::Settings& settings,
  MTStiffStudy::Result& result)
{
  vtkNew<vtkMultiTriangulationVerifier> verifier;
  verifier->SetNumberOfCuts(settings.Cuts);
  verifier->SetNumberOfSamples(settings.Samples);
  const bool isRun =
    verifier->Verify(store, [input](std::string&) { return std::make_unique<vtkMTPolyDataStream>(input); });
  result.IsValid = isRun && verifier->IsValid();
  result.Violation = verifier->GetErrorMessage();
  const auto* messages = vtkStringArray::SafeDownCast(verifier->GetChecks()->GetColumnByName("message"));
  for (vtkIdType i = 0; messages && i < messages->GetNumberOfValues() && result.Violation.empty(); ++i)
  {
    result.Violation = const_cast<vtkStringArray*>(messages)->GetValue(i);
  }
}

// Scaled by a power of two: the same, but that denormals have fewer digits.
bool IsScaled(double value, double scale, double scaled)
{
  const double expected = value * scale;
  return scaled == expected ||
    (expected < std::numeric_limits<double>::min() &&
      std::abs(scaled - expected) <= std::numeric_limits<double>::denorm_min());
}

double GetMedianError(const vtkMTGraph& graph, std::uint32_t level)
{
  std::vector<double> errors;
  for (const vtkMTNode& node : graph.Nodes)
  {
    if (node.Level == level)
    {
      errors.push_back(node.Error);
    }
  }
  std::sort(errors.begin(), errors.end());
  return errors.empty() ? 0.0 : errors[errors.size() / 2];
}
}

//------------------------------------------------------------------------------
bool MTStiffStudy::Build(vtkPolyData* input, const Settings& settings, vtkMTPatchStore& store, std::string& error)
{
  vtkNew<vtkMultiTriangulationBuilder> builder;
  builder->SetPatchTriangles(settings.PatchTriangles);
  builder->SetLatticeBits(settings.LatticeBits);
  builder->SetDirectLevels(settings.DirectLevels);
  builder->SetNumberOfThreads(1);
  vtkMTPolyDataStream stream(input);
  const bool isBuilt = builder->Build(stream, store);
  error = isBuilt ? std::string() : builder->GetErrorMessage();
  return isBuilt;
}

//------------------------------------------------------------------------------
MTStiffStudy::Result MTStiffStudy::Run(vtkPolyData* input, const Settings& settings)
{
  Result result;
  vtkMTPatchStore store;
  const std::clock_t start = std::clock();
  const bool isBuilt = Build(input, settings, store, result.Error);
  result.CpuSeconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  if (!isBuilt)
  {
    return result;
  }
  const vtkMTGraph& graph = store.GetGraph();
  result.InputTriangles = static_cast<std::uint64_t>(input->GetNumberOfPolys());
  result.Step = graph.Lattice.Step;
  result.RootTriangles = graph.IsEmpty() ? 0 : graph.GetNumberOfRootTriangles();
  result.IsFinite = IsFinite(store);
  for (std::size_t n = 1; n + 1 < graph.Nodes.size(); ++n)
  {
    result.LargestOwnError = std::max(result.LargestOwnError, graph.Nodes[n].OwnError);
  }
  if (settings.IsVerified)
  {
    Verify(input, store, settings, result);
  }
  result.IsSearched = result.InputTriangles <= settings.SearchTriangles;
  const MTStiffLevels levels(input, store, settings.Climbs, result.IsSearched);
  result.Diagonal = levels.GetDiagonal();
  for (std::uint32_t level = 0; !graph.IsEmpty() && level < graph.GetNumberOfLevels(); ++level)
  {
    result.Levels.push_back(levels.Measure(level, settings.Pairs));
    result.Levels.back().MedianError = GetMedianError(graph, level);
  }
  return result;
}

//------------------------------------------------------------------------------
std::string MTStiffStudy::CompareScaled(const vtkMTPatchStore& store, const vtkMTPatchStore& scaled, double scale)
{
  const vtkMTGraph& a = store.GetGraph();
  const vtkMTGraph& b = scaled.GetGraph();
  if (a.Nodes.size() != b.Nodes.size() || a.Arcs.size() != b.Arcs.size())
  {
    return std::to_string(b.Nodes.size()) + " nodes in place of " + std::to_string(a.Nodes.size());
  }
  for (std::size_t n = 0; n < a.Nodes.size(); ++n)
  {
    if (!IsScaled(a.Nodes[n].OwnError, scale, b.Nodes[n].OwnError) ||
      !IsScaled(a.Nodes[n].Error, scale, b.Nodes[n].Error) || a.Nodes[n].Level != b.Nodes[n].Level)
    {
      return "node " + std::to_string(n);
    }
  }
  for (std::uint32_t arc = 0; arc < a.Arcs.size(); ++arc)
  {
    vtkMTPatch x;
    vtkMTPatch y;
    std::string error;
    if (a.Arcs[arc].From != b.Arcs[arc].From || a.Arcs[arc].To != b.Arcs[arc].To ||
      !store.ReadPatch(arc, nullptr, x, error) || !scaled.ReadPatch(arc, nullptr, y, error) ||
      x.Triangles != y.Triangles || x.Ids != y.Ids || x.Points != y.Points)
    {
      return "patch " + std::to_string(arc);
    }
  }
  return std::string();
}

//------------------------------------------------------------------------------
double MTStiffStudy::CompareErrors(const Result& a, const Result& b)
{
  const double least = 10.0 * std::max(a.Step, b.Step);
  double largest = 1.0;
  for (std::size_t level = 1; level < std::min(a.Levels.size(), b.Levels.size()); ++level)
  {
    const double x = std::max(a.Levels[level].MedianError, least);
    const double y = std::max(b.Levels[level].MedianError, least);
    largest = std::max({ largest, x / y, y / x });
  }
  return largest;
}

//------------------------------------------------------------------------------
double MTStiffStudy::Result::GetViolation() const
{
  double largest = 0.0;
  for (const Level& level : this->Levels)
  {
    largest = std::max({ largest, level.ViolatedPatch, level.ViolatedCut });
  }
  return largest;
}

//------------------------------------------------------------------------------
double MTStiffStudy::Result::GetLooseness() const
{
  double largest = 0.0;
  for (const Level& level : this->Levels)
  {
    largest = std::max(largest, level.Certified / std::max(level.Found, 10.0 * this->Step));
  }
  return largest;
}

//------------------------------------------------------------------------------
double MTStiffStudy::Result::GetOwnLooseness() const
{
  double largest = 0.0;
  for (const Level& level : this->Levels)
  {
    largest = std::max(largest, level.OwnDistance / std::max(level.Found, 10.0 * this->Step));
  }
  return largest;
}

//------------------------------------------------------------------------------
double MTStiffStudy::Result::GetFlippedShare() const
{
  double largest = 0.0;
  for (const Level& level : this->Levels)
  {
    largest = level.Triangles > 0
      ? std::max(largest, static_cast<double>(level.Flipped) / static_cast<double>(level.Triangles))
      : largest;
  }
  return largest;
}

//------------------------------------------------------------------------------
std::int64_t MTStiffStudy::Result::GetMadeIntersections() const
{
  std::int64_t largest = 0;
  for (const Level& level : this->Levels)
  {
    if (level.Topology.Intersections < 0)
    {
      return -1;
    }
    largest = std::max(largest, level.Topology.Intersections - this->Levels[0].Topology.Intersections);
  }
  return largest;
}

//------------------------------------------------------------------------------
bool MTStiffStudy::Result::KeepsComponents() const
{
  return std::all_of(this->Levels.begin(), this->Levels.end(),
    [this](const Level& level) { return level.Topology.Components == this->Levels[0].Topology.Components; });
}

//------------------------------------------------------------------------------
bool MTStiffStudy::Result::KeepsEuler() const
{
  return std::all_of(this->Levels.begin(), this->Levels.end(),
    [this](const Level& level) { return level.Topology.Euler == this->Levels[0].Topology.Euler; });
}

//------------------------------------------------------------------------------
double MTStiffStudy::Result::GetCoarsestShare() const
{
  return this->Levels.empty() || this->Diagonal <= 0.0 ? 0.0 : this->Levels.back().Found / this->Diagonal;
}
