// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTVerification.h"

#include "Sampling/vtkMTNormalSampling.h"
#include "Sampling/vtkMTValueSampling.h"
#include "vtkMTGraph.h"
#include "vtkMTInputComparison.h"
#include "vtkMTPatchSource.h"
#include "vtkMTRandomCut.h"
#include "vtkMTStructureCheck.h"

#include "vtkNew.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace
{
// Random cuts that are measured against the input, beside one for every level: each costs a search structure.
constexpr std::size_t MeasuredCutsLimit = 8;
// Samples for angles on each surface: each may cost a search among many triangles.
constexpr std::size_t NormalSamplesLimit = 20000;
// Those for values, where the search within a triangle costs little.
constexpr std::size_t ValueSamplesLimit = 100000;
// Triangles of the input that are looked up one by one in the model.
constexpr std::size_t ComparedTrianglesLimit = 200000;

// Of normals and of values, to show progress by.
double CountJointMeasures(const vtkMTGraph& graph)
{
  const std::string ofValues = vtkMTMeasure::GetValueDeviationName("");
  const bool hasValues = std::any_of(graph.Measures.begin(), graph.Measures.end(),
    [&](const vtkMTMeasure& measure) { return measure.Name.compare(0, ofValues.size(), ofValues) == 0; });
  return (graph.FindMeasure(vtkMTMeasure::NormalDeviation) ? 1.0 : 0.0) + (hasValues ? 1.0 : 0.0);
}

std::string Join(const std::vector<vtkMTVerifyInput::Source>& sources)
{
  std::string text;
  for (const vtkMTVerifyInput::Source& source : sources)
  {
    text += (text.empty() ? "" : "; ") + source.Path + ": " +
      (source.Reason.empty() ? "read by " + source.Reader : "not independently checked: " + source.Reason);
  }
  return text;
}
}

bool vtkMTVerification::Result::IsOk() const
{
  return std::all_of(
    this->Checks.begin(), this->Checks.end(), [](const vtkMTVerificationCheck& check) { return check.IsOk(); });
}

vtkMTVerification::vtkMTVerification(
  const vtkMTPatchSource& source, const Settings& settings, vtkMTVerificationProgress progress)
  : Source(source)
  , Setting(settings)
  , Progress(std::move(progress))
{
}

// Progress of the next step as a share of all.
vtkMTVerificationProgress vtkMTVerification::NextStep()
{
  const double before = this->Step++;
  return [this, before](const std::string& step, double share)
  { return this->Progress(step, (before + share) / this->Steps); };
}

bool vtkMTVerification::Run(const Input& input, std::string& error)
{
  error.clear();
  this->Checked = Result();
  this->Step = 0.0;
  const vtkMTGraph& graph = this->Source.GetGraph();
  const std::size_t measuredCuts = std::min(this->Setting.Cuts, MeasuredCutsLimit);
  const double joint = CountJointMeasures(graph);
  this->Steps = !input.IsEmpty() ? 4.0 + joint + graph.GetNumberOfLevels() + static_cast<double>(measuredCuts) : 2.0;
  if (!this->TestStructure())
  {
    return false;
  }
  return input.IsEmpty() || !this->Checked.IsOk() || this->TestInput(input, error);
}

bool vtkMTVerification::TestStructure()
{
  Result& result = this->Checked;
  if (!vtkMTStructureCheck::TestParts(this->Source, this->NextStep(), result.Checks))
  {
    return false;
  }
  if (!result.IsOk()) // or else cuts and distances have no meaning
  {
    return true;
  }
  vtkMTValidate::Borders borders;
  result.Checks.push_back(vtkMTStructureCheck::TestPasting(this->Source, borders));
  return vtkMTStructureCheck::TestConformity(
    this->Source, borders, this->Setting.Cuts, this->Setting.Seed, this->NextStep(), result.Checks, result.Spans);
}

bool vtkMTVerification::TestInput(const Input& input, std::string& error)
{
  if (this->Source.GetGraph().IsEmpty())
  {
    error = this->Source.GetName() + ": the Multi-Triangulation is empty, so it cannot be held against an input";
    return false;
  }
  vtkMTSampledSurface surface;
  return this->ReadInput(input, surface, error) && this->TestErrors(std::move(surface), error);
}

bool vtkMTVerification::ReadInput(const Input& input, vtkMTSampledSurface& surface, std::string& error)
{
  if (input.Mesh)
  {
    return this->Compare(input.Mesh, 0.0, surface, error);
  }
  if (input.Files.Paths.empty())
  {
    return this->OpenInput(input.Open, surface, error);
  }
  const vtkMTVerificationProgress reading = this->NextStep();
  if (!reading("reading the input", 0.0))
  {
    return false;
  }
  vtkMTVerificationCheck check("input_reading");
  vtkNew<vtkPolyData> mesh;
  double rounding = 0.0;
  std::vector<vtkMTVerifyInput::Source>& sources = this->Checked.Sources;
  const bool isRead = vtkMTVerifyInput::Read(input.Files, mesh, sources, rounding);
  check.Message = Join(sources);
  check.Tested = isRead ? sources.size() : 0;
  this->Checked.Checks.push_back(check);
  if (isRead)
  {
    return this->Compare(mesh, rounding, surface, error);
  }
  if (!input.Open)
  {
    error = check.Message;
    return false;
  }
  return this->OpenInput(input.Open, surface, error);
}

// An input without a surface is an error, as it is for the builder.
bool vtkMTVerification::Compare(vtkPolyData* mesh, double rounding, vtkMTSampledSurface& surface, std::string& error)
{
  vtkMTInputComparison comparison(this->Source, mesh, rounding, ComparedTrianglesLimit);
  if (!comparison.Test(this->NextStep(), this->Checked.Checks, error))
  {
    return false;
  }
  surface = comparison.TakeSurface();
  if (surface.Triangles.empty())
  {
    error =
      this->Setting.InputName + ": has no triangle with three finite, different corners; name a mesh that has some";
    return false;
  }
  this->Checked.CoordinateAllowance = comparison.GetAllowance();
  this->Checked.AreaAllowance = comparison.ToModel(comparison.GetInputFigures().AreaAllowance, 2);
  this->Checked.VolumeAllowance = comparison.ToModel(comparison.GetInputFigures().VolumeAllowance, 3);
  return true;
}

bool vtkMTVerification::OpenInput(const InputOpener& open, vtkMTSampledSurface& surface, std::string& error)
{
  const vtkMTVerificationProgress reading = this->NextStep();
  if (!reading("reading the input", 0.0))
  {
    return false;
  }
  const std::unique_ptr<vtkMTTriangleStream> stream = open(error);
  if (!stream)
  {
    return false;
  }
  if (!surface.Read(
        *stream, [&reading] { return reading("reading the input", 0.5); }, error))
  {
    error.insert(0, error.empty() ? "" : this->Setting.InputName + ": ");
    return false;
  }
  return true;
}

bool vtkMTVerification::TestErrors(vtkMTSampledSurface&& surface, std::string& error)
{
  const vtkMTGraph& graph = this->Source.GetGraph();
  vtkMTErrorSampling sampling(this->Source, std::move(surface), this->Setting.Samples, this->Setting.Seed);
  for (std::uint32_t level = graph.GetNumberOfLevels(); level-- > 0;)
  {
    if (!sampling.TestLevel(level, this->NextStep(), error))
    {
      return false;
    }
  }
  for (std::size_t i = 0; i < std::min(this->Setting.Cuts, MeasuredCutsLimit); ++i)
  {
    const vtkMTCut cut = vtkMTRandomCut::Make(graph, this->Setting.Seed, i);
    if (!sampling.TestCut(cut, "random cut " + std::to_string(i), this->NextStep(), error))
    {
      return false;
    }
  }
  Result& result = this->Checked;
  result.Checks.push_back(sampling.GetPatchToInput());
  result.Checks.push_back(sampling.GetInputToCut());
  result.IsCertified = true;
  result.Tightness = sampling.GetTightness();
  result.MeasuredCuts = sampling.GetNumberOfCuts();
  result.Tolerance = sampling.GetTolerance();
  result.NonFinite = sampling.GetInput().NonFinite;
  result.OutOfRange = sampling.GetInput().OutOfRange;
  result.Degenerate = sampling.GetInput().Degenerate;
  result.FarOutliers = sampling.GetInput().FarOutliers;
  return this->TestJointly(error);
}

bool vtkMTVerification::TestJointly(std::string& error)
{
  const std::size_t samples = this->Setting.Samples;
  vtkMTNormalSampling normals(this->Source, std::min(samples, NormalSamplesLimit), this->Setting.Seed);
  vtkMTValueSampling values(this->Source, std::min(samples, ValueSamplesLimit), this->Setting.Seed);
  const bool done = this->TestJointly(normals, error) && this->TestJointly(values, error);
  this->Checked.SkippedValues = values.GetNumberOfSkipped();
  return done;
}

bool vtkMTVerification::TestJointly(vtkMTJointSampling& sampling, std::string& error)
{
  const vtkMTGraph& graph = this->Source.GetGraph();
  if (!sampling.HasMeasure())
  {
    return true;
  }
  const vtkMTVerificationProgress progress = this->NextStep();
  const std::uint32_t levels = graph.GetNumberOfLevels();
  const auto cuts = static_cast<std::uint32_t>(std::min(this->Setting.Cuts, MeasuredCutsLimit));
  bool done = sampling.Begin([&](const std::string& step, double) { return progress(step, 0.0); }, error);
  for (std::uint32_t i = 0; done && i < levels + cuts; ++i)
  {
    const bool isLevel = i < levels;
    const vtkMTCut cut = isLevel ? vtkMTErrorSampling::MakeLevelCut(graph, i)
                                 : vtkMTRandomCut::Make(graph, this->Setting.Seed, i - levels);
    const std::string name =
      isLevel ? "the cut of level " + std::to_string(i) : "random cut " + std::to_string(i - levels);
    done = sampling.TestCut(
      cut, name, [&](const std::string& step, double share) { return progress(step, (i + share) / (levels + cuts)); },
      error);
  }
  this->Checked.Checks.push_back(sampling.GetCheck());
  return done;
}
