// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTGltfReader.h"

#include "vtkMTGltfDraco.h"
#include "vtkMTGltfMesh.h"
#include "vtkMTGltfMeshopt.h"
#include "vtkMTPosix.h"
#include "vtkMTReadWhole.h"

#include <algorithm>

namespace
{
using namespace vtkMTGltfJson;

// Extensions that are read, and those that do nothing to geometry: materials, textures, lights and data beside it. What
// ends in an underscore stands for all that begin with it.
bool IsKnown(const std::string& extension)
{
  static const char* const known[] = { "KHR_mesh_quantization", "EXT_mesh_gpu_instancing", "KHR_texture_transform",
    "KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_materials_", "KHR_texture_basisu", "EXT_texture_",
    "MSFT_texture_", "MSFT_packing_", "KHR_lights_", "EXT_lights_", "KHR_xmp", "KHR_animation_pointer",
    "EXT_mesh_features", "EXT_instance_features", "EXT_structural_metadata", "EXT_feature_metadata",
    "KHR_techniques_webgl", "CESIUM_primitive_outline", "AGI_", "KHR_audio", "FB_ngon_encoding" };
  return std::any_of(std::begin(known), std::end(known),
    [&extension](const std::string& name)
    {
      return extension == name || (name.back() == '_' && extension.rfind(name, 0) == 0) ||
        (name == "KHR_xmp" && extension == "KHR_xmp_json_ld");
    });
}

void CheckExtensions(const vtkMTGltfFile& file)
{
  for (const Json& entry : file.GetList("extensionsRequired"))
  {
    const std::string extension = entry.is_string() ? entry.get<std::string>() : entry.dump();
    const bool isMissing = (extension == "KHR_draco_mesh_compression" && !vtkMTGltfDraco::IsAvailable()) ||
      (extension == "EXT_meshopt_compression" && !vtkMTGltfMeshopt::IsAvailable());
    if (isMissing || !IsKnown(extension))
    {
      throw Error("requires the extension " + extension + ", which " +
        (isMissing ? "this program was built without" : "is not known"));
    }
  }
}
}

bool vtkMTGltfReader::Read(
  const vtkMTByteSource& bytes, vtkPolyData* output, std::string& error, Counts* counts, std::uint64_t memoryLimit)
{
  return vtkMTReadWhole::Read(bytes, output, error,
    [&](std::string&)
    {
      Counts found;
      vtkMTGltfFile file(bytes);
      CheckExtensions(file);
      vtkMTGltfMesh(file, found).Make(memoryLimit > 0 ? memoryLimit : vtkMTPosix::GetMachineMemory(), output);
      for (const auto& [name, count] : found)
      {
        if (counts && count != 0)
        {
          (*counts)[name] += count;
        }
      }
      return true;
    });
}
