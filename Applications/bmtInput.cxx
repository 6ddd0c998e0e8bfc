// SPDX-License-Identifier: BSD-3-Clause
#include "bmtInput.h"
#include "bmtModel.h"

#include "vtkMTCut.h"
#include "vtkMTFileByteSource.h"
#include "vtkMTGraph.h"
#include "vtkMTMeshMerge.h"
#include "vtkMTMeshReader.h"
#include "vtkMTMeshStream.h"
#include "vtkMTPatchSource.h"
#include "vtkMTTerrain.h"
#include "vtkMTTextureCollector.h"
#include "vtkMTVolumeReader.h"
#include "vtkMultiTriangulation.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <set>

#include <sys/stat.h>
#include <xxhash.h>

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

namespace
{
std::unique_ptr<vtkMTTriangleStream> StreamTerrain(const bmtInput& input, vtkMTSpoolStore& store)
{
  vtkMTTerrain terrain;
  terrain.VerticalScale = input.VerticalScale;
  terrain.Degrees = input.Degrees;
  terrain.Store = &store;
  std::string error;
  for (const std::string& path : input.Paths)
  {
    if (!terrain.AddTile(path, error))
    {
      throw bmtError(error);
    }
  }
  std::unique_ptr<vtkMTTriangleStream> stream = terrain.MakeStream(error);
  return stream ? std::move(stream) : throw bmtError(error);
}

// All or none; whatever their sizes, as one of them may be large.
std::unique_ptr<vtkMTTriangleStream> StreamParts(
  const bmtInput& input, vtkMTMeshStream::Settings settings, bmtInputReport& report)
{
  settings.LeastSize = 0;
  std::vector<vtkSmartPointer<vtkPolyData>> names(input.Paths.size());
  std::generate(names.begin(), names.end(), [] { return vtkSmartPointer<vtkPolyData>::New(); });
  std::vector<std::uint64_t> cells;
  std::unique_ptr<vtkMTTriangleStream> stream = vtkMTMeshStream::OpenAll(input.Paths, settings, names, cells);
  vtkMTTextureCollector collector;
  for (std::size_t part = 0; stream && part < input.Paths.size(); ++part)
  {
    bmtJson entry;
    entry["id"] = part;
    entry["files"] = { input.Paths[part] };
    entry["cells"] = cells[part];
    report.Parts.push_back(entry);
    collector.Collect(input.Paths[part], names[part], static_cast<int>(part));
  }
  report.Textures = collector.GetTextures();
  report.Problems = collector.GetProblems();
  return stream;
}
}

std::unique_ptr<vtkMTTriangleStream> bmtStreamInput(
  const bmtInput& input, vtkMTSpoolStore& store, std::uint64_t memory, bmtInputReport& report)
{
  if (std::all_of(input.Paths.begin(), input.Paths.end(), vtkMTTerrain::CanRead))
  {
    return StreamTerrain(input, store);
  }
  vtkMTMeshStream::Settings settings;
  settings.Store = &store;
  settings.Memory = static_cast<std::size_t>(memory / 8);
  settings.LeastSize = memory / 32;
  if (input.Paths.size() != 1)
  {
    return StreamParts(input, settings, report);
  }
  const std::string& path = input.Paths.front();
  // Always, whatever the memory: the points come in another order than from the whole contour.
  if (input.Iso && !input.GradientNormals && vtkMTVolumeReader::CanRead(path))
  {
    std::string error;
    std::unique_ptr<vtkMTTriangleStream> isosurface = vtkMTVolumeReader::StreamIsosurface(path, *input.Iso, error);
    return isosurface ? std::move(isosurface) : throw bmtError(error);
  }
  const vtkNew<vtkPolyData> names;
  std::unique_ptr<vtkMTTriangleStream> stream = vtkMTMeshStream::Open(path, settings, names);
  if (stream)
  {
    vtkMTTextureCollector collector;
    collector.Collect(path, names, -1);
    report.Textures = collector.GetTextures();
    report.Problems = collector.GetProblems();
  }
  return stream;
}

//------------------------------------------------------------------------------
namespace
{
std::string ToText(std::uint64_t hash)
{
  char text[17];
  std::snprintf(text, sizeof(text), "%016llx", static_cast<unsigned long long>(hash));
  return text;
}
}

bmtInputFiles::State bmtInputFiles::Look(const std::string& path)
{
  State state;
  state.Path = path;
  struct stat status;
  if (::stat(path.c_str(), &status) == 0)
  {
    state.Size = static_cast<std::uint64_t>(status.st_size);
    state.Time = static_cast<std::int64_t>(status.st_mtim.tv_sec) * 1000000000 + status.st_mtim.tv_nsec;
    state.File = static_cast<std::uint64_t>(status.st_ino);
  }
  return state;
}

bmtInputFiles::bmtInputFiles(const std::vector<std::string>& paths)
{
  std::transform(paths.begin(), paths.end(), std::back_inserter(this->Files), Look);
}

std::string bmtInputFiles::FindChanged() const
{
  const auto changed =
    std::find_if(this->Files.begin(), this->Files.end(), [](const State& file) { return !(Look(file.Path) == file); });
  return changed == this->Files.end() ? "" : changed->Path;
}

std::string bmtInputFiles::GetHash() const
{
  constexpr std::size_t blockSize = std::size_t(1) << 20;
  const std::unique_ptr<XXH3_state_t, XXH_errorcode (*)(XXH3_state_t*)> hash(XXH3_createState(), XXH3_freeState);
  XXH3_64bits_reset(hash.get());
  std::vector<unsigned char> block(blockSize);
  std::string error;
  for (const State& file : this->Files)
  {
    const auto bytes = vtkMTFileByteSource::Open(file.Path, error);
    const std::uint64_t size = bytes ? bytes->GetSize() : 0;
    XXH3_64bits_update(hash.get(), &size, sizeof(size)); // where one file ends and the next begins
    for (std::uint64_t place = 0; error.empty() && place < size; place += blockSize)
    {
      const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(blockSize, size - place));
      if (bytes->Read(place, count, block.data(), error))
      {
        XXH3_64bits_update(hash.get(), block.data(), count);
      }
    }
    if (!error.empty())
    {
      throw bmtError(error);
    }
  }
  return ToText(XXH3_64bits_digest(hash.get()));
}

std::string bmtHash(const std::string& text)
{
  return ToText(XXH3_64bits(text.data(), text.size()));
}

//------------------------------------------------------------------------------
bmtInputStream::bmtInputStream(std::unique_ptr<vtkMTTriangleStream> input, const bmtInputFiles& files,
  const std::map<std::string, std::int64_t>& counts, const std::vector<std::string>* keep)
  : Input(std::move(input))
  , Files(files)
  , Report(this->Input->GetReport())
{
  for (const auto& [name, count] : counts)
  {
    this->Report[name] += count;
  }
  std::set<std::string> missing;
  if (keep)
  {
    missing.insert(keep->begin(), keep->end());
  }
  const std::set<std::string> wanted = missing;
  std::size_t columns[2] = { 0, 0 };
  for (const vtkMTArrayInfo& info : this->Input->GetArrays())
  {
    const bool isCell = info.Association == vtkMTArrayInfo::Cell;
    std::vector<std::size_t>& dropped = isCell ? this->DroppedCellColumns : this->DroppedPointColumns;
    missing.erase(info.Name);
    if (!keep || wanted.count(info.Name) > 0)
    {
      this->Arrays.push_back(info);
    }
    else
    {
      dropped.insert(dropped.begin(), columns[isCell ? 1 : 0]);
    }
    ++columns[isCell ? 1 : 0];
  }
  if (!missing.empty())
  {
    throw bmtError("--arrays: the input has no array \"" + *missing.begin() + "\"");
  }
}

bmtInputStream::~bmtInputStream() = default;

namespace
{
void Drop(const std::vector<std::size_t>& dropped, std::vector<vtkMTColumn>& columns)
{
  for (const std::size_t column : dropped)
  {
    columns.erase(columns.begin() + static_cast<std::ptrdiff_t>(std::min(column, columns.size())),
      columns.begin() + static_cast<std::ptrdiff_t>(std::min(column + 1, columns.size())));
  }
}
}

bool bmtInputStream::NextPoints(PointBlock& block)
{
  const bool good = this->Keep(this->Input->NextPoints(block));
  Drop(this->DroppedPointColumns, block.Columns);
  return good;
}

bool bmtInputStream::NextTriangles(TriangleBlock& block)
{
  const bool good = this->Keep(this->Input->NextTriangles(block));
  Drop(this->DroppedCellColumns, block.Columns);
  const std::string changed = good && !block.Triangles.empty() ? "" : this->Files.FindChanged();
  if (!changed.empty())
  {
    this->Error = changed + ": has changed while it was read; build again when it is complete" +
      (this->Error.empty() ? "" : " (" + this->Error + ")");
  }
  return good && changed.empty();
}
