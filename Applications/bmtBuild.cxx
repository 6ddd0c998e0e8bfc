// SPDX-License-Identifier: BSD-3-Clause
#include "bmtCommon.h"
#include "bmtInput.h"
#include "bmtModel.h"
#include "bmtModelSink.h"
#include "bmtWorkspace.h"

#include "vtkMTEdgeCollapse.h"
#include "vtkMTFileSink.h"
#include "vtkMTMeshStream.h"
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
#include <filesystem>
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
  bool Exact = false;
  bmtWorkspaceOptions Workspace;
};

void Advance(vtkObject* caller, unsigned long, void* client, void* fraction)
{
  vtkAlgorithm* algorithm = vtkAlgorithm::SafeDownCast(caller);
  const char* text = algorithm->GetProgressText();
  static_cast<bmtProgress*>(client)->Update(*static_cast<double*>(fraction), text ? text : "");
  if (bmtIsInterrupted())
  {
    algorithm->AbortExecuteOn();
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
  builder->SetExactPoints(options.Exact);
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

vtkMTFileSink::CompressionType GetCompression(const std::string& name)
{
  return name == "none" ? vtkMTFileSink::None : (name == "small" ? vtkMTFileSink::Small : vtkMTFileSink::Fast);
}

// What tells this input from others, without reading all of it again.
std::string GetIdentity(const bmtInput& input)
{
  std::string identity = "iso " + std::to_string(input.Iso.value_or(0.0)) +
    (input.GradientNormals ? " with normals" : "") + ", heights by " + std::to_string(input.VerticalScale) +
    (input.Degrees ? " in degrees; " : "; ");
  for (const std::string& path : input.Paths)
  {
    std::error_code code;
    const auto time = std::filesystem::last_write_time(path, code).time_since_epoch().count();
    const std::string whole = std::filesystem::absolute(path, code).string();
    identity += whole + ", " + std::to_string(std::filesystem::file_size(path, code)) + " bytes, of " +
      std::to_string(time) + "; ";
  }
  return identity;
}

void RunBuilder(const Options& options, int latticeBits, bmtWorkspace& workspace, vtkMTTriangleStream& stream,
  const bmtInputReport& report, std::uint64_t& fileSize)
{
  vtkNew<vtkMultiTriangulationBuilder> builder;
  Configure(options, latticeBits, builder);
  workspace.Prepare(stream, builder);
  // What becomes of the model in the sink has to be the same as well when the build is resumed.
  const std::string identity = GetIdentity(options.Input) + options.Compression + (options.NoIds ? ", no ids" : "");
  builder->SetInputIdentity(identity.c_str());
  vtkMTFileSink sink(options.Output, GetCompression(options.Compression), workspace.GetStore());
  bmtModelSink model(sink, report.Textures, !options.NoIds);
  bmtProgress progress("building");
  vtkNew<vtkCallbackCommand> advance;
  advance->SetCallback(Advance);
  advance->SetClientData(&progress);
  builder->AddObserver(vtkCommand::ProgressEvent, advance);
  if (!builder->Build(stream, model))
  {
    const std::string advice = workspace.GetAdvice(builder->GetHasCheckpoint());
    if (bmtIsInterrupted())
    {
      throw bmtInterrupt("interrupted; " + options.Output + " is as it was" + advice);
    }
    throw bmtError(options.Output + " was not written: " + builder->GetErrorMessage() + advice);
  }
  fileSize = sink.GetFileSize();
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

// A mesh that can be streamed is; everything else is read, and so is what must be looked at whole.
std::unique_ptr<vtkMTTriangleStream> OpenInput(const Options& options, vtkPolyData* mesh, bmtInputReport& report)
{
  for (const std::string& path : options.Input.Paths)
  {
    bmtRequireReadable(path);
  }
  const bool selects = options.ArraysOption && options.ArraysOption->count() > 0;
  std::unique_ptr<vtkMTTriangleStream> stream;
  if (options.Input.Paths.size() == 1 && !selects && !(options.Precision > 0.0))
  {
    stream = vtkMTMeshStream::Open(options.Input.Paths[0]);
  }
  if (!stream)
  {
    report = bmtReadInput(options.Input, mesh);
    if (selects)
    {
      SelectArrays(options.Arrays, mesh);
    }
    stream = std::make_unique<bmtInputStream>(mesh, report.Counts);
  }
  return stream;
}

bmtJson Build(const Options& options)
{
  bmtRequireWritable(options.Output);
  const double wall = bmtWallSeconds();
  const double cpu = bmtCpuSeconds();
  bmtWorkspace workspace(options.Workspace, options.Output);
  vtkNew<vtkPolyData> mesh;
  bmtInputReport report;
  const std::unique_ptr<vtkMTTriangleStream> stream = OpenInput(options, mesh, report);
  const double reading = bmtWallSeconds() - wall;
  std::uint64_t fileSize = 0;
  RunBuilder(options, GetLatticeBits(options, mesh), workspace, *stream, report, fileSize);

  bmtJson result;
  result["output"] = options.Output;
  result["seconds"] = bmtWallSeconds() - wall;
  result["cpu_seconds"] = bmtCpuSeconds() - cpu;
  result["reading_seconds"] = reading;
  result["input_streamed"] = mesh->GetNumberOfPoints() == 0;
  workspace.Describe(result);
  if (!report.Textures.empty() || !report.Problems.empty())
  {
    result["textures_of_input"] = DescribeTextures(report);
    result["texture_problems"] = report.Problems;
  }
  if (!report.Parts.empty())
  {
    result["parts"] = report.Parts;
  }
  result.update(bmtDescribeModel(bmtOpenModel(options.Output)->GetGraph(), fileSize));
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
  command.add_flag("--exact", options.Exact,
    "Keep the input's coordinates bit for bit beside the lattice's: 'bmt extract --level 0' gives them back");
  command.add_flag("--keep-far-outliers", options.KeepFarOutliers,
    "Keep triangles so far away that they coarsen the lattice for all others; a few are left out otherwise");
  bmtAddWorkspaceOptions(command, options.Workspace);
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
    "The file is written whole or not at all, and is the same byte for byte for any number of threads and\n"
    "any memory limit, also after --resume.");
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
