// SPDX-License-Identifier: BSD-3-Clause
// Mesh files of all formats, by content and ending; good ones, bad ones and the real ones of the test data.
#include "MTIOTest.h"
#include "MTTestMeshes.h"

#include "Obj/vtkMTObjReader.h"
#include "vtkMTMemoryByteSource.h"
#include "vtkMTMeshReader.h"
#include "vtkMTMeshWriter.h"
#include "vtkMTPolyDataStream.h"
#include "vtkMTStlReader.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataWriter.h"
#include "vtkSTLWriter.h"
#include "vtkXMLPolyDataWriter.h"

#include <cstring>
#include <map>

using namespace MTIOTest;

namespace
{
std::string Read(const std::string& path, vtkPolyData* mesh)
{
  std::string error;
  const bool done = vtkMTMeshReader::Read(path, mesh, error);
  EXPECT_NE(done, !error.empty());
  EXPECT_TRUE(done || error.find(path) != std::string::npos) << error;
  EXPECT_TRUE(done || mesh->GetNumberOfPoints() == 0);
  return error;
}

std::string ErrorOf(const std::string& path)
{
  vtkNew<vtkPolyData> mesh;
  return Read(path, mesh);
}

std::uint64_t CountTriangles(vtkPolyData* mesh)
{
  return vtkMTPolyDataStream(mesh).GetNumberOfTriangles();
}

void WriteLegacy(
  vtkPolyData* mesh, const std::string& path, bool binary, int version = vtkDataWriter::VTK_LEGACY_READER_VERSION_5_1)
{
  vtkNew<vtkPolyDataWriter> writer;
  writer->SetInputData(mesh);
  writer->SetFileName(path.c_str());
  binary ? writer->SetFileTypeToBinary() : writer->SetFileTypeToASCII();
  writer->SetFileVersion(version);
  EXPECT_EQ(writer->Write(), 1);
}

void WriteVtp(vtkPolyData* mesh, const std::string& path, int mode)
{
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(mesh);
  writer->SetFileName(path.c_str());
  writer->SetDataMode(mode);
  EXPECT_EQ(writer->Write(), 1);
}

// Two triangles' meshes under two nodes, one of them moved by 10 along x.
std::string MakeGltf(const std::string& buffer)
{
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1]}],
"nodes":[{"mesh":0},{"mesh":0,"translation":[10,0,0],"scale":[2,1,1]}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},
{"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"}],
"bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":6}],
"buffers":[{"byteLength":42)" +
    buffer + "}]}";
}

Bytes MakeGltfBuffer()
{
  const float places[9] = { 0, 0, 0, 1, 0, 0, 0, 1, 0 };
  const std::uint16_t indices[3] = { 0, 1, 2 };
  Bytes bytes(42);
  std::memcpy(bytes.data(), places, 36);
  std::memcpy(bytes.data() + 36, indices, 6);
  return bytes;
}

Bytes MakeGlb()
{
  std::string json = MakeGltf("");
  json.resize((json.size() + 3) / 4 * 4, ' ');
  Bytes buffer = MakeGltfBuffer();
  buffer.resize(44);
  Bytes bytes;
  const auto put = [&bytes](std::uint32_t value)
  {
    const unsigned char* from = reinterpret_cast<const unsigned char*>(&value);
    bytes.insert(bytes.end(), from, from + 4);
  };
  bytes = { 'g', 'l', 'T', 'F' };
  put(2);
  put(static_cast<std::uint32_t>(12 + 8 + json.size() + 8 + buffer.size()));
  put(static_cast<std::uint32_t>(json.size()));
  put(0x4e4f534a);
  bytes.insert(bytes.end(), json.begin(), json.end());
  put(static_cast<std::uint32_t>(buffer.size()));
  put(0x004e4942);
  bytes.insert(bytes.end(), buffer.begin(), buffer.end());
  return bytes;
}

const std::string TextStl =
  "solid a b c\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0\n   VERTEX 0 1e0 0\n  endloop\n "
  "endfacet\nendsolid a\n";
}

//------------------------------------------------------------------------------
TEST(MeshReader, EveryFormatGivesTheSameTriangles)
{
  Folder folder;
  const MTTestMeshes::Mesh mesh = MTTestMeshes::FractalSphere(3);
  const std::uint64_t triangles = CountTriangles(mesh);
  std::string error;
  for (const char* name : { "a.ply", "b.PLY", "a.stl", "b.StL", "a.obj", "b.OBJ", "a.vtp", "b.VTP" })
  {
    ASSERT_TRUE(vtkMTMeshWriter::Write(folder / name, mesh, error)) << error;
  }
  WriteLegacy(mesh, folder / "binary.vtk", true);
  WriteLegacy(mesh, folder / "text.VTK", false);
  WriteVtp(mesh, folder / "text.vtp", vtkXMLWriter::Ascii);
  WriteVtp(mesh, folder / "inline.vtp", vtkXMLWriter::Binary);
  vtkNew<vtkSTLWriter> writer;
  writer->SetInputData(mesh);
  writer->SetFileTypeToASCII();
  writer->SetFileName((folder / "text.stl").c_str());
  writer->Write();
  for (const std::string& name : folder.List())
  {
    vtkNew<vtkPolyData> read;
    EXPECT_EQ(Read(folder / name, read), "") << name;
    EXPECT_EQ(CountTriangles(read), triangles) << name;
    double expected[6];
    double bounds[6];
    mesh->GetBounds(expected);
    read->GetBounds(bounds);
    for (int i = 0; i < 6; ++i)
    {
      EXPECT_NEAR(bounds[i], expected[i], 1e-5) << name;
    }
  }
}

TEST(MeshReader, ContentCountsMoreThanEnding)
{
  Folder folder;
  const MTTestMeshes::Mesh mesh = MTTestMeshes::Icosphere(1);
  std::string error;
  for (const char* ending : { "ply", "vtp" })
  {
    ASSERT_TRUE(vtkMTMeshWriter::Write(folder / (std::string("mesh.") + ending), mesh, error)) << error;
    std::filesystem::rename(folder / (std::string("mesh.") + ending), folder / "mesh.obj");
    EXPECT_EQ(ErrorOf(folder / "mesh.obj"), "");
    std::filesystem::rename(folder / "mesh.obj", folder / "mesh");
    EXPECT_EQ(ErrorOf(folder / "mesh"), "");
  }
  WriteLegacy(mesh, folder / "mesh.stl", true);
  EXPECT_EQ(ErrorOf(folder / "mesh.stl"), "");
}

TEST(MeshReader, PolygonsAndStripsAreKept)
{
  Folder folder;
  std::string error;
  WriteLegacy(MTTestMeshes::Strips(5, 4), folder / "strips.vtk", true);
  WriteVtp(MTTestMeshes::Quads(5, 4), folder / "quads.vtp", vtkXMLWriter::Appended);
  WriteFile(folder / "quads.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
  vtkNew<vtkPolyData> mesh;
  ASSERT_EQ(Read(folder / "strips.vtk", mesh), "");
  EXPECT_EQ(mesh->GetNumberOfStrips(), 3);
  EXPECT_EQ(CountTriangles(mesh), 24u);
  ASSERT_EQ(Read(folder / "quads.vtp", mesh), "");
  EXPECT_EQ(mesh->GetNumberOfPolys(), 12);
  EXPECT_EQ(CountTriangles(mesh), 24u);
  ASSERT_EQ(Read(folder / "quads.obj", mesh), "");
  EXPECT_EQ(CountTriangles(mesh), 2u);
}

TEST(MeshReader, ArraysArriveFromVtksFormats)
{
  Folder folder;
  const MTTestMeshes::Mesh mesh = MTTestMeshes::Icosphere(1);
  MTTestMeshes::AddArrays(mesh);
  WriteVtp(mesh, folder / "mesh.vtp", vtkXMLWriter::Appended);
  WriteLegacy(mesh, folder / "mesh.vtk", true);
  for (const char* name : { "mesh.vtp", "mesh.vtk" })
  {
    vtkNew<vtkPolyData> read;
    ASSERT_EQ(Read(folder / name, read), "") << name;
    EXPECT_EQ(read->GetPointData()->GetNumberOfArrays(), mesh->GetPointData()->GetNumberOfArrays()) << name;
    EXPECT_EQ(read->GetCellData()->GetNumberOfArrays(), mesh->GetCellData()->GetNumberOfArrays()) << name;
  }
}

TEST(MeshReader, GltfNodesArePutInTheirPlaces)
{
  Folder folder;
  WriteFile(folder / "scene.glb", MakeGlb());
  WriteFile(folder / "scene.gltf", MakeGltf(R"(,"uri":"scene.bin")"));
  WriteFile(folder / "scene.bin", MakeGltfBuffer());
  for (const char* name : { "scene.glb", "scene.gltf" })
  {
    vtkNew<vtkPolyData> mesh;
    ASSERT_EQ(Read(folder / name, mesh), "") << name;
    EXPECT_EQ(CountTriangles(mesh), 2u);
    const double* bounds = mesh->GetBounds();
    EXPECT_EQ(bounds[0], 0.0);
    EXPECT_EQ(bounds[1], 12.0); // 10 + 2 * 1
  }
}

//------------------------------------------------------------------------------
TEST(MeshReader, TextStlIsReadLineByLine)
{
  Folder folder;
  WriteFile(folder / "mesh.stl", TextStl + TextStl);
  vtkNew<vtkPolyData> mesh;
  ASSERT_EQ(Read(folder / "mesh.stl", mesh), "");
  EXPECT_EQ(mesh->GetNumberOfPolys(), 2);
  const std::vector<std::pair<std::string, std::string>> cases = {
    { "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\nendfacet\nendsolid\n",
      "no triangles" },
    { "solid a\nvertex 0 0 0\nendsolid\n", "no triangles" }, { "solid a\nfacet\nfacet\n", "truncated" },
    { "solid a\nsolid b\n", "truncated" }, { "solid a\nwhat is this\n", "truncated" },
    { "solid a\n" + std::string("x\n\n") + "y\ny\ny\ny\ny\ny\ny\ny\ny\ny\ny\ny\nendsolid\n", "line 14" },
    { "solid a\nendsolid\n", "no triangles" }
  };
  for (const auto& test : cases)
  {
    WriteFile(folder / "bad.stl", test.first);
    EXPECT_NE(ErrorOf(folder / "bad.stl").find(test.second), std::string::npos)
      << test.first << ErrorOf(folder / "bad.stl");
  }
  for (std::size_t length = 0; length + 12 < TextStl.size(); ++length)
  {
    WriteFile(folder / "cut.stl", TextStl.substr(0, length));
    EXPECT_NE(ErrorOf(folder / "cut.stl"), "") << length;
  }
}

TEST(MeshReader, BinaryStlMustHaveAsManyRecordsAsItAnnounces)
{
  Folder folder;
  std::string error;
  ASSERT_TRUE(vtkMTMeshWriter::Write(folder / "mesh.stl", MTTestMeshes::Icosphere(1), error)) << error;
  const Bytes good = ReadFile(folder / "mesh.stl");
  for (std::size_t length = 0; length < good.size(); ++length)
  {
    vtkNew<vtkPolyData> mesh;
    std::string reason;
    EXPECT_FALSE(vtkMTStlReader::Read(
      vtkMTMemoryByteSource(Bytes(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(length))), mesh, reason));
    EXPECT_FALSE(reason.empty());
  }
  // Many programs begin the free text of a binary file with the word that begins a text file.
  Bytes solid = good;
  std::memcpy(solid.data(), "solid of bytes", 14);
  WriteFile(folder / "solid.stl", solid);
  EXPECT_EQ(ErrorOf(folder / "solid.stl"), "");
  Bytes huge = good;
  std::memset(huge.data() + 80, 0x7f, 4);
  WriteFile(folder / "huge.stl", huge);
  EXPECT_NE(ErrorOf(folder / "huge.stl").find("announces 2139062143"), std::string::npos);
  Bytes more = good;
  more.resize(good.size() + 49);
  WriteFile(folder / "more.stl", more);
  EXPECT_EQ(ErrorOf(folder / "more.stl"), "");
  more.resize(good.size() + 50); // zeros are no triangle
  WriteFile(folder / "more.stl", more);
  EXPECT_EQ(ErrorOf(folder / "more.stl"), "");
}

//------------------------------------------------------------------------------
TEST(MeshReader, ObjSplitsPointsOnlyWhereAttributesDiffer)
{
  Folder folder;
  WriteFile(folder / "mesh.obj",
    "# a comment\nmtllib x.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0 0\nvt 1 1\nvt 0 1\nvt 0.5 0.5\nvn 0 "
    "0 1\n"
    "g one\nusemtl red\nf 1/1/1 2/2/1 3/3/1 # the first\ng two\nusemtl blue\nf -4/1/1 -2/5/1 \\\n -1/4/1\nl 1 2\n");
  vtkNew<vtkPolyData> mesh;
  ASSERT_EQ(Read(folder / "mesh.obj", mesh), "");
  EXPECT_EQ(mesh->GetNumberOfPoints(), 5);
  EXPECT_EQ(mesh->GetNumberOfPolys(), 2);
  EXPECT_EQ(mesh->GetNumberOfLines(), 1);
  ASSERT_NE(mesh->GetPointData()->GetTCoords(), nullptr);
  EXPECT_EQ(mesh->GetPointData()->GetTCoords()->GetComponent(4, 0), 0.5);
  EXPECT_EQ(mesh->GetPointData()->GetNormals()->GetComponent(4, 2), 1.0);
  vtkDataArray* materials = mesh->GetCellData()->GetArray("MaterialIds"); // the line comes first
  ASSERT_NE(materials, nullptr);
  EXPECT_EQ(materials->GetTuple1(0), 1.0);
  EXPECT_EQ(materials->GetTuple1(1), 0.0);
  EXPECT_EQ(materials->GetTuple1(2), 1.0);
  EXPECT_EQ(mesh->GetCellData()->GetArray("GroupIds")->GetTuple1(2), 1.0);
  EXPECT_EQ(mesh->GetFieldData()->GetAbstractArray("MaterialNames")->GetVariantValue(1).ToString(), "blue");
}

TEST(MeshReader, ObjPrecisionFollowsTheText)
{
  Folder folder;
  WriteFile(folder / "single.obj", "v 0.471551 -500.000000 1e3\nv 1.00000001 0 0\nv 0 1 0\nf 1 2 3\n");
  WriteFile(folder / "double.obj", "v 500123.456 4500123.25 1\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  vtkNew<vtkPolyData> mesh;
  WriteFile(folder / "short.obj", "v 0.471551 -500.000000 1e3\nv 1.5 0 0\nv 0 1 0\nf 1 2 3\n");
  ASSERT_EQ(Read(folder / "short.obj", mesh), "");
  EXPECT_EQ(mesh->GetPoints()->GetDataType(), VTK_FLOAT);
  ASSERT_EQ(Read(folder / "double.obj", mesh), "");
  EXPECT_EQ(mesh->GetPoints()->GetDataType(), VTK_DOUBLE);
  EXPECT_EQ(mesh->GetPoint(0)[0], 500123.456);
  ASSERT_EQ(Read(folder / "single.obj", mesh), "");
  EXPECT_EQ(mesh->GetPoints()->GetDataType(), VTK_DOUBLE); // 1.00000001
}

TEST(MeshReader, ChangedObjAndStlAreSurvived)
{
  const std::string obj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvn 0 0 1\ng a\nusemtl b\nf 1/1/1 2/2/1 "
                          "3/1/1 4/2/1\nf -1 -2 -3\nl 1 2\n";
  MTTestMeshes::Random random(5);
  std::size_t refused = 0;
  for (int i = 0; i < 20000; ++i)
  {
    Bytes bytes(obj.begin(), obj.end());
    Bytes stl(TextStl.begin(), TextStl.end());
    for (std::size_t j = 0; j <= random.Below(4); ++j)
    {
      static const char likely[] = "0123456789/-. \nfvl";
      const unsigned char value =
        static_cast<unsigned char>(random.Below(4) ? likely[random.Below(sizeof(likely) - 1)] : random.Below(256));
      bytes[random.Below(bytes.size())] = value;
      stl[random.Below(stl.size())] = value;
    }
    vtkNew<vtkPolyData> mesh;
    std::string error;
    refused += !vtkMTObjReader::Read(vtkMTMemoryByteSource(bytes), mesh, error);
    refused += !vtkMTStlReader::Read(vtkMTMemoryByteSource(stl), mesh, error);
  }
  std::cout << refused << " of 40000 refused\n";
}

//------------------------------------------------------------------------------
TEST(MeshReader, FilesThatAreNoMeshesAreClearErrors)
{
  Folder folder;
  EXPECT_NE(ErrorOf(folder / "missing.ply").find("No such file"), std::string::npos);
  EXPECT_NE(ErrorOf(folder / "").find("regular file"), std::string::npos);
  for (const char* ending : { "ply", "stl", "obj", "vtp", "vtk", "glb", "gltf", "txt" })
  {
    const std::string path = folder / (std::string("mesh.") + ending);
    WriteFile(path, "");
    EXPECT_NE(ErrorOf(path).find("empty"), std::string::npos) << ending;
    WriteFile(path, std::string(5000, '\x5a'));
    EXPECT_NE(ErrorOf(path), "") << ending;
  }
  WriteFile(folder / "grid.vti", "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" version=\"0.1\"></VTKFile>\n");
  EXPECT_NE(ErrorOf(folder / "grid.vti").find("no polydata"), std::string::npos);
  WriteFile(folder / "grid.vtk", "# vtk DataFile Version 3.0\nx\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 1 1 1\n");
  EXPECT_NE(ErrorOf(folder / "grid.vtk").find("no polydata"), std::string::npos);
}

TEST(MeshReader, MeshWithoutTrianglesIsAnError)
{
  Folder folder;
  vtkNew<vtkPolyData> points;
  points->SetPoints(MTTestMeshes::Icosphere(1)->GetPoints());
  WriteVtp(points, folder / "points.vtp", vtkXMLWriter::Appended);
  WriteLegacy(points, folder / "points.vtk", true);
  WriteFile(folder / "points.ply",
    "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nend_header\n0 0 "
    "0\n");
  for (const std::string& name : folder.List())
  {
    EXPECT_NE(ErrorOf(folder / name).find("no triangles"), std::string::npos) << name;
  }
}

TEST(MeshReader, IndicesOutOfRangeAreFoundWhateverReaderLetThemThrough)
{
  Folder folder;
  WriteFile(folder / "bad.vtk",
    "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n0 0 0 1 0 0 0 1 0\nPOLYGONS 1 4\n3 0 1 "
    "7\n");
  EXPECT_NE(ErrorOf(folder / "bad.vtk").find("does not exist"), std::string::npos);
}

// What is truncated is refused; VTK's own readers run in a child process, as they may crash.
TEST(MeshReader, CutFilesOfVtksFormatsAreNeverTakenForWhole)
{
  Folder folder;
  const MTTestMeshes::Mesh mesh = MTTestMeshes::Icosphere(1);
  MTTestMeshes::AddArrays(mesh);
  WriteVtp(mesh, folder / "appended.vtp", vtkXMLWriter::Appended);
  WriteVtp(mesh, folder / "text.vtp", vtkXMLWriter::Ascii);
  WriteLegacy(mesh, folder / "binary.vtk", true);
  WriteLegacy(mesh, folder / "text.vtk", false);
  WriteLegacy(mesh, folder / "old-binary.vtk", true, vtkDataWriter::VTK_LEGACY_READER_VERSION_4_2);
  WriteLegacy(mesh, folder / "old-text.vtk", false, vtkDataWriter::VTK_LEGACY_READER_VERSION_4_2);
  WriteFile(folder / "scene.glb", MakeGlb());
  for (const std::string& name : folder.List())
  {
    const Bytes good = ReadFile(folder / name);
    const std::string text(good.begin(), good.end());
    // The legacy format has no end and does not say how many arrays there are: a file that ends within or before an
    // array's name cannot be told from a whole one.
    const bool hasEnd = name.find(".vtk") == std::string::npos;
    const std::size_t cells = hasEnd ? text.size() : text.find("_DATA");
    std::map<std::string, int> outcomes;
    for (int i = 0; i < 60; ++i)
    {
      const std::size_t length = good.size() * static_cast<std::size_t>(i) / 60;
      const std::string path = (folder / "cut-") + name;
      WriteFile(path, Bytes(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(length)));
      const ChildResult result = RunInChild(
        [&]
        {
          vtkNew<vtkPolyData> read;
          std::string error;
          return vtkMTMeshReader::Read(path, read, error) ? 1 : error.find(path) == 0 ? 0 : 2;
        });
      EXPECT_FALSE(result.Crashed) << name << " " << length;
      EXPECT_NE(result.ExitCode, 2) << name << " " << length;
      EXPECT_TRUE(result.ExitCode == 0 || length > cells) << name << " " << length;
      ++outcomes[result.ExitCode == 0 ? "refused" : "taken for whole"];
      std::filesystem::remove(path);
    }
    std::cout << name << ": " << outcomes["refused"] << " refused, " << outcomes["taken for whole"]
              << " taken for whole\n";
    EXPECT_LE(outcomes["taken for whole"], hasEnd ? 0 : 3) << name;
  }
}

//------------------------------------------------------------------------------
TEST(MeshReader, RealMeshesAreReadOrRefusedWithAReason)
{
  const std::string folder = GetDataFolder();
  if (folder.empty())
  {
    GTEST_SKIP() << "the test data are not there: set MT_TEST_DATA";
  }
  // What is known to hold no mesh.
  const std::vector<std::string> refused = { "empty.ply", "empty_binary.stl", "issue623_crashes_vtkply.ply",
    "points_emptyface.ply" };
  std::map<std::string, std::uint64_t> triangles = { { "dragon_res2.ply", 202520 }, { "nefertiti_lowres.obj", 70000 },
    { "lucy_100k.ply", 99970 }, { "igea.vtp", 268686 }, { "trumpet.obj", 23696 }, { "2CylinderEngine.glb", 121496 },
    { "thingi_1514499.stl", 26700 }, { "spot.obj", 5856 }, { "doorman_multi_uv.obj", 9783 },
    { "fetal_cortex_strips.vtk", 53714 }, { "mvs_textured_wedge_uv.ply", 14709 },
    { "texturedknot_crashes_vtkply.ply", 2880 }, { "kitchen_scene.vtp", 1443509 }, { "bad-stl-wing.stl", 842 },
    { "negative_indices.obj", 12 }, { "regr01_house.obj", 2710 }, { "BoxWithInfinites.glb", 12 },
    // One record each that is none; it is counted, and costs no other.
    { "invalidvertex.stl", 14 }, { "notenoughindices.obj", 1 }, { "unparseable.stl", 1 } };
  std::size_t count = 0;
  for (const char* kind : { "scanned", "cad", "attributes", "extreme" })
  {
    for (const auto& entry : std::filesystem::directory_iterator(folder + "/" + kind))
    {
      const std::string name = entry.path().filename().string();
      if (entry.path().extension() == ".png")
      {
        continue;
      }
      vtkNew<vtkPolyData> mesh;
      const std::string error = Read(entry.path().string(), mesh);
      const bool isBad = std::find(refused.begin(), refused.end(), name) != refused.end();
      EXPECT_EQ(isBad, !error.empty()) << name << ": " << error;
      if (isBad)
      {
        std::cout << error << "\n";
      }
      else if (triangles.count(name))
      {
        EXPECT_EQ(CountTriangles(mesh), triangles[name]) << name;
      }
      ++count;
    }
  }
  std::cout << count << " files\n";
  vtkNew<vtkPolyData> spot;
  EXPECT_EQ(Read(folder + "/attributes/spot.obj", spot), "");
  std::cout << "spot.obj has " << spot->GetNumberOfPoints() << " points (2930 places; vtkOBJReader gives 17568)\n";
  EXPECT_LT(spot->GetNumberOfPoints(), 3300);
}
