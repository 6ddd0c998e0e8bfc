// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTGltfMaterials.h"

#include "vtkMTIdNames.h"

#include "vtkDataArray.h"

#include <algorithm>
#include <cmath>

using namespace vtkMTGltfJson;

namespace
{
using Material = vtkMTGltfMaterials::Material;

void ReadTexture(const Json& reference, const std::string& where, Material& material)
{
  material.Texture = &reference;
  material.Coordinates = GetCount(reference, "texCoord", where, 0);
  const Json* transform = FindExtension(reference, "KHR_texture_transform");
  if (transform)
  {
    const std::vector<double> offset = GetNumbers(*transform, "offset", 2, where, { 0.0, 0.0 });
    const std::vector<double> scale = GetNumbers(*transform, "scale", 2, where, { 1.0, 1.0 });
    std::copy_n(offset.begin(), 2, material.Transform.Offset);
    std::copy_n(scale.begin(), 2, material.Transform.Scale);
    const Json* rotation = Find(*transform, "rotation");
    material.Transform.Rotation = rotation && rotation->is_number() ? rotation->get<double>() : 0.0;
    material.Coordinates = GetCount(*transform, "texCoord", where, material.Coordinates);
  }
}

Material ReadMaterial(const Json& object, const std::string& where)
{
  const Json* old = FindExtension(object, "KHR_materials_pbrSpecularGlossiness");
  const Json& base = old ? *old : vtkMTGltfJson::GetObject(object, "pbrMetallicRoughness", where);
  Material material;
  material.Name = GetText(object, "name");
  material.HasName = !material.Name.empty();
  material.Name = material.HasName ? material.Name : where;
  const std::vector<double> color =
    GetNumbers(base, old ? "diffuseFactor" : "baseColorFactor", 4, where, { 1.0, 1.0, 1.0, 1.0 });
  std::copy_n(color.begin(), 4, material.Color.begin());
  const Json& texture = vtkMTGltfJson::GetObject(base, old ? "diffuseTexture" : "baseColorTexture", where);
  if (!texture.empty())
  {
    ReadTexture(texture, where, material);
  }
  for (const std::string& name : vtkMTGltfMaterials::GetOtherTextures())
  {
    material.OtherTextures += Find(object, name.c_str()) || Find(base, name.c_str()) ? 1 : 0;
  }
  return material;
}
}

//------------------------------------------------------------------------------
bool vtkMTGltfMaterials::TextureTransform::IsIdentity() const
{
  return this->Offset[0] == 0.0 && this->Offset[1] == 0.0 && this->Rotation == 0.0 && this->Scale[0] == 1.0 &&
    this->Scale[1] == 1.0;
}

// Counter-clockwise as one sees it, with v downwards. (The matrix in the extension's text turns the other way, its
// examples and all viewers this way.)
void vtkMTGltfMaterials::TextureTransform::Transform(const double from[2], double to[2]) const
{
  const double cosine = std::cos(this->Rotation);
  const double sine = std::sin(this->Rotation);
  const double u = this->Scale[0] * from[0];
  const double v = this->Scale[1] * from[1];
  to[0] = this->Offset[0] + cosine * u + sine * v;
  to[1] = this->Offset[1] - sine * u + cosine * v;
}

//------------------------------------------------------------------------------
vtkMTGltfMaterials::vtkMTGltfMaterials(const vtkMTGltfFile& file)
{
  for (std::size_t i = 0; i < file.GetSize("materials"); ++i)
  {
    this->Materials.push_back(ReadMaterial(file.GetItem("materials", i), "material " + std::to_string(i)));
  }
}

vtkMTGltfMaterials::TextureTransform vtkMTGltfMaterials::FindTransform(int material, const std::string& attribute) const
{
  if (material < 0)
  {
    return TextureTransform();
  }
  const Material& found = this->Materials[static_cast<std::size_t>(material)];
  return found.Texture && attribute == "TEXCOORD_" + std::to_string(found.Coordinates) ? found.Transform
                                                                                       : TextureTransform();
}

const std::vector<std::string>& vtkMTGltfMaterials::GetOtherTextures()
{
  static const std::vector<std::string> names = { "normalTexture", "occlusionTexture", "emissiveTexture",
    "metallicRoughnessTexture", "specularGlossinessTexture" };
  return names;
}

std::array<unsigned char, 4> vtkMTGltfMaterials::GetColor(int material) const
{
  const std::array<double, 4> color =
    material < 0 ? Material().Color : this->Materials[static_cast<std::size_t>(material)].Color;
  std::array<unsigned char, 4> bytes{};
  std::transform(color.begin(), color.end(), bytes.begin(),
    [](double value) { return static_cast<unsigned char>(std::floor(255.0 * std::clamp(value, 0.0, 1.0) + 0.5)); });
  return bytes;
}

void vtkMTGltfMaterials::Describe(vtkDataArray* ids, bool hasCellsWithout) const
{
  std::vector<std::string> names;
  std::vector<vtkMTIdNames::Color> colors;
  std::vector<double> values;
  const auto add = [&](const std::string& name, const std::array<double, 4>& color, double value)
  {
    names.push_back(name);
    colors.push_back(
      { std::clamp(color[0], 0.0, 1.0), std::clamp(color[1], 0.0, 1.0), std::clamp(color[2], 0.0, 1.0) });
    values.push_back(value);
  };
  for (const Material& material : this->Materials)
  {
    add(material.Name, material.Color, static_cast<double>(values.size()));
  }
  if (hasCellsWithout)
  {
    add("no material", Material().Color, -1.0);
  }
  ids->SetLookupTable(vtkMTIdNames::MakeTable(names, colors, values));
}
