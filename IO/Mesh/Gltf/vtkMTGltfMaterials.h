// SPDX-License-Identifier: BSD-3-Clause
// The materials of a glTF file: their names, base colours and textures. Not installed.
//
// Colours are taken as the file has them; glTF means them as linear ones, VTK draws them as they are. Where there is
// KHR_materials_pbrSpecularGlossiness, the diffuse colour and texture are the base ones.
#ifndef vtkMTGltfMaterials_h
#define vtkMTGltfMaterials_h

#include "vtkMTGltfFile.h"

#include <array>
#include <map>

class vtkDataArray;

class vtkMTGltfMaterials
{
public:
  using Json = vtkMTGltfJson::Json;

  /// KHR_texture_transform: u' = offset + rotation * scale * u, coordinates counted from the top of the image.
  struct TextureTransform
  {
    double Offset[2] = { 0.0, 0.0 };
    double Rotation = 0.0; // radians
    double Scale[2] = { 1.0, 1.0 };

    bool IsIdentity() const;
    /// Both counted from the top.
    void Transform(const double from[2], double to[2]) const;
  };
  struct Material
  {
    std::string Name; // "material 3" where it has none
    bool HasName = false;
    std::array<double, 4> Color{ 1.0, 1.0, 1.0, 1.0 };
    const Json* Texture = nullptr; // the reference to the base colour's
    std::uint64_t Coordinates = 0; // the set of texture coordinates that it goes by
    TextureTransform Transform;
    std::size_t OtherTextures = 0; // such as a normal map

    bool IsPlain() const { return !this->HasName && !this->Texture && this->Color == Material().Color; }
  };

  /// Throws vtkMTGltfJson::Error, as all members do. The file must outlive this.
  explicit vtkMTGltfMaterials(const vtkMTGltfFile& file);

  const std::vector<Material>& GetMaterials() const { return this->Materials; }
  /// The base colour of a material, linear as the file has it; white of none (-1).
  std::array<unsigned char, 4> GetColor(int material) const;

  /// How the coordinates of this set are transformed on this material (-1: none).
  TextureTransform FindTransform(int material, const std::string& attribute) const;

  /// Names of a material's references to textures beside the base colour's.
  static const std::vector<std::string>& GetOtherTextures();

  /// The names and base colours as the annotations and colours of the array's lookup table.
  void Describe(vtkDataArray* ids, bool hasCellsWithout) const;

private:
  std::vector<Material> Materials;
};

#endif
