// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file bmtInput.h
 * @brief the input of a command: meshes, volumes and tiles of terrain, put together; everything here throws bmtError
 */
#ifndef bmtInput_h
#define bmtInput_h

#include "bmtCommon.h"

#include "vtkMTPolyDataStream.h"
#include "vtkMTTexture.h"
#include "vtkMTTriangleStream.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

class vtkPolyData;

/// What the command line says of the input.
struct bmtInput
{
  std::vector<std::string> Paths;
  std::optional<double> Iso; ///< of volumes
  bool GradientNormals = false;
  double VerticalScale = 1.0; ///< of terrain
  bool Degrees = false;

  bmtInput() = default;
  explicit bmtInput(const std::string& path)
    : Paths{ path }
  {
  }
};

/// What came of it.
struct bmtInputReport
{
  std::map<std::string, std::int64_t> Counts; ///< goes into the model's input_report
  bmtJson Parts = bmtJson::array();           ///< id, files and cells of each, where there are several
  std::vector<vtkMTTexture> Textures;         ///< that the meshes refer to
  std::vector<std::string> Problems;          ///< textures that could not be had
};

/// The kinds of files, for help texts.
const char* bmtGetInputKinds();

/// Adds --iso, --gradient-normals, --vertical-scale and --degrees.
void bmtAddInputOptions(CLI::App& command, bmtInput& input);

/**
 * Reads everything: of a Multi-Triangulation file the finest level, of a volume the isosurface; all tiles of terrain
 * are one terrain, in the place of the first of them. Several meshes become one with a cell array that says which part
 * a cell is of (vtkMTMeshMerge).
 */
bmtInputReport bmtReadInput(const bmtInput& input, vtkPolyData* mesh);

/// A polydata as a stream whose report says more.
class bmtInputStream : public vtkMTTriangleStream
{
public:
  bmtInputStream(vtkPolyData* mesh, const std::map<std::string, std::int64_t>& counts);

  const std::vector<vtkMTArrayInfo>& GetArrays() const override { return this->Mesh.GetArrays(); }
  std::uint64_t GetNumberOfPoints() const override { return this->Mesh.GetNumberOfPoints(); }
  std::uint64_t GetNumberOfTriangles() const override { return this->Mesh.GetNumberOfTriangles(); }
  const std::map<std::string, std::int64_t>& GetReport() const override { return this->Report; }
  bool Rewind() override { return this->Keep(this->Mesh.Rewind()); }
  bool NextPoints(PointBlock& block) override { return this->Keep(this->Mesh.NextPoints(block)); }
  bool NextTriangles(TriangleBlock& block) override { return this->Keep(this->Mesh.NextTriangles(block)); }

private:
  bool Keep(bool good)
  {
    this->Error = this->Mesh.GetError();
    return good;
  }

  vtkMTPolyDataStream Mesh;
  std::map<std::string, std::int64_t> Report;
};

#endif
