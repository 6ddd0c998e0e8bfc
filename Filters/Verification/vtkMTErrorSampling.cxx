// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTErrorSampling.h"

#include "vtkMTCut.h"
#include "vtkMTGraph.h"
#include "vtkMTPatchSource.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace
{
constexpr std::size_t SamplesPerClimber = 400; // about, and at least one of each node

vtkMTMeasuringFrame MakeFrame(const vtkMTGraph& graph, const vtkMTSampledSurface& input)
{
  vtkMTRealBounds bounds = input.GetBounds();
  double model[6];
  graph.GetBounds(model);
  bounds.Add({ model[0], model[2], model[4] });
  bounds.Add({ model[1], model[3], model[5] });
  return vtkMTMeasuringFrame::FromBounds(bounds);
}

vtkMTSampledSurface LeaveOutFar(const vtkMTGraph& graph, vtkMTSampledSurface input)
{
  input.LeaveOutFar(graph);
  return input;
}

double GetLargestFromInput(const vtkMTGraph& graph, const std::vector<std::uint32_t>& arcs)
{
  double distance = 0.0;
  for (std::uint32_t arc : arcs)
  {
    distance = std::max(distance, graph.GetDistanceFromInput(arc));
  }
  return distance;
}

std::string Describe(const vtkMTRealPoint& x, const std::string& where)
{
  std::ostringstream text;
  text.precision(9);
  text << where << ", near (" << x[0] << ", " << x[1] << ", " << x[2] << ")";
  return text.str();
}
}

vtkMTErrorSampling::vtkMTErrorSampling(
  const vtkMTPatchSource& source, vtkMTSampledSurface input, std::size_t samples, std::uint64_t seed)
  : Source(source)
  , Input(LeaveOutFar(source.GetGraph(), std::move(input)))
  , Frame(MakeFrame(source.GetGraph(), this->Input))
  , Samples(samples)
  , Seed(seed)
  , NodeDistances(source.GetGraph().Nodes.size(), -1.0)
  , PatchToInput("certified_patch_to_input")
  , InputToCut("certified_input_to_cut")
{
  const auto& report = source.GetGraph().InputReport;
  const auto far = report.find("dropped_far_outlier");
  if (far != report.end() && far->second != this->Input.FarOutliers)
  {
    this->InputToCut.Fail("the model lacks " + std::to_string(far->second) + " far outliers, but " +
      std::to_string(this->Input.FarOutliers) + " triangles of the input lie far outside of it");
  }
  this->Input.Transform(this->Frame);
  this->InputSearch = std::make_unique<vtkMTClosestPoint>(this->Input);
  this->InputVertices = this->Input.GetUsedPoints();
  this->InputSamples = vtkMTSurfaceSampler(this->Input, this->Samples, this->Seed).Take(0, this->Samples);
  if (!this->Input.Slack.empty())
  {
    this->LargestSlack = *std::max_element(this->Input.Slack.begin(), this->Input.Slack.end());
  }
}

vtkMTErrorSampling::~vtkMTErrorSampling() = default;

vtkMTCut vtkMTErrorSampling::MakeLevelCut(const vtkMTGraph& graph, std::uint32_t level)
{
  vtkMTCut cut(graph);
  for (std::uint32_t node = 1; node < graph.GetSink(); ++node)
  {
    if (graph.Nodes[node].Level > level && !cut.IsRefined(node))
    {
      cut.RefineWithDependencies(node);
    }
  }
  return cut;
}

bool vtkMTErrorSampling::ReadCut(const std::vector<std::uint32_t>& arcs, const vtkMTVerificationProgress& progress,
  CutSurface& cut, std::string& error) const
{
  const vtkMTGraph& graph = this->Source.GetGraph();
  const std::vector<unsigned char> noArrays(graph.Arrays.size(), 0);
  vtkMTPatch patch;
  for (std::uint32_t arc : arcs)
  {
    if (!progress("reading patches", 0.0) || !this->Source.ReadPatch(arc, &noArrays, patch, error))
    {
      return false;
    }
    cut.Surface.Append(patch, graph.Lattice, this->Frame);
    cut.PointArcs.resize(cut.Surface.Points.size(), arc);
    cut.TriangleArcs.resize(cut.Surface.Triangles.size(), arc);
  }
  return true;
}

void vtkMTErrorSampling::Compare(vtkMTVerificationCheck& check, double distance, double error, const std::string& where)
{
  ++check.Tested;
  const double allowed = error + this->GetTolerance();
  check.Worst = std::max(check.Worst, distance / allowed);
  if (!(distance <= allowed))
  {
    std::ostringstream text;
    text.precision(17);
    text << where << ": the distance is " << distance << ", the certified error " << error;
    check.Fail(text.str());
  }
}

void vtkMTErrorSampling::CountNode(std::uint32_t node, double distance)
{
  this->NodeDistances[node] = std::max(this->NodeDistances[node], distance);
}

void vtkMTErrorSampling::TestPlaceOfPatch(
  std::uint32_t arc, const vtkMTFarthestPlaces::Place& place, const std::string& name)
{
  const vtkMTGraph& graph = this->Source.GetGraph();
  const double distance = this->Frame.ToModel(place.Distance);
  this->CountNode(graph.Arcs[arc].To, distance);
  const double error = graph.GetDistanceToInput(arc) + this->Frame.ToModel(this->LargestSlack);
  const bool isGood = distance <= error + this->GetTolerance();
  this->Compare(this->PatchToInput, distance, error,
    isGood ? std::string()
           : Describe(this->Frame.ToModelPoint(place.Point), "patch " + std::to_string(arc) + ", " + name));
}

bool vtkMTErrorSampling::TestPatches(
  const CutSurface& cut, std::uint32_t level, const vtkMTVerificationProgress& progress)
{
  const std::string name = "patches of level " + std::to_string(level);
  const vtkMTFarthestPlaces search(cut.Surface, *this->InputSearch);
  double done = 0.0;
  const auto advance = [&](double share) { return progress(name + " to input", done + share / 3.0); };
  Places places;
  if (!search.Measure(cut.Surface.Points, {}, places, advance))
  {
    return false;
  }
  for (std::size_t p = 0; p < places.size(); ++p)
  {
    this->TestPlaceOfPatch(cut.PointArcs[p], places[p], name);
  }
  done = 1.0 / 3.0;
  const vtkMTSurfaceSampler::Samples samples =
    vtkMTSurfaceSampler(cut.Surface, this->Samples, this->Seed + level + 1).Take(0, this->Samples);
  const auto getArc = [&](const vtkMTFarthestPlaces::Place& place) { return cut.TriangleArcs[place.Triangle]; };
  const auto getNode = [&](const vtkMTFarthestPlaces::Place& place)
  { return this->Source.GetGraph().Arcs[getArc(place)].To; };
  Places climbed;
  if (!search.Measure(samples.Points, samples.Triangles, places, advance))
  {
    return false;
  }
  done = 2.0 / 3.0;
  if (!search.Climb(places, getNode, places.size() / SamplesPerClimber, climbed, advance))
  {
    return false;
  }
  for (const Places* each : { &places, &climbed })
  {
    for (const vtkMTFarthestPlaces::Place& place : *each)
    {
      this->TestPlaceOfPatch(getArc(place), place, name);
    }
  }
  return true;
}

// Whether one of the patches within whose own distance a point is stands for it.
bool vtkMTErrorSampling::IsStoodFor(const CutSurface& cut, const vtkMTClosestPoint& search, const vtkMTRealPoint& point,
  double radius, double allowance) const
{
  const vtkMTGraph& graph = this->Source.GetGraph();
  bool isStoodFor = false;
  search.VisitWithin(point, radius * this->Frame.Scale,
    [&](std::uint32_t triangle)
    {
      const vtkMTTriangle& t = cut.Surface.Triangles[triangle];
      const std::vector<vtkMTRealPoint>& x = cut.Surface.Points;
      const double distance = std::sqrt(vtkMTClosestPoint::GetDistance2(point, x[t[0]], x[t[1]], x[t[2]]));
      isStoodFor = this->Frame.ToModel(distance) <= graph.GetDistanceFromInput(cut.TriangleArcs[triangle]) + allowance;
      return !isStoodFor;
    });
  return isStoodFor;
}

void vtkMTErrorSampling::TestPlaceOfInput(const CutTest& test, const vtkMTFarthestPlaces::Place& place)
{
  const vtkMTGraph& graph = this->Source.GetGraph();
  const double distance = this->Frame.ToModel(place.Distance);
  const bool hasNearest = place.Nearest != vtkMTClosestPoint::NoTriangle;
  const std::uint32_t nearest = hasNearest ? test.Cut.TriangleArcs[place.Nearest] : 0;
  if (test.CountsNodes && hasNearest)
  {
    this->CountNode(graph.Arcs[nearest].To, distance);
  }
  const bool hasSlack = !this->Input.Slack.empty() && place.Triangle != vtkMTClosestPoint::NoTriangle;
  const double slack = hasSlack ? this->Frame.ToModel(this->Input.Slack[place.Triangle]) : 0.0;
  const double allowance = slack + this->GetTolerance();
  const bool isGood = distance <= test.Error + allowance;
  this->Compare(this->InputToCut, distance, test.Error + slack,
    isGood ? std::string() : Describe(this->Frame.ToModelPoint(place.Point), test.Name));
  if (isGood && hasNearest && distance > graph.GetDistanceFromInput(nearest) + allowance &&
    !this->IsStoodFor(test.Cut, test.Search, place.Point, test.Error + allowance, allowance))
  {
    this->InputToCut.Fail(Describe(this->Frame.ToModelPoint(place.Point), test.Name) +
      ": no patch is within its own distance of the input");
  }
}

bool vtkMTErrorSampling::TestInput(const CutSurface& cut, const std::vector<std::uint32_t>& arcs,
  const std::string& name, bool countNodes, const vtkMTVerificationProgress& progress)
{
  const vtkMTGraph& graph = this->Source.GetGraph();
  const vtkMTClosestPoint places(cut.Surface);
  const CutTest test{ cut, places, name, GetLargestFromInput(graph, arcs), countNodes };
  const vtkMTFarthestPlaces search(this->Input, places);
  const auto getNode = [&](const vtkMTFarthestPlaces::Place& place)
  { return graph.Arcs[cut.TriangleArcs[place.Nearest]].To; };
  double done = 0.0;
  const auto advance = [&](double share) { return progress("input to " + name, done + share / 3.0); };
  Places vertices;
  Places samples;
  Places climbed;
  if (!search.Measure(this->InputVertices, {}, vertices, advance))
  {
    return false;
  }
  done = 1.0 / 3.0;
  if (!search.Measure(this->InputSamples.Points, this->InputSamples.Triangles, samples, advance))
  {
    return false;
  }
  done = 2.0 / 3.0;
  if (!search.Climb(samples, getNode, samples.size() / SamplesPerClimber, climbed, advance))
  {
    return false;
  }
  for (const Places* each : { &vertices, &samples, &climbed })
  {
    for (const vtkMTFarthestPlaces::Place& place : *each)
    {
      this->TestPlaceOfInput(test, place);
    }
  }
  ++this->Cuts;
  return true;
}

bool vtkMTErrorSampling::TestLevel(std::uint32_t level, const vtkMTVerificationProgress& progress, std::string& error)
{
  const vtkMTGraph& graph = this->Source.GetGraph();
  const std::vector<std::uint32_t> arcs = MakeLevelCut(graph, level).GetArcs();
  CutSurface cut;
  const auto firstHalf = [&](const std::string& step, double share) { return progress(step, 0.5 * share); };
  const auto secondHalf = [&](const std::string& step, double share) { return progress(step, 0.5 + 0.5 * share); };
  return this->ReadCut(arcs, firstHalf, cut, error) && this->TestPatches(cut, level, firstHalf) &&
    this->TestInput(cut, arcs, "the cut of level " + std::to_string(level), true, secondHalf);
}

bool vtkMTErrorSampling::TestCut(
  const vtkMTCut& cut, const std::string& name, const vtkMTVerificationProgress& progress, std::string& error)
{
  const std::vector<std::uint32_t> arcs = cut.GetArcs();
  CutSurface surface;
  return this->ReadCut(arcs, progress, surface, error) && this->TestInput(surface, arcs, name, false, progress);
}

std::map<std::uint32_t, vtkMTErrorSampling::Tightness> vtkMTErrorSampling::GetTightness() const
{
  const vtkMTGraph& graph = this->Source.GetGraph();
  const double least = std::max(graph.Nodes[graph.GetSink()].Error, this->GetTolerance());
  std::map<std::uint32_t, std::vector<double>> ratios;
  for (std::uint32_t node = 1; node < graph.GetSink(); ++node)
  {
    if (this->NodeDistances[node] >= 0.0)
    {
      const double certified = std::max(graph.Nodes[node].Error, least);
      ratios[graph.Nodes[node].Level].push_back(certified / std::max(this->NodeDistances[node], least));
    }
  }
  std::map<std::uint32_t, Tightness> result;
  for (auto& [level, values] : ratios)
  {
    std::sort(values.begin(), values.end());
    const double median = 0.5 * (values[(values.size() - 1) / 2] + values[values.size() / 2]);
    result[level] = { median, values.back(), values.size() };
  }
  return result;
}
