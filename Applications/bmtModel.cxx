// SPDX-License-Identifier: BSD-3-Clause
#include "bmtModel.h"

#include "vtkMTCut.h"
#include "vtkMTFileSource.h"
#include "vtkMTGraph.h"
#include "vtkMTMeshWriter.h"

#include "vtkImageData.h"
#include "vtkPolyData.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdlib>

//------------------------------------------------------------------------------
// Multi-Triangulation files

bool bmtIsModel(const std::string& path)
{
  return vtkMTFileSource::CanRead(path);
}

std::shared_ptr<const vtkMTPatchSource> bmtOpenModel(const std::string& path)
{
  bmtRequireReadable(path);
  if (!bmtIsModel(path))
  {
    throw bmtError(path + ": is no Multi-Triangulation file; make one with 'bmt build " + path + " -o OUT.bmt'");
  }
  auto source = std::make_shared<vtkMTFileSource>();
  std::string error;
  if (!source->Open(path, error))
  {
    throw bmtError(error);
  }
  return source;
}

void bmtAddModelArgument(CLI::App& command, std::string& path)
{
  command.add_option("FILE", path, "A Multi-Triangulation file (.bmt)")->required();
}

//------------------------------------------------------------------------------
// Figures

namespace
{
bmtJson DescribeArrays(const std::vector<vtkMTArrayInfo>& arrays)
{
  bmtJson list = bmtJson::array();
  for (const vtkMTArrayInfo& array : arrays)
  {
    static const char* const resampling[] = { "interpolate", "nearest", "direction" };
    static const char* const roles[] = { "plain", "input_cell_ids", "made_normals", "exact_points" };
    bmtJson entry;
    entry["name"] = array.Name;
    entry["association"] = array.Association == vtkMTArrayInfo::Point ? "point" : "cell";
    entry["type"] = vtkImageScalarTypeNameMacro(array.Type);
    entry["components"] = array.Components;
    entry["resampling"] = resampling[array.Resampling];
    entry["role"] = roles[array.Role];
    list.push_back(entry);
  }
  return list;
}

template <class Map>
bmtJson DescribeMap(const Map& map)
{
  bmtJson json = bmtJson::object();
  for (const auto& [name, value] : map)
  {
    json[name] = value;
  }
  return json;
}

std::string GetSetting(const vtkMTGraph& graph, const std::string& name)
{
  const auto found = graph.Settings.find(name);
  return found == graph.Settings.end() ? "" : found->second;
}

// The settings of a strategy begin with its name.
std::string GetStrategy(const vtkMTGraph& graph, const std::string& name)
{
  const std::string settings = GetSetting(graph, name);
  return settings.substr(0, settings.find(' '));
}

// The largest floor over what the partition was asked for.
double GetLargestRegion(const vtkMTGraph& graph)
{
  std::uint64_t largest = 0;
  for (std::size_t n = 1; n + 1 < graph.Nodes.size(); ++n)
  {
    std::uint64_t floor = 0;
    for (std::uint32_t i = 0; i < graph.Nodes[n].OutCount; ++i)
    {
      floor += graph.Arcs[graph.Nodes[n].FirstOut + i].Triangles;
    }
    largest = std::max(largest, floor);
  }
  const double target = std::atof(GetSetting(graph, "floor_triangles").c_str());
  return target > 0.0 ? static_cast<double>(largest) / target : 0.0;
}
}

bmtJson bmtDescribeModel(const vtkMTGraph& graph, std::uint64_t bytes)
{
  double bounds[6];
  graph.GetBounds(bounds);
  const vtkMTGraph::Conditioning conditioning = graph.GetConditioning();
  bmtJson json;
  json["triangles"] = graph.InputCounts.Triangles;
  json["stored_triangles"] = graph.GetNumberOfFinestTriangles();
  json["nodes"] = graph.Nodes.size();
  json["patches"] = graph.Arcs.size();
  json["levels"] = graph.GetNumberOfLevels();
  json["bytes"] = bytes;
  json["bytes_per_triangle"] =
    graph.InputCounts.Triangles > 0 ? static_cast<double>(bytes) / static_cast<double>(graph.InputCounts.Triangles) : 0.0;
  json["bounds"] = std::vector<double>(bounds, bounds + 6);
  json["arrays"] = DescribeArrays(graph.Arrays);
  json["partition"] = GetStrategy(graph, "partition");
  json["simplifier"] = GetStrategy(graph, "simplifier");
  json["settings"] = DescribeMap(graph.Settings);
  json["conditioning"]["depth"] = conditioning.Depth;
  json["conditioning"]["diameter_ratio"] = conditioning.DiameterRatio;
  json["conditioning"]["fully_shared_borders"] = conditioning.FullySharedBorders;
  json["conditioning"]["largest_region_over_target"] = GetLargestRegion(graph);
  json["root_triangles"] = graph.GetNumberOfRootTriangles();
  json["blocked"] = DescribeMap(graph.Blocked);
  json["input_report"] = DescribeMap(graph.InputReport);
  for (const vtkMTBlobInfo& blob : graph.Blobs)
  {
    bmtJson entry;
    entry["name"] = blob.Name;
    entry["type"] = blob.Type;
    entry.update(bmtJson(blob.Properties));
    json["blobs"].push_back(entry);
  }
  json["lattice_step"] = graph.Lattice.Step;
  json["largest_shift"] = graph.Lattice.MaximumShift;
  json["finest_error"] = graph.IsEmpty() ? 0.0 : graph.Nodes[graph.GetSink()].Error;
  json["coarsest_error"] = graph.IsEmpty() ? 0.0 : vtkMTCut(graph).GetError();
  return json;
}

//------------------------------------------------------------------------------
// Meshes

void bmtRequireMeshEnding(const std::string& path)
{
  if (!vtkMTMeshWriter::CanWrite(path))
  {
    throw bmtError(path + ": unknown ending; .ply, .stl, .obj, .vtp, .gltf and .glb can be written");
  }
}

std::vector<std::string> bmtWriteMesh(const std::string& path, vtkPolyData* mesh)
{
  std::string error;
  std::vector<std::string> dropped;
  if (!vtkMTMeshWriter::Write(path, mesh, error, &dropped))
  {
    throw bmtError(error);
  }
  return dropped;
}
