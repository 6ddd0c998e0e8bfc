// SPDX-License-Identifier: BSD-3-Clause
// A mesh of KHR_draco_mesh_compression, where Draco was found (MT_WITH_DRACO). Not installed.
#ifndef vtkMTGltfDraco_h
#define vtkMTGltfDraco_h

#include "vtkMTGltfAccessor.h"

#include <memory>

class vtkMTGltfDraco
{
public:
  static bool IsAvailable();

  /// How many triangles the bytes announce; checked against their number. Throws vtkMTGltfJson::Error, as all do.
  static std::uint64_t FindNumberOfTriangles(const std::vector<unsigned char>& bytes, const std::string& where);

  vtkMTGltfDraco(const std::vector<unsigned char>& bytes, const std::string& where);
  ~vtkMTGltfDraco();
  vtkMTGltfDraco(const vtkMTGltfDraco&) = delete;
  void operator=(const vtkMTGltfDraco&) = delete;

  std::uint64_t GetNumberOfPoints() const;
  std::uint64_t GetNumberOfTriangles() const;

  /// The attribute with this number, which must have as many components as its accessor.
  void ReadAttribute(
    std::uint64_t number, const vtkMTGltfAccessor& accessor, const vtkMTGltfAccessor::Consumer& consumer) const;
  /// The corners of all triangles.
  void ReadCorners(const vtkMTGltfAccessor::Consumer& consumer) const;

private:
  struct Internals;
  std::unique_ptr<Internals> Implementation;
  std::string Where;
};

#endif
