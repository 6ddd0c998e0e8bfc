// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTBuildInput
 * @brief opens what a model is built from: meshes, volumes, tiles of terrain and models, each by its own reader
 *
 * What can be read block by block is: a mesh of a format that vtkMTMeshStream knows, several of them whose arrays are
 * the same, a volume of which an isosurface without gradient normals is wanted, and tiles of terrain alone. Everything
 * else is read whole: of a model the finest level, of a volume the isosurface. All tiles of terrain are one terrain, at
 * the place of the first of them. Several meshes become one with a cell array that says which part a cell is of
 * (vtkMTMeshMerge). The triangles are the same either way.
 */
#ifndef vtkMTBuildInput_h
#define vtkMTBuildInput_h

#include "vtkMTBuildingModule.h" // For export macro
#include "vtkMTInputSettings.h"
#include "vtkMTTexture.h"

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

class vtkMTSpoolStore;
class vtkMTTriangleStream;
class vtkPolyData;
struct vtkMTBuildError;

class VTKMTBUILDING_EXPORT vtkMTBuildInput
{
public:
  struct Part
  {
    std::vector<std::string> Files;
    std::uint64_t Cells = 0;
  };

  /// What came of the last Open or Read.
  struct Result
  {
    std::map<std::string, std::int64_t> Counts; ///< what was left out or made up, by reason
    ///@{
    /// The frame of the coordinates and their units, where all inputs have the same; else empty, and where one of them
    /// has some, "differing_frames" counts those that are unlike the first.
    std::string Crs;
    std::string Units;
    ///@}
    std::vector<Part> Parts;            ///< where there are several
    std::vector<vtkMTTexture> Textures; ///< that the meshes refer to
    std::vector<std::string> Problems;  ///< textures that are missing, and why
    bool IsStreamed = false;
  };

  /// goesOn is asked between files: false is an abort.
  explicit vtkMTBuildInput(
    const vtkMTInputSettings& settings, std::function<bool()> goesOn = [] { return true; });
  ~vtkMTBuildInput();
  vtkMTBuildInput(const vtkMTBuildInput&) = delete;
  void operator=(const vtkMTBuildInput&) = delete;

  /// Those of the paths, and the files that headers of volumes among them name.
  static std::vector<std::string> FindFiles(const std::vector<std::string>& paths);

  /// Whether all of them are terrain or volumes: surfaces that were measured or calculated, and not designed.
  static bool AreSampled(const std::vector<std::string>& paths);

  /// store and memory, in bytes, are for what is sorted; the store must outlive the stream. Null on failure.
  std::unique_ptr<vtkMTTriangleStream> Open(vtkMTSpoolStore& store, std::uint64_t memory, vtkMTBuildError& error);

  /// All of it, as a mesh. False on failure.
  bool Read(vtkPolyData* mesh, vtkMTBuildError& error);

  const Result& GetResult() const { return this->Found; }

private:
  struct ReadPart;

  std::unique_ptr<vtkMTTriangleStream> Stream(vtkMTSpoolStore& store, std::uint64_t memory, vtkMTBuildError& error);
  std::unique_ptr<vtkMTTriangleStream> StreamTerrain(vtkMTSpoolStore& store, vtkMTBuildError& error);
  std::unique_ptr<vtkMTTriangleStream> StreamParts(vtkMTSpoolStore& store, std::uint64_t memory);
  bool ReadParts(std::vector<ReadPart>& parts, vtkMTBuildError& error);
  bool ReadPath(const std::string& path, ReadPart& part, vtkMTBuildError& error);
  void AddCounts(const std::map<std::string, std::int64_t>& counts);
  void UniteFrames(const std::vector<ReadPart>& parts);
  bool CheckGoesOn(vtkMTBuildError& error) const;

  const vtkMTInputSettings Settings;
  const std::function<bool()> GoesOn;
  Result Found;
};

#endif
