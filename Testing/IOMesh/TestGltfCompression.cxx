// SPDX-License-Identifier: BSD-3-Clause
// Compressed glTF: meshopt and Draco, encoded here by their own libraries.
#include "MTGltfScene.h"

#include "vtkPointData.h"

#ifdef MT_HAS_DRACO
#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#endif
#ifdef MT_HAS_MESHOPTIMIZER
#include <meshoptimizer.h>
#endif

#include <cmath>

using namespace MTIOTest;
using Json = nlohmann::json;

#ifdef MT_HAS_MESHOPTIMIZER
namespace
{
// The view becomes a compressed one, whose own bytes are in a fallback buffer that is not there.
void Compress(MTGltfScene& scene, std::size_t view, const Bytes& bytes, std::size_t count, std::size_t stride,
  const std::string& mode, const std::string& filter = "NONE")
{
  const Json old = scene.Document["bufferViews"][view];
  const std::size_t compressed = scene.AddView(bytes.data(), bytes.size());
  Json extension = scene.Document["bufferViews"][compressed];
  extension.update({ { "byteStride", stride }, { "count", count }, { "mode", mode }, { "filter", filter } });
  Json& changed = scene.Document["bufferViews"][view];
  changed = { { "buffer", 1 }, { "byteLength", count * stride }, { "byteOffset", 0 },
    { "extensions", { { "EXT_meshopt_compression", extension } } } };
  if (mode == "ATTRIBUTES")
  {
    changed["byteStride"] = stride;
  }
  if (scene.Document["buffers"].size() == 1)
  {
    scene.Document["buffers"].push_back(
      { { "byteLength", 100000 }, { "extensions", { { "EXT_meshopt_compression", { { "fallback", true } } } } } });
    scene.Require("EXT_meshopt_compression");
  }
}

Bytes EncodeVertices(const void* values, std::size_t count, std::size_t stride)
{
  Bytes bytes(meshopt_encodeVertexBufferBound(count, stride));
  bytes.resize(meshopt_encodeVertexBuffer(bytes.data(), bytes.size(), values, count, stride));
  return bytes;
}

MTGltfScene MakeMeshopt(bool isSequence)
{
  MTGltfScene scene;
  const Json cube = scene.MakeCube(); // accessors and views 0 (places) and 1 (corners)
  scene.AddNode({ { "mesh", scene.AddMesh({ cube }) } });
  Compress(scene, 0, EncodeVertices(MTGltfScene::GetCubePlaces().data(), 8, 12), 8, 12, "ATTRIBUTES");
  const std::vector<std::uint16_t>& corners = MTGltfScene::GetCubeCorners();
  Bytes bytes(meshopt_encodeIndexBufferBound(36, 8) + meshopt_encodeIndexSequenceBound(36, 8));
  const std::vector<unsigned int> wide(corners.begin(), corners.end());
  bytes.resize(isSequence ? meshopt_encodeIndexSequence(bytes.data(), bytes.size(), wide.data(), 36)
                          : meshopt_encodeIndexBuffer(bytes.data(), bytes.size(), wide.data(), 36));
  Compress(scene, 1, bytes, 36, 2, isSequence ? "INDICES" : "TRIANGLES");
  return scene;
}
}

TEST(GltfCompression, MeshoptInAllModes)
{
  for (const bool isSequence : { false, true })
  {
    const MTGltfMesh read = MTGltfMesh::Read(MakeMeshopt(isSequence));
    ASSERT_EQ(read.Error, "");
    EXPECT_EQ(read.Mesh->GetNumberOfPolys(), 12);
    EXPECT_NEAR(read.GetVolume(), 1.0, 1e-6);
  }
}

TEST(GltfCompression, MeshoptWithAllFilters)
{
  MTGltfScene scene = MakeMeshopt(false);
  std::vector<float> normals;
  std::vector<float> places;
  for (std::size_t i = 0; i < 8; ++i)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      const float place = MTGltfScene::GetCubePlaces()[3 * i + c];
      places.push_back(place + 0.25f);
      normals.push_back((2.0f * place - 1.0f) / std::sqrt(3.0f));
    }
    normals.push_back(0.0f);
  }
  std::vector<std::uint32_t> exponential(24);
#if MESHOPTIMIZER_VERSION >= 190
  meshopt_encodeFilterExp(exponential.data(), 8, 12, 20, places.data(), meshopt_EncodeExpSharedVector);
#else
  meshopt_encodeFilterExp(exponential.data(), 8, 12, 20, places.data());
#endif
  std::vector<std::int8_t> octahedral(32);
  meshopt_encodeFilterOct(octahedral.data(), 8, 4, 8, normals.data());
  const float half = std::sqrt(0.5f);
  const std::vector<float> turns = { 0, 0, 0, 1, 0, 0, half, half };
  std::vector<std::int16_t> quaternions(8);
  meshopt_encodeFilterQuat(quaternions.data(), 2, 8, 16, turns.data());

  Json& attributes = scene.Document["meshes"][0]["primitives"][0]["attributes"];
  attributes["POSITION"] = scene.AddAccessor(places, "VEC3");
  std::size_t view = scene.Document["accessors"].back()["bufferView"];
  Compress(scene, view, EncodeVertices(exponential.data(), 8, 12), 8, 12, "ATTRIBUTES", "EXPONENTIAL");
  view = scene.AddView(octahedral.data(), 32, 4);
  attributes["NORMAL"] = scene.AddAccessor(view, 5120, 8, "VEC3", true);
  Compress(scene, view, EncodeVertices(octahedral.data(), 8, 4), 8, 4, "ATTRIBUTES", "OCTAHEDRAL");
  view = scene.AddView(quaternions.data(), 16, 8);
  const std::size_t rotation = scene.AddAccessor(view, 5122, 2, "VEC4", true);
  Compress(scene, view, EncodeVertices(quaternions.data(), 2, 8), 2, 8, "ATTRIBUTES", "QUATERNION");
  scene.Document["nodes"][0]["extensions"] = { { "EXT_mesh_gpu_instancing",
    { { "attributes", { { "ROTATION", rotation } } } } } };
  const MTGltfMesh read = MTGltfMesh::Read(scene);
  ASSERT_EQ(read.Error, "");
  EXPECT_EQ(read.Mesh->GetNumberOfPolys(), 24);
  EXPECT_NEAR(read.GetVolume(), 2.0, 1e-3);
  const std::array<double, 6> bounds = read.GetBounds();
  EXPECT_NEAR(bounds[0], -1.25, 1e-3); // turned by a quarter about z
  EXPECT_NEAR(bounds[1], 1.25, 1e-3);
  const double middles[2][3] = { { 0.75, 0.75, 0.75 }, { -0.75, 0.75, 0.75 } };
  EXPECT_EQ(read.CountOutwardNormals(middles[0], 0, 8), 8);
  EXPECT_EQ(read.CountOutwardNormals(middles[1], 8, 8), 8);
  EXPECT_NEAR(std::abs(read.GetValues("NORMAL")[0]), std::sqrt(1.0 / 3.0), 0.02);
}

TEST(GltfCompression, DamagedMeshoptIsRefused)
{
  const std::vector<std::pair<std::string, Json>> changes = { { "mode", "WHAT" }, { "count", 9 }, { "count", 35 },
    { "byteStride", 3 }, { "byteStride", 0 }, { "byteLength", 5 }, { "byteLength", 100000000 }, { "buffer", 7 },
    { "buffer", 1 }, { "filter", "WHAT" }, { "filter", "QUATERNION" }, { "filter", "OCTAHEDRAL" },
    { "count", 4000000000u } };
  for (const std::size_t view : { 0, 1 })
  {
    for (const auto& [key, value] : changes)
    {
      MTGltfScene scene = MakeMeshopt(false);
      Json& extension = scene.Document["bufferViews"][view]["extensions"]["EXT_meshopt_compression"];
      extension[key] = value;
      EXPECT_NE(MTGltfMesh::Read(scene).Error, "") << view << " " << key << " " << value;
    }
  }
  // A fallback that is used without the extension.
  MTGltfScene scene = MakeMeshopt(false);
  scene.Document["bufferViews"][0].erase("extensions");
  EXPECT_NE(MTGltfMesh::Read(scene).Error.find("EXT_meshopt_compression"), std::string::npos);
  // Little memory for large announcements.
  scene = MakeMeshopt(false);
  scene.Document["buffers"][1]["byteLength"] = 4000000000u;
  Json& view = scene.Document["bufferViews"][0];
  view["byteLength"] = 3999999996u;
  view["extensions"]["EXT_meshopt_compression"]["count"] = 333333333;
  scene.Document["accessors"][0]["count"] = 333333333;
  EXPECT_NE(MTGltfMesh::Read(scene).Error.find("fewer bytes"), std::string::npos);
}
#endif

#ifdef MT_HAS_DRACO
namespace
{
Bytes EncodeCube(int speed, int* attributes)
{
  const std::vector<float>& places = MTGltfScene::GetCubePlaces();
  const std::vector<std::uint16_t>& corners = MTGltfScene::GetCubeCorners();
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(12);
  attributes[0] = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  attributes[1] = builder.AddAttribute(draco::GeometryAttribute::GENERIC, 1, draco::DT_UINT16);
  for (std::uint32_t i = 0; i < 12; ++i)
  {
    const std::uint16_t ids[3] = { corners[3 * i], corners[3 * i + 1], corners[3 * i + 2] };
    builder.SetAttributeValuesForFace(
      attributes[0], draco::FaceIndex(i), &places[3 * ids[0]], &places[3 * ids[1]], &places[3 * ids[2]]);
    builder.SetAttributeValuesForFace(attributes[1], draco::FaceIndex(i), &ids[0], &ids[1], &ids[2]);
  }
  const auto mesh = builder.Finalize();
  draco::Encoder encoder;
  encoder.SetSpeedOptions(speed, speed);
  encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, 14);
  draco::EncoderBuffer buffer;
  EXPECT_TRUE(encoder.EncodeMeshToBuffer(*mesh, &buffer).ok());
  for (int i = 0; i < 2; ++i)
  {
    attributes[i] = static_cast<int>(mesh->attribute(attributes[i])->unique_id());
  }
  return Bytes(buffer.data(), buffer.data() + buffer.size());
}

MTGltfScene MakeDraco(int speed, Bytes* bytes = nullptr)
{
  int attributes[2];
  const Bytes encoded = bytes && !bytes->empty() ? *bytes : EncodeCube(speed, attributes);
  EncodeCube(speed, attributes);
  MTGltfScene scene;
  const auto accessor = [&scene](int type, int count, const char* kind)
  {
    scene.Document["accessors"].push_back({ { "componentType", type }, { "count", count }, { "type", kind } });
    return scene.Document["accessors"].size() - 1;
  };
  const std::size_t view = scene.AddView(encoded.data(), encoded.size());
  const Json primitive = {
    { "attributes", { { "POSITION", accessor(5126, 8, "VEC3") }, { "_ID", accessor(5123, 8, "SCALAR") } } },
    { "indices", accessor(5123, 36, "SCALAR") },
    { "extensions",
      { { "KHR_draco_mesh_compression",
        { { "bufferView", view }, { "attributes", { { "POSITION", attributes[0] }, { "_ID", attributes[1] } } } } } } }
  };
  scene.AddNode({ { "mesh", scene.AddMesh({ primitive }) }, { "scale", { 2, 1, -1 } } });
  scene.Require("KHR_draco_mesh_compression");
  if (bytes)
  {
    *bytes = encoded;
  }
  return scene;
}
}

TEST(GltfCompression, DracoWithBothCodecs)
{
  for (const int speed : { 0, 5, 10 }) // 10: the sequential one
  {
    const MTGltfMesh read = MTGltfMesh::Read(MakeDraco(speed));
    ASSERT_EQ(read.Error, "");
    EXPECT_EQ(read.Mesh->GetNumberOfPoints(), 8);
    EXPECT_EQ(read.Mesh->GetNumberOfPolys(), 12);
    EXPECT_NEAR(read.GetVolume(), 2.0, 1e-3);
    EXPECT_EQ(read.Mesh->GetPointData()->GetArray("_ID")->GetDataType(), VTK_UNSIGNED_SHORT);
    for (vtkIdType i = 0; i < 8; ++i)
    {
      const auto id = static_cast<std::size_t>(read.GetValues("_ID")[static_cast<std::size_t>(i)]);
      EXPECT_NEAR(read.Mesh->GetPoint(i)[0], 2.0 * MTGltfScene::GetCubePlaces()[3 * id], 1e-3) << i;
      EXPECT_NEAR(read.Mesh->GetPoint(i)[2], -1.0 * MTGltfScene::GetCubePlaces()[3 * id + 2], 1e-3) << i;
    }
  }
}

TEST(GltfCompression, DamagedDracoIsRefused)
{
  MTGltfScene scene = MakeDraco(5);
  scene.Document["accessors"][0]["count"] = 9;
  scene.Document["accessors"][1]["count"] = 9;
  EXPECT_NE(MTGltfMesh::Read(scene).Error.find("holds 8 points"), std::string::npos);
  scene = MakeDraco(5);
  scene.Document["accessors"][1]["type"] = "VEC2";
  EXPECT_NE(MTGltfMesh::Read(scene).Error.find("attribute"), std::string::npos);
  for (const int speed : { 5, 10 })
  {
    Bytes good;
    MakeDraco(speed, &good);
    std::size_t refused = 0;
    for (std::size_t i = 0; i < 6 * good.size(); ++i)
    {
      Bytes bytes = good;
      static const unsigned char values[] = { 0, 1, 0x7f, 0x80, 0xfe, 0xff };
      bytes[i % good.size()] = values[i / good.size()];
      refused += MTGltfMesh::Read(MakeDraco(speed, &bytes).ToGlb(), 16 << 20).Error.empty() ? 0 : 1;
    }
    std::cout << refused << " of " << 6 * good.size() << " refused\n";
    EXPECT_GT(refused, 0u);
    for (std::size_t length = 0; length + 1 < good.size(); ++length)
    {
      Bytes bytes(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(length + 1));
      EXPECT_NE(MTGltfMesh::Read(MakeDraco(speed, &bytes)).Error, "") << length;
    }
  }
}
#endif
