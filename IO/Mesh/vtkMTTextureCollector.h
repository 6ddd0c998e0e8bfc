// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTTextureCollector
 * @brief collects the images that a mesh file refers to
 *
 * - OBJ: map_Kd of the materials that are used (usemtl), from the libraries that are named (mtllib);
 * - PLY: "comment TextureFile NAME";
 * - glTF, GLB: the images of the materials' base colours, from files, from data in the JSON or from the buffers; of
 *   other textures only that they are missing is told.
 *
 * Images are kept as they are: they are not decoded. They must be PNG, JPEG, WebP, TIFF, BMP, GIF, KTX2 or TGA by their
 * own bytes (TGA, which has no mark, by its ending). KTX2 and WebP, which VTK does not draw, are among the problems
 * too.
 *
 * Only files in the folder of the mesh or below it are opened: of a name that leads elsewhere (an absolute one, or one
 * with "..") the last component alone is looked for, beside the mesh. A texture that cannot be read is no error of the
 * mesh; it is named, with the reason, among the problems.
 */
#ifndef vtkMTTextureCollector_h
#define vtkMTTextureCollector_h

#include "vtkMTIOMeshModule.h" // For export macro
#include "vtkMTTexture.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkMTByteSource;
class vtkPolyData;

class VTKMTIOMESH_EXPORT vtkMTTextureCollector
{
public:
  /// No larger image is taken.
  static constexpr std::uint64_t LargestImage = std::uint64_t(1) << 28;

  /**
   * Adds the textures of the mesh that vtkMTMeshReader read from path, which says in its field data what it refers to
   * ("MaterialNames", "MaterialLibraries", "TextureFiles"). part: its number where several meshes become one, or -1.
   */
  void Collect(const std::string& path, vtkPolyData* mesh, int part = -1);

  const std::vector<vtkMTTexture>& GetTextures() const { return this->Textures; }
  const std::vector<std::string>& GetProblems() const { return this->Problems; }

private:
  void CollectObj(const std::string& path, vtkPolyData* mesh, int part);
  void CollectPly(const std::string& path, vtkPolyData* mesh, int part);
  void CollectGltf(const vtkMTByteSource& source, int part);
  static bool IsGltf(const vtkMTByteSource& source);
  void Add(vtkMTTexture&& texture);

  std::vector<vtkMTTexture> Textures;
  std::vector<std::string> Problems;
};

#endif
