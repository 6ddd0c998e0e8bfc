// SPDX-License-Identifier: BSD-3-Clause
// The point arrays of all primitives of a glTF scene as one set of arrays. Not installed.
//
// Every attribute that some primitive has is one array, with the attribute's name: points and normals in the places of
// their nodes, texture coordinates counted from the bottom of the image as VTK has them, colours as bytes, and all else
// in its own type; integers where types differ in one that holds them all, _FEATURE_ID_n of whole floats as integers.
// Primitives that lack it have 0, colours 255.
#ifndef vtkMTGltfArrays_h
#define vtkMTGltfArrays_h

#include "vtkMTGltfMaterials.h"
#include "vtkMTGltfMatrix.h"
#include "vtkMTGltfPrimitive.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

class vtkDataArray;
class vtkPolyData;

class vtkMTGltfArrays
{
public:
  using Counts = std::map<std::string, std::int64_t>;

  /// The attributes of a primitive will be among the arrays.
  void Add(const vtkMTGltfPrimitive& primitive);
  /// Points come in double precision.
  void SetDouble(bool isDouble) { this->IsDouble = isDouble; }

  /// Bytes of all values of one point.
  std::uint64_t GetTupleSize() const;
  void Allocate(vtkIdType points);

  /// The points of one placed primitive, from point first on.
  void Fill(vtkMTGltfFile& file, vtkMTGltfPrimitive& primitive, const vtkMTGltfMatrix& matrix,
    const vtkMTGltfMaterials& materials, vtkIdType first);
  /// Area-weighted normals of one placed primitive, where it has none and others have.
  bool NeedsNormals(const vtkMTGltfPrimitive& primitive) const;
  void MakeNormals(vtkIdType first, vtkIdType count, const std::vector<vtkIdType>& corners);

  /// Gives them to the mesh.
  void Finish(vtkPolyData* output, Counts& counts);

private:
  enum class Kind
  {
    Position,
    Normal,
    Tangent,
    TextureCoordinates,
    Color,
    Custom
  };
  struct Column
  {
    Kind What = Kind::Custom;
    int Type = VTK_FLOAT;
    std::size_t Components = 0;
    std::size_t Users = 0; // primitives
    vtkSmartPointer<vtkDataArray> Array;
  };
  static Kind FindKind(const std::string& name);
  static int FindType(Kind kind, const vtkMTGltfAccessor& accessor);
  static int Unite(int a, int b);
  static void FillMissing(
    const Column& column, const vtkMTGltfMaterials& materials, int material, vtkIdType first, vtkIdType count);

  std::map<std::string, Column> Columns;
  std::size_t Primitives = 0;
  bool IsDouble = false;
};

#endif
