// SPDX-License-Identifier: BSD-3-Clause
// The verification's own readers: each quirk of a format is read for what the format's description makes of it.
#include "vtkMTVerifyInput.h"
#include "vtkMTVerifyPolygons.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtk_zlib.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace
{
const double Cube[8][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 },
  { 0, 1, 1 } };
const int Faces[12][3] = { { 0, 2, 1 }, { 0, 3, 2 }, { 4, 5, 6 }, { 4, 6, 7 }, { 0, 1, 5 }, { 0, 5, 4 }, { 1, 2, 6 },
  { 1, 6, 5 }, { 2, 3, 7 }, { 2, 7, 6 }, { 3, 0, 4 }, { 3, 4, 7 } };

struct Reading
{
  bool IsRead = false;
  vtkMTVerifyInput::Source Source;
  vtkNew<vtkPolyData> Mesh;
  vtkMTSampledSurface Surface;
  double Area = 0.0;
  double Volume = 0.0;
  std::int64_t Crossing = 0;
};

class VerifyInput : public testing::Test
{
protected:
  void SetUp() override
  {
    const std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
    this->Folder = std::filesystem::path(testing::TempDir()) / ("verify_input_" + name);
    std::filesystem::create_directories(this->Folder);
  }
  void TearDown() override { std::filesystem::remove_all(this->Folder); }

  void Write(const std::string& name, const std::string& bytes) const
  {
    std::ofstream(this->Folder / name, std::ios::binary) << bytes;
  }

  void Read(const std::string& name, Reading& reading) const
  {
    vtkMTVerifyInput::Options options;
    options.Paths = { (this->Folder / name).string() };
    std::vector<vtkMTVerifyInput::Source> sources;
    double rounding = 0.0;
    reading.IsRead = vtkMTVerifyInput::Read(options, reading.Mesh, sources, rounding);
    ASSERT_EQ(sources.size(), 1u);
    reading.Source = sources[0];
    vtkMTVerifyPolygons polygons(nullptr);
    polygons.Split(reading.Mesh, reading.Surface);
    reading.Crossing = polygons.GetNumberOfCrossing();
    for (std::size_t t = 0; t < reading.Surface.Triangles.size(); ++t)
    {
      const auto& x = reading.Surface.Points;
      const vtkMTTriangle& c = reading.Surface.Triangles[t];
      const vtkMTRealPoint &a = x[c[0]], &b = x[c[1]], &d = x[c[2]];
      reading.Area += reading.Surface.GetArea(t);
      reading.Volume +=
        (a[0] * (b[1] * d[2] - b[2] * d[1]) + a[1] * (b[2] * d[0] - b[0] * d[2]) + a[2] * (b[0] * d[1] - b[1] * d[0])) /
        6.0;
    }
  }

  void ExpectCube(const std::string& name, double volume = 1.0) const
  {
    Reading reading;
    this->Read(name, reading);
    EXPECT_TRUE(reading.IsRead) << name << ": " << reading.Source.Reason;
    EXPECT_EQ(reading.Surface.Triangles.size(), 12u) << name;
    EXPECT_NEAR(reading.Volume, volume, 1e-6) << name;
  }

  std::filesystem::path Folder;
};

std::string ObjCube(const std::string& before, const std::string& after = "")
{
  std::ostringstream text;
  text << before;
  for (const auto& x : Cube)
  {
    text << "v " << x[0] << " " << x[1] << " " << x[2] << "\n";
  }
  for (const auto& f : Faces)
  {
    text << "f " << f[0] + 1 << " " << f[1] + 1 << " " << f[2] + 1 << "\n";
  }
  return text.str() + after;
}

template <class T>
void Put(std::string& bytes, T value, bool isBig = false)
{
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T)); // the tests run on little-endian machines
  std::reverse(raw, raw + (isBig ? sizeof(T) : 0));
  bytes.append(raw, sizeof(T));
}

std::string StlCube(std::uint32_t count, const std::string& header, const std::vector<std::uint16_t>& words)
{
  std::string bytes = header + std::string(80 - header.size(), ' ');
  Put(bytes, count);
  for (int f = 0; f < 12; ++f)
  {
    bytes.append(12, '\0');
    for (int corner : Faces[f])
    {
      for (double x : Cube[corner])
      {
        Put(bytes, static_cast<float>(x));
      }
    }
    Put(bytes, words.empty() ? std::uint16_t(0) : words[f % words.size()]);
  }
  return bytes;
}

std::string TextStlCube(const std::string& endLoop, const std::string& name)
{
  std::ostringstream text;
  text << "solid " << name << "\n";
  for (const auto& f : Faces)
  {
    text << "facet normal 0 0 0\nouter loop\n";
    for (int corner : f)
    {
      text << "vertex " << Cube[corner][0] << " " << Cube[corner][1] << " " << Cube[corner][2] << "\n";
    }
    text << endLoop << "\nendfacet\n";
  }
  text << "endsolid " << name << "\n";
  return text.str();
}

std::string PlyCube(const std::string& format, const std::string& junk, const std::string& color)
{
  std::ostringstream header;
  header << "ply\nformat " << format << " 1.0\n" << junk << "element vertex 8\n";
  for (const char* name : { "x", "y", "z" })
  {
    header << "property float " << name << "\n";
  }
  for (const char* name : { "red", "green", "blue" })
  {
    header << "property uchar " << color << name << "\n";
  }
  header << "element face 12\nproperty list uchar int vertex_indices\nend_header\n";
  std::string bytes = header.str();
  const bool isText = format == "ascii";
  const bool isBig = format == "binary_big_endian";
  std::ostringstream text;
  for (const auto& x : Cube)
  {
    text << x[0] << " " << x[1] << " " << x[2] << " 255 128 0\n";
    for (int c = 0; c < 3 && !isText; ++c)
    {
      Put(bytes, static_cast<float>(x[c]), isBig);
    }
    bytes += isText ? std::string() : std::string("\xff\x80\x00", 3);
  }
  for (const auto& f : Faces)
  {
    text << "3 " << f[0] << " " << f[1] << " " << f[2] << "\n";
    bytes += isText ? "" : "\x03";
    for (int c = 0; c < 3 && !isText; ++c)
    {
      Put(bytes, static_cast<std::int32_t>(f[c]), isBig);
    }
  }
  return bytes + (isText ? text.str() : "");
}

// Positions as floats in one buffer and indices behind them; node: its JSON; more: further members of the root.
std::string GltfCube(const std::string& node, const std::string& more)
{
  std::string buffer;
  for (const auto& x : Cube)
  {
    for (double c : x)
    {
      Put(buffer, static_cast<float>(c));
    }
  }
  for (const auto& f : Faces)
  {
    for (int corner : f)
    {
      Put(buffer, static_cast<std::uint16_t>(corner));
    }
  }
  Put(buffer, std::uint16_t(6)); // of the sparse accessor: point 6 is at (1, 1, 5)
  buffer.append(2, '\0');
  for (float c : { 1.0f, 1.0f, 5.0f })
  {
    Put(buffer, c);
  }
  std::string json = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[)" + node +
    R"(],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],)" + more +
    R"("bufferViews":[{"buffer":0,"byteLength":96},{"buffer":0,"byteOffset":96,"byteLength":72},)"
    R"({"buffer":0,"byteOffset":168,"byteLength":2},{"buffer":0,"byteOffset":172,"byteLength":12}],)"
    R"("buffers":[{"byteLength":)" +
    std::to_string(buffer.size()) + "}]}";
  json.append((4 - json.size() % 4) % 4, ' ');
  std::string bytes = "glTF";
  Put(bytes, std::uint32_t(2));
  Put(bytes, static_cast<std::uint32_t>(28 + json.size() + buffer.size()));
  Put(bytes, static_cast<std::uint32_t>(json.size()));
  bytes += "JSON" + json;
  Put(bytes, static_cast<std::uint32_t>(buffer.size()));
  return bytes + std::string("BIN\0", 4) + buffer;
}

const std::string Accessors = R"("accessors":[{"bufferView":0,"componentType":5126,"count":8,"type":"VEC3"},)"
                              R"({"bufferView":1,"componentType":5123,"count":36,"type":"SCALAR"}],)";
}

TEST_F(VerifyInput, QuirksOfObjAreRead)
{
  this->Write("plain.obj", ObjCube(""));
  this->Write("bom.obj", ObjCube("\xef\xbb\xbf"));
  this->Write("two.obj", ObjCube("", "f 1 2\n"));
  this->Write("normals.obj", ObjCube("", "f 1//9 2//9\n"));
  for (const char* name : { "plain.obj", "bom.obj", "two.obj", "normals.obj" })
  {
    this->ExpectCube(name);
  }
  this->Write("nan.obj", ObjCube("", "v 1.#QNAN 0 0\nv 2 0 -1.#IND\nf 1 2 9\nf -1 1 2\nf 1 2 99\n"));
  Reading reading;
  this->Read("nan.obj", reading);
  EXPECT_EQ(reading.Surface.Triangles.size(), 12u);
  EXPECT_EQ(reading.Surface.NonFinite, 2);
  EXPECT_EQ(reading.Surface.OutOfRange, 1);
  this->Write("wide.obj", "\xff\xfev");
  this->Read("wide.obj", reading);
  EXPECT_FALSE(reading.IsRead);
  EXPECT_EQ(reading.Source.Reason, "is UTF-16");
}

TEST_F(VerifyInput, APolygonWithAHoleHasTheRightArea)
{
  this->Write("keyhole.obj",
    "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 1 1 0\nv 1 3 0\nv 3 3 0\nv 3 1 0\n"
    "f 1 2 3 4 1 5 6 7 8 5\n");
  Reading reading;
  this->Read("keyhole.obj", reading);
  EXPECT_EQ(reading.Surface.Triangles.size(), 8u);
  EXPECT_NEAR(reading.Area, 12.0, 1e-12);
  EXPECT_EQ(reading.Crossing, 0);
  Reading bow;
  this->Write("bow.obj", "v 0 0 0\nv 2 0 0\nv 0 1 0\nv 3 1 0\nf 1 2 3 4\n");
  this->Read("bow.obj", bow);
  EXPECT_EQ(bow.Crossing, 1) << "a polygon that crosses itself has no triangulation";
}

TEST_F(VerifyInput, NamesAndColorsOfObjAreRead)
{
  this->Write(
    "names.obj", "v 0 0 0 1 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\ng inlet\nusemtl steel\nf 1 2 3\ng walls\nf 1 2 4\n");
  Reading reading;
  this->Read("names.obj", reading);
  vtkDataArray* groups = reading.Mesh->GetCellData()->GetArray("GroupIds");
  ASSERT_TRUE(groups);
  EXPECT_EQ(groups->GetLookupTable()->GetAnnotation(1), "walls");
  EXPECT_FALSE(reading.Mesh->GetCellData()->GetArray("MaterialIds")) << "one material tells no cells apart";
  vtkDataArray* colors = reading.Mesh->GetPointData()->GetScalars();
  ASSERT_TRUE(colors);
  EXPECT_EQ(colors->GetComponent(0, 0), 1.0);
  EXPECT_TRUE(std::isnan(colors->GetComponent(1, 0))) << "a point without a colour has none";
}

TEST_F(VerifyInput, QuirksOfStlAreRead)
{
  this->Write("count0.stl", StlCube(0, "solid that is binary", {}));
  this->Write("right.stl", StlCube(12, "", {}));
  this->Write("text.stl", TextStlCube("endloop", "cube"));
  this->Write("bom.stl", "\xef\xbb\xbf" + TextStlCube("endloop", "cube"));
  this->Write("loop.stl", TextStlCube("end loop", "cube"));
  for (const char* name : { "count0.stl", "right.stl", "text.stl", "bom.stl", "loop.stl" })
  {
    this->ExpectCube(name);
  }
  this->Write("short.stl", StlCube(12, "", {}).substr(0, 300));
  Reading reading;
  this->Read("short.stl", reading);
  EXPECT_FALSE(reading.IsRead);
}

TEST_F(VerifyInput, ColorsAndSolidsOfStlAreRead)
{
  const std::uint16_t red = 31 << 10, blue = 31;
  Reading viscam, magics, solids;
  this->Write("viscam.stl", StlCube(12, "", { std::uint16_t(0x8000 | red), std::uint16_t(0x8000 | blue) }));
  this->Read("viscam.stl", viscam);
  ASSERT_TRUE(viscam.Mesh->GetCellData()->GetScalars());
  EXPECT_EQ(viscam.Mesh->GetCellData()->GetScalars()->GetComponent(0, 0), 1.0);
  EXPECT_EQ(viscam.Mesh->GetCellData()->GetScalars()->GetComponent(1, 2), 1.0);
  this->Write("magics.stl", StlCube(12, std::string("COLOR=\xff\x00\x00\xff", 10), { red, 0x8000 }));
  this->Read("magics.stl", magics);
  ASSERT_TRUE(magics.Mesh->GetCellData()->GetScalars());
  EXPECT_EQ(magics.Mesh->GetCellData()->GetScalars()->GetComponent(0, 2), 1.0) << "Magics has red lowest";
  EXPECT_EQ(magics.Mesh->GetCellData()->GetScalars()->GetComponent(1, 0), 1.0) << "the whole object's colour";
  this->Write("solids.stl", TextStlCube("endloop", "inlet") + TextStlCube("endloop", "walls"));
  this->Read("solids.stl", solids);
  ASSERT_TRUE(solids.Mesh->GetCellData()->GetArray("SolidIds"));
  EXPECT_EQ(solids.Mesh->GetCellData()->GetArray("SolidIds")->GetComponent(12, 0), 1.0);
  Reading plain;
  this->Write("plain.stl", StlCube(12, "", { 7 }));
  this->Read("plain.stl", plain);
  EXPECT_FALSE(plain.Mesh->GetCellData()->GetScalars()) << "attribute bytes without the bit are no colours";
}

TEST_F(VerifyInput, EveryFormOfPlyIsRead)
{
  for (const char* format : { "ascii", "binary_little_endian", "binary_big_endian" })
  {
    for (const char* color : { "", "diffuse_" })
    {
      this->Write("cube.ply", PlyCube(format, "Created by hand\ncomment x\n", color));
      this->ExpectCube("cube.ply");
      Reading reading;
      this->Read("cube.ply", reading);
      vtkDataArray* scalars = reading.Mesh->GetPointData()->GetScalars();
      ASSERT_TRUE(scalars) << format << color;
      EXPECT_EQ(scalars->GetComponent(7, 0), 1.0);
      EXPECT_NEAR(scalars->GetComponent(7, 1), 128.0 / 255.0, 1e-12);
    }
  }
  const std::string whole = PlyCube("binary_little_endian", "", "");
  this->Write("short.ply", whole.substr(0, whole.size() - 3));
  Reading reading;
  this->Read("short.ply", reading);
  EXPECT_FALSE(reading.IsRead);
}

TEST_F(VerifyInput, OffWithColorsIsReadAlsoThroughGzip)
{
  std::ostringstream text;
  text << "COFF # a cube\n8 12 0\n";
  for (const auto& x : Cube)
  {
    text << x[0] << " " << x[1] << " " << x[2] << " 255 0 0 255\n";
  }
  for (const auto& f : Faces)
  {
    text << "3 " << f[0] << " " << f[1] << " " << f[2] << " 0.5 0.25 1.0\n";
  }
  this->Write("cube.off", text.str());
  this->ExpectCube("cube.off");
  Reading reading;
  this->Read("cube.off", reading);
  EXPECT_EQ(reading.Mesh->GetPointData()->GetScalars()->GetComponent(3, 0), 1.0);
  EXPECT_EQ(reading.Mesh->GetCellData()->GetScalars()->GetComponent(3, 1), 0.25);
  gzFile file = gzopen((this->Folder / "cube.off.gz").string().c_str(), "wb");
  gzwrite(file, text.str().data(), static_cast<unsigned int>(text.str().size()));
  gzclose(file);
  this->ExpectCube("cube.off.gz");
}

TEST_F(VerifyInput, GltfHasItsNodesAndItsSparseAccessors)
{
  this->Write("plain.glb", GltfCube(R"({"mesh":0})", Accessors));
  this->ExpectCube("plain.glb");
  this->Write("mirror.glb", GltfCube(R"({"mesh":0,"scale":[-1,2,1]})", Accessors));
  this->ExpectCube("mirror.glb", 2.0);
  this->Write(
    "turned.glb", GltfCube(R"({"mesh":0,"rotation":[0,0,0.7071067811865476,0.7071067811865476]})", Accessors));
  Reading turned;
  this->Read("turned.glb", turned);
  EXPECT_NEAR(turned.Surface.GetBounds().Minimum[0], -1.0, 1e-6);
  EXPECT_NEAR(turned.Volume, 1.0, 1e-6);
  const std::string sparse = R"("accessors":[{"bufferView":0,"componentType":5126,"count":8,"type":"VEC3",)"
                             R"("sparse":{"count":1,"indices":{"bufferView":2,"componentType":5123},)"
                             R"("values":{"bufferView":3}}},)"
                             R"({"bufferView":1,"componentType":5123,"count":36,"type":"SCALAR"}],)";
  Reading reading;
  this->Write("sparse.glb", GltfCube(R"({"mesh":0})", sparse));
  this->Read("sparse.glb", reading);
  EXPECT_EQ(reading.Surface.GetBounds().Maximum[2], 5.0);
}

TEST_F(VerifyInput, WhatIsNotReadHasAReason)
{
  const std::pair<const char*, const char*> required[] = { { "EXT_meshopt_compression", "EXT_meshopt_compression" },
    { "KHR_draco_mesh_compression", "KHR_draco_mesh_compression" } };
  for (const auto& [name, reason] : required)
  {
    Reading reading;
    this->Write("x.glb", GltfCube(R"({"mesh":0})", Accessors + R"("extensionsRequired":[")" + name + R"("],)"));
    this->Read("x.glb", reading);
    EXPECT_FALSE(reading.IsRead);
    EXPECT_NE(reading.Source.Reason.find(reason), std::string::npos) << reading.Source.Reason;
  }
  Reading cycle, unknown;
  this->Write("cycle.glb", GltfCube(R"({"mesh":0,"children":[0]})", Accessors));
  this->Read("cycle.glb", cycle);
  EXPECT_NE(cycle.Source.Reason.find("cycle"), std::string::npos) << cycle.Source.Reason;
  this->Write("x.las", "LASF");
  this->Read("x.las", unknown);
  EXPECT_FALSE(unknown.IsRead);
  EXPECT_FALSE(unknown.Source.Reason.empty());
}
