// SPDX-License-Identifier: BSD-3-Clause
#include "bmtCommon.h"
#include "bmtInput.h"
#include "bmtModel.h"

#include "vtkMTEdgeCollapse.h"
#include "vtkMTFileBuildReport.h"
#include "vtkMTPatchSource.h"
#include "vtkMTRegularPartition.h"
#include "vtkMTStageTimes.h"
#include "vtkMultiTriangulationFileBuilder.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkNew.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <sys/resource.h>

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
  std::string Memory; // a size; empty: a quarter of the machine's
  std::string Temp;
  bool Resume = false;
};

//------------------------------------------------------------------------------
// Options to settings
vtkTypeInt64 GetMemoryLimit(const std::string& text)
{
  if (text.empty())
  {
    return vtkMultiTriangulationFileBuilder::GetDefaultMemoryLimit();
  }
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  std::string unit(end);
  std::transform(unit.begin(), unit.end(), unit.begin(), [](unsigned char c) { return std::tolower(c); });
  const std::pair<const char*, double> units[] = { { "", 1.0 }, { "b", 1.0 }, { "k", 1024.0 }, { "kib", 1024.0 },
    { "kb", 1e3 }, { "m", 1048576.0 }, { "mib", 1048576.0 }, { "mb", 1e6 }, { "g", 1073741824.0 },
    { "gib", 1073741824.0 }, { "gb", 1e9 }, { "t", 1099511627776.0 }, { "tib", 1099511627776.0 }, { "tb", 1e12 } };
  for (const auto& [name, factor] : units)
  {
    const double bytes = number * factor;
    if (unit == name && end != text.c_str() && bytes >= 1.0 && bytes < 1e18)
    {
      return static_cast<vtkTypeInt64>(bytes);
    }
  }
  throw bmtError("\"" + text + "\" is no size; say 512MiB, 1.5GiB or a number of bytes");
}

void ConfigureInput(const Options& options, vtkMultiTriangulationFileBuilder* builder)
{
  for (const std::string& path : options.Input.Paths)
  {
    builder->AddFileName(path.c_str());
  }
  if (options.Input.IsoValue)
  {
    builder->SetIsoValue(*options.Input.IsoValue);
  }
  builder->SetGradientNormals(options.Input.GradientNormals);
  builder->SetVerticalScale(options.Input.VerticalScale);
  builder->SetDegrees(options.Input.Degrees);
  builder->SetKeepAllArrays(options.ArraysOption->count() == 0);
  for (const std::string& name : options.Arrays)
  {
    builder->AddArrayName(name.c_str());
  }
}

void Configure(const Options& options, vtkMultiTriangulationFileBuilder* builder)
{
  ConfigureInput(options, builder);
  builder->SetOutputFileName(options.Output.c_str());
  if (options.Partition == "regular")
  {
    builder->SetPartitionStrategy(vtkNew<vtkMTRegularPartition>());
  }
  vtkNew<vtkMTEdgeCollapse> simplifier;
  simplifier->SetModeByName(options.Simplifier.c_str());
  builder->SetSimplifier(simplifier);
  builder->SetPatchTriangles(options.PatchTriangles);
  builder->SetLatticeBits(options.LatticeBits);
  builder->SetPrecision(options.Precision);
  builder->SetCompression(options.Compression == "none" ? vtkMultiTriangulationFileBuilder::NoCompression
      : options.Compression == "small"                  ? vtkMultiTriangulationFileBuilder::SmallCompression
                                                        : vtkMultiTriangulationFileBuilder::FastCompression);
  builder->SetNumberOfThreads(options.Threads);
  builder->SetMakeNormals(!options.NoNormals);
  builder->SetKeepIds(!options.NoIds);
  builder->SetKeepFarOutliers(options.KeepFarOutliers);
  builder->SetExactPoints(options.Exact);
  builder->SetMemoryLimit(GetMemoryLimit(options.Memory));
  builder->SetTemporaryFolder(options.Temp.c_str());
  builder->SetResume(options.Resume);
}

//------------------------------------------------------------------------------
// The report
bmtJson DescribeStages(const vtkMTStageTimes& times, const vtkMTFileBuildReport& report)
{
  bmtJson stages = bmtJson::object();
  for (int i = 0; i < vtkMTStageTimes::NumberOfStages; ++i)
  {
    const auto stage = static_cast<vtkMTStageTimes::StageType>(i);
    const bool isReading = stage == vtkMTStageTimes::Read;
    bmtJson& entry = stages[vtkMTStageTimes::GetName(stage)];
    entry["cpu_seconds"] = times.GetCpuSeconds(stage) + (isReading ? report.ReadingCpuSeconds : 0.0);
    entry["wall_seconds"] = times.GetWallSeconds(stage) + (isReading ? report.ReadingWallSeconds : 0.0);
  }
  return stages;
}

void DescribeInput(const vtkMTBuildInput::Result& input, bmtJson& result)
{
  if (!input.Textures.empty() || !input.Problems.empty())
  {
    bmtJson list = bmtJson::array();
    for (const vtkMTTexture& texture : input.Textures)
    {
      list.push_back({ { "name", texture.Name }, { "type", texture.MimeType }, { "bytes", texture.Bytes.size() },
        { "coordinates", texture.Coordinates }, { "material", texture.Material }, { "part", texture.Part } });
    }
    result["textures_of_input"] = list;
    result["texture_problems"] = input.Problems;
  }
  for (const vtkMTBuildInput::Part& part : input.Parts)
  {
    bmtJson entry;
    entry["id"] = result["parts"].size();
    entry["files"] = part.Files;
    entry["cells"] = part.Cells;
    result["parts"].push_back(entry);
  }
}

std::uint64_t GetPeakMemory()
{
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

bmtJson DescribeBuild(vtkMultiTriangulationFileBuilder* builder)
{
  const vtkMTFileBuildReport& report = builder->GetReport();
  bmtJson result;
  result["output"] = builder->GetOutputFileName();
  if (report.WasFinished)
  {
    result["was_finished"] = true;
    return result;
  }
  result["seconds"] = report.WallSeconds;
  result["cpu_seconds"] = report.CpuSeconds;
  result["triangles_per_cpu_second"] = static_cast<double>(report.InputTriangles) / std::max(1e-9, report.CpuSeconds);
  result["reading_seconds"] = report.ReadingWallSeconds;
  result["levels_seconds"] = builder->GetStageTimes().GetLevelSeconds();
  result["stages"] = DescribeStages(builder->GetStageTimes(), report);
  result["input_streamed"] = report.Input.IsStreamed;
  result["memory_limit_bytes"] = report.MemoryLimit;
  result["peak_memory_bytes"] = GetPeakMemory();
  result["temporary_bytes"] = report.TemporaryBytes;
  result["temporary_bytes_estimated"] = report.TemporaryBytesEstimated;
  DescribeInput(report.Input, result);
  return result;
}

//------------------------------------------------------------------------------
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

std::string GetResumeAdvice(const vtkMultiTriangulationFileBuilder* builder, bool hasCheckpoint)
{
  return hasCheckpoint
    ? "; the same command with --resume goes on from the last checkpoint, in " + builder->GetWorkFolder()
    : "";
}

// Errors are thrown here; what the library would say itself is kept quiet.
void Run(vtkMultiTriangulationFileBuilder* builder)
{
  bmtProgress progress("building");
  const vtkNew<vtkCallbackCommand> advance;
  advance->SetCallback(Advance);
  advance->SetClientData(&progress);
  builder->AddObserver(vtkCommand::ProgressEvent, advance);
  const vtkNew<vtkCallbackCommand> quiet;
  builder->AddObserver(vtkCommand::ErrorEvent, quiet);
  builder->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, quiet);
  const std::string interrupted = "interrupted; " + std::string(builder->GetOutputFileName()) + " is as it was";
  const bmtInterruptWatch watch(
    0.6, [builder, interrupted] { return interrupted + GetResumeAdvice(builder, builder->ReleaseFilesBeforeExit()); });
  if (!builder->Write())
  {
    const std::string advice = GetResumeAdvice(builder, builder->GetHasCheckpoint());
    if (bmtIsInterrupted())
    {
      throw bmtInterrupt(interrupted + advice);
    }
    throw bmtError(builder->GetErrorMessage() + bmtGetAdvice(builder->GetErrorCode()) + advice);
  }
}

bmtJson Build(const Options& options)
{
  const vtkNew<vtkMultiTriangulationFileBuilder> builder;
  Configure(options, builder);
  Run(builder);
  bmtJson result = DescribeBuild(builder);
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
  command.add_option("--memory", options.Memory,
    "Most memory that the process may hold, such as 512MiB or 2GiB; default: a quarter of the machine's. No influence "
    "on "
    "the file");
  command.add_option("--temp", options.Temp, "Folder for temporary files; default: that of the output");
  command.add_flag("--resume", options.Resume, "Go on with the build that was interrupted, if there is one");
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
