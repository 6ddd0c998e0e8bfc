// SPDX-License-Identifier: BSD-3-Clause
#include "bmtCommon.h"
#include "bmtModel.h"

#include "vtkMTFileSource.h"
#include "vtkMTGraph.h"
#include "vtkMTPatchSource.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <iostream>
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

constexpr std::size_t MostNodesToDraw = 500;

// Coarse above fine: an arc leaves the node whose floor its patch belongs to.
void PrintDot(const std::string& path, std::ostream& out)
{
  const std::shared_ptr<const vtkMTPatchSource> source = bmtOpenModel(path);
  const vtkMTGraph& graph = source->GetGraph();
  if (graph.Nodes.size() > MostNodesToDraw)
  {
    throw bmtError(path + ": has " + std::to_string(graph.Nodes.size()) + " nodes; only a DAG of at most " +
      std::to_string(MostNodesToDraw) + " can be drawn: build with larger --patch-triangles, or from a smaller mesh");
  }
  out.precision(4);
  out << "digraph multi_triangulation {\n  node [shape=box];\n";
  for (std::size_t n = 0; n < graph.Nodes.size(); ++n)
  {
    const vtkMTNode& node = graph.Nodes[n];
    out << "  n" << n << " [label=\"";
    if (n == 0)
    {
      out << "source";
    }
    else if (n == graph.GetSink())
    {
      out << "sink";
    }
    else
    {
      out << "node " << n << "\\nlevel " << node.Level;
    }
    out << "\\nerror " << node.Error << "\"];\n";
  }
  for (const vtkMTArc& arc : graph.Arcs)
  {
    out << "  n" << arc.From << " -> n" << arc.To << " [label=\"" << arc.Triangles << "\"];\n";
  }
  out << "}\n";
}
}

void bmtAddInfo(CLI::App& app, bmtContext& context)
{
  auto file = std::make_shared<std::string>();
  auto dot = std::make_shared<bool>(false);
  CLI::App* command = app.add_subcommand("info", "Print the figures of a Multi-Triangulation file");
  command->footer(
    "Level 0 is the finest. Patches are not read: 'bmt verify' does that.\n"
    "'bmt info --dot x.bmt | dot -Tsvg -o x.svg' draws a small DAG: nodes with level and error, arcs with "
    "the triangles of\n"
    "their patches.");
  bmtAddModelArgument(*command, *file);
  CLI::Option* graphviz = command->add_flag(
    "--dot", *dot, "Print the DAG as a Graphviz digraph instead; an error where it has more than 500 nodes");
  bmtAddCommonOptions(*command, context);
  graphviz->excludes("--json");
  command->callback(
    [file, dot, &context]
    {
      context.Run = [file, dot, &context]
      {
        if (*dot)
        {
          PrintDot(*file, std::cout);
          bmtFinishOutput();
        }
        else
        {
          bmtPrint(context, Inform(*file));
        }
        return bmtExit::Success;
      };
    });
}
