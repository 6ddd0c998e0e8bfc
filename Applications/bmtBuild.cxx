// SPDX-License-Identifier: BSD-3-Clause
#include "bmtCommon.h"
#include "bmtInput.h"
#include "bmtModel.h"

#include "vtkMTEdgeCollapse.h"
#include "vtkMTFileBuildReport.h"
#include "vtkMTPartitionStrategy.h"
#include "vtkMTPatchSource.h"
#include "vtkMTStageTimes.h"
#include "vtkMultiTriangulationFileBuilder.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkNew.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <sys/resource.h>

namespace
{
using Builder = vtkMultiTriangulationFileBuilder;

struct BuildOptions
{
  vtkNew<Builder> Settings; // by the options that are not kept here
  bmtInput Input;
  std::string Output;
  std::string Partition = "v";
  std::string Simplifier = "fast";
  std::string Memory; // a size; empty: a quarter of the machine's
};

//------------------------------------------------------------------------------
// Options to settings
vtkTypeInt64 ParseSize(const std::string& text)
{
  char* end = nullptr;
  double bytes = std::strtod(text.c_str(), &end);
  std::string unit(end + (*end == ' ' ? 1 : 0)); // messages print one
  std::transform(unit.begin(), unit.end(), unit.begin(), [](unsigned char c) { return std::tolower(c); });
  const std::string prefixes = "kmgt";
  const std::size_t prefix = unit.empty() ? std::string::npos : prefixes.find(unit[0]);
  const std::string rest = unit.substr(prefix == std::string::npos ? 0 : 1);
  const bool isDecimal = rest == "b"; // "kb"; "k" and "kib" are powers of two
  bytes *= prefix == std::string::npos ? 1.0 : std::pow(isDecimal ? 1000.0 : 1024.0, static_cast<double>(prefix + 1));
  const bool isUnit = rest.empty() || isDecimal || (rest == "ib" && prefix != std::string::npos);
  if (isUnit && end != text.c_str() && bytes >= 1.0 && bytes < 1e18)
  {
    return static_cast<vtkTypeInt64>(bytes);
  }
  throw bmtError("\"" + text + "\" is no size; say 512MiB, 1.5GiB or a number of bytes");
}

void ConfigureInput(const BuildOptions& options, Builder* builder)
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
  if (builder->GetVerticalScale() != options.Input.VerticalScale ||
    builder->GetIsoValue() != options.Input.IsoValue.value_or(0.0))
  {
    throw bmtError("nothing was built"); // the builder has reported why
  }
}

void Configure(const BuildOptions& options, Builder* builder)
{
  ConfigureInput(options, builder);
  builder->SetOutputFileName(options.Output.c_str());
  builder->SetPartitionStrategy(vtkMTPartitionStrategy::MakeByName(options.Partition));
  vtkNew<vtkMTEdgeCollapse> simplifier;
  simplifier->SetModeByName(options.Simplifier.c_str());
  builder->SetSimplifier(simplifier);
  builder->SetMemoryLimit(options.Memory.empty() ? Builder::GetDefaultMemoryLimit() : ParseSize(options.Memory));
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
    stages[vtkMTStageTimes::GetName(stage)] = {
      { "cpu_seconds", times.GetCpuSeconds(stage) + (isReading ? report.ReadingCpuSeconds : 0.0) },
      { "wall_seconds", times.GetWallSeconds(stage) + (isReading ? report.ReadingWallSeconds : 0.0) }
    };
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
    result["parts"].push_back({ { "id", result["parts"].size() }, { "files", part.Files }, { "cells", part.Cells } });
  }
}

std::uint64_t GetPeakMemory()
{
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

bmtJson DescribeBuild(Builder* builder)
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

std::string GetResumeAdvice(const Builder* builder, bool hasCheckpoint)
{
  return hasCheckpoint
    ? "; the same command with --resume goes on from the last checkpoint, in " + builder->GetWorkFolder()
    : "";
}

// Errors are thrown here; what the library would say itself is kept quiet.
void Run(Builder* builder)
{
  bmtProgress progress("building");
  bmtFollow(builder, progress);
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

bmtJson Build(const BuildOptions& options)
{
  Builder* builder = options.Settings;
  Configure(options, builder);
  Run(builder);
  bmtJson result = DescribeBuild(builder);
  result.update(bmtDescribeModel(bmtOpenModel(options.Output)->GetGraph(), std::filesystem::file_size(options.Output)));
  return result;
}

//------------------------------------------------------------------------------
template <class Value>
CLI::Option* AddSetting(
  CLI::App& command, const char* name, Builder* builder, void (Builder::*set)(Value), const char* text)
{
  return command.add_option_function<Value>(
    name, [=](const Value& value) { (builder->*set)(value); }, text);
}

void AddSettings(CLI::App& command, Builder* builder)
{
  const auto whole = [&](const char* name, void (Builder::*set)(int), std::array<int, 3> range, const char* text)
  {
    AddSetting(command, name, builder, set, text)
      ->check(CLI::Range(range[0], range[2]))
      ->default_str(std::to_string(range[1]));
  };
  whole("--patch-triangles", &Builder::SetPatchTriangles, { 16, 1000, 16384 }, "Wanted mean triangles of a patch");
  whole("--lattice-bits", &Builder::SetLatticeBits, { 10, 24, 31 }, "2^N lattice steps on the longest side");
  whole("--normal-bits", &Builder::SetNormalBits, { 6, 12, 16 }, "Bits of both coordinates of normals that are made");
  whole("--direct-levels", &Builder::SetDirectLevels, { 1, 5, 8 },
    "Errors are held against the mesh so many levels below; 1: those of steps add up, faster to make and looser");
  whole("--threads", &Builder::SetNumberOfThreads, { 0, 0, 1024 },
    "Threads; 0: as many as there are processors. No influence on the file");
  AddSetting(command, "--precision", builder, &Builder::SetPrecision,
    "No point moves by more than this, in model units, when it is put on the lattice; in place of --lattice-bits")
    ->check(CLI::PositiveNumber);
  AddSetting(command, "--feature-angle", builder, &Builder::SetFeatureAngle,
    "Edges sharper than this (degrees) are hard where normals are made; none; auto: 30 for CAD, none otherwise")
    ->transform(CLI::Transformer(std::map<std::string, double>{ { "auto", -1.0 }, { "none", 180.0 } }))
    ->check(CLI::Range(-1.0, 180.0));
  AddSetting(command, "--compression", builder, &Builder::SetCompression,
    "none, fast (packed, LZ4) or small (packed, zstd: a little smaller, slower)")
    ->transform(CLI::CheckedTransformer(std::map<std::string, int>{ { "none", 0 }, { "fast", 1 }, { "small", 2 } }))
    ->default_str("fast");
  AddSetting(command, "--ids", builder, &Builder::SetInputIds,
    "Levels with the input's cell ids, by which picking finds cells: none, finest, all")
    ->transform(CLI::CheckedTransformer(std::map<std::string, int>{ { "none", 0 }, { "finest", 1 }, { "all", 2 } }))
    ->default_str("finest");
  const auto list = [&](const char* name, void (Builder::*add)(const char*), const char* text)
  {
    const auto set = [=](const std::vector<std::string>& names)
    { std::for_each(names.begin(), names.end(), [=](const std::string& one) { (builder->*add)(one.c_str()); }); };
    return command.add_option_function<std::vector<std::string>>(name, set, text)->delimiter(',');
  };
  list("--arrays", &Builder::AddArrayName, "The input's arrays to keep, with commas between; \"\": none")
    ->each([=](const std::string&) { builder->KeepAllArraysOff(); });
  list("--labels", &Builder::AddLabelArrayName, "Arrays that are labels, which never mix: whatever their type");
  list("--values", &Builder::AddValueArrayName, "Arrays that are values, which have a mean: integers too");
  list("--certify-values", &Builder::AddCertifiedArrayName, "Scalars to be bounded jointly with the distance");
  const auto flag = [&](const char* name, void (Builder::*set)(), const char* text)
  {
    command.add_flag_callback(
      name, [=] { (builder->*set)(); }, text);
  };
  flag("--no-ids", &Builder::SetInputIdsToNone, "The same as --ids none");
  flag("--point-ids", &Builder::InputPointIdsOn, "Keep the input's point ids on the finest level");
  flag("--exact", &Builder::ExactPointsOn, "Keep the input's coordinates bit for bit, for 'bmt extract --level 0'");
  flag("--certify-normals", &Builder::CertifyNormalsOn, "Bound normals too, for 'bmt render --metric normals'");
  flag("--keep-far-outliers", &Builder::KeepFarOutliersOn,
    "Keep triangles so far away that they coarsen the lattice for all others; a few are left out otherwise");
  flag("--no-normals", &Builder::MakeNormalsOff, "Make no normals where the input has none");
  flag("--resume", &Builder::ResumeOn, "Go on with the build that was interrupted, if there is one");
  command.add_option_function<std::string>(
    "--temp", [=](const std::string& folder) { builder->SetTemporaryFolder(folder.c_str()); },
    "Folder for temporary files; default: that of the output");
}

void AddOptions(CLI::App& command, BuildOptions& options)
{
  command.add_option("INPUT", options.Input.Paths, std::string("What to build from: ") + bmtGetInputKinds())
    ->required();
  command.add_option("-o,--output", options.Output, "The Multi-Triangulation file to write")->required();
  bmtAddInputOptions(command, options.Input);
  command
    .add_option("--partition", options.Partition,
      "Regions: v (Voronoi), regular (cubes, octahedra), kd (boxes), quad, hexagon (or with a domain: quad-plane)")
    ->check(CLI::IsMember(vtkMTPartitionStrategy::GetNames()))
    ->capture_default_str();
  command
    .add_option("--simplifier", options.Simplifier,
      "fast (memoryless), best (stock loop), or CGAL's own lindstrom-turk and garland-heckbert")
    ->check(CLI::IsMember({ "fast", "best", "lindstrom-turk", "garland-heckbert" }))
    ->capture_default_str();
  command.add_option("--memory", options.Memory,
    "Most memory that the process may hold, such as 512MiB or 2GiB; default: a quarter of the machine's. No influence "
    "on the file");
  AddSettings(command, options.Settings);
}
}

void bmtAddBuild(CLI::App& app, bmtContext& context)
{
  auto options = std::make_shared<BuildOptions>();
  CLI::App* command = app.add_subcommand("build", "Build a Multi-Triangulation file from a mesh");
  command->footer(
    "Several inputs become one model with a cell array PartId (0, 1 ... in the order of the command line). Parts that\n"
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
