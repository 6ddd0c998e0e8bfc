// SPDX-License-Identifier: BSD-3-Clause
#include "bmtCommon.h"
#include "bmtInput.h"

#include "vtkMTPolyDataStream.h"
#include "vtkMTSampledSurface.h"
#include "vtkMTSurfaceDistance.h"

#include "vtkNew.h"
#include "vtkPolyData.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace
{
struct CompareOptions
{
  std::string A;
  std::string B;
  bmtInput Input; // what holds for both
  std::uint64_t Samples = 1000000;
  std::uint64_t Seed = 1;
};

vtkMTSampledSurface ReadSurface(const std::string& path, bmtInput input)
{
  input.Paths = { path };
  vtkNew<vtkPolyData> mesh;
  bmtReadInput(input, mesh);
  vtkMTPolyDataStream stream(mesh);
  vtkMTSampledSurface surface;
  std::string error;
  if (!surface.Read(
        stream, [] { return !bmtIsInterrupted(); }, error))
  {
    bmtThrowIfInterrupted();
    throw bmtError(path + ": " + error);
  }
  return surface;
}

bmtJson Compare(const CompareOptions& options)
{
  vtkMTSampledSurface a = ReadSurface(options.A, options.Input);
  vtkMTSampledSurface b = ReadSurface(options.B, options.Input);
  bmtProgress progress("comparing");
  const auto advance = [&progress](const std::string& step, double share)
  {
    progress.Update(share, step);
    return !bmtIsInterrupted();
  };
  vtkMTSurfaceDistance distance;
  if (!distance.Measure(a, b, options.Samples, options.Seed, advance))
  {
    throw bmtInterrupt();
  }
  bmtJson result;
  result["max"] = distance.Maximum;
  result["rms"] = distance.RootMeanSquare;
  result["max_ab"] = distance.FromAToB.Maximum;
  result["max_ba"] = distance.FromBToA.Maximum;
  result["rms_ab"] = distance.FromAToB.RootMeanSquare;
  result["rms_ba"] = distance.FromBToA.RootMeanSquare;
  result["diagonal"] = distance.Diagonal;
  result["triangles_a"] = a.Triangles.size();
  result["triangles_b"] = b.Triangles.size();
  result["samples_a"] = distance.FromAToB.Samples;
  result["samples_b"] = distance.FromBToA.Samples;
  result["vertices_a"] = distance.FromAToB.Vertices;
  result["vertices_b"] = distance.FromBToA.Vertices;
  return result;
}
}

void bmtAddCompare(CLI::App& app, bmtContext& context)
{
  auto options = std::make_shared<CompareOptions>();
  CLI::App* command = app.add_subcommand("compare", "Measure the two-sided distance between two meshes");
  command->footer(
    "Distances go from area-weighted samples and from all vertices of one surface to the closest point of the other,\n"
    "in model units. max is over both; rms over the samples alone, both directions weighing the same.\n"
    "A and B may also be .bmt files; then their finest level is meant.");
  command->add_option("A", options->A, std::string("A mesh: ") + bmtGetInputKinds())->required();
  command->add_option("B", options->B, "Another mesh")->required();
  command->add_option("--samples", options->Samples, "Samples on each surface")
    ->check(CLI::Range(std::uint64_t(1), std::uint64_t(1000000000)))
    ->capture_default_str();
  command->add_option("--seed", options->Seed, "Seed of the samples; the same seed gives the same figures")
    ->capture_default_str();
  bmtAddInputOptions(*command, options->Input);
  bmtAddCommonOptions(*command, context);
  command->callback(
    [options, &context]
    {
      context.Run = [options, &context]
      {
        bmtPrint(context, Compare(*options));
        return bmtExit::Success;
      };
    });
}
