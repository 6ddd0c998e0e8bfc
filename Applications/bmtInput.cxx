// SPDX-License-Identifier: BSD-3-Clause
#include "bmtInput.h"

#include "vtkMTBuildError.h"
#include "vtkMTBuildInput.h"
#include "vtkMultiTriangulationFileBuilder.h"

#include <CLI/CLI.hpp>

const char* bmtGetInputKinds()
{
  return "PLY, STL, OBJ, OFF, VTP, VTU, VTM, VTK, glTF, GLB, all but VTM as .gz too; "
         "volumes with --iso (.vti, .mhd, .mha, .nrrd, .nhdr, .nii, .nii.gz, .vtk); "
         "tiles of terrain (.hgt, .hgt.gz, .dem, and .tif where GDAL is built in)";
}

void bmtAddInputOptions(CLI::App& command, bmtInput& input)
{
  command.add_option("--iso", input.IsoValue, "Of volumes: the value of the isosurface to take");
  command.add_flag("--gradient-normals", input.GradientNormals,
    "Of volumes: normals from the volume's gradient, not from the triangles");
  command.add_option("--vertical-scale", input.VerticalScale, "Of terrain: what heights are multiplied by")
    ->capture_default_str();
  command.add_flag("--degrees", input.Degrees,
    "Of terrain: keep longitude and latitude in degrees, instead of a local frame in metres");
}

std::string bmtGetAdvice(unsigned long errorCode)
{
  switch (errorCode)
  {
    case vtkMultiTriangulationFileBuilder::IsoValueError:
      return "; give it with --iso V";
    case vtkMultiTriangulationFileBuilder::UnfinishedBuildError:
      return "; --resume resumes it";
    case vtkErrorCode::OutOfDiskSpaceError:
      return ", with --temp";
    default:
      return "";
  }
}

void bmtReadInput(const bmtInput& input, vtkPolyData* mesh)
{
  vtkMTBuildError error;
  if (!vtkMTBuildInput(input, [] { return !bmtIsInterrupted(); }).Read(mesh, error))
  {
    bmtThrowIfInterrupted();
    throw bmtError(error.Message + bmtGetAdvice(error.Code));
  }
}
