// SPDX-License-Identifier: BSD-3-Clause
// glTF scenes: where nodes put them, what accessors hold, and which arrays come of them.
#include "MTGltfScene.h"

#include "vtkMTMeshReader.h"

#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkGLTFReader.h"
#include "vtkLookupTable.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <cmath>

using namespace MTIOTest;
using Json = nlohmann::json;

namespace
{
// A cube whose points have the normals of a sphere about it.
Json MakeCubeWithNormals(MTGltfScene& scene)
{
  std::vector<float> normals;
  for (const float place : MTGltfScene::GetCubePlaces())
  {
    normals.push_back((2.0f * place - 1.0f) / std::sqrt(3.0f));
  }
  Json cube = scene.MakeCube();
  cube["attributes"]["NORMAL"] = scene.AddAccessor(normals, "VEC3");
  return cube;
}

// The cube with positions of another type, scaled from 0..1 to 0..top.
template <typename T>
MTGltfMesh ReadQuantized(bool isNormalized, double top)
{
  MTGltfScene scene;
  std::vector<T> places;
  for (const float place : MTGltfScene::GetCubePlaces())
  {
    places.push_back(static_cast<T>(place * top));
  }
  Json cube = scene.MakeCube();
  cube["attributes"]["POSITION"] = scene.AddAccessor(places, "VEC3", isNormalized, sizeof(T) == 1 ? 4 : 8);
  scene.Require("KHR_mesh_quantization");
  scene.AddNode({ { "mesh", scene.AddMesh({ cube }) } });
  return MTGltfMesh::Read(scene);
}

std::vector<double> Flatten(std::initializer_list<std::vector<double>> lists)
{
  std::vector<double> all;
  for (const std::vector<double>& list : lists)
  {
    all.insert(all.end(), list.begin(), list.end());
  }
  return all;
}
}

//------------------------------------------------------------------------------
TEST(GltfReader, MirroredPartsKeepTheirInsideInside)
{
  const double root = std::sqrt(0.5);
  const std::vector<Json> nodes = { { { "scale", { -1, 1, 1 } } }, { { "scale", { -1, -2, -1 } } },
    { { "scale", { 1, -1, 1 } }, { "rotation", { 0, root, 0, root } }, { "translation", { 3, 4, 5 } } },
    { { "matrix", { 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 7, 8, 9, 1 } } }, { { "scale", { 2, 3, 0.5 } } } };
  const std::vector<double> volumes = { 1.0, 2.0, 1.0, 1.0, 3.0 };
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    MTGltfScene scene;
    Json node = nodes[i];
    node["mesh"] = scene.AddMesh({ MakeCubeWithNormals(scene) });
    scene.AddNode(node);
    const MTGltfMesh read = MTGltfMesh::Read(scene);
    ASSERT_EQ(read.Error, "");
    EXPECT_NEAR(read.GetVolume(), volumes[i], 1e-5) << i;
    double middle[3];
    read.Mesh->GetCenter(middle);
    EXPECT_EQ(read.CountOutwardNormals(middle, 0, 8), 8) << i;
    EXPECT_EQ(read.Counts.count("turned_triangles"), i == 4 ? 0u : 1u) << i;
  }
}

TEST(GltfReader, MirrorsWithinMirrorsAndMirroredInstancesAreTurnedOnce)
{
  MTGltfScene scene;
  const std::size_t mesh = scene.AddMesh({ MakeCubeWithNormals(scene) });
  const std::size_t inner = scene.AddNode({ { "mesh", mesh }, { "scale", { 1, 1, -1 } } });
  scene.AddNode({ { "children", { inner } }, { "scale", { -1, 1, 1 } }, { "translation", { 10, 0, 0 } } });
  scene.Document["scenes"][0]["nodes"] = { 1 };
  Json attributes = { { "TRANSLATION", scene.AddAccessor(std::vector<float>{ 0, 0, 20, 5, 0, 20 }, "VEC3") },
    { "SCALE", scene.AddAccessor(std::vector<float>{ 1, 1, 1, -1, 1, 1 }, "VEC3") },
    { "ROTATION", scene.AddAccessor(std::vector<std::int16_t>{ 0, 0, 0, 32767, 0, 0, 32767, 0 }, "VEC4", true) } };
  scene.AddNode({ { "mesh", mesh }, { "scale", { 2, 2, 2 } },
    { "extensions", { { "EXT_mesh_gpu_instancing", { { "attributes", attributes } } } } } });
  scene.Require("EXT_mesh_gpu_instancing");
  const MTGltfMesh read = MTGltfMesh::Read(scene);
  ASSERT_EQ(read.Error, "");
  EXPECT_EQ(read.Mesh->GetNumberOfPolys(), 36);
  EXPECT_NEAR(read.GetVolume(), 1.0 + 8.0 + 8.0, 1e-5);
  EXPECT_EQ(read.Counts.at("turned_triangles"), 12); // of the second instance; the nested mirrors cancel
  const double middles[3][3] = { { 9.5, 0.5, -0.5 }, { 1, 1, 41 }, { 11, -1, 41 } };
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_EQ(read.CountOutwardNormals(middles[i], 8 * i, 8), 8) << i;
  }
  const std::array<double, 6> bounds = read.GetBounds();
  EXPECT_NEAR(bounds[0], 0.0, 1e-6);
  EXPECT_NEAR(bounds[1], 12.0, 1e-3); // 10 + 2, rotated by half a turn about z: -(-2)
  EXPECT_NEAR(bounds[2], -2.0, 1e-3);
  EXPECT_EQ(read.GetCellValues("NodeIds")[0], 0.0);
  EXPECT_EQ(read.GetCellValues("NodeIds")[35], 2.0);
}

TEST(GltfReader, StockReaderAgreesWhereItIsSound)
{
  Folder folder;
  MTGltfScene scene;
  const std::size_t mesh = scene.AddMesh({ MakeCubeWithNormals(scene) });
  const std::size_t inner =
    scene.AddNode({ { "mesh", mesh }, { "rotation", { 0.5, 0.5, -0.5, 0.5 } }, { "scale", { 1, 2, 3 } } });
  scene.AddNode({ { "mesh", mesh }, { "children", { inner } }, { "translation", { 1, 2, 3 } } });
  scene.Document["scenes"][0]["nodes"] = { 1 };
  WriteFile(folder / "scene.glb", scene.ToGlb());
  vtkNew<vtkGLTFReader> stock;
  stock->SetFileName((folder / "scene.glb").c_str());
  stock->Update();
  const MTGltfMesh read = MTGltfMesh::Read(scene);
  ASSERT_EQ(read.Error, "");
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(stock->GetOutputDataObject(0));
  const auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
  vtkIdType next = 0;
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    auto* part = vtkPolyData::SafeDownCast(iterator->GetCurrentDataObject());
    for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i, ++next)
    {
      EXPECT_LT(vtkMath::Distance2BetweenPoints(part->GetPoint(i), read.Mesh->GetPoint(next)), 1e-12) << next;
      for (int c = 0; c < 3; ++c)
      {
        EXPECT_NEAR(part->GetPointData()->GetNormals()->GetComponent(i, c),
          read.Mesh->GetPointData()->GetNormals()->GetComponent(next, c), 1e-6);
      }
    }
  }
  EXPECT_EQ(next, 16);
}

TEST(GltfReader, PlacesFarFromTheOriginAreDouble)
{
  MTGltfScene scene;
  Json cube = scene.MakeCube();
  scene.Document["accessors"][0]["min"] = { 0, 0, 0 };
  scene.Document["accessors"][0]["max"] = { 1, 1, 1 };
  scene.AddNode({ { "mesh", scene.AddMesh({ cube }) }, { "translation", { 4500000.0625, 0, 0 } } });
  MTGltfMesh read = MTGltfMesh::Read(scene);
  EXPECT_EQ(read.Mesh->GetPoints()->GetDataType(), VTK_DOUBLE);
  EXPECT_EQ(read.GetBounds()[1], 4500001.0625);
  scene.Document["nodes"][0]["translation"] = { 10, 0, 0 };
  read = MTGltfMesh::Read(scene);
  EXPECT_EQ(read.Mesh->GetPoints()->GetDataType(), VTK_FLOAT);
}

//------------------------------------------------------------------------------
TEST(GltfReader, QuantizedPositionsOfEveryType)
{
  const std::array<double, 6> unit = { 0, 1, 0, 1, 0, 1 };
  const std::array<double, 6> hundred = { 0, 100, 0, 100, 0, 100 };
  EXPECT_EQ(ReadQuantized<std::int8_t>(true, 127).GetBounds(), unit);
  EXPECT_EQ(ReadQuantized<std::uint8_t>(true, 255).GetBounds(), unit);
  EXPECT_EQ(ReadQuantized<std::int16_t>(true, 32767).GetBounds(), unit);
  EXPECT_EQ(ReadQuantized<std::uint16_t>(true, 65535).GetBounds(), unit);
  EXPECT_EQ(ReadQuantized<std::int16_t>(true, -32768).GetBounds()[0], -1.0);
  EXPECT_EQ(ReadQuantized<std::int8_t>(false, 100).GetBounds(), hundred);
  EXPECT_EQ(ReadQuantized<std::uint8_t>(false, 100).GetBounds(), hundred);
  EXPECT_EQ(ReadQuantized<std::int16_t>(false, 100).GetBounds(), hundred);
  EXPECT_EQ(ReadQuantized<std::uint16_t>(false, 100).GetBounds(), hundred);
}

TEST(GltfReader, SparseAccessorsWithAndWithoutView)
{
  for (const bool hasView : { true, false })
  {
    MTGltfScene scene;
    Json cube = scene.MakeCube();
    const std::vector<std::uint8_t> indices = { 4, 5, 6, 7 };
    const std::vector<float> values = { 0, 0, 5, 1, 0, 5, 1, 1, 5, 0, 1, 5 };
    Json& accessor = scene.Document["accessors"][0];
    accessor["sparse"] = { { "count", 4 },
      { "indices", { { "bufferView", scene.AddView(indices.data(), 4) }, { "componentType", 5121 } } },
      { "values", { { "bufferView", scene.AddView(values.data(), 48) } } } };
    if (!hasView)
    {
      accessor.erase("bufferView"); // zeros
    }
    scene.AddNode({ { "mesh", scene.AddMesh({ cube }) } });
    const MTGltfMesh read = MTGltfMesh::Read(scene);
    ASSERT_EQ(read.Error, "");
    EXPECT_EQ(read.Mesh->GetNumberOfPolys(), 12);
    EXPECT_EQ(read.GetBounds()[5], 5.0);
    EXPECT_NEAR(read.GetVolume(), hasView ? 5.0 : 5.0 / 3.0, 1e-6); // without, a pyramid
  }
}

TEST(GltfReader, StripsAndFansBecomeTrianglesAndOthersAreCounted)
{
  MTGltfScene scene;
  const std::size_t square =
    scene.AddAccessor(std::vector<float>{ 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0 }, "VEC3");
  const std::size_t fan = scene.AddAccessor(std::vector<float>{ 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, -1, 1, 0 }, "VEC3");
  const std::size_t seven = scene.AddAccessor(std::vector<std::uint32_t>{ 0, 1, 2, 1, 3, 2, 0 }, "SCALAR");
  Json primitives = Json::array();
  for (const int mode : { 0, 1, 2, 3, 4, 5 })
  {
    primitives.push_back({ { "attributes", { { "POSITION", square } } }, { "mode", mode } });
  }
  primitives[4]["indices"] = seven;
  primitives.push_back({ { "attributes", { { "POSITION", fan } } }, { "mode", 6 } });
  scene.AddNode({ { "mesh", scene.AddMesh(primitives) } });
  const MTGltfMesh read = MTGltfMesh::Read(scene);
  ASSERT_EQ(read.Error, "");
  EXPECT_EQ(read.Mesh->GetNumberOfPolys(), 2 + 3 + 3);
  for (vtkIdType i = 0; i < read.Mesh->GetNumberOfPolys(); ++i)
  {
    vtkIdType count = 0;
    const vtkIdType* corners = nullptr;
    read.Mesh->GetPolys()->GetCellAtId(i, count, corners);
    double p[3][3];
    for (vtkIdType c = 0; c < 3; ++c)
    {
      read.Mesh->GetPoint(corners[c], p[c]);
    }
    double a[3], b[3];
    vtkMath::Subtract(p[1], p[0], a);
    vtkMath::Subtract(p[2], p[0], b);
    EXPECT_GT(a[0] * b[1] - a[1] * b[0], 0.0) << i; // all are seen from above
  }
  EXPECT_EQ(read.Counts.at("vertices"), 5);
  EXPECT_EQ(read.Counts.at("lines"), 2 + 5 + 4);
  EXPECT_EQ(read.Counts.at("left_corners"), 1);
}

//------------------------------------------------------------------------------
TEST(GltfReader, PrimitivesWithDifferentAttributesKeepAll)
{
  MTGltfScene scene;
  Json first = MakeCubeWithNormals(scene);
  Json second = scene.MakeCube();
  first["attributes"]["COLOR_0"] = scene.AddAccessor(std::vector<std::uint16_t>(24, 32768), "VEC3", true, 8);
  first["attributes"]["TEXCOORD_0"] = scene.AddAccessor(std::vector<float>(16, 0.25f), "VEC2");
  first["attributes"]["_FEATURE_ID_0"] = scene.AddAccessor(std::vector<float>(8, 7.0f), "SCALAR");
  first["attributes"]["_WHOLE"] = scene.AddAccessor(std::vector<std::uint8_t>(8, 200), "SCALAR", false, 4);
  second["attributes"]["COLOR_0"] = scene.AddAccessor(std::vector<float>{ 1, 0.5, 0, 0.5, 2, -1, 0, 1, 0, 0, 0, 1, 0, 0,
                                                        0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1 },
    "VEC4");
  second["attributes"]["_WHOLE"] = scene.AddAccessor(std::vector<std::int16_t>(8, -5), "SCALAR", false, 4);
  second["attributes"]["_HEAT"] = scene.AddAccessor(std::vector<float>(8, 0.5f), "SCALAR");
  scene.AddNode({ { "mesh", scene.AddMesh({ first, second }) } });
  const MTGltfMesh read = MTGltfMesh::Read(scene);
  ASSERT_EQ(read.Error, "");
  vtkPointData* arrays = read.Mesh->GetPointData();
  EXPECT_EQ(arrays->GetScalars(), arrays->GetArray("COLOR_0"));
  EXPECT_EQ(arrays->GetNormals(), arrays->GetArray("NORMAL"));
  EXPECT_EQ(arrays->GetTCoords(), arrays->GetArray("TEXCOORD_0"));
  EXPECT_EQ(arrays->GetArray("COLOR_0")->GetDataType(), VTK_UNSIGNED_CHAR);
  const std::vector<double> colors = read.GetValues("COLOR_0");
  EXPECT_EQ(std::vector<double>(colors.begin(), colors.begin() + 4), (std::vector<double>{ 128, 128, 128, 255 }));
  EXPECT_EQ(std::vector<double>(colors.begin() + 32, colors.begin() + 40),
    (std::vector<double>{ 255, 128, 0, 128, 255, 0, 0, 255 }));
  EXPECT_EQ(arrays->GetArray("_FEATURE_ID_0")->GetDataType(), VTK_INT);
  EXPECT_EQ(arrays->GetArray("_WHOLE")->GetDataType(), VTK_INT);
  const std::vector<double> zeros(8, 0.0);
  EXPECT_EQ(read.GetValues("_FEATURE_ID_0"), Flatten({ std::vector<double>(8, 7.0), zeros }));
  EXPECT_EQ(read.GetValues("_WHOLE"), Flatten({ std::vector<double>(8, 200.0), std::vector<double>(8, -5.0) }));
  EXPECT_EQ(read.GetValues("_HEAT"), Flatten({ zeros, std::vector<double>(8, 0.5) }));
  EXPECT_EQ(read.GetValues("TEXCOORD_0")[1], 0.75);
  EXPECT_EQ(read.GetValues("TEXCOORD_0")[17], 0.0);
  EXPECT_EQ(read.Counts.at("united_arrays_filled"), 4); // NORMAL, TEXCOORD_0, _FEATURE_ID_0, _HEAT
  EXPECT_EQ(read.Counts.at("made_part_normals"), 8);
  const double middle[3] = { 0.5, 0.5, 0.5 };
  EXPECT_EQ(read.CountOutwardNormals(middle, 0, 16), 16);
}

TEST(GltfReader, MaterialsAndNodesAreIdsWithNamesAndColors)
{
  MTGltfScene scene;
  scene.Document["materials"] = { { { "name", "paint" },
                                    { "pbrMetallicRoughness", { { "baseColorFactor", { 1, 0, 0, 0.5 } } } } },
    { { "extensions", { { "KHR_materials_pbrSpecularGlossiness", { { "diffuseFactor", { 0, 0, 1, 1 } } } } } } } };
  Json red = scene.MakeCube();
  red["material"] = 0;
  Json blue = red;
  blue["material"] = 1;
  Json none = red;
  none.erase("material");
  scene.AddNode({ { "mesh", scene.AddMesh({ red, blue }) }, { "name", "left" } });
  scene.AddNode({ { "mesh", scene.AddMesh({ none }) }, { "translation", { 5, 0, 0 } } });
  const MTGltfMesh read = MTGltfMesh::Read(scene);
  ASSERT_EQ(read.Error, "");
  const std::vector<double> ids = read.GetCellValues("MaterialIds");
  EXPECT_EQ(ids[0], 0.0);
  EXPECT_EQ(ids[12], 1.0);
  EXPECT_EQ(ids[24], -1.0);
  vtkDataArray* colors = read.Mesh->GetCellData()->GetScalars();
  ASSERT_NE(colors, nullptr);
  EXPECT_STREQ(colors->GetName(), "BaseColor");
  const std::vector<double> all = read.GetCellValues("BaseColor");
  EXPECT_EQ(std::vector<double>(all.begin(), all.begin() + 4), (std::vector<double>{ 255, 0, 0, 128 }));
  EXPECT_EQ(std::vector<double>(all.begin() + 48, all.begin() + 52), (std::vector<double>{ 0, 0, 255, 255 }));
  EXPECT_EQ(std::vector<double>(all.begin() + 96, all.begin() + 100), (std::vector<double>{ 255, 255, 255, 255 }));
  vtkLookupTable* table = read.Mesh->GetCellData()->GetArray("MaterialIds")->GetLookupTable();
  ASSERT_NE(table, nullptr);
  EXPECT_EQ(table->GetIndexedLookup(), 1);
  EXPECT_EQ(table->GetAnnotation(0), "paint");
  EXPECT_EQ(table->GetAnnotation(1), "material 1");
  double color[4];
  table->GetAnnotationColor(vtkVariant(1), color);
  EXPECT_EQ(color[2], 1.0);
  EXPECT_EQ(read.Mesh->GetCellData()->GetArray("NodeIds")->GetLookupTable()->GetAnnotation(0), "left");
  // What says nothing is not there.
  MTGltfScene plain;
  plain.Document["materials"] = { Json::object() };
  Json cube = plain.MakeCube();
  cube["material"] = 0;
  plain.AddNode({ { "mesh", plain.AddMesh({ cube }) } });
  EXPECT_EQ(MTGltfMesh::Read(plain).Mesh->GetCellData()->GetNumberOfArrays(), 0);
}

TEST(GltfReader, TextureCoordinatesAreTransformedWhereTheTextureIs)
{
  const double quarter = vtkMath::Pi() / 2.0;
  MTGltfScene scene;
  const std::vector<Json> transforms = { { { "scale", { 2, 4 } }, { "offset", { 0.5, 0.25 } } },
    { { "rotation", quarter } }, { { "texCoord", 1 }, { "scale", { 3, 3 } } } };
  Json primitives = Json::array();
  scene.Document["materials"] = Json::array();
  const std::size_t set = scene.AddAccessor(std::vector<std::uint8_t>(16, 51), "VEC2", true, 4); // 0.2
  for (const Json& transform : transforms)
  {
    scene.Document["materials"].push_back({ { "pbrMetallicRoughness",
      { { "baseColorTexture", { { "index", 0 }, { "extensions", { { "KHR_texture_transform", transform } } } } } } } });
    primitives.push_back(scene.MakeCube());
    primitives.back()["attributes"]["TEXCOORD_0"] = set;
    primitives.back()["attributes"]["TEXCOORD_1"] = set;
    primitives.back()["material"] = primitives.size() - 1;
  }
  scene.Require("KHR_texture_transform");
  scene.AddNode({ { "mesh", scene.AddMesh(primitives) } });
  const MTGltfMesh read = MTGltfMesh::Read(scene);
  ASSERT_EQ(read.Error, "");
  const std::vector<double> first = read.GetValues("TEXCOORD_0");
  const std::vector<double> other = read.GetValues("TEXCOORD_1");
  EXPECT_NEAR(first[0], 0.9, 1e-6);
  EXPECT_NEAR(first[1], 1.0 - 1.05, 1e-6);
  EXPECT_NEAR(other[0], 0.2, 1e-6);
  EXPECT_NEAR(other[1], 0.8, 1e-6);
  EXPECT_NEAR(first[16], 0.2, 1e-6); // counter-clockwise, v downwards
  EXPECT_NEAR(first[17], 1.2, 1e-6);
  EXPECT_NEAR(first[32], 0.2, 1e-6);
  EXPECT_NEAR(other[32], 0.6, 1e-6);
  EXPECT_NEAR(other[33], 0.4, 1e-6);
}

//------------------------------------------------------------------------------
TEST(GltfReader, UrisAreDecodedAndBuffersFound)
{
  Folder folder;
  MTGltfScene scene;
  scene.AddNode({ { "mesh", scene.AddMesh({ scene.MakeCube() }) } });
  const auto read = [&folder](const std::string& text)
  {
    WriteFile(folder / "scene.gltf", text);
    vtkNew<vtkPolyData> mesh;
    std::string error;
    vtkMTMeshReader::Read(folder / "scene.gltf", mesh, error);
    return error.empty() ? std::to_string(mesh->GetNumberOfPolys()) : error;
  };
  EXPECT_EQ(read(scene.ToGltf(true)), "12");
  EXPECT_EQ(read(scene.ToGltf(false)), "12");
  EXPECT_EQ(read("\xef\xbb\xbf" + scene.ToGltf(true)), "12"); // a byte order mark
  WriteFile(folder / "my bin+ü%41.bin", scene.Buffer);
  for (const char* uri : { "my%20bin+%C3%BC%2541.bin", "my bin+ü%41.bin", "./my%20bin+ü%2541.bin" })
  {
    scene.Document["buffers"][0]["uri"] = uri;
    EXPECT_EQ(read(scene.Document.dump()), "12") << uri;
  }
  WriteFile(folder / "short.bin", Bytes(10));
  const std::vector<std::pair<std::string, std::string>> bad = { { "gone.bin", "gone.bin" },
    { "short.bin", "short.bin has 10 bytes and should have 168" }, { "/etc/hostname", "/etc/hostname" },
    { "https://example.org/a.bin", "leads elsewhere" }, { "data:;base64,A?", "no base64" }, { "data:", "no base64" },
    { "data:;base64,AAAA", "has 3 bytes" }, { ".", "regular file" } };
  for (const auto& [uri, reason] : bad)
  {
    scene.Document["buffers"][0]["uri"] = uri;
    const std::string error = read(scene.Document.dump());
    EXPECT_NE(error.find("buffer 0: "), std::string::npos) << error;
    EXPECT_NE(error.find(reason), std::string::npos) << error;
  }
}
