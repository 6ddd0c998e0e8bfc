// SPDX-License-Identifier: BSD-3-Clause
// The images that the materials of a glTF file refer to. Not installed.
//
// A texture that names two images, one of them for an extension (KHR_texture_basisu, EXT_texture_webp and so on), is
// taken from the plain one.
#ifndef vtkMTGltfTextures_h
#define vtkMTGltfTextures_h

#include "vtkMTGltfMaterials.h"
#include "vtkMTTexture.h"

class vtkMTGltfTextures
{
public:
  /// Opens a file that lies beside the mesh; false, with the reason in error.
  using Opener = std::function<bool(const std::string& name, std::vector<unsigned char>& bytes, std::string& error)>;

  vtkMTGltfTextures(vtkMTGltfFile& file, std::uint64_t largestImage, Opener open);

  /// Adds the textures of all base colours, and the reasons where there is none. Other textures, such as normal maps,
  /// are not taken; that the image of one is missing is told. Throws vtkMTGltfJson::Error where the materials are
  /// damaged.
  void Collect(std::vector<vtkMTTexture>& textures, std::vector<std::string>& problems);

private:
  using Json = vtkMTGltfJson::Json;

  std::size_t FindImage(const Json& reference, const std::string& where) const;
  void ReadImage(std::size_t image, vtkMTTexture& texture);
  void CheckOther(std::size_t material, std::vector<std::string>& problems);

  vtkMTGltfFile& File;
  const std::uint64_t LargestImage;
  const Opener Open;
};

#endif
