// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file meshes_from_data.cxx
 * @brief makes large triangle meshes of real data: terrain of SRTM tiles, isosurfaces of volumes
 *
 *   meshes_from_data terrain N36W005.hgt.gz N36W004.hgt.gz -o terrain.ply
 *   meshes_from_data isosurface bonsai.vti --value 40 -o bonsai.vtp
 */
#include "vtkMTMeshWriter.h"
#include "vtkMTTerrain.h"
#include "vtkMTVolumeReader.h"

#include "vtkNew.h"
#include "vtkPolyData.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{
void MakeTerrain(const std::vector<std::string>& tiles, vtkPolyData* mesh)
{
  vtkMTTerrain terrain;
  std::string error;
  for (const std::string& tile : tiles)
  {
    if (!terrain.AddTile(tile, error))
    {
      throw std::runtime_error(error);
    }
  }
  if (!terrain.Make(mesh, error))
  {
    throw std::runtime_error(error);
  }
}

void MakeIsosurface(const std::string& path, double value, vtkPolyData* mesh)
{
  std::string error;
  if (!vtkMTVolumeReader::ReadIsosurface(path, value, false, mesh, error))
  {
    throw std::runtime_error(error);
  }
}

void WriteMesh(const std::string& path, vtkPolyData* mesh)
{
  if (mesh->GetNumberOfPolys() == 0)
  {
    throw std::runtime_error(path + " was not written: there is not one triangle");
  }
  std::string error;
  if (!vtkMTMeshWriter::Write(path, mesh, error))
  {
    throw std::runtime_error(error);
  }
  std::cout << path << ": " << mesh->GetNumberOfPolys() << " triangles, " << mesh->GetNumberOfPoints() << " points\n";
}

int Run(int argc, char* argv[])
{
  CLI::App app("Makes triangle meshes of real data.", "meshes_from_data");
  app.require_subcommand(1);

  std::vector<std::string> tiles;
  std::string terrainOutput;
  CLI::App* terrain = app.add_subcommand("terrain", "A terrain of SRTM tiles, joined; in metres, voids are holes");
  terrain->add_option("TILE", tiles, "Tiles such as N36W005.hgt.gz or a .dem, all on one grid")->required();
  terrain->add_option("-o,--output", terrainOutput, "The mesh to write: .ply, .stl, .obj or .vtp")->required();

  std::string volume;
  std::string isosurfaceOutput;
  double value = 0.0;
  CLI::App* isosurface = app.add_subcommand("isosurface", "An isosurface of a volume");
  isosurface->add_option("VOLUME", volume, "A volume: .vti, .mhd, .mha, .nrrd, .nii.gz, .vtk")->required();
  isosurface->add_option("--value", value, "The isovalue")->required();
  isosurface->add_option("-o,--output", isosurfaceOutput, "The mesh to write: .ply, .stl, .obj or .vtp")->required();
  CLI11_PARSE(app, argc, argv);

  vtkNew<vtkPolyData> mesh;
  if (*terrain)
  {
    MakeTerrain(tiles, mesh);
  }
  else
  {
    MakeIsosurface(volume, value, mesh);
  }
  WriteMesh(*terrain ? terrainOutput : isosurfaceOutput, mesh);
  return 0;
}
}

int main(int argc, char* argv[])
{
  try
  {
    return Run(argc, argv);
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "meshes_from_data: %s\n", error.what());
    return 1;
  }
}
