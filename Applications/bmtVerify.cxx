// SPDX-License-Identifier: BSD-3-Clause
#include "bmtCommon.h"
#include "bmtInput.h"
#include "bmtModel.h"

#include "vtkMTFileSource.h"
#include "vtkMTPatchSource.h"
#include "vtkMTPolyDataStream.h"
#include "vtkMultiTriangulationVerifier.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace
{
struct VerifyOptions
{
  std::string File;
  bmtInput Input;
  int Cuts = 100;
  std::uint32_t Seed = 1;
  int Samples = 500000;
};

// A check that has tested nothing, but says why, has not passed.
bmtJson DescribeCheck(
  const std::string& name, std::uint64_t tested, std::uint64_t violations, double worst, const std::string& message)
{
  const bool isOpen = tested == 0 && violations == 0 && !message.empty();
  bmtJson json = { { "name", name }, { "ok", isOpen ? bmtJson() : bmtJson(violations == 0) }, { "tested", tested },
    { "violations", violations }, { "worst", worst } };
  if (!message.empty())
  {
    json["message"] = message;
  }
  return json;
}

bmtJson DescribeChecks(vtkTable* checks)
{
  bmtJson json = bmtJson::array();
  for (vtkIdType row = 0; row < checks->GetNumberOfRows(); ++row)
  {
    json.push_back(DescribeCheck(checks->GetValueByName(row, "name").ToString(),
      checks->GetValueByName(row, "tested").ToUnsignedLongLong(),
      checks->GetValueByName(row, "violations").ToUnsignedLongLong(), checks->GetValueByName(row, "worst").ToDouble(),
      checks->GetValueByName(row, "message").ToString()));
  }
  return json;
}

bmtJson DescribeSpans(vtkTable* spans)
{
  std::uint64_t wide = 0;
  bmtJson counts = bmtJson::object();
  for (vtkIdType row = 0; row < spans->GetNumberOfRows(); ++row)
  {
    const std::uint64_t cuts = spans->GetValueByName(row, "cuts").ToUnsignedLongLong();
    const int levels = spans->GetValueByName(row, "levels").ToInt();
    wide += levels >= 3 ? cuts : 0;
    counts[std::to_string(levels)] = cuts;
  }
  return { { "three_levels_or_more", wide }, { "cuts_by_levels_spanned", counts } };
}

bmtJson DescribeTightness(vtkTable* levels)
{
  bmtJson json = bmtJson::object();
  for (vtkIdType row = 0; row < levels->GetNumberOfRows(); ++row)
  {
    json[levels->GetValueByName(row, "level").ToString()] = { { "median",
                                                                levels->GetValueByName(row, "median").ToDouble() },
      { "worst", levels->GetValueByName(row, "worst").ToDouble() },
      { "n", levels->GetValueByName(row, "nodes").ToUnsignedLongLong() } };
  }
  return json;
}

bmtJson Describe(vtkMultiTriangulationVerifier* verifier)
{
  bmtJson json;
  const bool isChecked = verifier->GetInputReading().empty() || verifier->GetInputChecked();
  json["ok"] = verifier->IsValid() && !isChecked ? bmtJson() : bmtJson(verifier->IsValid());
  json["checks"] = DescribeChecks(verifier->GetChecks());
  if (!verifier->GetInputReading().empty())
  {
    json["input"] = { { "reading", verifier->GetInputReading() }, { "independent", verifier->GetInputChecked() },
      { "coordinate_allowance", verifier->GetCoordinateAllowance() },
      { "area_allowance", verifier->GetAreaAllowance() }, { "volume_allowance", verifier->GetVolumeAllowance() } };
  }
  if (verifier->GetChecks()->GetNumberOfRows() > 4) // the model by itself was sound, so there were cuts
  {
    json["spans"] = DescribeSpans(verifier->GetSpans());
  }
  if (verifier->GetCertified())
  {
    json["certified_over_sampled"] = DescribeTightness(verifier->GetTightness());
    json["measured_cuts"] = verifier->GetNumberOfMeasuredCuts();
    json["tolerance"] = verifier->GetTolerance();
    json["skipped_input_triangles"] = { { "not_finite", verifier->GetNumberOfNonFiniteTriangles() },
      { "index_out_of_range", verifier->GetNumberOfOutOfRangeTriangles() },
      { "degenerate", verifier->GetNumberOfDegenerateTriangles() },
      { "far_outlier", verifier->GetNumberOfFarOutliers() } };
  }
  return json;
}

std::unique_ptr<vtkMTTriangleStream> OpenInput(const bmtInput& input, std::string& error)
{
  try
  {
    vtkNew<vtkPolyData> mesh;
    bmtReadInput(input, mesh);
    return std::make_unique<vtkMTPolyDataStream>(mesh);
  }
  catch (const bmtError& failure)
  {
    error = failure.what();
    return nullptr;
  }
}

bmtJson Verify(const VerifyOptions& options)
{
  std::shared_ptr<const vtkMTPatchSource> source;
  try
  {
    source = bmtOpenModel(options.File);
  }
  catch (const bmtError& error)
  {
    if (!vtkMTFileSource::CanRead(options.File))
    {
      throw;
    }
    // The file as an unsound model: the report says what keeps it from being opened as it does for any other damage.
    return { { "ok", false }, { "checks", bmtJson::array({ DescribeCheck("checksums", 1, 1, 0.0, error.what()) }) } };
  }
  vtkNew<vtkMultiTriangulationVerifier> verifier;
  const bmtInput& input = options.Input;
  for (const std::string& path : input.Paths)
  {
    verifier->AddInputFileName(path.c_str());
  }
  if (input.IsoValue)
  {
    verifier->SetInputIsoValue(*input.IsoValue);
  }
  verifier->SetInputVerticalScale(input.VerticalScale);
  verifier->SetInputDegrees(input.Degrees);
  vtkMultiTriangulationVerifier::InputOpener openInput = [&](std::string& error) { return OpenInput(input, error); };
  verifier->SetNumberOfCuts(options.Cuts);
  verifier->SetNumberOfSamples(options.Samples);
  verifier->SetSeed(options.Seed);
  bmtProgress progress("verifying");
  bmtFollow(verifier, progress);
  if (!verifier->Verify(*source, input.Paths.empty() ? nullptr : openInput))
  {
    bmtThrowIfInterrupted();
    throw bmtError(verifier->GetErrorMessage());
  }
  return Describe(verifier);
}

int Report(const VerifyOptions& options, const bmtContext& context, const bmtJson& result)
{
  bmtPrint(context, result);
  for (const bmtJson& check : result["checks"])
  {
    const bool isOpen = check["ok"].is_null();
    if (isOpen || !check["ok"])
    {
      bmtWarn(options.File + ": check '" + check["name"].get<std::string>() + (isOpen ? "': " : "' failed: ") +
        check.value("message", "") + (isOpen ? "" : "; do not trust this file, build it anew"));
    }
  }
  return result["ok"].is_null() ? bmtExit::Unchecked : (result["ok"] ? bmtExit::Success : bmtExit::Failure);
}
}

void bmtAddVerify(CLI::App& app, bmtContext& context)
{
  auto options = std::make_shared<VerifyOptions>();
  CLI::App* command = app.add_subcommand("verify", "Check a Multi-Triangulation file, and its certified errors");
  command->footer(
    "Checks: checksums (every block is read), graph, patches, nesting, pasting, conformity of random cuts and, with\n"
    "--input, the input, read by other code than the builder's: input_reading (by which; or 'not independently\n"
    "checked', exit code 3), input_triangles, _bounds, _area, _volume (signed), _orientation, _arrays, labels; then\n"
    "by sampling certified_patch_to_input, certified_input_to_cut, certified_normals, certified_values. 'worst' is\n"
    "the largest of what was measured over what is allowed: at most 1 when all is well. Errors are allowed 1e-12\n"
    "of the model's size for rounding. certified_over_sampled: by level, the certified error of a node over the\n"
    "largest distance that was found by sampling. Exit code 0 only when every check passed.");
  command->add_option("FILE", options->File, "A Multi-Triangulation file (.bmt)")->required();
  command
    ->add_option("--input", options->Input.Paths,
      "What the file was built from; repeated where there were several, in the same order and with the same options")
    ->allow_extra_args(false);
  bmtAddInputOptions(*command, options->Input);
  command->add_option("--cuts", options->Cuts, "Random cuts to check; at least half of them span three levels or more")
    ->check(CLI::Range(0, 100000000))
    ->capture_default_str();
  command->add_option("--samples", options->Samples, "Area-weighted samples on each surface, beside all its vertices")
    ->check(CLI::Range(1, 100000000))
    ->capture_default_str();
  command->add_option("--seed", options->Seed, "Seed of cuts and samples; the same seed gives the same report")
    ->capture_default_str();
  bmtAddCommonOptions(*command, context);
  command->callback(
    [options, &context] { context.Run = [options, &context] { return Report(*options, context, Verify(*options)); }; });
}
