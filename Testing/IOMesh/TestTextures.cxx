// SPDX-License-Identifier: BSD-3-Clause
// The images that meshes refer to.
#include "MTIOTest.h"

#include "vtkMTMeshReader.h"
#include "vtkMTTextureCollector.h"

#include "vtkNew.h"
#include "vtkPolyData.h"

using namespace MTIOTest;

namespace
{
const std::string Png = std::string("\x89PNG\r\n\x1a\n", 8) + "the rest of a picture";
const std::string Jpeg = std::string("\xff\xd8\xff\xe0") + "the rest of a photograph";

class Textures : public testing::Test
{
protected:
  void SetUp() override
  {
    this->Folder = std::filesystem::path(MT_TEST_OUTPUT_DIRECTORY) / "Textures";
    std::filesystem::remove_all(this->Folder);
    std::filesystem::create_directories(this->Folder / "mesh" / "images");
  }
  void TearDown() override { std::filesystem::remove_all(this->Folder); }
  void Write(const std::string& name, const std::string& text) const
  {
    WriteFile((this->Folder / "mesh" / name).string(), text);
  }
  vtkMTTextureCollector Collect(const std::string& name) const
  {
    const std::string path = (this->Folder / "mesh" / name).string();
    vtkNew<vtkPolyData> mesh;
    std::string error;
    EXPECT_TRUE(vtkMTMeshReader::Read(path, mesh, error)) << error;
    vtkMTTextureCollector collector;
    collector.Collect(path, mesh);
    return collector;
  }
  std::filesystem::path Folder;
};

std::string ToText(const vtkMTTexture& texture)
{
  return std::string(texture.Bytes.begin(), texture.Bytes.end());
}
}

TEST_F(Textures, OfObjMaterialsAreFound)
{
  this->Write("images/bark.png", Png);
  this->Write("leaf two.jpg", Jpeg);
  this->Write("tree.mtl",
    "newmtl unused\nmap_Kd images/bark.png\nnewmtl leaf\nKd 1 1 1\nmap_Kd -s 2 2 1 -clamp on leaf two.jpg\n"
    "newmtl bark\nmap_Kd images\\bark.png\nnewmtl gone\nmap_Kd gone.png\n");
  this->Write("tree.obj",
    "mtllib tree.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl bark\nf 1/1 2/2 3/3\n"
    "usemtl leaf\nf 1/1 3/3 2/2\nusemtl gone\nf 1 2 3\n");
  const vtkMTTextureCollector collector = this->Collect("tree.obj");
  ASSERT_EQ(collector.GetTextures().size(), 2u);
  const vtkMTTexture& bark = collector.GetTextures()[0];
  EXPECT_EQ(bark.MaterialName, "bark");
  EXPECT_EQ(bark.Material, 0);
  EXPECT_EQ(bark.MimeType, "image/png");
  EXPECT_EQ(ToText(bark), Png);
  EXPECT_EQ(collector.GetTextures()[1].Name, "leaf two.jpg");
  EXPECT_EQ(collector.GetTextures()[1].Material, 1);
  EXPECT_EQ(collector.GetTextures()[1].MimeType, "image/jpeg");
  ASSERT_EQ(collector.GetProblems().size(), 1u);
  EXPECT_NE(collector.GetProblems()[0].find("gone.png"), std::string::npos);
}

TEST_F(Textures, OfPlyCommentsAreFound)
{
  this->Write("skin.png", Png);
  this->Write("skin.ply",
    "ply\nformat ascii 1.0\ncomment TextureFile skin.png\nelement vertex 3\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  const vtkMTTextureCollector collector = this->Collect("skin.ply");
  ASSERT_EQ(collector.GetTextures().size(), 1u);
  EXPECT_EQ(ToText(collector.GetTextures()[0]), Png);
  EXPECT_EQ(collector.GetTextures()[0].Material, -1);
}

TEST_F(Textures, OutsideOfTheMeshsFolderNothingIsOpened)
{
  WriteFile((this->Folder / "secret.png").string(), Png);
  const auto write = [this](const std::string& texture)
  {
    this->Write("skin.ply",
      "ply\nformat ascii 1.0\ncomment TextureFile " + texture +
        "\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
        "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  };
  for (const std::string& name : { std::string("../secret.png"), (this->Folder / "secret.png").string() })
  {
    write(name);
    const vtkMTTextureCollector collector = this->Collect("skin.ply");
    EXPECT_TRUE(collector.GetTextures().empty()) << name;
    EXPECT_EQ(collector.GetProblems().size(), 1u) << name;
  }
  // Beside the mesh the last component of the name is looked for, whatever folder its author had.
  this->Write("secret.png", Png);
  write("C:\\Users\\me\\secret.png");
  EXPECT_EQ(this->Collect("skin.ply").GetTextures().size(), 1u);
  // What is no image is not carried.
  this->Write("secret.png", "root:x:0:0");
  EXPECT_EQ(this->Collect("skin.ply").GetProblems().size(), 1u);
}

TEST_F(Textures, OfGltfMaterialsAreFoundInTheJson)
{
  this->Write(
    "buffer.bin", std::string("\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x80?\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x80?\0\0\0\0", 36));
  this->Write("scene.gltf",
    R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
    R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"material":0}]}],)"
    R"("materials":[{"name":"m","pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}],)"
    R"("textures":[{"source":0}],"images":[{"uri":"data:image/png;base64,iVBORw0KGgphYmM="}],)"
    R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],)"
    R"("bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,"uri":"buffer.bin"}]})");
  vtkMTTextureCollector collector = this->Collect("scene.gltf");
  vtkNew<vtkPolyData> mesh;
  ASSERT_EQ(collector.GetTextures().size(), 1u) << testing::PrintToString(collector.GetProblems());
  EXPECT_EQ(collector.GetTextures()[0].MimeType, "image/png");
  EXPECT_EQ(collector.GetTextures()[0].Bytes.size(), 11u);
  EXPECT_EQ(collector.GetTextures()[0].MaterialName, "m");
  EXPECT_EQ(collector.GetTextures()[0].Material, 0);
  const auto count = [&](const std::string& rest)
  {
    this->Write("bad.gltf", R"({"asset":{"version":"2.0"},)" + rest + "}");
    vtkMTTextureCollector bad;
    bad.Collect((this->Folder / "mesh" / "bad.gltf").string(), mesh);
    EXPECT_TRUE(bad.GetTextures().empty() || bad.GetTextures()[0].MimeType == "image/webp") << rest;
    return bad.GetProblems().size();
  };
  const std::string material = R"("materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}])";
  EXPECT_EQ(count(R"("materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":7}}}])"), 1u);
  EXPECT_EQ(count(R"("materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":-1}}}])"), 1u);
  EXPECT_EQ(count(material + R"(,"textures":[{}])"), 1u);
  EXPECT_EQ(count(material + R"(,"textures":[{"source":3}],"images":[{"uri":"gone.png"}])"), 1u);
  EXPECT_EQ(count(material + R"(,"textures":[{"source":0}],"images":[{"uri":"gone.png"}])"), 1u);
  EXPECT_EQ(count(material + R"(,"textures":[{"source":0}],"images":[{"bufferView":3}])"), 1u);
  EXPECT_EQ(
    count(R"("materials":[{"normalTexture":{"index":0}}],"textures":[{"source":0}],"images":[{"uri":"g.png"}])"), 1u);
  // WebP is carried, and told: VTK does not draw it.
  EXPECT_EQ(count(material +
              R"(,"textures":[{"extensions":{"EXT_texture_webp":{"source":0}}}],)"
              R"("images":[{"uri":"data:image/webp;base64,UklGRgAAAABXRUJQVlA4IAAAAAA="}])"),
    1u);
}
