// SPDX-License-Identifier: BSD-3-Clause
// Writes a triangle stream as glTF 2.0 for vtkMTMeshWriter. Not installed.
//
// One mesh of one primitive in one buffer: the points with all their attributes interleaved, then the triangles' 32-bit
// indices, so that one pass over the points and one over the triangles write it. What is not a point array that glTF
// has a form for is left out and named. (VTK 9.1's vtkGLTFWriter is made for buildings: it takes composite data only
// and writes no colours.)
#ifndef vtkMTGltfWriter_h
#define vtkMTGltfWriter_h

#include "vtkMTJson.h"
#include "vtkMTTriangleStream.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkMTOutputFile;

class vtkMTGltfWriter
{
public:
  /// Binary: one GLB file; otherwise JSON with the buffer in it (base64).
  vtkMTGltfWriter(vtkMTTriangleStream& mesh, bool binary);

  /// Writes everything into the open file; does not commit it.
  bool Write(vtkMTOutputFile& file, std::string& error);

  /// The arrays that glTF has no form for, as "point NAME" or "cell NAME".
  const std::vector<std::string>& GetDropped() const { return this->Dropped; }

private:
  enum class Kind
  {
    Normal,
    TextureCoordinates,
    Color,
    Custom
  };
  struct Attribute
  {
    Kind What;
    std::string Name;
    int Type; // VTK_FLOAT, VTK_DOUBLE or VTK_UNSIGNED_CHAR
    std::size_t Components;
    std::size_t Column;
    std::size_t Offset; // in the vertex
  };
  class Output;

  void ChooseAttributes();
  bool Choose(const vtkMTArrayInfo& array, std::size_t column);
  bool Survey(std::string& error);
  void ChooseOrigin();
  nlohmann::ordered_json Describe() const;
  bool WritePoints(Output& output, std::string& error);
  bool WriteTriangles(Output& output, std::string& error);
  void FillVertex(const vtkMTTriangleStream::PointBlock& block, std::size_t i, unsigned char* vertex) const;

  vtkMTTriangleStream& Mesh;
  const bool IsBinary;
  std::vector<Attribute> Attributes;
  std::vector<std::string> Dropped;
  std::size_t Stride = 12;
  double Bounds[6];
  double Origin[3] = { 0.0, 0.0, 0.0 };
  bool NeedsDouble = false;
};

#endif
