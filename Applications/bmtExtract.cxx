// SPDX-License-Identifier: BSD-3-Clause
#include "bmtCommon.h"
#include "bmtModel.h"

#include "vtkMTCut.h"
#include "vtkMTExtraction.h"
#include "vtkMTGraph.h"
#include "vtkMTPatchSource.h"
#include "vtkMultiTriangulation.h"

#include "vtkNew.h"
#include "vtkPolyData.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>

namespace
{
struct Options
{
  std::string File;
  std::string Output;
  std::uint64_t Triangles = 0;
  double Error = -1.0;
  std::uint32_t Level = 0;
  CLI::Option* HasTriangles = nullptr;
  CLI::Option* HasError = nullptr;
};

vtkMTCut ChooseCut(const vtkMTGraph& graph, const Options& options)
{
  vtkMTExtraction extraction;
  vtkMTCut cut(graph);
  std::string message;
  bool found = false;
  if (options.HasTriangles->count() > 0)
  {
    found = extraction.ByTriangles(graph, options.Triangles, cut, message);
  }
  else if (options.HasError->count() > 0)
  {
    found = extraction.ByError(graph, options.Error, cut, message);
  }
  else
  {
    found = vtkMTExtraction::ByLevel(graph, options.Level, cut, message);
  }
  if (!found)
  {
    throw bmtError(options.File + ": " + message);
  }
  return cut;
}

bmtJson DescribeCut(const vtkMTGraph& graph, const vtkMTCut& cut)
{
  bmtJson json;
  std::uint32_t finest = ~std::uint32_t(0);
  std::uint32_t coarsest = 0;
  for (std::uint32_t arc : cut.GetArcs())
  {
    finest = std::min(finest, graph.GetLevelOfArc(arc));
    coarsest = std::max(coarsest, graph.GetLevelOfArc(arc));
  }
  json["triangles"] = cut.GetNumberOfTriangles();
  json["patches"] = cut.GetNumberOfArcs();
  json["error"] = cut.GetError();
  json["finest_level"] = finest;
  json["coarsest_level"] = coarsest;
  return json;
}

bmtJson Extract(const Options& options)
{
  bmtRequireWritable(options.Output);
  bmtRequireMeshEnding(options.Output);
  const double start = bmtWallSeconds();
  const std::shared_ptr<const vtkMTPatchSource> source = bmtOpenModel(options.File);
  const vtkMTCut cut = ChooseCut(source->GetGraph(), options);
  vtkNew<vtkPolyData> mesh;
  std::string error;
  if (!vtkMultiTriangulation::CutToPolyData(*source, cut, mesh, error))
  {
    throw bmtError(error);
  }
  bmtThrowIfInterrupted();
  const std::vector<std::string> dropped = bmtWriteMesh(options.Output, mesh);
  bmtJson result;
  result["output"] = options.Output;
  result.update(DescribeCut(source->GetGraph(), cut));
  result["points"] = mesh->GetNumberOfPoints();
  result["dropped_arrays"] = dropped;
  result["seconds"] = bmtWallSeconds() - start;
  return result;
}
}

void bmtAddExtract(CLI::App& app, bmtContext& context)
{
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("extract", "Write one cut as a conforming, welded mesh");
  command->footer(
    "A point appears more than once only where its attribute values differ (wedges). Where N is 50 mean patches or\n"
    "more, at least 90 % of N are used; N below the coarsest cut is an error. dropped_arrays names the arrays that "
    "the\n"
    "format has no form for.");
  bmtAddModelArgument(*command, options->File);
  command->add_option("-o,--output", options->Output, "The mesh to write: .ply, .stl, .obj, .vtp, .gltf or .glb")
    ->required();
  CLI::Option_group* which = command->add_option_group("which cut", "Exactly one of these");
  options->HasTriangles =
    which->add_option("--triangles", options->Triangles, "The most precise cut of at most N triangles");
  options->HasError = which
                        ->add_option("--error", options->Error,
                          "The coarsest cut that is certified to be within E model units of the input")
                        ->check(CLI::NonNegativeNumber);
  which->add_option("--level", options->Level, "The cut of one level; 0 is the finest");
  which->require_option(1);
  bmtAddCommonOptions(*command, context);
  command->callback(
    [options, &context]
    {
      context.Run = [options, &context]
      {
        bmtPrint(context, Extract(*options));
        return bmtExit::Success;
      };
    });
}
