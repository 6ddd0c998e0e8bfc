// SPDX-License-Identifier: BSD-3-Clause
#include "bmtCertifier.h"
#include "bmtCommon.h"
#include "bmtInput.h"
#include "bmtModel.h"
#include "bmtStructure.h"

#include "vtkMTCut.h"
#include "vtkMTGraph.h"
#include "vtkMTPatchSource.h"
#include "vtkMTRandomCut.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>

namespace
{
struct Options
{
  std::string File;
  bmtInput Input;
  std::size_t Cuts = 100;
  std::uint32_t Seed = 1;
  std::size_t Samples = 500000;
};

// Random cuts that are measured against the input, beside one for every level: each costs a search structure.
constexpr std::size_t MeasuredCuts = 8;

bool AreAllOk(const std::vector<bmtCheck>& checks)
{
  return std::all_of(checks.begin(), checks.end(), [](const bmtCheck& check) { return check.IsOk(); });
}

void CertifyErrors(
  const vtkMTPatchSource& source, const Options& options, std::vector<bmtCheck>& checks, bmtJson& result)
{
  const vtkMTGraph& graph = source.GetGraph();
  bmtCertifier certifier(source, bmtReadSurface(options.Input), options.Samples, options.Seed);
  for (std::uint32_t level = graph.GetNumberOfLevels(); level-- > 0;)
  {
    certifier.TestLevel(level);
  }
  for (std::size_t i = 0; i < std::min(options.Cuts, MeasuredCuts); ++i)
  {
    certifier.TestCut(vtkMTRandomCut::Make(graph, options.Seed, i), "random cut " + std::to_string(i));
  }
  checks.push_back(certifier.GetPatchToInput());
  checks.push_back(certifier.GetInputToCut());
  result["certified_over_sampled"] = certifier.GetTightness();
  result["measured_cuts"] = certifier.GetNumberOfCuts();
  result["tolerance"] = certifier.GetTolerance();
  result["skipped_input_triangles"] = certifier.GetSkipped();
}

// What is wrong with the file keeps it from being opened; the report says so in the same form as for any other damage.
bool FindDamage(const Options& options, std::shared_ptr<const vtkMTPatchSource>& source, std::vector<bmtCheck>& checks)
{
  if (!bmtIsModel(options.File))
  {
    source = bmtOpenModel(options.File); // throws what is wrong
    return false;
  }
  try
  {
    source = bmtOpenModel(options.File);
    return false;
  }
  catch (const bmtError& error)
  {
    checks.emplace_back("checksums");
    checks.back().Tested = 1;
    checks.back().Fail(error.what());
    return true;
  }
}

bmtJson Verify(const Options& options)
{
  std::vector<bmtCheck> checks;
  std::shared_ptr<const vtkMTPatchSource> source;
  bmtJson result;
  result["ok"] = false;
  result["checks"] = bmtJson::array();
  if (!FindDamage(options, source, checks))
  {
    checks = bmtCheckStructure(*source);
    if (AreAllOk(checks)) // or else cuts and distances have no meaning
    {
      vtkMTValidate::Borders borders;
      checks.push_back(bmtCheckPasting(*source, borders));
      checks.push_back(bmtCheckConformity(*source, borders, options.Cuts, options.Seed, result["spans"]));
      if (!options.Input.Paths.empty())
      {
        CertifyErrors(*source, options, checks, result);
      }
    }
  }
  result["ok"] = AreAllOk(checks);
  for (const bmtCheck& check : checks)
  {
    result["checks"].push_back(check.ToJson());
  }
  return result;
}

int Report(const Options& options, const bmtContext& context, const bmtJson& result)
{
  bmtPrint(context, result);
  for (const bmtJson& check : result["checks"])
  {
    if (!check["ok"])
    {
      bmtWarn(options.File + ": check '" + check["name"].get<std::string>() +
        "' failed: " + check.value("message", "") + "; do not trust this file, build it anew");
    }
  }
  return result["ok"] ? bmtExit::Success : bmtExit::Failure;
}
}

void bmtAddVerify(CLI::App& app, bmtContext& context)
{
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("verify", "Check a Multi-Triangulation file, and its certified errors");
  command->footer("Checks: checksums (every block is read), graph, patches, nesting (errors and spheres), pasting, "
                  "conformity of random cuts and, with\n"
                  "--input, certified_patch_to_input and certified_input_to_cut: distances by sampling, with code that "
                  "the builder does not use, against\n"
                  "the errors in the file. 'worst' is the largest of what was measured over what is allowed: at most 1 "
                  "when all is well. The only\n"
                  "allowance is 1e-12 of the model's size for the rounding of coordinates. certified_over_sampled "
                  "says, by level, how\n"
                  "far the certified error of a node is above the largest distance that was found by sampling.\n"
                  "Exit code 0 only when every check passed.");
  command->add_option("FILE", options->File, "A Multi-Triangulation file (.bmt)")->required();
  command
    ->add_option("--input", options->Input.Paths,
      "What the file was built from; repeated where there were several, in the same order and with the same options")
    ->allow_extra_args(false);
  bmtAddInputOptions(*command, options->Input);
  command->add_option("--cuts", options->Cuts, "Random cuts to check; at least half of them span three levels or more")
    ->check(CLI::Range(std::size_t(0), std::size_t(100000000)))
    ->capture_default_str();
  command->add_option("--samples", options->Samples, "Area-weighted samples on each surface, beside all its vertices")
    ->check(CLI::Range(std::size_t(1), std::size_t(100000000)))
    ->capture_default_str();
  command->add_option("--seed", options->Seed, "Seed of cuts and samples; the same seed gives the same report")
    ->capture_default_str();
  bmtAddCommonOptions(*command, context);
  command->callback(
    [options, &context] { context.Run = [options, &context] { return Report(*options, context, Verify(*options)); }; });
}
