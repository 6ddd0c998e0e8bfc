// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file meshes_from_data.cxx
 * @brief makes large triangle meshes of real data: terrain of SRTM tiles, isosurfaces of volumes
 *
 *   meshes_from_data terrain N36W005.hgt.gz N36W004.hgt.gz -o terrain.ply
 *   meshes_from_data isosurface bonsai.vti --value 40 -o bonsai.vtp
 */
#include "heightfield.h"

#include "vtkMTMeshWriter.h"

#include "vtkDataSetReader.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkNIFTIImageReader.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkXMLImageDataReader.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{
template <class Reader>
vtkSmartPointer<vtkImageData> ReadWith(const std::string& path)
{
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return vtkImageData::SafeDownCast(reader->GetOutputDataObject(0));
}

bool EndsWith(const std::string& text, const std::string& end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

vtkSmartPointer<vtkImageData> ReadVolume(const std::string& path)
{
  vtkSmartPointer<vtkImageData> volume;
  if (EndsWith(path, ".vti"))
  {
    volume = ReadWith<vtkXMLImageDataReader>(path);
  }
  else if (EndsWith(path, ".vtk"))
  {
    volume = ReadWith<vtkDataSetReader>(path);
  }
  else if (EndsWith(path, ".nii.gz") || EndsWith(path, ".nii"))
  {
    volume = ReadWith<vtkNIFTIImageReader>(path);
  }
  if (!volume || volume->GetNumberOfCells() == 0)
  {
    throw std::runtime_error(path + ": no volume could be read; .vti, .vtk and .nii.gz are known");
  }
  return volume;
}

void MakeIsosurface(const std::string& path, double value, vtkPolyData* mesh)
{
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(ReadVolume(path));
  contour->SetValue(0, value);
  contour->ComputeNormalsOff();
  contour->ComputeGradientsOff();
  contour->ComputeScalarsOff();
  contour->Update();
  mesh->ShallowCopy(contour->GetOutput());
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
  terrain->add_option("TILE", tiles, "Tiles such as N36W005.hgt or N36W005.hgt.gz, all of one size")->required();
  terrain->add_option("-o,--output", terrainOutput, "The mesh to write: .ply, .stl, .obj or .vtp")->required();

  std::string volume;
  std::string isosurfaceOutput;
  double value = 0.0;
  CLI::App* isosurface = app.add_subcommand("isosurface", "An isosurface of a volume");
  isosurface->add_option("VOLUME", volume, "A volume: .vti, .vtk, .nii.gz")->required();
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
