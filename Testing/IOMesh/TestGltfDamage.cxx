// SPDX-License-Identifier: BSD-3-Clause
// glTF files that are damaged, hostile or of a kind that is not known.
#include "MTGltfScene.h"
#include "MTTestMeshes.h"

using namespace MTIOTest;
using Json = nlohmann::json;

namespace
{
MTGltfScene MakeScene()
{
  MTGltfScene scene;
  Json cube = scene.MakeCube();
  cube["attributes"]["NORMAL"] = scene.AddAccessor(std::vector<float>(24, 1.0f), "VEC3");
  cube["material"] = 0;
  scene.Document["materials"] = { { { "name", "m" } } };
  scene.AddNode({ { "mesh", scene.AddMesh({ cube }) } });
  return scene;
}

// Every case: what is put where (a JSON pointer), and what the error must name.
struct Case
{
  const char* Where;
  const char* Value;
  const char* Reason;
};
}

TEST(GltfDamage, EveryFaultIsRefusedByName)
{
  const Case cases[] = { { "/asset/version", "\"1.0\"", "version 1.0" }, { "/asset", "null", "asset" },
    { "/extensionsRequired", "[\"XX_unknown\"]", "XX_unknown" }, { "/extensionsRequired", "[7]", "extension 7" },
    { "/scene", "3", "\"scene\" is 3, of 1" }, { "/scene", "-1", "scene" }, { "/scenes/0/nodes", "[0,9]", "scene 0" },
    { "/scenes/0/nodes", "7", "no list" }, { "/scenes", "{}", "scenes" }, { "/nodes/0", "5", "nodes 0" },
    { "/nodes/0/children", "[0]", "its own ancestor" }, { "/nodes/0/mesh", "4", "node 0" },
    { "/nodes/0/mesh", "0.5", "node 0" }, { "/nodes/0/matrix", "[1,2]", "16 numbers" },
    { "/nodes/0/scale", "[1,2,\"a\"]", "3 numbers" }, { "/nodes/0/rotation", "{\"a\":1}", "4 numbers" },
    { "/meshes/0/primitives/0", "[]", "primitive 0 of mesh 0" },
    { "/meshes/0/primitives/0/mode", "7", "primitive 0 of mesh 0: mode 7" },
    { "/meshes/0/primitives/0/material", "1", "\"material\" is 1, of 1" },
    { "/meshes/0/primitives/0/indices", "9", "\"indices\" is 9" },
    { "/meshes/0/primitives/0/indices", "0", "no unsigned whole numbers" },
    { "/meshes/0/primitives/0/attributes/POSITION", "1", "there are 36 points" },
    { "/meshes/0/primitives/0/attributes/POSITION", "99", "99" },
    { "/meshes/0/primitives/0/attributes/TEXCOORD_0", "0", "TEXCOORD_0" },
    { "/meshes/0/primitives", "[]", "no triangles" }, { "/meshes/0/primitives", "3", "mesh 0" },
    { "/accessors/0/count", "9", "accessor 0: 9 elements" }, { "/accessors/0/count", "0", "accessor 0" },
    { "/accessors/0/count", "7", "there are 7 points" }, { "/accessors/0/count", "-8", "accessor 0" },
    { "/accessors/0/count", "9007199254740992", "accessor 0" }, { "/accessors/0/count", "1e300", "accessor 0" },
    { "/accessors/0/byteOffset", "4", "more than bufferView 0 holds" },
    { "/accessors/0/byteOffset", "9007199254740992", "more than bufferView 0 holds" },
    { "/accessors/0/componentType", "5124", "componentType 5124" }, { "/accessors/0/type", "\"VEC5\"", "VEC5" },
    { "/accessors/0/type", "7", "accessor 0" }, { "/accessors/0/bufferView", "8", "accessor 0" },
    { "/bufferViews/0/byteStride", "8", "8 bytes apart" }, { "/bufferViews/0/byteStride", "4000000000", "accessor 0" },
    { "/bufferViews/0/byteLength", "9000000000000000", "bufferView 0" },
    { "/bufferViews/0/byteOffset", "9007199254740992", "bufferView 0" },
    { "/bufferViews/0/buffer", "1", "bufferView 0" }, { "/bufferViews/0/byteLength", "95", "accessor 0" },
    { "/buffers/0/byteLength", "1000000", "buffer 0" }, { "/buffers/0/byteLength", "4", "of a buffer of 4" },
    { "/buffers", "[]", "\"buffer\" is 0, of 0" }, { "/accessors/0/sparse", R"({"count":9})", "9 sparse elements" },
    { "/accessors/0/sparse", R"({"count":2,"indices":{"bufferView":1,"componentType":5126},"values":{"bufferView":0}})",
      "unsigned" },
    { "/accessors/0/sparse", R"({"count":2,"indices":{"bufferView":0,"componentType":5125},"values":{"bufferView":0}})",
      "sparse index" },
    { "/accessors/0/sparse",
      R"({"count":8,"indices":{"bufferView":1,"componentType":5123},"values":{"bufferView":0,"byteOffset":4}})",
      "accessor 0" },
    { "/materials/0/pbrMetallicRoughness", R"({"baseColorFactor":[1,1]})", "material 0" } };
  for (const Case& test : cases)
  {
    MTGltfScene scene = MakeScene();
    scene.Document[Json::json_pointer(test.Where)] = Json::parse(test.Value);
    const MTGltfMesh read = MTGltfMesh::Read(scene);
    EXPECT_NE(read.Error, "") << test.Where << " " << test.Value;
    EXPECT_NE(read.Error.find(test.Reason), std::string::npos) << test.Where << " " << test.Value << ": " << read.Error;
  }
}

TEST(GltfDamage, IndicesOutOfRangeAndCyclesAreFound)
{
  MTGltfScene scene = MakeScene();
  std::uint16_t large = 8;
  std::memcpy(scene.Buffer.data() + 96 + 2 * 10, &large, sizeof(large));
  EXPECT_NE(
    MTGltfMesh::Read(scene).Error.find("primitive 0 of mesh 0: index 8 at place 10, of 8 points"), std::string::npos);
  scene = MakeScene();
  scene.Document["nodes"] = { { { "mesh", 0 }, { "children", { 1 } } }, { { "children", { 2 } } },
    { { "children", { 0 } } } };
  EXPECT_NE(MTGltfMesh::Read(scene).Error.find("its own ancestor"), std::string::npos);
  scene.Document["nodes"] = { { { "mesh", 0 }, { "children", { 1, 2 } } }, { { "children", { 2 } } }, Json::object() };
  EXPECT_NE(MTGltfMesh::Read(scene).Error.find("node 2: is a child of two nodes"), std::string::npos);
  // A cycle elsewhere is one too, however deep the nodes lie.
  scene.Document["nodes"] = Json::array();
  for (int i = 0; i < 100000; ++i)
  {
    scene.Document["nodes"].push_back({ { "children", { i + 1 } } });
  }
  scene.Document["nodes"].push_back({ { "mesh", 0 } });
  EXPECT_EQ(MTGltfMesh::Read(scene).Mesh->GetNumberOfPolys(), 12);
  scene.Document["nodes"][100000]["children"] = { 50000 };
  EXPECT_NE(MTGltfMesh::Read(scene).Error.find("node 50000"), std::string::npos);
}

TEST(GltfDamage, SmallFilesTakeNoLargeMemory)
{
  MTGltfScene scene = MakeScene();
  scene.Document["accessors"][0].erase("bufferView");
  scene.Document["accessors"][0]["count"] = 4000000000u;
  scene.Document["meshes"][0]["primitives"][0]["attributes"].erase("NORMAL");
  EXPECT_NE(MTGltfMesh::Read(scene).Error, "");
  // Many nodes with one mesh.
  scene = MakeScene();
  for (int i = 0; i < 10000; ++i)
  {
    scene.AddNode({ { "mesh", 0 } });
  }
  EXPECT_NE(MTGltfMesh::Read(scene.ToGlb(), 1 << 20).Error.find("1 MiB is the limit"), std::string::npos);
  EXPECT_EQ(MTGltfMesh::Read(scene.ToGlb(), 64 << 20).Mesh->GetNumberOfPolys(), 120012);
}

TEST(GltfDamage, TruncatedFilesAreRefusedAndChangedOnesSurvived)
{
  const Bytes good = MakeScene().ToGlb();
  ASSERT_EQ(MTGltfMesh::Read(good).Error, "");
  for (std::size_t length = 0; length < good.size(); ++length)
  {
    EXPECT_NE(MTGltfMesh::Read(Bytes(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(length))).Error, "")
      << length;
  }
  MTTestMeshes::Random random(9);
  std::size_t refused = 0;
  constexpr int runs = 20000;
  for (int i = 0; i < runs; ++i)
  {
    Bytes bytes = good;
    for (std::size_t j = 0; j <= random.Below(3); ++j)
    {
      static const char likely[] = "0123456789-.,:[]{}\"e";
      bytes[random.Below(bytes.size())] = static_cast<unsigned char>(
        random.Below(4) ? static_cast<unsigned char>(likely[random.Below(sizeof(likely) - 1)]) : random.Below(256));
    }
    refused += MTGltfMesh::Read(bytes, 16 << 20).Error.empty() ? 0 : 1;
  }
  std::cout << refused << " of " << runs << " refused\n";
  EXPECT_GT(refused, runs / 4u);
}

TEST(GltfDamage, WhatOnlyAnImageNeedsMayBeMissing)
{
  MTGltfScene scene = MakeScene();
  scene.Document["buffers"].push_back({ { "byteLength", 100 }, { "uri", "gone.bin" } });
  scene.Document["bufferViews"].push_back({ { "buffer", 1 }, { "byteLength", 100 } });
  scene.Document["images"] = { { { "bufferView", 3 }, { "mimeType", "image/png" } } };
  scene.Require("KHR_texture_basisu");
  scene.Require("KHR_materials_unlit");
  EXPECT_EQ(MTGltfMesh::Read(scene).Error, "");
}
