// SPDX-License-Identifier: BSD-3-Clause
// bmt-report -o DIR [--quick] [--part NAME]... [MESH...]: measures error against run time and writes tables, charts and
// the page DIR/index.html, with a copy of its text in DIR/report.md. The exit code is 1 when a claim does not hold that
// is not known not to, 2 when something went wrong. Needs a display: CMake/with-display bmt-report ...
#include "MTReportContext.h"
#include "MTReportMachine.h"
#include "MTReportPage.h"
#include "MTReportParts.h"
#include "MTReportTimes.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

namespace
{
struct Options
{
  std::string Output;
  bool IsQuick = false;
  std::vector<std::string> Parts; // none: all
  std::vector<std::string> Meshes;
};

void AddOptions(CLI::App& app, Options& options)
{
  std::vector<std::string> names;
  for (const MTReportPart& part : MTReportGetParts())
  {
    names.emplace_back(part.Name);
  }
  app
    .add_option("-o,--output", options.Output, "Folder for the page, its tables and charts; made where it is not there")
    ->required();
  app.add_flag("--quick", options.IsQuick, "Small meshes and few repeats");
  app.add_option("--part", options.Parts, "A part of the report; several may be named; default: all")
    ->check(CLI::IsMember(names))
    ->allow_extra_args(false); // what follows its name is a mesh
  app.add_option("MESH", options.Meshes, "Meshes to measure beside the generated ones");
}

std::vector<MTReportSection> RunParts(const Options& options)
{
  MTReportContext context(options.Output, options.IsQuick, options.Meshes);
  std::vector<MTReportSection> sections;
  for (const MTReportPart& part : MTReportGetParts())
  {
    if (options.Parts.empty() ||
      std::find(options.Parts.begin(), options.Parts.end(), part.Name) != options.Parts.end())
    {
      context.Say(std::string("part ") + part.Name);
      const double begin = MTReportTimes::GetCpuSeconds();
      part.Run(context, sections.emplace_back(part.Title, options.Output));
      context.Say(std::string("part ") + part.Name + " took " +
        MTReportTable::Shorten(MTReportTimes::GetCpuSeconds() - begin) + " CPU seconds");
    }
  }
  return sections;
}

// Files by their names alone: where they lay says nothing to a reader.
std::string GetCommand(const Options& options)
{
  std::string command = std::string("bmt-report -o DIR") + (options.IsQuick ? " --quick" : "");
  for (const std::string& part : options.Parts)
  {
    command += " --part " + part;
  }
  for (const std::string& mesh : options.Meshes)
  {
    command += " " + std::filesystem::path(mesh).filename().string();
  }
  return command;
}

// The number of claims that do not hold and are not known not to.
int ListFailures(const std::vector<MTReportSection>& sections)
{
  int claims = 0;
  int failures = 0;
  for (const MTReportSection& section : sections)
  {
    for (const MTReportClaim& claim : section.GetClaims())
    {
      ++claims;
      const bool isKnown = !claim.KnownReason.empty();
      failures += claim.Holds || isKnown ? 0 : 1;
      if (!claim.Holds)
      {
        std::printf("does not hold%s: %s: %s\n", isKnown ? " (known)" : "", claim.Text.c_str(), claim.Figure.c_str());
      }
    }
  }
  std::printf("%d claims, %d of them fail\n", claims, failures);
  return failures;
}
}

int main(int argc, char** argv)
{
  try
  {
    Options options;
    CLI::App app("Error against run time: tables, charts and claims");
    AddOptions(app, options);
    CLI11_PARSE(app, argc, argv);
    std::filesystem::create_directories(options.Output);
    auto head = MTReportMachine::Describe();
    const std::vector<MTReportSection> sections = RunParts(options);
    head.emplace_back("command", GetCommand(options));
    MTReportPage::Write(options.Output, head, sections);
    return ListFailures(sections) > 0 ? 1 : 0;
  }
  catch (const std::exception& exception)
  {
    std::fprintf(stderr, "bmt-report: %s\n", exception.what());
    return 2;
  }
}
