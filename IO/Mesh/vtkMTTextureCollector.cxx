// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTTextureCollector.h"

#include "vtkMTFileByteSource.h"
#include "vtkMTGltfTextures.h"
#include "vtkMTTextFormat.h"

#include "vtkFieldData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cstring>
#include <exception>
#include <filesystem>
#include <map>

namespace
{
using Bytes = std::vector<unsigned char>;
using vtkMTTextFormat::NextToken;

//------------------------------------------------------------------------------
// Files beside the mesh

// Where a file that the mesh names may be: never outside of the mesh's folder.
std::string FindBeside(const std::string& mesh, std::string name)
{
  std::replace(name.begin(), name.end(), '\\', '/');
  const std::filesystem::path folder = std::filesystem::path(mesh).parent_path();
  const std::filesystem::path wanted(name);
  const bool leadsAway = wanted.is_absolute() || name.find(':') != std::string::npos ||
    std::find(wanted.begin(), wanted.end(), "..") != wanted.end();
  std::error_code code;
  return !leadsAway && std::filesystem::is_regular_file(folder / wanted, code) ? (folder / wanted).string()
                                                                               : (folder / wanted.filename()).string();
}

bool ReadFile(const std::string& path, Bytes& bytes, std::string& error)
{
  const auto source = vtkMTFileByteSource::Open(path, error);
  if (!source)
  {
    return false;
  }
  if (source->GetSize() > vtkMTTextureCollector::LargestImage)
  {
    error = path + ": is larger than 256 MiB";
    return false;
  }
  bytes.resize(source->GetSize());
  return source->Read(0, bytes.size(), bytes.data(), error);
}

std::string FindMimeType(const Bytes& bytes, const std::string& name)
{
  static const struct
  {
    std::size_t Offset;
    std::string Mark;
    const char* Type;
  } types[] = { { 0, "\x89PNG", "image/png" }, { 0, "\xff\xd8\xff", "image/jpeg" }, { 8, "WEBP", "image/webp" },
    { 0, std::string("II*\0", 4), "image/tiff" }, { 0, std::string("MM\0*", 4), "image/tiff" },
    { 0, "GIF8", "image/gif" }, { 1, "KTX 20", "image/ktx2" }, { 0, "BM", "image/bmp" } };
  for (const auto& type : types)
  {
    if (bytes.size() > type.Offset + type.Mark.size() &&
      std::memcmp(bytes.data() + type.Offset, type.Mark.data(), type.Mark.size()) == 0)
    {
      return type.Type;
    }
  }
  return bytes.size() > 18 && vtkMTTextFormat::GetLowerCaseEnding(name) == "tga" ? "image/x-tga" : "";
}

std::vector<std::string> GetStrings(vtkPolyData* mesh, const char* name)
{
  std::vector<std::string> strings;
  auto* array = vtkStringArray::SafeDownCast(mesh->GetFieldData()->GetAbstractArray(name));
  for (vtkIdType i = 0; array && i < array->GetNumberOfValues(); ++i)
  {
    strings.push_back(array->GetValue(i));
  }
  return strings;
}

//------------------------------------------------------------------------------
// Material libraries of OBJ

bool IsNumber(std::string_view token)
{
  double value = 0.0;
  return vtkMTTextFormat::ToNumber(token, value);
}

// What follows the options: -s 1 1 1 -clamp on "name with blanks.png".
std::string SkipOptions(std::string_view line)
{
  std::string_view rest = line;
  for (std::string_view token = NextToken(rest); !token.empty() && token[0] == '-'; token = NextToken(rest))
  {
    std::string_view after = rest;
    const bool takesNumbers = token == "-o" || token == "-s" || token == "-t" || token == "-mm";
    NextToken(after);
    rest = after;
    for (int i = 0; takesNumbers && i < 2; ++i)
    {
      std::string_view next = after;
      if (!IsNumber(NextToken(next)))
      {
        break;
      }
      rest = after = next;
    }
    line = rest;
  }
  const std::size_t first = line.find_first_not_of(" \t");
  const std::size_t last = line.find_last_not_of(" \t\r");
  return first == std::string_view::npos ? "" : std::string(line.substr(first, last - first + 1));
}

// The image of each material.
std::map<std::string, std::string> ReadLibrary(const vtkMTByteSource& source)
{
  std::map<std::string, std::string> images;
  vtkMTTextFormat::Stream stream(source);
  std::string material;
  for (std::string_view line; stream.TakeLine(line);)
  {
    const std::string keyword = vtkMTTextFormat::ToLower(NextToken(line));
    if (keyword == "newmtl")
    {
      material = std::string(NextToken(line));
    }
    else if (keyword == "map_kd")
    {
      images.emplace(material, SkipOptions(line));
    }
  }
  return images;
}

}

//------------------------------------------------------------------------------
void vtkMTTextureCollector::Add(vtkMTTexture&& texture)
{
  texture.MimeType = FindMimeType(texture.Bytes, texture.Name);
  if (texture.MimeType.empty())
  {
    this->Problems.push_back("texture " + texture.Name + ": is no image of a known format");
    return;
  }
  if (texture.MimeType == "image/ktx2" || texture.MimeType == "image/webp")
  {
    this->Problems.push_back("texture " + texture.Name + ": is " + texture.MimeType + ", which VTK does not draw");
  }
  this->Textures.push_back(std::move(texture));
}

void vtkMTTextureCollector::CollectObj(const std::string& path, vtkPolyData* mesh, int part)
{
  const std::vector<std::string> materials = GetStrings(mesh, "MaterialNames");
  for (const std::string& library : GetStrings(mesh, "MaterialLibraries"))
  {
    std::string error;
    const auto source = vtkMTFileByteSource::Open(FindBeside(path, library), error);
    if (!source)
    {
      this->Problems.push_back("material library " + library + ": " + error);
      continue;
    }
    for (const auto& [material, image] : ReadLibrary(*source))
    {
      const auto used = std::find(materials.begin(), materials.end(), material);
      vtkMTTexture texture;
      texture.Name = image;
      texture.Material = static_cast<int>(used - materials.begin());
      texture.MaterialName = material;
      texture.Part = part;
      if (used == materials.end())
      {
        continue;
      }
      if (ReadFile(FindBeside(path, image), texture.Bytes, error))
      {
        this->Add(std::move(texture));
      }
      else
      {
        this->Problems.push_back("texture " + image + ": " + error);
      }
    }
  }
}

void vtkMTTextureCollector::CollectPly(const std::string& path, vtkPolyData* mesh, int part)
{
  for (const std::string& name : GetStrings(mesh, "TextureFiles"))
  {
    vtkMTTexture texture;
    texture.Name = name;
    texture.Part = part;
    std::string error;
    if (ReadFile(FindBeside(path, name), texture.Bytes, error))
    {
      this->Add(std::move(texture));
    }
    else
    {
      this->Problems.push_back("texture " + name + ": " + error);
    }
  }
}

void vtkMTTextureCollector::CollectGltf(const vtkMTByteSource& source, int part)
{
  const auto open = [&source](const std::string& name, Bytes& bytes, std::string& error)
  { return ReadFile(FindBeside(source.GetName(), name), bytes, error); };
  vtkMTGltfFile file(source);
  std::vector<vtkMTTexture> textures;
  vtkMTGltfTextures(file, LargestImage, open).Collect(textures, this->Problems);
  for (vtkMTTexture& texture : textures)
  {
    texture.Part = part;
    this->Add(std::move(texture));
  }
}

// By content or by ending, as vtkMTMeshReader does.
bool vtkMTTextureCollector::IsGltf(const vtkMTByteSource& source)
{
  char magic[4] = {};
  std::string error;
  const bool isBinary = source.GetSize() >= 4 && source.Read(0, 4, magic, error) && std::memcmp(magic, "glTF", 4) == 0;
  return isBinary || vtkMTTextFormat::GetLowerCaseEnding(source.GetName()) == "gltf";
}

void vtkMTTextureCollector::Collect(const std::string& path, vtkPolyData* mesh, int part)
{
  try
  {
    std::string ignored; // the reader has met it
    const auto source = vtkMTFileByteSource::Open(path, ignored);
    if (source && IsGltf(*source))
    {
      this->CollectGltf(*source, part);
    }
    this->CollectObj(path, mesh, part);
    this->CollectPly(path, mesh, part);
  }
  catch (const std::exception& exception) // JSON that is not as it should be, or no memory
  {
    this->Problems.push_back("textures of " + path + ": " + exception.what());
  }
}
