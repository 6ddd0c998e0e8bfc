// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTVerification.h"

#include "vtkMTGraph.h"
#include "vtkMTPatchSource.h"
#include "vtkMTRandomCut.h"
#include "vtkMTStructureCheck.h"

#include <algorithm>

namespace
{
// Random cuts that are measured against the input, beside one for every level: each costs a search structure.
constexpr std::size_t MeasuredCutsLimit = 8;
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

bool vtkMTVerification::Run(const InputOpener& openInput, std::string& error)
{
  error.clear();
  this->Checked = Result();
  this->Step = 0.0;
  const vtkMTGraph& graph = this->Source.GetGraph();
  const std::size_t measuredCuts = std::min(this->Setting.Cuts, MeasuredCutsLimit);
  this->Steps = openInput ? 3.0 + graph.GetNumberOfLevels() + static_cast<double>(measuredCuts) : 2.0;
  if (!this->TestStructure())
  {
    return false;
  }
  return !openInput || !this->Checked.IsOk() || this->TestErrors(openInput, error);
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

bool vtkMTVerification::TestErrors(const InputOpener& openInput, std::string& error)
{
  const vtkMTGraph& graph = this->Source.GetGraph();
  if (graph.IsEmpty())
  {
    error = this->Source.GetName() + ": the Multi-Triangulation is empty, so it cannot be held against an input";
    return false;
  }
  const vtkMTVerificationProgress reading = this->NextStep();
  if (!reading("reading the input", 0.0))
  {
    return false;
  }
  std::unique_ptr<vtkMTTriangleStream> stream = openInput(error);
  vtkMTSampledSurface input;
  if (!stream)
  {
    return false;
  }
  if (!input.Read(
        *stream, [&reading] { return reading("reading the input", 0.5); }, error))
  {
    error.insert(0, error.empty() ? "" : this->Setting.InputName + ": ");
    return false;
  }
  stream.reset(); // the surface is a copy
  vtkMTErrorSampling sampling(this->Source, std::move(input), this->Setting.Samples, this->Setting.Seed);
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
  return true;
}
