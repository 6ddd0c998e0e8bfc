// SPDX-License-Identifier: BSD-3-Clause
// The scene of a glTF file as one mesh. Not installed.
//
// Everything is checked and counted first (and compared with the memory limit, as a small file may place one mesh a
// million times), then allocated once, then decoded straight into its place: node by node, primitive by primitive.
// Cell arrays: MaterialIds and NodeIds (int, with names as annotations of the lookup table) where there is something to
// tell apart, and BaseColor (unsigned char, the active scalars) where a material has one.
#ifndef vtkMTGltfMesh_h
#define vtkMTGltfMesh_h

#include "vtkMTGltfArrays.h"
#include "vtkMTGltfScene.h"

class vtkIntArray;
class vtkPolyData;

class vtkMTGltfMesh
{
public:
  using Counts = std::map<std::string, std::int64_t>;

  /// Throws vtkMTGltfJson::Error, as all members do. The file must outlive this.
  vtkMTGltfMesh(vtkMTGltfFile& file, Counts& counts);

  void Make(std::uint64_t memoryLimit, vtkPolyData* output);

private:
  using Placement = vtkMTGltfScene::Placement;

  void FindPrimitives(std::size_t mesh);
  void CountPlacement(const Placement& placement);
  void CountIgnored(const vtkMTGltfPrimitive& primitive);
  void AddBounds(const vtkMTGltfPrimitive& primitive, const vtkMTGltfMatrix& matrix);
  void CheckMemory(std::uint64_t limit) const;
  bool IsFarFromOrigin() const;
  void FillPlacement(const Placement& placement);
  template <typename Array>
  void MakeCells(vtkPolyData* output);
  void FillCells(vtkMTGltfPrimitive& primitive, const Placement& placement);
  void AddMaterials(vtkPolyData* output);
  void AddBaseColors(const std::vector<int>& used, vtkPolyData* output);
  void AddNodes(vtkPolyData* output);

  vtkMTGltfFile& File;
  Counts& Report;
  const vtkMTGltfScene Scene;
  const vtkMTGltfMaterials Materials;
  std::map<std::size_t, std::vector<vtkMTGltfPrimitive>> Primitives; // of the meshes that are placed
  vtkMTGltfArrays Arrays;
  std::uint64_t Points = 0;
  std::uint64_t Triangles = 0;
  double Bounds[6];
  bool IsMoved = false;

  std::function<void(std::uint64_t position, std::uint64_t point)> PutCorner;
  vtkIdType NextPoint = 0;
  vtkIdType NextTriangle = 0;
  vtkSmartPointer<vtkIntArray> MaterialIds;
  vtkSmartPointer<vtkIntArray> NodeIds;
};

#endif
