// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTVerifyGltfInput
 * @brief reads glTF 2.0 for the verification, after the specification alone
 *
 * The meshes of the default scene as they stand: nodes' matrices, translations, rotations and scales, instances of
 * EXT_mesh_gpu_instancing, positions of any component type. Where a node's global matrix has a negative determinant the
 * corners of its triangles change their order, as the specification says, and normals go by the inverse transpose.
 * Texture coordinates count from the bottom, as VTK's do, behind KHR_texture_transform of the base colour; where
 * that has a rotation they are left out, since the extension's words and its formula turn to different sides. Materials
 * are an array of names with the base colours beside it where no texture covers them. Not read, which error says: Draco
 * and meshopt compression, skins, morph targets with weights, and required extensions that are not known here.
 */
#ifndef vtkMTVerifyGltfInput_h
#define vtkMTVerifyGltfInput_h

#include "vtkMTVerificationModule.h" // For export macro

#include <string>

class vtkPolyData;

class VTKMTVERIFICATION_EXPORT vtkMTVerifyGltfInput
{
public:
  static bool Read(const std::string& path, vtkPolyData* out, std::string& error);
};

#endif
