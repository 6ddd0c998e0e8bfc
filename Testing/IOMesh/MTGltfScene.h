// SPDX-License-Identifier: BSD-3-Clause
// glTF scenes that tests assemble, and what they ask of the mesh that is read from one.
#ifndef MTGltfScene_h
#define MTGltfScene_h

#include "MTIOTest.h"

#include "vtkMTGltfReader.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cstring>
#include <map>

class MTGltfScene
{
public:
  using Json = nlohmann::json;
  using Bytes = MTIOTest::Bytes;

  Json Document;
  Bytes Buffer;

  /// An empty scene.
  MTGltfScene();

  /// The number of a new view; stride 0: none.
  std::size_t AddView(const void* bytes, std::size_t size, std::size_t stride = 0);

  /// The number of a new accessor of values that lie one after the other; elements of padded types are filled up to
  /// stride bytes.
  template <typename T>
  std::size_t AddAccessor(
    const std::vector<T>& values, const std::string& type, bool isNormalized = false, std::size_t stride = 0)
  {
    const std::size_t components = type == "SCALAR" ? 1 : static_cast<std::size_t>(type.back() - '0');
    const std::size_t size = components * sizeof(T);
    const std::size_t step = std::max(size, stride);
    Bytes bytes(values.size() / components * step);
    for (std::size_t i = 0; i < values.size() / components; ++i)
    {
      std::memcpy(bytes.data() + i * step, values.data() + i * components, size);
    }
    const std::size_t view = this->AddView(bytes.data(), bytes.size(), stride);
    return this->AddAccessor(view, GetType(T()), values.size() / components, type, isNormalized);
  }
  std::size_t AddAccessor(
    std::size_t view, int componentType, std::size_t count, const std::string& type, bool isNormalized = false);

  /// The number of a new mesh of these primitives.
  std::size_t AddMesh(const std::vector<Json>& primitives);
  /// The number of a new node, which is a root of the scene.
  std::size_t AddNode(const Json& node);
  /// The unit cube: a primitive with its accessors.
  Json MakeCube();
  void Require(const std::string& extension);

  Bytes ToGlb() const;
  /// With the buffer in the uri, percent-encoded or as base64.
  std::string ToGltf(bool isBase64) const;

  static const std::vector<float>& GetCubePlaces();
  static const std::vector<std::uint16_t>& GetCubeCorners();

private:
  static int GetType(std::int8_t) { return 5120; }
  static int GetType(std::uint8_t) { return 5121; }
  static int GetType(std::int16_t) { return 5122; }
  static int GetType(std::uint16_t) { return 5123; }
  static int GetType(std::uint32_t) { return 5125; }
  static int GetType(float) { return 5126; }
};

/// What was read.
struct MTGltfMesh
{
  vtkSmartPointer<vtkPolyData> Mesh = vtkSmartPointer<vtkPolyData>::New();
  std::map<std::string, std::int64_t> Counts;
  std::string Error;

  static MTGltfMesh Read(const MTIOTest::Bytes& bytes, std::uint64_t memoryLimit = 0);
  static MTGltfMesh Read(const MTGltfScene& scene) { return Read(scene.ToGlb()); }

  double GetVolume() const;
  std::array<double, 6> GetBounds() const;
  /// How many points of a closed convex part have normals that lead away from its middle.
  vtkIdType CountOutwardNormals(const double middle[3], vtkIdType first, vtkIdType count) const;
  std::vector<double> GetValues(const char* pointArray) const;
  std::vector<double> GetCellValues(const char* cellArray) const;
};

#endif
