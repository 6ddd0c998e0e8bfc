// SPDX-License-Identifier: BSD-3-Clause
// One primitive of a mesh of a glTF file: what it refers to, checked, and its triangles. Not installed.
#ifndef vtkMTGltfPrimitive_h
#define vtkMTGltfPrimitive_h

#include "vtkMTGltfAccessor.h"
#include "vtkMTGltfDraco.h"

#include <map>
#include <memory>
#include <optional>

class vtkMTGltfPrimitive
{
public:
  using Json = vtkMTGltfJson::Json;
  /// Called for every triangle; corners are below the number of points.
  using TriangleConsumer = std::function<void(std::uint64_t a, std::uint64_t b, std::uint64_t c)>;

  /// Throws vtkMTGltfJson::Error, as all members do.
  vtkMTGltfPrimitive(vtkMTGltfFile& file, std::size_t mesh, std::size_t index);

  const std::string& GetName() const { return this->Where; }
  std::uint64_t GetNumberOfPoints() const { return this->Points; }
  std::uint64_t GetNumberOfTriangles() const { return this->Triangles; }
  /// Cells that are no triangles; with them a primitive has no triangles.
  std::uint64_t GetNumberOfVertices() const { return this->Vertices; }
  std::uint64_t GetNumberOfLines() const { return this->Lines; }
  /// Corners at the end that make no triangle.
  std::uint64_t GetNumberOfLeftCorners() const { return this->LeftCorners; }
  std::size_t GetNumberOfMorphTargets() const { return this->MorphTargets; }
  int GetMaterial() const { return this->Material; }
  /// By name; POSITION is there, and all have as many values.
  const std::map<std::string, vtkMTGltfAccessor>& GetAttributes() const { return this->Attributes; }

  void ReadAttribute(vtkMTGltfFile& file, const std::string& name, const vtkMTGltfAccessor::Consumer& consumer);
  void ReadTriangles(vtkMTGltfFile& file, const TriangleConsumer& consumer);

  /// Forgets what was decoded.
  void Release() { this->Decoded.reset(); }

private:
  enum ModeType
  {
    PointCells = 0,
    LineCells = 1,
    LineLoop = 2,
    LineStrip = 3,
    TriangleCells = 4,
    Strip = 5,
    Fan = 6
  };
  void FindAttributes(vtkMTGltfFile& file, const Json& primitive);
  void FindDraco(vtkMTGltfFile& file, const Json& primitive);
  void FindCells(std::uint64_t corners);
  const vtkMTGltfDraco& Decode(vtkMTGltfFile& file);

  std::string Where;
  std::uint64_t Mode = TriangleCells;
  int Material = -1;
  std::uint64_t Points = 0;
  std::uint64_t Triangles = 0;
  std::uint64_t Vertices = 0;
  std::uint64_t Lines = 0;
  std::uint64_t LeftCorners = 0;
  std::size_t MorphTargets = 0;
  std::map<std::string, vtkMTGltfAccessor> Attributes;
  std::optional<vtkMTGltfAccessor> Indices;
  std::optional<std::size_t> DracoView;
  std::map<std::string, std::uint64_t> DracoNumbers;
  std::shared_ptr<const vtkMTGltfDraco> Decoded;
};

#endif
