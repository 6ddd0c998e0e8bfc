// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTBuildInput.h"

#include "vtkMTBuildError.h"
#include "vtkMTCut.h"
#include "vtkMTFileAccess.h"
#include "vtkMTFileSource.h"
#include "vtkMTMeshMerge.h"
#include "vtkMTMeshReader.h"
#include "vtkMTMeshStream.h"
#include "vtkMTPlacement.h"
#include "vtkMTPolyDataStream.h"
#include "vtkMTTerrain.h"
#include "vtkMTTextureCollector.h"
#include "vtkMTVolumeReader.h"
#include "vtkMultiTriangulation.h"
#include "vtkMultiTriangulationFileBuilder.h"

#include "vtkNew.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <utility>

struct vtkMTBuildInput::ReadPart
{
  std::vector<std::string> Files;
  vtkSmartPointer<vtkPolyData> Mesh = vtkSmartPointer<vtkPolyData>::New();
  vtkMTWorldFrame Frame;
};

namespace
{
// The finest level, at the place that the model's frame gives it: the name of its coordinates' frame is that of a model
// that stays in its place.
bool ReadModel(const std::string& path, vtkPolyData* mesh, vtkMTWorldFrame& frame, std::string& error)
{
  vtkMTFileSource source;
  if (!source.Open(path, error))
  {
    return false;
  }
  const vtkMTGraph& graph = source.GetGraph();
  frame = graph.Frame ? vtkMTWorldFrame() : vtkMTWorldFrame{ graph.Crs, graph.Units };
  vtkMTCut cut(source.GetGraph());
  for (std::uint32_t node = 0; node < source.GetGraph().GetSink(); ++node)
  {
    cut.RefineWithDependencies(node);
  }
  if (!vtkMultiTriangulation::CutToPolyData(source, cut, mesh, error))
  {
    return false;
  }
  vtkMTPlacement placement;
  placement.Matrix = source.GetGraph().Frame.value_or(placement.Matrix);
  if (!vtkMTPlacement::IsSound(placement.Matrix.data()))
  {
    error = path + ": its frame is no affine map that has an inverse";
    return false;
  }
  placement.Apply(mesh);
  return true;
}
}

vtkMTBuildInput::vtkMTBuildInput(const vtkMTInputSettings& settings, std::function<bool()> goesOn)
  : Settings(settings)
  , GoesOn(std::move(goesOn))
{
}

vtkMTBuildInput::~vtkMTBuildInput() = default;

bool vtkMTBuildInput::CheckGoesOn(vtkMTBuildError& error) const
{
  return this->GoesOn() || error.Fail(vtkMultiTriangulationFileBuilder::AbortError, "aborted");
}

bool vtkMTBuildInput::AreSampled(const std::vector<std::string>& paths)
{
  return std::all_of(paths.begin(), paths.end(),
    [](const std::string& path) { return vtkMTTerrain::CanRead(path) || vtkMTVolumeReader::CanRead(path); });
}

std::vector<std::string> vtkMTBuildInput::FindFiles(const std::vector<std::string>& paths)
{
  std::vector<std::string> files = paths;
  for (const std::string& path : paths)
  {
    const std::vector<std::string> others = vtkMTVolumeReader::FindOtherFiles(path);
    files.insert(files.end(), others.begin(), others.end());
  }
  return files;
}

//------------------------------------------------------------------------------
// Read whole
bool vtkMTBuildInput::ReadPath(const std::string& path, ReadPart& part, vtkMTBuildError& error)
{
  std::string reason;
  bool good = true;
  if (vtkMTFileSource::CanRead(path))
  {
    good = ReadModel(path, part.Mesh, part.Frame, reason);
  }
  else if (vtkMTVolumeReader::CanRead(path))
  {
    if (!this->Settings.IsoValue)
    {
      return error.Fail(vtkMultiTriangulationFileBuilder::IsoValueError,
        path + ": is a volume; an iso value must say which isosurface is meant");
    }
    vtkMTVolumeReader::Facts facts;
    good = vtkMTVolumeReader::ReadIsosurface(
      path, *this->Settings.IsoValue, this->Settings.GradientNormals, part.Mesh, reason, &facts);
    part.Frame = facts.Frame;
    this->AddCounts(facts.Report);
  }
  else
  {
    good = vtkMTMeshReader::Read(path, part.Mesh, reason, &this->Found.Counts);
  }
  return good || error.Fail(vtkErrorCode::FileFormatError, reason);
}

bool vtkMTBuildInput::ReadParts(std::vector<ReadPart>& parts, vtkMTBuildError& error)
{
  vtkMTTerrain terrain;
  terrain.VerticalScale = this->Settings.VerticalScale;
  terrain.Degrees = this->Settings.Degrees;
  std::size_t ofTerrain = this->Settings.Paths.size(); // its place among the parts, once there is a tile
  std::string reason;
  for (const std::string& path : this->Settings.Paths)
  {
    if (!vtkMTFileAccess::CanRead(path, reason))
    {
      return error.Fail(vtkErrorCode::CannotOpenFileError, reason);
    }
    const bool isTile = vtkMTTerrain::CanRead(path);
    if (!isTile || ofTerrain == this->Settings.Paths.size())
    {
      ofTerrain = isTile ? parts.size() : ofTerrain;
      parts.emplace_back();
    }
    ReadPart& part = isTile ? parts[ofTerrain] : parts.back();
    part.Files.push_back(path);
    if (isTile && !terrain.AddTile(path, reason))
    {
      return error.Fail(vtkErrorCode::FileFormatError, reason);
    }
    if ((!isTile && !this->ReadPath(path, part, error)) || !this->CheckGoesOn(error))
    {
      return false;
    }
  }
  // It is made when all tiles are there.
  if (ofTerrain < parts.size() && !terrain.Make(parts[ofTerrain].Mesh, reason))
  {
    return error.Fail(vtkErrorCode::FileFormatError, reason);
  }
  if (ofTerrain < parts.size())
  {
    parts[ofTerrain].Frame = terrain.GetFrame();
    this->AddCounts(terrain.GetReport());
  }
  this->UniteFrames(parts);
  return true;
}

void vtkMTBuildInput::AddCounts(const std::map<std::string, std::int64_t>& counts)
{
  for (const auto& [name, count] : counts)
  {
    this->Found.Counts[name] += count;
  }
}

void vtkMTBuildInput::UniteFrames(const std::vector<ReadPart>& parts)
{
  const vtkMTWorldFrame& first = parts.front().Frame;
  const auto differing = std::count_if(parts.begin(), parts.end(),
    [&first](const ReadPart& part) { return part.Frame.Crs != first.Crs || part.Frame.Units != first.Units; });
  if (differing > 0)
  {
    this->Found.Counts["differing_frames"] = differing;
    return;
  }
  this->Found.Crs = first.Crs;
  this->Found.Units = first.Units;
}

bool vtkMTBuildInput::Read(vtkPolyData* mesh, vtkMTBuildError& error)
{
  this->Found = Result();
  std::vector<ReadPart> parts;
  if (!this->ReadParts(parts, error))
  {
    return false;
  }
  vtkMTTextureCollector collector;
  for (std::size_t part = 0; part < parts.size(); ++part)
  {
    collector.Collect(parts[part].Files.front(), parts[part].Mesh, parts.size() > 1 ? static_cast<int>(part) : -1);
  }
  this->Found.Textures = collector.GetTextures();
  this->Found.Problems = collector.GetProblems();
  if (parts.size() == 1)
  {
    mesh->ShallowCopy(parts.front().Mesh);
    return true;
  }
  std::vector<vtkSmartPointer<vtkPolyData>> meshes;
  for (const ReadPart& part : parts)
  {
    this->Found.Parts.push_back({ part.Files, static_cast<std::uint64_t>(part.Mesh->GetNumberOfCells()) });
    meshes.push_back(part.Mesh);
  }
  std::string reason;
  if (!vtkMTMeshMerge::Merge(meshes, mesh, this->Found.Counts, reason))
  {
    return error.Fail(vtkErrorCode::UnknownError, reason);
  }
  return this->CheckGoesOn(error);
}

//------------------------------------------------------------------------------
// Block by block
std::unique_ptr<vtkMTTriangleStream> vtkMTBuildInput::StreamTerrain(vtkMTSpoolStore& store, vtkMTBuildError& error)
{
  vtkMTTerrain terrain;
  terrain.VerticalScale = this->Settings.VerticalScale;
  terrain.Degrees = this->Settings.Degrees;
  terrain.Store = &store;
  std::string reason;
  for (const std::string& path : this->Settings.Paths)
  {
    if (!terrain.AddTile(path, reason))
    {
      error.Fail(vtkErrorCode::FileFormatError, reason);
      return nullptr;
    }
    if (!this->CheckGoesOn(error))
    {
      return nullptr;
    }
  }
  std::unique_ptr<vtkMTTriangleStream> stream = terrain.MakeStream(reason);
  const vtkMTWorldFrame frame = terrain.GetFrame();
  this->Found.Crs = frame.Crs;
  this->Found.Units = frame.Units;
  if (!stream)
  {
    error.Fail(vtkErrorCode::FileFormatError, reason);
  }
  return stream;
}

std::unique_ptr<vtkMTTriangleStream> vtkMTBuildInput::StreamParts(vtkMTSpoolStore& store, std::uint64_t memory)
{
  const std::vector<std::string>& paths = this->Settings.Paths;
  const bool isOne = paths.size() == 1;
  vtkMTMeshStream::Settings settings;
  settings.Store = &store;
  settings.Memory = static_cast<std::size_t>(memory / 8);
  settings.LeastSize = isOne ? memory / 32 : 0; // all or none of several, as one of them may be large
  std::vector<vtkSmartPointer<vtkPolyData>> names(paths.size());
  std::generate(names.begin(), names.end(), [] { return vtkSmartPointer<vtkPolyData>::New(); });
  std::vector<std::uint64_t> cells;
  std::unique_ptr<vtkMTTriangleStream> stream = isOne ? vtkMTMeshStream::Open(paths.front(), settings, names.front())
                                                      : vtkMTMeshStream::OpenAll(paths, settings, names, cells);
  vtkMTTextureCollector collector;
  for (std::size_t part = 0; stream && part < paths.size(); ++part)
  {
    if (!isOne)
    {
      this->Found.Parts.push_back({ { paths[part] }, cells[part] });
    }
    collector.Collect(paths[part], names[part], isOne ? -1 : static_cast<int>(part));
  }
  this->Found.Textures = collector.GetTextures();
  this->Found.Problems = collector.GetProblems();
  return stream;
}

// Null, too, where that is not possible: then without an error.
std::unique_ptr<vtkMTTriangleStream> vtkMTBuildInput::Stream(
  vtkMTSpoolStore& store, std::uint64_t memory, vtkMTBuildError& error)
{
  const std::vector<std::string>& paths = this->Settings.Paths;
  if (std::all_of(paths.begin(), paths.end(), vtkMTTerrain::CanRead))
  {
    return this->StreamTerrain(store, error);
  }
  // Always, whatever the memory: the points come in another order than from the whole contour.
  if (paths.size() == 1 && this->Settings.IsoValue && !this->Settings.GradientNormals &&
    vtkMTVolumeReader::CanRead(paths.front()))
  {
    std::string reason;
    vtkMTWorldFrame frame;
    std::unique_ptr<vtkMTTriangleStream> isosurface =
      vtkMTVolumeReader::StreamIsosurface(paths.front(), *this->Settings.IsoValue, reason, 0, &frame);
    this->Found.Crs = frame.Crs;
    this->Found.Units = frame.Units;
    if (!isosurface)
    {
      error.Fail(vtkErrorCode::FileFormatError, reason);
    }
    return isosurface;
  }
  return this->StreamParts(store, memory);
}

std::unique_ptr<vtkMTTriangleStream> vtkMTBuildInput::Open(
  vtkMTSpoolStore& store, std::uint64_t memory, vtkMTBuildError& error)
{
  this->Found = Result();
  std::unique_ptr<vtkMTTriangleStream> stream = this->Stream(store, memory, error);
  if (stream || error.Code != vtkErrorCode::NoError)
  {
    this->Found.IsStreamed = stream != nullptr;
    return stream;
  }
  const vtkNew<vtkPolyData> mesh;
  return this->Read(mesh, error) ? std::make_unique<vtkMTPolyDataStream>(mesh) : nullptr;
}
