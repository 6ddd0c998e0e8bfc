// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTGltfReader
 * @brief reads the scene of a glTF 2.0 file (.gltf, .glb) as one mesh
 *
 * All meshes of the scene, in the places that nodes and instances (EXT_mesh_gpu_instancing) give them; a mesh that is
 * placed twice is there twice. Triangles, strips and fans become triangles; what is mirrored (a negative determinant)
 * has its triangles turned, so that outside stays outside. Positions are in single precision, or in double where nodes
 * move them so far from the origin that single precision would lose digits.
 *
 * Read are interleaved, sparse and quantized accessors (KHR_mesh_quantization), Draco and meshopt compression
 * (KHR_draco_mesh_compression, EXT_meshopt_compression: where the libraries were found), and texture coordinates as
 * KHR_texture_transform has them; what other required extensions do to geometry is not known, so these are refused by
 * name. Attributes keep their names: NORMAL, TEXCOORD_0 and COLOR_0 (unsigned char, whatever the file has) are the
 * active normals, texture coordinates and scalars. Arrays are united over all primitives: 0 where a primitive lacks
 * one, 255 for colours, and made normals. Cells have MaterialIds, NodeIds and BaseColor, where there is something to
 * tell apart (vtkMTGltfMesh).
 *
 * The counts: "vertices" and "lines" (cells that are no triangles), "left_corners" (at the end, that make no triangle),
 * "turned_triangles", "united_arrays_filled" (arrays that some primitive lacks), "made_part_normals" (points),
 * "primitives_without_points", "scenes_left_out", "skins_ignored" and "morph_targets_ignored" (the base geometry is
 * read), "instance_attributes_ignored", "textures_ignored" (others than of base colours).
 *
 * Nothing in a file is taken on trust: every index, offset and length is checked before it is used, against the bytes
 * that are there, and an error says what is wrong where. Memory: the mesh, and what is compressed a view at a time.
 */
#ifndef vtkMTGltfReader_h
#define vtkMTGltfReader_h

#include "vtkMTIOMeshModule.h" // For export macro

#include <cstdint>
#include <map>
#include <string>

class vtkMTByteSource;
class vtkPolyData;

struct VTKMTIOMESH_EXPORT vtkMTGltfReader
{
  using Counts = std::map<std::string, std::int64_t>;

  /**
   * False, with the source's name and the reason in error, and an empty output, on failure. The name of the source is
   * where the files that a .gltf refers to are looked for. counts: what was left out or made up is added to it; may be
   * null. memoryLimit, in bytes: a larger mesh is refused; 0 (default): the memory of the machine.
   */
  static bool Read(const vtkMTByteSource& bytes, vtkPolyData* output, std::string& error, Counts* counts = nullptr,
    std::uint64_t memoryLimit = 0);
};

#endif
