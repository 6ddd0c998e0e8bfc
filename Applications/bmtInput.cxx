// SPDX-License-Identifier: BSD-3-Clause
#include "bmtInput.h"
#include "bmtModel.h"

#include "vtkMTCut.h"
#include "vtkMTGraph.h"
#include "vtkMTMeshMerge.h"
#include "vtkMTMeshReader.h"
#include "vtkMTPatchSource.h"
#include "vtkMTTerrain.h"
#include "vtkMTTextureCollector.h"
#include "vtkMTVolumeReader.h"
#include "vtkMultiTriangulation.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace
{
struct Part
{
  std::vector<std::string> Files;
  vtkSmartPointer<vtkPolyData> Mesh = vtkSmartPointer<vtkPolyData>::New();
};

void ReadModel(const std::string& path, vtkPolyData* mesh)
{
  const std::shared_ptr<const vtkMTPatchSource> source = bmtOpenModel(path);
  vtkMTCut cut(source->GetGraph());
  for (std::uint32_t node = 0; node < source->GetGraph().GetSink(); ++node)
  {
    cut.RefineWithDependencies(node);
  }
  std::string error;
  if (!vtkMultiTriangulation::CutToPolyData(*source, cut, mesh, error))
  {
    throw bmtError(error);
  }
}

void ReadMesh(const std::string& path, const bmtInput& input, vtkPolyData* mesh)
{
  std::string error;
  bool good = true;
  if (bmtIsModel(path))
  {
    ReadModel(path, mesh);
  }
  else if (vtkMTVolumeReader::CanRead(path))
  {
    if (!input.Iso)
    {
      throw bmtError(path + ": is a volume; say which isosurface is meant with --iso V");
    }
    good = vtkMTVolumeReader::ReadIsosurface(path, *input.Iso, input.GradientNormals, mesh, error);
  }
  else
  {
    good = vtkMTMeshReader::Read(path, mesh, error);
  }
  if (!good)
  {
    throw bmtError(error);
  }
}

// Adds the tile to the terrain, which is made when all are there.
void AddTile(const std::string& path, vtkMTTerrain& terrain, Part*& part, std::vector<std::unique_ptr<Part>>& parts)
{
  std::string error;
  if (!terrain.AddTile(path, error))
  {
    throw bmtError(error);
  }
  if (!part)
  {
    parts.push_back(std::make_unique<Part>());
    part = parts.back().get();
  }
  part->Files.push_back(path);
}

std::vector<std::unique_ptr<Part>> ReadParts(const bmtInput& input, bmtInputReport& report)
{
  std::vector<std::unique_ptr<Part>> parts;
  vtkMTTerrain terrain;
  terrain.VerticalScale = input.VerticalScale;
  terrain.Degrees = input.Degrees;
  Part* ofTerrain = nullptr;
  for (const std::string& path : input.Paths)
  {
    bmtRequireReadable(path);
    if (vtkMTTerrain::CanRead(path))
    {
      AddTile(path, terrain, ofTerrain, parts);
    }
    else
    {
      parts.push_back(std::make_unique<Part>());
      parts.back()->Files.push_back(path);
      ReadMesh(path, input, parts.back()->Mesh);
    }
    bmtThrowIfInterrupted();
  }
  std::string error;
  if (ofTerrain && !terrain.Make(ofTerrain->Mesh, error))
  {
    throw bmtError(error);
  }
  for (const auto& [name, count] : terrain.GetReport())
  {
    report.Counts[name] += count;
  }
  return parts;
}
}

const char* bmtGetInputKinds()
{
  return "PLY, STL, OBJ, VTP, VTK, glTF, GLB; volumes with --iso (.vti, .mhd, .mha, .nrrd, .nhdr, .nii, .nii.gz, "
         ".vtk); "
         "tiles of terrain (.hgt, .hgt.gz, .dem, and .tif where GDAL is built in)";
}

void bmtAddInputOptions(CLI::App& command, bmtInput& input)
{
  command.add_option("--iso", input.Iso, "Of volumes: the value of the isosurface to take");
  command.add_flag("--gradient-normals", input.GradientNormals,
    "Of volumes: normals from the volume's gradient, not from the triangles");
  command.add_option("--vertical-scale", input.VerticalScale, "Of terrain: what heights are multiplied by")
    ->capture_default_str();
  command.add_flag("--degrees", input.Degrees,
    "Of terrain: keep longitude and latitude in degrees, instead of a local frame in metres");
}

namespace
{
void CollectTextures(const std::vector<std::unique_ptr<Part>>& parts, bmtInputReport& report)
{
  vtkMTTextureCollector collector;
  for (std::size_t part = 0; part < parts.size(); ++part)
  {
    collector.Collect(parts[part]->Files.front(), parts[part]->Mesh, parts.size() > 1 ? static_cast<int>(part) : -1);
  }
  report.Textures = collector.GetTextures();
  report.Problems = collector.GetProblems();
}
}

bmtInputReport bmtReadInput(const bmtInput& input, vtkPolyData* mesh)
{
  bmtInputReport report;
  std::vector<std::unique_ptr<Part>> parts = ReadParts(input, report);
  CollectTextures(parts, report);
  if (parts.size() == 1)
  {
    mesh->ShallowCopy(parts.front()->Mesh);
    return report;
  }
  std::vector<vtkSmartPointer<vtkPolyData>> meshes;
  for (const auto& part : parts)
  {
    bmtJson entry;
    entry["id"] = report.Parts.size();
    entry["files"] = part->Files;
    entry["cells"] = part->Mesh->GetNumberOfCells();
    report.Parts.push_back(entry);
    meshes.push_back(part->Mesh);
  }
  std::string error;
  if (!vtkMTMeshMerge::Merge(meshes, mesh, report.Counts, error))
  {
    throw bmtError(error);
  }
  bmtThrowIfInterrupted();
  return report;
}

bmtInputStream::bmtInputStream(vtkPolyData* mesh, const std::map<std::string, std::int64_t>& counts)
  : Mesh(mesh)
  , Report(this->Mesh.GetReport())
{
  for (const auto& [name, count] : counts)
  {
    this->Report[name] += count;
  }
}
