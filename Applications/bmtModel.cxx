// SPDX-License-Identifier: BSD-3-Clause
#include "bmtModel.h"

#include "vtkMTCut.h"
#include "vtkMTFileAccess.h"
#include "vtkMTFileSource.h"
#include "vtkMTGraph.h"
#include "vtkMTLookupTable.h"
#include "vtkMTMeshWriter.h"

#include "vtkImageData.h"
#include "vtkPolyData.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdlib>

//------------------------------------------------------------------------------
// Multi-Triangulation files

std::shared_ptr<const vtkMTPatchSource> bmtOpenModel(const std::string& path)
{
  std::string error;
  if (!vtkMTFileAccess::CanRead(path, error))
  {
    throw bmtError(error);
  }
  if (!vtkMTFileSource::CanRead(path))
  {
    throw bmtError(path + ": is no Multi-Triangulation file; make one with 'bmt build " + path + " -o OUT.bmt'");
  }
  auto source = std::make_shared<vtkMTFileSource>();
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
    static const char* const roles[] = { "plain", "input_cell_ids", "made_normals", "exact_points", "input_point_ids",
      "materials", "heights" };
    list.push_back(
      { { "name", array.Name }, { "association", array.Association == vtkMTArrayInfo::Point ? "point" : "cell" },
        { "type", vtkImageScalarTypeNameMacro(array.Type) }, { "components", array.Components },
        { "resampling", resampling[array.Resampling] }, { "role", roles[array.Role] },
        { "taken_for", array.GetMeaning() } });
    for (const auto& [value, name] : vtkMTLookupTable::GetNames(array))
    {
      list.back()["names"][value] = name;
    }
  }
  return list;
}

// Of each measure its largest value, which is the source's, as measures are saturated.
bmtJson DescribeMeasures(const vtkMTGraph& graph)
{
  bmtJson list = bmtJson::array();
  for (const vtkMTMeasure& measure : graph.Measures)
  {
    list.push_back(
      { { "name", measure.Name }, { "largest", measure.Values.empty() ? 0.0 : measure.Values[graph.GetSource()] } });
  }
  return list;
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
  json["bytes_per_triangle"] = graph.InputCounts.Triangles > 0
    ? static_cast<double>(bytes) / static_cast<double>(graph.InputCounts.Triangles)
    : 0.0;
  json["bounds"] = std::vector<double>(bounds, bounds + 6);
  json["crs"] = graph.Crs;
  json["units"] = graph.Units;
  json["arrays"] = DescribeArrays(graph.Arrays);
  json["partition"] = GetStrategy(graph, "partition");
  json["simplifier"] = GetStrategy(graph, "simplifier");
  json["settings"] = bmtJson(graph.Settings);
  const double target = std::atof(GetSetting(graph, "floor_triangles").c_str());
  json["conditioning"] = { { "depth", conditioning.Depth }, { "diameter_ratio", conditioning.DiameterRatio },
    { "fully_shared_borders", conditioning.FullySharedBorders },
    { "largest_region_over_target", target > 0.0 ? static_cast<double>(conditioning.LargestFloor) / target : 0.0 } };
  json["root_triangles"] = graph.GetNumberOfRootTriangles();
  json["blocked"] = bmtJson(graph.Blocked);
  json["input_report"] = bmtJson(graph.InputReport);
  for (const vtkMTBlobInfo& blob : graph.Blobs)
  {
    bmtJson entry = { { "name", blob.Name }, { "type", blob.Type } };
    entry.update(bmtJson(blob.Properties));
    json["blobs"].push_back(entry);
  }
  json["lattice_step"] = graph.Lattice.Step;
  json["largest_shift"] = graph.Lattice.MaximumShift;
  json["measures"] = DescribeMeasures(graph);
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
