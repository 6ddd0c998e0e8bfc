// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTTextureCollector.h"

#include "Obj/vtkMTObjMaterials.h"
#include "vtkMTFileBeside.h"
#include "vtkMTFileByteSource.h"
#include "vtkMTTextFormat.h"

#include "vtkFieldData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstring>
#include <exception>
#include <filesystem>
#include <map>

namespace
{
using Bytes = std::vector<unsigned char>;
using Json = nlohmann::json;
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

//------------------------------------------------------------------------------
// glTF

// False where a digit is none.
bool FromBase64(const std::string& text, std::size_t begin, Bytes& bytes)
{
  static const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::uint32_t bits = 0;
  int count = 0;
  for (std::size_t i = begin; i < text.size() && text[i] != '='; ++i)
  {
    const std::size_t digit = digits.find(text[i]);
    if (digit == std::string::npos)
    {
      return false;
    }
    bits = bits << 6 | static_cast<std::uint32_t>(digit);
    count += 6;
    if (count >= 8)
    {
      count -= 8;
      bytes.push_back(static_cast<unsigned char>(bits >> count & 255));
    }
  }
  return true;
}

std::string FromPercent(const std::string& uri)
{
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i)
  {
    const auto value = [&uri](std::size_t at) {
      return at < uri.size() ? std::string("0123456789abcdef").find(vtkMTTextFormat::ToLower(uri.substr(at, 1))) : 99;
    };
    const bool isCode = uri[i] == '%' && value(i + 1) < 16 && value(i + 2) < 16;
    text += isCode ? static_cast<char>(16 * value(i + 1) + value(i + 2)) : uri[i];
    i += isCode ? 2 : 0;
  }
  return text;
}

class Gltf
{
public:
  explicit Gltf(const std::string& path)
    : Path(path)
  {
  }

  // Throws Json::exception where the JSON is not as it should be.
  bool Open(std::string& error)
  {
    this->Source = vtkMTFileByteSource::Open(this->Path, error);
    std::uint32_t head[5] = {};
    if (!this->Source || this->Source->GetSize() < sizeof(head) || !this->Source->Read(0, sizeof(head), head, error))
    {
      return false;
    }
    const bool isBinary = head[0] == 0x46546c67;
    const std::uint64_t begin = isBinary ? sizeof(head) : 0;
    const std::uint64_t size = isBinary ? head[3] : this->Source->GetSize();
    this->BinaryBegin = begin + size + 8;
    if (size > vtkMTTextureCollector::LargestImage || begin + size > this->Source->GetSize())
    {
      error = this->Path + ": its JSON is larger than the file, or than 256 MiB";
      return false;
    }
    std::string text(size, ' ');
    if (!this->Source->Read(begin, text.size(), text.data(), error))
    {
      return false;
    }
    this->Document = Json::parse(text);
    return true;
  }

  bool ReadImage(const Json& image, vtkMTTexture& texture, std::string& error) const
  {
    if (image.contains("uri"))
    {
      return this->ReadUri(image.at("uri").get<std::string>(), texture, error);
    }
    const Json& view = this->Document.at("bufferViews").at(image.at("bufferView").get<std::size_t>());
    const Json& buffer = this->Document.at("buffers").at(view.at("buffer").get<std::size_t>());
    const auto offset = view.value("byteOffset", std::uint64_t(0));
    const auto size = view.at("byteLength").get<std::uint64_t>();
    if (size > vtkMTTextureCollector::LargestImage)
    {
      error = "is larger than 256 MiB";
      return false;
    }
    if (!buffer.contains("uri"))
    {
      texture.Bytes.resize(size);
      return this->Source->Read(this->BinaryBegin + offset, size, texture.Bytes.data(), error);
    }
    vtkMTTexture whole;
    if (!this->ReadUri(buffer.at("uri").get<std::string>(), whole, error))
    {
      return false;
    }
    if (offset > whole.Bytes.size() || size > whole.Bytes.size() - offset)
    {
      error = "lies beyond its buffer";
      return false;
    }
    const auto first = whole.Bytes.begin() + static_cast<std::ptrdiff_t>(offset);
    texture.Bytes.assign(first, first + static_cast<std::ptrdiff_t>(size));
    return true;
  }

  Json Document;

private:
  bool ReadUri(const std::string& uri, vtkMTTexture& texture, std::string& error) const
  {
    if (uri.rfind("data:", 0) != 0)
    {
      const std::string name = FromPercent(uri);
      texture.Name = texture.Name.empty() ? name : texture.Name;
      return ReadFile(FindBeside(this->Path, name), texture.Bytes, error);
    }
    const std::size_t comma = uri.find(";base64,");
    const bool good = comma != std::string::npos && FromBase64(uri, comma + 8, texture.Bytes);
    error = good ? error : "its data are no base64";
    return good;
  }

  const std::string Path;
  std::unique_ptr<vtkMTFileByteSource> Source;
  std::uint64_t BinaryBegin = 0;
};
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

void vtkMTTextureCollector::CollectGltf(const std::string& path, int part)
{
  Gltf file(path);
  std::string error;
  if (!file.Open(error))
  {
    this->Problems.push_back(error);
    return;
  }
  const Json materials = file.Document.value("materials", Json::array());
  for (std::size_t m = 0; m < materials.size(); ++m)
  {
    const Json pbr = materials.at(m).value("pbrMetallicRoughness", Json::object());
    if (!pbr.contains("baseColorTexture"))
    {
      continue;
    }
    const Json& reference = pbr.at("baseColorTexture");
    const Json& sampler = file.Document.at("textures").at(reference.at("index").get<std::size_t>());
    if (!sampler.contains("source"))
    {
      continue;
    }
    const auto index = sampler.at("source").get<std::size_t>();
    const Json& image = file.Document.at("images").at(index);
    vtkMTTexture texture;
    texture.Name = image.value("name", std::string());
    texture.Coordinates = "TEXCOORD_" + std::to_string(reference.value("texCoord", 0));
    texture.Material = static_cast<int>(m);
    texture.MaterialName = materials.at(m).value("name", std::string());
    texture.Part = part;
    if (!file.ReadImage(image, texture, error))
    {
      this->Problems.push_back("image " + std::to_string(index) + " of " + path + ": " + error);
      continue;
    }
    texture.Name = texture.Name.empty() ? "image " + std::to_string(index) : texture.Name;
    this->Add(std::move(texture));
  }
}

void vtkMTTextureCollector::Collect(const std::string& path, vtkPolyData* mesh, int part)
{
  try
  {
    const std::string ending = vtkMTTextFormat::GetLowerCaseEnding(path);
    if (ending == "gltf" || ending == "glb")
    {
      this->CollectGltf(path, part);
    }
    this->CollectObj(path, mesh, part);
    this->CollectPly(path, mesh, part);
  }
  catch (const std::exception& exception) // JSON that is not as it should be, or no memory
  {
    this->Problems.push_back("textures of " + path + ": " + exception.what());
  }
}
