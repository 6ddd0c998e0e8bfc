// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file bmtInput.h
 * @brief the input of a command: meshes, volumes and tiles of terrain, put together; everything here throws bmtError
 */
#ifndef bmtInput_h
#define bmtInput_h

#include "bmtCommon.h"

#include "vtkMTTexture.h"
#include "vtkMTTriangleStream.h"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class vtkMTSpoolStore;
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

/**
 * The input as a stream that is never in memory whole, or null where it has to be: for several inputs, and for kinds of
 * files that are not streamed. store and memory: for what is sorted.
 */
std::unique_ptr<vtkMTTriangleStream> bmtStreamInput(
  const bmtInput& input, vtkMTSpoolStore& store, std::uint64_t memory, bmtInputReport& report);

/// A hash (XXH3-64) of the text, as text.
std::string bmtHash(const std::string& text);

/// The input's files as they are on the disk: to see whether they change.
class bmtInputFiles
{
public:
  explicit bmtInputFiles(const std::vector<std::string>& paths);
  /// The first file that is not any more what it was; empty when there is none.
  std::string FindChanged() const;
  /// A hash (XXH3-64) of all that is in the files, one after the other.
  std::string GetHash() const;

private:
  struct State
  {
    std::string Path;
    std::uint64_t Size = 0;
    std::int64_t Time = 0;
    std::uint64_t File = 0;
    bool operator==(const State& other) const
    {
      return this->Size == other.Size && this->Time == other.Time && this->File == other.File;
    }
  };
  static State Look(const std::string& path);

  std::vector<State> Files;
};

/**
 * The input as `bmt build` uses it: arrays that are not wanted are left out, what was counted while the input was read
 * is in the report, and files that changed while they were read are an error.
 */
class bmtInputStream : public vtkMTTriangleStream
{
public:
  /// keep: the arrays' names; null: all. Throws bmtError when there is no array of a name.
  bmtInputStream(std::unique_ptr<vtkMTTriangleStream> input, const bmtInputFiles& files,
    const std::map<std::string, std::int64_t>& counts, const std::vector<std::string>* keep);
  ~bmtInputStream() override;

  const std::vector<vtkMTArrayInfo>& GetArrays() const override { return this->Arrays; }
  std::uint64_t GetNumberOfPoints() const override { return this->Input->GetNumberOfPoints(); }
  std::uint64_t GetNumberOfTriangles() const override { return this->Input->GetNumberOfTriangles(); }
  const std::map<std::string, std::int64_t>& GetReport() const override { return this->Report; }
  bool Rewind() override { return this->Keep(this->Input->Rewind()); }
  bool NextPoints(PointBlock& block) override;
  bool NextTriangles(TriangleBlock& block) override;

private:
  bool Keep(bool good)
  {
    this->Error = good ? "" : this->Input->GetError();
    return good;
  }

  std::unique_ptr<vtkMTTriangleStream> Input;
  const bmtInputFiles Files;
  std::vector<vtkMTArrayInfo> Arrays;
  std::vector<std::size_t> DroppedPointColumns; // from the last to the first
  std::vector<std::size_t> DroppedCellColumns;
  std::map<std::string, std::int64_t> Report;
};

#endif
