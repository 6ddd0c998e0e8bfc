// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTTextureCollector.h"

#include "Obj/vtkMTObjMaterials.h"
#include "vtkMTFileBeside.h"
#include "vtkMTFileByteSource.h"
#include "vtkMTGltfTextures.h"
#include "vtkMTTextFormat.h"

#include "vtkFieldData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cstring>
#include <exception>

namespace
{
using Bytes = std::vector<unsigned char>;
using vtkMTFileBeside::FindBeside;

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
  const auto found = vtkMTObjMaterials::Read(path, GetStrings(mesh, "MaterialLibraries"), this->Problems);
  for (const auto& [name, material] : found)
  {
    const auto used = std::find(materials.begin(), materials.end(), name);
    if (used == materials.end() || material.Image.empty())
    {
      continue;
    }
    vtkMTTexture texture;
    texture.Name = material.Image;
    texture.Material = static_cast<int>(used - materials.begin());
    texture.MaterialName = name;
    texture.Part = part;
    std::string error;
    if (ReadFile(FindBeside(path, texture.Name), texture.Bytes, error))
    {
      this->Add(std::move(texture));
    }
    else
    {
      this->Problems.push_back("texture " + texture.Name + ": " + error);
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
