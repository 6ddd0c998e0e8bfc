// SPDX-License-Identifier: BSD-3-Clause
#include "bmtCommon.h"
#include "bmtInput.h"
#include "bmtModel.h"
#include "bmtModelSink.h"
#include "bmtWorkspace.h"

#include "vtkMTEdgeCollapse.h"
#include "vtkMTFileSink.h"
#include "vtkMTPartitionStrategy.h"
#include "vtkMTPatchSource.h"
#include "vtkMTPolyDataStream.h"
#include "vtkMTRegularPartition.h"
#include "vtkMTSimplifier.h"
#include "vtkMTStageTimes.h"
#include "vtkMTVoronoiPartition.h"
#include "vtkMultiTriangulationBuilder.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
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

// Of all points that are finite.
std::array<double, 6> GetBounds(vtkMTTriangleStream& stream)
{
  constexpr double most = std::numeric_limits<double>::max();
  std::array<double, 6> bounds{ most, -most, most, -most, most, -most };
  vtkMTTriangleStream::PointBlock block;
  bool good = stream.Rewind();
  while (good && (good = stream.NextPoints(block)) && !block.Points.empty())
  {
    for (const std::array<double, 3>& point : block.Points)
    {
      for (std::size_t i = 0; i < 3 && std::isfinite(point[0] + point[1] + point[2]); ++i)
      {
        bounds[2 * i] = std::min(bounds[2 * i], point[i]);
        bounds[2 * i + 1] = std::max(bounds[2 * i + 1], point[i]);
      }
    }
  }
  if (!good)
  {
    throw bmtError(stream.GetError());
  }
  return bounds[0] <= bounds[1] ? bounds : std::array<double, 6>{};
}

// The bits that keep every point within the precision.
int GetLatticeBits(const Options& options, vtkMTTriangleStream& stream)
{
  if (!(options.Precision > 0.0))
  {
    return options.LatticeBits;
  }
  const std::array<double, 6> bounds = GetBounds(stream);
  for (int bits = vtkMTLattice::MinimumBits; bits <= vtkMTLattice::MaximumBits; ++bits)
  {
    if (vtkMTLattice::FromBounds(bounds.data(), bits).MaximumShift <= options.Precision)
    {
      return bits;
    }
  }
  std::ostringstream message;
  message << "--precision " << options.Precision
          << " is finer than a lattice of 2^31 steps over this mesh resolves; the least is "
          << vtkMTLattice::FromBounds(bounds.data(), vtkMTLattice::MaximumBits).MaximumShift;
  throw bmtError(message.str());
}

vtkMTFileSink::CompressionType GetCompression(const std::string& name)
{
  return name == "none" ? vtkMTFileSink::None : (name == "small" ? vtkMTFileSink::Small : vtkMTFileSink::Fast);
}

// What has an influence on the file: the input's bytes and the settings, as a hash.
std::string GetIdentity(const Options& options, const bmtInputFiles& files, vtkMultiTriangulationBuilder* builder)
{
  const bmtInput& input = options.Input;
  std::ostringstream text;
  text.precision(17);
  text << files.GetHash();
  for (const std::string& path : input.Paths) // the ending says what a file is, the name of a tile where it lies
  {
    text << ", " << std::filesystem::path(path).filename().string();
  }
  text << "; iso " << input.Iso.value_or(0.0) << input.Iso.has_value() << input.GradientNormals << "; heights by "
       << input.VerticalScale << input.Degrees << "; patches of " << options.PatchTriangles << ", "
       << options.LatticeBits << " bits, precision " << options.Precision << ", " << options.Compression << "; "
       << options.NoNormals << options.NoIds << options.KeepFarOutliers << "; "
       << builder->GetPartitionStrategy()->GetSettings() << "; " << builder->GetSimplifier()->GetSettings();
  if (options.ArraysOption->count() > 0)
  {
    for (const std::string& name : options.Arrays)
    {
      text << "; " << name;
    }
  }
  return bmtHash(text.str());
}

// Whether the output is there already, as this build would make it.
bool IsFinished(const std::string& output, const std::string& identity)
{
  std::error_code code;
  if (!std::filesystem::exists(output, code) || !bmtIsModel(output))
  {
    return false;
  }
  const std::shared_ptr<const vtkMTPatchSource> model = bmtOpenModel(output);
  const auto& settings = model->GetGraph().Settings;
  const auto found = settings.find("build");
  return found != settings.end() && found->second == identity;
}

void RunBuilder(vtkMultiTriangulationBuilder* builder, const Options& options, bmtWorkspace& workspace,
  vtkMTTriangleStream& stream, const bmtInputReport& report)
{
  workspace.Prepare(stream, builder);
  vtkMTFileSink sink(options.Output, GetCompression(options.Compression), workspace.GetStore());
  bmtModelSink model(sink, report.Textures, !options.NoIds, builder->GetInputIdentity());
  bmtProgress progress("building");
  vtkNew<vtkCallbackCommand> advance;
  advance->SetCallback(Advance);
  advance->SetClientData(&progress);
  builder->AddObserver(vtkCommand::ProgressEvent, advance);
  const bmtInterruptWatch watch(0.6, [&workspace] { return workspace.Leave(); });
  if (!builder->Build(stream, model))
  {
    const std::string advice = workspace.GetAdvice(builder->GetHasCheckpoint());
    if (bmtIsInterrupted())
    {
      throw bmtInterrupt("interrupted; " + options.Output + " is as it was" + advice);
    }
    throw bmtError(options.Output + " was not written: " + builder->GetErrorMessage() + advice);
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

// A mesh that can be streamed is; everything else is read.
std::unique_ptr<vtkMTTriangleStream> OpenInput(const Options& options, const bmtInputFiles& files,
  const bmtWorkspace& workspace, vtkPolyData* mesh, bmtInputReport& report)
{
  std::unique_ptr<vtkMTTriangleStream> stream =
    bmtStreamInput(options.Input, workspace.GetScratch(), workspace.GetLimit(), report);
  if (!stream)
  {
    report = bmtReadInput(options.Input, mesh);
    stream = std::make_unique<vtkMTPolyDataStream>(mesh);
  }
  const std::vector<std::string>* keep = options.ArraysOption->count() > 0 ? &options.Arrays : nullptr;
  return std::make_unique<bmtInputStream>(std::move(stream), files, report.Counts, keep);
}

// reading: CPU and wall seconds that went into opening the input.
bmtJson DescribeStages(const vtkMTStageTimes& times, const std::array<double, 2>& reading)
{
  bmtJson stages = bmtJson::object();
  for (int i = 0; i < vtkMTStageTimes::NumberOfStages; ++i)
  {
    const auto stage = static_cast<vtkMTStageTimes::StageType>(i);
    const bool isReading = stage == vtkMTStageTimes::Read;
    bmtJson& entry = stages[vtkMTStageTimes::GetName(stage)];
    entry["cpu_seconds"] = times.GetCpuSeconds(stage) + (isReading ? reading[0] : 0.0);
    entry["wall_seconds"] = times.GetWallSeconds(stage) + (isReading ? reading[1] : 0.0);
  }
  return stages;
}

bmtJson DescribeInput(const bmtInputReport& report)
{
  bmtJson result = bmtJson::object();
  if (!report.Textures.empty() || !report.Problems.empty())
  {
    result["textures_of_input"] = DescribeTextures(report);
    result["texture_problems"] = report.Problems;
  }
  if (!report.Parts.empty())
  {
    result["parts"] = report.Parts;
  }
  return result;
}

// From nothing, or from a checkpoint.
bmtJson BuildModel(const Options& options, const bmtInputFiles& files, vtkMultiTriangulationBuilder* builder)
{
  const double wall = bmtWallSeconds();
  const double cpu = bmtCpuSeconds();
  bmtWorkspace workspace(options.Workspace, options.Output);
  vtkNew<vtkPolyData> mesh;
  bmtInputReport report;
  std::unique_ptr<vtkMTTriangleStream> stream;
  {
    // Nothing can be lost yet.
    const bmtInterruptWatch watch(0.0, [] { return std::string(bmtInterrupt().what()); });
    stream = OpenInput(options, files, workspace, mesh, report);
    builder->SetLatticeBits(GetLatticeBits(options, *stream));
  }
  const std::array<double, 2> reading{ bmtCpuSeconds() - cpu, bmtWallSeconds() - wall };
  RunBuilder(builder, options, workspace, *stream, report);

  bmtJson result;
  result["output"] = options.Output;
  result["seconds"] = bmtWallSeconds() - wall;
  result["cpu_seconds"] = bmtCpuSeconds() - cpu;
  result["triangles_per_cpu_second"] =
    static_cast<double>(stream->GetNumberOfTriangles()) / std::max(1e-9, bmtCpuSeconds() - cpu);
  result["reading_seconds"] = reading[1];
  result["levels_seconds"] = builder->GetStageTimes().GetLevelSeconds();
  result["stages"] = DescribeStages(builder->GetStageTimes(), reading);
  result["input_streamed"] = mesh->GetNumberOfPoints() == 0;
  workspace.Describe(result);
  result.update(DescribeInput(report));
  return result;
}

bmtJson Build(const Options& options)
{
  bmtRequireWritable(options.Output);
  for (const std::string& path : options.Input.Paths)
  {
    bmtRequireReadable(path);
  }
  vtkNew<vtkMultiTriangulationBuilder> builder;
  Configure(options, options.LatticeBits, builder);
  const bmtInputFiles files(options.Input.Paths);
  std::string identity;
  {
    const bmtInterruptWatch watch(0.0, [] { return std::string(bmtInterrupt().what()); });
    identity = GetIdentity(options, files, builder);
  }
  builder->SetInputIdentity(identity.c_str());
  bmtJson result;
  if (options.Workspace.Resume && IsFinished(options.Output, identity))
  {
    bmtWorkspace(options.Workspace, options.Output).RemoveCheckpoint();
    result["output"] = options.Output;
    result["was_finished"] = true;
  }
  else
  {
    result = BuildModel(options, files, builder);
  }
  result.update(bmtDescribeModel(bmtOpenModel(options.Output)->GetGraph(), std::filesystem::file_size(options.Output)));
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
