// SPDX-License-Identifier: BSD-3-Clause
#include "bmtCommon.h"
#include "bmtModel.h"

#include "vtkMTFileSource.h"
#include "vtkMTGraph.h"
#include "vtkMTPatchSource.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>

namespace
{
bmtJson Inform(const std::string& path)
{
  const std::shared_ptr<const vtkMTPatchSource> source = bmtOpenModel(path);
  const vtkMTGraph& graph = source->GetGraph();
  bmtJson json = bmtDescribeModel(graph, std::filesystem::file_size(path));
  if (const auto* file = dynamic_cast<const vtkMTFileSource*>(source.get()))
  {
    const std::vector<std::uint64_t> sizes = file->GetSizeByKind();
    json["bytes_of"]["geometry"] = sizes[0];
    for (std::size_t i = 0; i < graph.Arrays.size(); ++i)
    {
      json["bytes_of"][graph.Arrays[i].Name] = sizes[i + 1];
    }
  }
  return json;
}
}

void bmtAddInfo(CLI::App& app, bmtContext& context)
{
  auto file = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("info", "Print the figures of a Multi-Triangulation file");
  command->footer("Level 0 is the finest. Patches are not read: 'bmt verify' does that.");
  bmtAddModelArgument(*command, *file);
  bmtAddCommonOptions(*command, context);
  command->callback(
    [file, &context]
    {
      context.Run = [file, &context]
      {
        bmtPrint(context, Inform(*file));
        return bmtExit::Success;
      };
    });
}
