// SPDX-License-Identifier: BSD-3-Clause
#include "bmtCommon.h"
#include "bmtInput.h"
#include "bmtModel.h"
#include "bmtModelSink.h"

#include "vtkMTEdgeCollapse.h"
#include "vtkMTFileSink.h"
#include "vtkMTPatchSource.h"
#include "vtkMTRegularPartition.h"
#include "vtkMTVoronoiPartition.h"
#include "vtkMultiTriangulationBuilder.h"

#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace
{
struct Options
{
  bmtInput Input;
  std::string Output;
  std::string Partition = "v";
  std::string Simplifier = "fast";
  int PatchTriangles = 1000;
  int LatticeBits = 24;
  int Threads = 0;
  double Precision = 0.0;
  std::string Compression = "fast";
  std::vector<std::string> Arrays;
  CLI::Option* ArraysOption = nullptr;
  bool NoNormals = false;
  bool NoIds = false;
  bool KeepFarOutliers = false;
};

void Advance(vtkObject* caller, unsigned long, void* client, void* fraction)
{
  static_cast<bmtProgress*>(client)->Update(*static_cast<double*>(fraction));
  if (bmtIsInterrupted())
  {
    vtkAlgorithm::SafeDownCast(caller)->AbortExecuteOn();
  }
}

void Configure(const Options& options, int latticeBits, vtkMultiTriangulationBuilder* builder)
{
  if (options.Partition == "regular")
  {
    builder->SetPartitionStrategy(vtkNew<vtkMTRegularPartition>());
  }
  else
  {
    builder->SetPartitionStrategy(vtkNew<vtkMTVoronoiPartition>());
  }
  vtkNew<vtkMTEdgeCollapse> simplifier;
  simplifier->SetModeByName(options.Simplifier.c_str());
  builder->SetSimplifier(simplifier);
  builder->SetPatchTriangles(options.PatchTriangles);
  builder->SetLatticeBits(latticeBits);
  builder->SetNumberOfThreads(options.Threads);
  builder->SetMakeNormals(!options.NoNormals);
  builder->SetKeepFarOutliers(options.KeepFarOutliers);
}

// The bits that keep every point within the precision.
int GetLatticeBits(const Options& options, vtkPolyData* mesh)
{
  if (!(options.Precision > 0.0))
  {
    return options.LatticeBits;
  }
  double bounds[6];
  mesh->GetBounds(bounds);
  for (int bits = vtkMTLattice::MinimumBits; bits <= vtkMTLattice::MaximumBits; ++bits)
  {
    if (vtkMTLattice::FromBounds(bounds, bits).MaximumShift <= options.Precision)
    {
      return bits;
    }
  }
  std::ostringstream message;
  message << "--precision " << options.Precision
          << " is finer than a lattice of 2^31 steps over this mesh resolves; the least is "
          << vtkMTLattice::FromBounds(bounds, vtkMTLattice::MaximumBits).MaximumShift;
  throw bmtError(message.str());
}

// Leaves out what --arrays does not name.
void SelectArrays(const std::vector<std::string>& names, vtkPolyData* mesh)
{
  for (const std::string& name : names)
  {
    if (!mesh->GetPointData()->HasArray(name.c_str()) && !mesh->GetCellData()->HasArray(name.c_str()))
    {
      throw bmtError("--arrays: the input has no array \"" + name + "\"");
    }
  }
  for (vtkDataSetAttributes* data : { static_cast<vtkDataSetAttributes*>(mesh->GetPointData()),
         static_cast<vtkDataSetAttributes*>(mesh->GetCellData()) })
  {
    for (int i = data->GetNumberOfArrays(); i-- > 0;)
    {
      const char* name = data->GetArrayName(i);
      if (!name || std::find(names.begin(), names.end(), name) == names.end())
      {
        data->RemoveArray(i);
      }
    }
  }
}

void RunBuilder(const Options& options, int latticeBits, vtkMTTriangleStream& stream, vtkMTPatchSink& sink)
{
  vtkNew<vtkMultiTriangulationBuilder> builder;
  Configure(options, latticeBits, builder);
  bmtProgress progress("building");
  vtkNew<vtkCallbackCommand> advance;
  advance->SetCallback(Advance);
  advance->SetClientData(&progress);
  builder->AddObserver(vtkCommand::ProgressEvent, advance);
  if (!builder->Build(stream, sink))
  {
    bmtThrowIfInterrupted();
    throw bmtError(options.Output + " was not written: " + builder->GetErrorMessage());
  }
}

// What the input refers to and the file holds as blobs.
bmtJson DescribeTextures(const bmtInputReport& report)
{
  bmtJson list = bmtJson::array();
  for (const vtkMTTexture& texture : report.Textures)
  {
    bmtJson entry;
    entry["name"] = texture.Name;
    entry["type"] = texture.MimeType;
    entry["bytes"] = texture.Bytes.size();
    entry["coordinates"] = texture.Coordinates;
    entry["material"] = texture.Material;
    entry["part"] = texture.Part;
    list.push_back(entry);
  }
  return list;
}

vtkMTFileSink::CompressionType GetCompression(const std::string& name)
{
  return name == "none" ? vtkMTFileSink::None : (name == "small" ? vtkMTFileSink::Small : vtkMTFileSink::Fast);
}

bmtJson Build(const Options& options)
{
  bmtRequireWritable(options.Output);
  const double wall = bmtWallSeconds();
  const double cpu = bmtCpuSeconds();
  vtkNew<vtkPolyData> mesh;
  const bmtInputReport report = bmtReadInput(options.Input, mesh);
  if (options.ArraysOption && options.ArraysOption->count() > 0)
  {
    SelectArrays(options.Arrays, mesh);
  }
  const double reading = bmtWallSeconds() - wall;
  bmtInputStream stream(mesh, report.Counts);
  vtkMTFileSink sink(options.Output, GetCompression(options.Compression));
  bmtModelSink model(sink, report.Textures, !options.NoIds);
  RunBuilder(options, GetLatticeBits(options, mesh), stream, model);

  bmtJson result;
  result["output"] = options.Output;
  result["seconds"] = bmtWallSeconds() - wall;
  result["cpu_seconds"] = bmtCpuSeconds() - cpu;
  result["reading_seconds"] = reading;
  if (!report.Textures.empty() || !report.Problems.empty())
  {
    result["textures_of_input"] = DescribeTextures(report);
    result["texture_problems"] = report.Problems;
  }
  if (!report.Parts.empty())
  {
    result["parts"] = report.Parts;
  }
  result.update(bmtDescribeModel(bmtOpenModel(options.Output)->GetGraph(), sink.GetFileSize()));
  return result;
}

void AddOptions(CLI::App& command, Options& options)
{
  command.add_option("INPUT", options.Input.Paths, std::string("What to build from: ") + bmtGetInputKinds())
    ->required();
  command.add_option("-o,--output", options.Output, "The Multi-Triangulation file to write")->required();
  command
    .add_option(
      "--partition", options.Partition, "How regions are placed: v (Voronoi) or regular (cube, face and edge centres)")
    ->check(CLI::IsMember({ "v", "regular" }))
    ->capture_default_str();
  bmtAddInputOptions(command, options.Input);
  command.add_option("--patch-triangles", options.PatchTriangles, "Wanted mean number of triangles in a patch")
    ->check(CLI::Range(16, 16384))
    ->capture_default_str();
  command
    .add_option("--simplifier", options.Simplifier,
      "fast (memoryless), best (stock loop), or CGAL's own lindstrom-turk and garland-heckbert")
    ->check(CLI::IsMember({ "fast", "best", "lindstrom-turk", "garland-heckbert" }))
    ->capture_default_str();
  command.add_option("--lattice-bits", options.LatticeBits, "The longest side has at most 2^N lattice steps")
    ->check(CLI::Range(10, 31))
    ->capture_default_str();
  command
    .add_option("--threads", options.Threads, "Threads; 0: as many as there are processors. No influence on the file")
    ->check(CLI::Range(0, 1024))
    ->capture_default_str();
  command
    .add_option("--precision", options.Precision,
      "No point moves by more than this, in model units, when it is put on the lattice; in place of --lattice-bits")
    ->check(CLI::PositiveNumber);
  command
    .add_option("--compression", options.Compression,
      "none, fast (packed, LZ4) or small (packed, zstd: a little smaller, slower)")
    ->check(CLI::IsMember({ "none", "fast", "small" }))
    ->capture_default_str();
  options.ArraysOption =
    command.add_option("--arrays", options.Arrays, "The input's arrays to keep, with commas between; \"\": none")
      ->delimiter(',');
  command.add_flag("--no-ids", options.NoIds, "Do not keep the input's cell ids, by which picking finds cells");
  command.add_flag("--keep-far-outliers", options.KeepFarOutliers,
    "Keep triangles so far away that they coarsen the lattice for all others; a few are left out otherwise");
  command.add_flag("--no-normals", options.NoNormals, "Make no smooth normals where the input has none");
}
}

void bmtAddBuild(CLI::App& app, bmtContext& context)
{
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("build", "Build a Multi-Triangulation file from a mesh");
  command->footer(
    "Several inputs become one model with a cell array PartId (0, 1, 2 ... in the order of the command line). Parts "
    "that\n"
    "touch stay apart. Arrays of one name, type and number of components become one; where an input lacks it, real\n"
    "numbers are NaN, whole numbers 0, and normals are made; input_report counts it. All tiles of terrain make one\n"
    "terrain, in metres about its middle; samples that tiles share are one point, voids are holes.\n"
    "The file is written whole or not at all, and is the same byte for byte for any number of threads.");
  AddOptions(*command, *options);
  bmtAddCommonOptions(*command, context);
  command->callback(
    [options, &context]
    {
      context.Run = [options, &context]
      {
        bmtPrint(context, Build(*options));
        return bmtExit::Success;
      };
    });
}
