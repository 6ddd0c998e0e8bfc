// SPDX-License-Identifier: BSD-3-Clause
#include "bmtCommon.h"

#include "vtkMTFractalSphere.h"
#include "vtkMTMeshWriter.h"
#include "vtkMTPlane.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>

namespace
{
struct GenerateOptions
{
  std::string Kind;
  std::uint64_t Triangles = 0;
  std::uint64_t Seed = 0;
  std::string Output;
};

std::unique_ptr<vtkMTTriangleStream> MakeStream(const GenerateOptions& options)
{
  if (options.Kind == "plane")
  {
    return std::make_unique<vtkMTPlane>(options.Triangles);
  }
  return std::make_unique<vtkMTFractalSphere>(options.Triangles, options.Seed);
}

bmtJson Generate(const GenerateOptions& options)
{
  bmtRequireWritable(options.Output);
  if (bmtGetEnding(options.Output) != ".ply")
  {
    throw bmtError(options.Output + ": meshes are generated as PLY; give the output the ending .ply");
  }
  const double start = bmtWallSeconds();
  const std::unique_ptr<vtkMTTriangleStream> stream = MakeStream(options);
  bmtProgress progress("generating");
  const auto advance = [&progress](double fraction)
  {
    progress.Update(fraction);
    bmtThrowIfInterrupted(); // ends WritePly, which then abandons the file
  };
  std::string error;
  if (!vtkMTMeshWriter::WritePly(*stream, options.Output, error, vtkMTMeshWriter::Precision::Single, advance))
  {
    bmtThrowIfInterrupted();
    throw bmtError(error);
  }
  bmtJson result;
  result["output"] = options.Output;
  result["kind"] = options.Kind;
  result["triangles"] = stream->GetNumberOfTriangles();
  result["points"] = stream->GetNumberOfPoints();
  result["bytes"] = std::filesystem::file_size(options.Output);
  result["seconds"] = bmtWallSeconds() - start;
  return result;
}
}

void bmtAddGenerate(CLI::App& app, bmtContext& context)
{
  auto options = std::make_shared<GenerateOptions>();
  CLI::App* command = app.add_subcommand("generate", "Write a test mesh of any size");
  command->footer(
    "fractal-sphere: a unit icosphere of 20 * 4^k triangles, k chosen nearest to N, with fractal noise of eight "
    "octaves; closed, of\n"
    "genus 0. plane: a flat unit square of 2 * n^2 triangles, n chosen nearest. Binary PLY, single precision, shared\n"
    "vertices, written in memory that does not grow with the mesh.");
  command->add_option("KIND", options->Kind, "fractal-sphere or plane")
    ->required()
    ->check(CLI::IsMember({ "fractal-sphere", "plane" }));
  command->add_option("--triangles", options->Triangles, "Wanted number of triangles")
    ->required()
    ->check(CLI::Range(std::uint64_t(1), std::uint64_t(4294967295)));
  command->add_option("--seed", options->Seed, "Seed of the noise")->capture_default_str();
  command->add_option("-o,--output", options->Output, "The mesh to write: a .ply file")->required();
  bmtAddCommonOptions(*command, context);
  command->callback(
    [options, &context]
    {
      context.Run = [options, &context]
      {
        bmtPrint(context, Generate(*options));
        return bmtExit::Success;
      };
    });
}
