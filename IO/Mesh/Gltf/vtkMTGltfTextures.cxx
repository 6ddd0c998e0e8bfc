// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTGltfTextures.h"

#include "vtkMTGltfUri.h"

using namespace vtkMTGltfJson;

vtkMTGltfTextures::vtkMTGltfTextures(vtkMTGltfFile& file, std::uint64_t largestImage, Opener open)
  : File(file)
  , LargestImage(largestImage)
  , Open(std::move(open))
{
}

std::size_t vtkMTGltfTextures::FindImage(const Json& reference, const std::string& where) const
{
  const std::size_t index = GetIndex(reference, "index", this->File.GetSize("textures"), where);
  const Json& texture = this->File.GetItem("textures", index);
  const std::string name = where + ", texture " + std::to_string(index);
  const std::size_t images = this->File.GetSize("images");
  if (Find(texture, "source"))
  {
    return GetIndex(texture, "source", images, name);
  }
  for (const auto& [extension, value] : vtkMTGltfJson::GetObject(texture, "extensions", name).items())
  {
    if (Find(value, "source"))
    {
      return GetIndex(value, "source", images, name + ", " + extension);
    }
  }
  Fail(name, "has no image");
}

void vtkMTGltfTextures::ReadImage(std::size_t index, vtkMTTexture& texture)
{
  const std::string where = "image " + std::to_string(index);
  const Json& image = this->File.GetItem("images", index);
  const std::string uri = GetText(image, "uri");
  texture.Name = GetText(image, "name");
  if (uri.empty())
  {
    const vtkMTGltfFile::Range range =
      this->File.OpenView(GetIndex(image, "bufferView", this->File.GetSize("bufferViews"), where));
    if (range.Length > this->LargestImage)
    {
      Fail(where, "is larger than " + std::to_string(this->LargestImage >> 20) + " MiB");
    }
    texture.Bytes = range.ReadAll(where);
  }
  else if (vtkMTGltfUri::HasData(uri))
  {
    if (!vtkMTGltfUri::DecodeData(uri, texture.Bytes))
    {
      Fail(where, "its data are no base64");
    }
  }
  else
  {
    std::string error;
    const std::string name = vtkMTGltfUri::FromPercent(uri);
    texture.Name = texture.Name.empty() ? name : texture.Name;
    if (!this->Open(name, texture.Bytes, error))
    {
      Fail(where, error);
    }
  }
  texture.Name = texture.Name.empty() ? where : texture.Name;
}

void vtkMTGltfTextures::CheckOther(std::size_t index, std::vector<std::string>& problems)
{
  const std::string where = "material " + std::to_string(index);
  const Json& material = this->File.GetItem("materials", index);
  const Json& base = vtkMTGltfJson::GetObject(material, "pbrMetallicRoughness", where);
  for (const std::string& name : vtkMTGltfMaterials::GetOtherTextures())
  {
    const Json* reference = Find(material, name.c_str());
    reference = reference ? reference : Find(base, name.c_str());
    if (!reference)
    {
      continue;
    }
    try
    {
      vtkMTTexture texture;
      this->ReadImage(this->FindImage(*reference, where), texture);
    }
    catch (const Error& error)
    {
      problems.push_back(name + " of " + where + ": " + error.what());
    }
  }
}

void vtkMTGltfTextures::Collect(std::vector<vtkMTTexture>& textures, std::vector<std::string>& problems)
{
  const vtkMTGltfMaterials materials(this->File);
  for (std::size_t i = 0; i < materials.GetMaterials().size(); ++i)
  {
    const vtkMTGltfMaterials::Material& material = materials.GetMaterials()[i];
    const std::string where = "material " + std::to_string(i);
    if (material.Texture)
    {
      try
      {
        vtkMTTexture texture;
        this->ReadImage(this->FindImage(*material.Texture, where), texture);
        texture.Coordinates = "TEXCOORD_" + std::to_string(material.Coordinates);
        texture.Material = static_cast<int>(i);
        texture.MaterialName = material.HasName ? material.Name : "";
        textures.push_back(std::move(texture));
      }
      catch (const Error& error)
      {
        problems.push_back("texture of " + where + ": " + error.what());
      }
    }
    this->CheckOther(i, problems);
  }
}
