// SPDX-License-Identifier: BSD-3-Clause
// Where the meshes of a glTF file are: the nodes of its scene, with their instances. Not installed.
//
// The scene is the one that the file names, else its first; without scenes all nodes that have no parent, and without
// nodes all meshes as they are. Nodes come before their children, children in their order; the instances of
// EXT_mesh_gpu_instancing in theirs. A node with two parents and a node that is its own ancestor are errors.
#ifndef vtkMTGltfScene_h
#define vtkMTGltfScene_h

#include "vtkMTGltfFile.h"
#include "vtkMTGltfMatrix.h"

#include <map>

class vtkMTGltfScene
{
public:
  struct Placement
  {
    std::size_t Mesh = 0;
    int Node = -1;
    vtkMTGltfMatrix Matrix;
  };
  using Counts = std::map<std::string, std::int64_t>;

  /// counts gets what is ignored: "scenes_left_out", "skins_ignored", "instance_attributes_ignored". Throws
  /// vtkMTGltfJson::Error.
  vtkMTGltfScene(vtkMTGltfFile& file, Counts& counts);

  const std::vector<Placement>& GetPlacements() const { return this->Placements; }

private:
  using Json = vtkMTGltfJson::Json;

  void FindParents();
  std::vector<std::size_t> FindRoots(Counts& counts) const;
  std::vector<std::size_t> GetIndices(const Json& object, const char* key, const std::string& where) const;
  void AddNode(std::size_t node, const vtkMTGltfMatrix& matrix, Counts& counts);
  std::vector<vtkMTGltfMatrix> ReadInstances(std::size_t node, const Json& extension, Counts& counts);

  vtkMTGltfFile& File;
  std::vector<std::size_t> Parents; // of all nodes; the number of nodes for none
  std::vector<Placement> Placements;
};

#endif
