// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTVerifyInput.h"

#include "vtkMTVerifyGltfInput.h"
#include "vtkMTVerifyObjInput.h"
#include "vtkMTVerifyOffInput.h"
#include "vtkMTVerifyPlyInput.h"
#include "vtkMTVerifyStlInput.h"
#include "vtkMTVerifyTerrainInput.h"
#include "vtkMTVerifyText.h"
#include "vtkMTVerifyVolumeInput.h"
#include "vtkMTVerifyVtkInput.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <fstream>

namespace
{
// Coordinates that are calculated in single precision somewhere on the way, a few operations long.
constexpr double SingleRounding = 1e-6;
// Coordinates that are stored in single precision: half a unit in the last place, along three axes.
constexpr double SingleStorage = 1.1e-7;

struct Reader
{
  const char* Name;
  bool (*Read)(const std::string& path, vtkPolyData* out, std::string& error);
};

// By what the file begins with where that is unmistakable, else by the ending of its name.
std::string GetFormat(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  std::string start(4, '\0');
  file.read(start.data(), 4);
  const std::string ending = vtkMTVerifyText::GetEnding(path);
  if (start.compare(0, 3, "ply") == 0)
  {
    return "ply";
  }
  return start == "glTF" ? "glb" : ending;
}

const Reader* FindReader(const std::string& format)
{
  static const std::pair<std::vector<std::string>, Reader> readers[] = {
    { { "ply" }, { "vtkMTVerifyPlyInput", vtkMTVerifyPlyInput::Read } },
    { { "stl" }, { "vtkMTVerifyStlInput", vtkMTVerifyStlInput::Read } },
    { { "obj" }, { "vtkMTVerifyObjInput", vtkMTVerifyObjInput::Read } },
    { { "off" }, { "vtkMTVerifyOffInput", vtkMTVerifyOffInput::Read } },
    { { "gltf", "glb" }, { "vtkMTVerifyGltfInput", vtkMTVerifyGltfInput::Read } },
    { { "vtp", "vtu", "vtm", "vtk" }, { "vtkMTVerifyVtkInput", vtkMTVerifyVtkInput::Read } }
  };
  for (const auto& [formats, reader] : readers)
  {
    if (std::find(formats.begin(), formats.end(), format) != formats.end())
    {
      return &reader;
    }
  }
  return nullptr;
}

void ReadMesh(const std::string& path, vtkPolyData* out, vtkMTVerifyInput::Source& source, double& rounding)
{
  const std::string format = GetFormat(path);
  const Reader* const reader = FindReader(format);
  if (!reader)
  {
    source.Reason = "no independent reader knows this format";
    return;
  }
  const char* const stock = vtkMTVerifyVtkInput::GetReader(format);
  source.Reader = stock ? stock : reader->Name;
  std::string error;
  if (!reader->Read(path, out, error))
  {
    source.Reason = error.empty() ? "cannot be read" : error;
  }
  const double own = format == "glb" || format == "gltf" ? SingleRounding : (stock ? 0.0 : SingleStorage);
  rounding = std::max(rounding, own);
}

bool ReadVolume(
  const std::string& path, double isoValue, vtkPolyData* out, vtkMTVerifyInput::Source& source, double& rounding)
{
  vtkMTVerifyVolumeInput::Options options;
  options.IsoValue = isoValue;
  vtkMTVerifyVolumeInput::Facts facts;
  source.Reason.clear();
  const bool isRead = vtkMTVerifyVolumeInput::Read(path, options, out, facts, source.Reason);
  source.Reader = facts.Reader;
  rounding = std::max(rounding, SingleRounding);
  return isRead;
}

void ReadTerrain(const std::vector<std::string>& paths, const vtkMTVerifyInput::Options& options, vtkPolyData* out,
  vtkMTVerifyInput::Source& source, double& rounding)
{
  vtkMTVerifyTerrainInput::Options settings;
  settings.VerticalScale = options.VerticalScale;
  settings.Degrees = options.Degrees;
  vtkMTVerifyTerrainInput::Facts facts;
  std::string error;
  if (!vtkMTVerifyTerrainInput::Read(paths, settings, out, facts, error))
  {
    source.Reason = error.empty() ? "cannot be read" : error;
  }
  source.Reader = facts.Reader;
  rounding = std::max(rounding, SingleRounding);
}
}

bool vtkMTVerifyInput::Read(const Options& options, vtkPolyData* out, std::vector<Source>& sources, double& rounding)
{
  std::vector<vtkSmartPointer<vtkPolyData>> meshes;
  std::vector<std::string> tiles;
  std::copy_if(options.Paths.begin(), options.Paths.end(), std::back_inserter(tiles), vtkMTVerifyTerrainInput::CanRead);
  bool hasTerrain = false;
  rounding = 0.0;
  for (const std::string& path : options.Paths)
  {
    const bool isTerrain = vtkMTVerifyTerrainInput::CanRead(path);
    if (isTerrain && hasTerrain)
    {
      continue;
    }
    sources.push_back({ path, "", "" });
    meshes.push_back(vtkSmartPointer<vtkPolyData>::New());
    if (isTerrain)
    {
      hasTerrain = true;
      ReadTerrain(tiles, options, meshes.back(), sources.back(), rounding);
    }
    else if (!options.IsoValue || !vtkMTVerifyVolumeInput::CanRead(path) ||
      (!ReadVolume(path, *options.IsoValue, meshes.back(), sources.back(), rounding) &&
        vtkMTVerifyText::GetEnding(path) == "vtk")) // which may be a mesh beside volumes
    {
      sources.back().Reason.clear();
      ReadMesh(path, meshes.back(), sources.back(), rounding);
    }
  }
  if (std::any_of(sources.begin(), sources.end(), [](const Source& source) { return !source.Reason.empty(); }))
  {
    return false;
  }
  std::vector<vtkPolyData*> parts(meshes.begin(), meshes.end());
  if (parts.size() == 1)
  {
    out->ShallowCopy(parts[0]);
  }
  else
  {
    vtkMTVerifyVtkInput::Append(parts, true, out);
  }
  return true;
}
