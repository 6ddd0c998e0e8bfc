// SPDX-License-Identifier: BSD-3-Clause
// PLY in all its forms, good and bad.
#include "MTIOTest.h"
#include "MTTestMeshes.h"

#include "vtkMTMemoryByteSource.h"
#include "vtkMTPlyReader.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cstring>

using namespace MTIOTest;

namespace
{
// Puts numbers in the byte order of a format.
class Body
{
public:
  explicit Body(const std::string& header, bool bigEndian = false)
    : Bytes(header.begin(), header.end())
    , BigEndian(bigEndian)
  {
  }
  template <typename Number>
  Body& Put(Number value)
  {
    unsigned char digits[sizeof(value)];
    std::memcpy(digits, &value, sizeof(value));
    if (this->BigEndian)
    {
      std::reverse(digits, digits + sizeof(value));
    }
    this->Bytes.insert(this->Bytes.end(), digits, digits + sizeof(value));
    return *this;
  }
  MTIOTest::Bytes Bytes;

private:
  bool BigEndian;
};

std::string Read(const Bytes& bytes, vtkPolyData* mesh)
{
  std::string error;
  const bool done = vtkMTPlyReader::Read(vtkMTMemoryByteSource(bytes), mesh, error);
  EXPECT_NE(done, !error.empty());
  EXPECT_TRUE(done || mesh->GetNumberOfPoints() == 0);
  return error;
}

std::string Read(const std::string& text, vtkPolyData* mesh)
{
  return Read(Bytes(text.begin(), text.end()), mesh);
}

std::string ErrorOf(const std::string& text)
{
  vtkNew<vtkPolyData> mesh;
  return Read(text, mesh);
}

std::vector<vtkIdType> CellOf(vtkCellArray* cells, vtkIdType cell)
{
  vtkIdType count = 0;
  const vtkIdType* corners = nullptr;
  cells->GetCellAtId(cell, count, corners);
  return std::vector<vtkIdType>(corners, corners + count);
}

const std::string Vertices = "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
const std::string Faces = "element face 1\nproperty list uchar int vertex_indices\n";
const std::string Places = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

std::string Ascii(const std::string& elements, const std::string& body)
{
  return "ply\nformat ascii 1.0\n" + elements + "end_header\n" + body;
}
}

//------------------------------------------------------------------------------
TEST(PlyReader, AllPropertiesOfAVertexArrive)
{
  vtkNew<vtkPolyData> mesh;
  const std::string text =
    Ascii("comment all of them\nelement vertex 3\nproperty double x\nproperty float32 y\nproperty int z\n"
          "property float nx\nproperty float ny\nproperty float nz\nproperty uchar red\nproperty uint8 green\n"
          "property uchar blue\nproperty uchar alpha\nproperty float u\nproperty float v\nproperty short label\n"
          "property list uchar int neighbours\nproperty double quality\n" +
        Faces,
      "0.1 0 0  0 0 1  255 0 1 128  0.5 0.25  -7 0 1e-3\n"
      "1 0 2  0 1 0  2 3 4 255  1 0  8 2 5 6 +2.5\n"
      "\n"
      "0 1 -3  1 0 0  5 6 7 0  0 1  9 1 1 nan\n"
      "3 0 1 2\n");
  ASSERT_EQ(Read(text, mesh), "");
  ASSERT_EQ(mesh->GetNumberOfPoints(), 3);
  EXPECT_EQ(mesh->GetPoints()->GetDataType(), VTK_DOUBLE);
  EXPECT_EQ(mesh->GetPoint(0)[0], 0.1);
  EXPECT_EQ(mesh->GetPoint(2)[2], -3.0);
  vtkPointData* data = mesh->GetPointData();
  ASSERT_NE(data->GetNormals(), nullptr);
  EXPECT_EQ(data->GetNormals()->GetComponent(1, 1), 1.0);
  ASSERT_NE(data->GetScalars(), nullptr);
  EXPECT_STREQ(data->GetScalars()->GetName(), "RGBA");
  EXPECT_EQ(data->GetScalars()->GetDataType(), VTK_UNSIGNED_CHAR);
  EXPECT_EQ(data->GetScalars()->GetComponent(0, 3), 128.0);
  ASSERT_NE(data->GetTCoords(), nullptr);
  EXPECT_EQ(data->GetTCoords()->GetComponent(0, 1), 0.25);
  ASSERT_NE(data->GetArray("label"), nullptr);
  EXPECT_EQ(data->GetArray("label")->GetDataType(), VTK_SHORT);
  EXPECT_EQ(data->GetArray("label")->GetTuple1(0), -7.0);
  EXPECT_EQ(data->GetArray("quality")->GetDataType(), VTK_DOUBLE);
  EXPECT_EQ(data->GetArray("quality")->GetTuple1(1), 2.5);
  EXPECT_TRUE(std::isnan(data->GetArray("quality")->GetTuple1(2)));
  EXPECT_EQ(data->GetNumberOfArrays(), 5);
  EXPECT_EQ(CellOf(mesh->GetPolys(), 0), (std::vector<vtkIdType>{ 0, 1, 2 }));
}

TEST(PlyReader, BinaryOfBothByteOrdersIsReadAlike)
{
  for (const bool big : { false, true })
  {
    Body body(std::string("ply\r\nformat binary_") + (big ? "big" : "little") +
        "_endian 1.0\r\nelement camera 1\r\nproperty float f\r\nproperty list int double m\r\nelement vertex "
        "4\r\nproperty ushort id\r\n"
        "property float x\r\nproperty float y\r\nproperty float z\r\nproperty double w\r\nelement face 2\r\nproperty "
        "uchar flag\r\n"
        "property list uint ushort vertex_index\r\nproperty uint part\r\nend_header\r\n",
      big);
    body.Put(1.0f).Put(std::int32_t(2)).Put(1.0).Put(2.0);
    for (int i = 0; i < 4; ++i)
    {
      body.Put(std::uint16_t(60000 + i)).Put(0.1f * static_cast<float>(i)).Put(1.0f).Put(-2.0f).Put(1e100 * i);
    }
    body.Put(std::uint8_t(1)).Put(std::uint32_t(4));
    for (const int corner : { 0, 1, 2, 3 })
    {
      body.Put(static_cast<std::uint16_t>(corner));
    }
    body.Put(std::uint32_t(4000000000u));
    body.Put(std::uint8_t(2)).Put(std::uint32_t(3));
    for (const int corner : { 3, 2, 1 })
    {
      body.Put(static_cast<std::uint16_t>(corner));
    }
    body.Put(std::uint32_t(7));
    vtkNew<vtkPolyData> mesh;
    ASSERT_EQ(Read(body.Bytes, mesh), "");
    EXPECT_EQ(mesh->GetNumberOfPoints(), 4);
    EXPECT_EQ(static_cast<float>(mesh->GetPoint(3)[0]), 0.1f * 3.0f);
    EXPECT_EQ(mesh->GetPointData()->GetArray("id")->GetTuple1(3), 60003.0);
    EXPECT_EQ(mesh->GetPointData()->GetArray("w")->GetTuple1(2), 2e100);
    EXPECT_EQ(mesh->GetNumberOfPolys(), 2);
    EXPECT_EQ(CellOf(mesh->GetPolys(), 0), (std::vector<vtkIdType>{ 0, 1, 2, 3 }));
    EXPECT_EQ(mesh->GetCellData()->GetArray("part")->GetTuple1(0), 4000000000.0);
    EXPECT_EQ(mesh->GetCellData()->GetArray("flag")->GetTuple1(1), 2.0);
  }
}

TEST(PlyReader, FaceColorsBecomeCellScalars)
{
  vtkNew<vtkPolyData> mesh;
  ASSERT_EQ(Read(Ascii(Vertices + Faces + "property uchar red\nproperty uchar green\nproperty uchar blue\n",
                   Places + "4 0 1 2 3 9 8 7\n"),
              mesh),
    "");
  ASSERT_NE(mesh->GetCellData()->GetScalars(), nullptr);
  EXPECT_STREQ(mesh->GetCellData()->GetScalars()->GetName(), "RGB");
  EXPECT_EQ(mesh->GetCellData()->GetScalars()->GetComponent(0, 2), 7.0);
}

TEST(PlyReader, TextureCoordinatesOfCornersSplitOnlyThePointsOfSeams)
{
  vtkNew<vtkPolyData> mesh;
  const std::string text = Ascii(Vertices +
      "property uchar mark\nelement face 3\nproperty list uchar int vertex_indices\nproperty list uchar float "
      "texcoord\nproperty int texnumber\n",
    "0 0 0 10\n1 0 0 11\n1 1 0 12\n0 1 0 13\n"
    "3 0 1 2 6 0 0 1 0 1 1 0\n"
    "3 0 2 3 6 0 0 0.5 1 0 1 1\n"
    "3 3 2 1 0 2\n");
  ASSERT_EQ(Read(text, mesh), "");
  // Point 2 has (1, 1), (0.5, 1) and, in the face without coordinates, (0, 0); 1 and 3 have two.
  EXPECT_EQ(mesh->GetNumberOfPoints(), 8);
  const std::vector<vtkIdType> second = CellOf(mesh->GetPolys(), 1);
  EXPECT_EQ(second[0], 0);
  EXPECT_EQ(second[1], 4);
  EXPECT_EQ(second[2], 3);
  vtkDataArray* coordinates = mesh->GetPointData()->GetTCoords();
  ASSERT_NE(coordinates, nullptr);
  EXPECT_EQ(coordinates->GetComponent(4, 0), 0.5);
  EXPECT_EQ(mesh->GetPointData()->GetArray("mark")->GetTuple1(4), 12.0);
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_EQ(mesh->GetPoint(4)[i], mesh->GetPoint(2)[i]);
  }
  EXPECT_EQ(mesh->GetCellData()->GetArray("texnumber")->GetTuple1(2), 2.0);
}

TEST(PlyReader, StripsArriveAsStripsAndTheirCellsHaveValues)
{
  vtkNew<vtkPolyData> mesh;
  const std::string text =
    Ascii(Vertices + Faces + "property int part\nelement tristrips 1\nproperty list int int vertex_indices\n",
      Places + "3 0 1 2 5\n9 0 1 3 2 -1 1 2 3 -1\n");
  ASSERT_EQ(Read(text, mesh), "");
  EXPECT_EQ(mesh->GetNumberOfPolys(), 1);
  EXPECT_EQ(mesh->GetNumberOfStrips(), 2);
  EXPECT_EQ(CellOf(mesh->GetStrips(), 0), (std::vector<vtkIdType>{ 0, 1, 3, 2 }));
  vtkDataArray* part = mesh->GetCellData()->GetArray("part");
  ASSERT_EQ(part->GetNumberOfTuples(), 3);
  EXPECT_EQ(part->GetTuple1(0), 5.0);
  EXPECT_EQ(part->GetTuple1(2), 0.0);
}

TEST(PlyReader, NamesThatCollideKeepTheirValues)
{
  vtkNew<vtkPolyData> mesh;
  const std::string text =
    Ascii("element vertex 1\nproperty float x\nproperty float y\nproperty float z\nproperty float nx\n"
          "property float ny\nproperty float nz\nproperty int Normals\nproperty uchar TCoords\n",
      "1 2 3 0 0 1 77 8\n");
  ASSERT_EQ(Read(text, mesh), "");
  EXPECT_EQ(mesh->GetPointData()->GetNormals()->GetComponent(0, 2), 1.0);
  EXPECT_EQ(mesh->GetPointData()->GetArray("Normals_")->GetTuple1(0), 77.0);
}

TEST(PlyReader, MacLinesAndMissingLastLineEndAreRead)
{
  std::string text = Ascii(Vertices + Faces, Places + "4 0 1 2 3");
  vtkNew<vtkPolyData> mesh;
  EXPECT_EQ(Read(text, mesh), "");
  std::replace(text.begin(), text.end(), '\n', '\r');
  EXPECT_EQ(Read(text, mesh), "");
  EXPECT_EQ(mesh->GetNumberOfPolys(), 1);
}

TEST(PlyReader, TinyNumbersAreZeroAndHugeOnesAreNone)
{
  vtkNew<vtkPolyData> mesh;
  EXPECT_EQ(Read(Ascii(Vertices, "1e-60 -1e-400 0\n1 0 0\n1 1 0\n0 1 0\n"), mesh), "");
  EXPECT_EQ(mesh->GetPoint(0)[0], 0.0);
  EXPECT_EQ(Read(Ascii(Vertices, "1e60 0 0\n1 0 0\n1 1 0\n0 1 0\n"), mesh), "");
  EXPECT_TRUE(std::isnan(mesh->GetPoint(0)[0]));
}

//------------------------------------------------------------------------------
TEST(PlyReader, ErrorsNameElementRowAndReason)
{
  const std::vector<std::pair<std::string, std::string>> cases = { { "", "empty" }, { "plx\n", "ply" },
    { "ply\n", "header" }, { "ply\nformat ascii 2.0\nend_header\n", "format" }, { "ply\nend_header\n", "no format" },
    { "ply\nformat ascii 1.0\nformat ascii 1.0\nend_header\n", "second format" },
    { Ascii("element vertex -4\n", ""), "impossible count" }, { Ascii("element vertex 4x\n", ""), "impossible count" },
    { Ascii("element vertex 99999999999999999999\n", ""), "impossible count" },
    { Ascii(Vertices + Vertices, Places), "comes twice" },
    { Ascii("property float x\n", ""), "before the first element" },
    { Ascii("element vertex 1\nproperty quark x\n", ""), "quark" },
    { Ascii("element vertex 1\nproperty list float int x\n", ""), "count of type" },
    { Ascii("element vertex 1\nproperty float x\nproperty float x\n", ""), "no property y" },
    { Ascii("nonsense\n", ""), "no element vertex" }, { Ascii("element face 0\n", ""), "no element vertex" },
    { Ascii("element vertex 1\nproperty float x\nproperty float y\n", "0 0\n"), "no property z" },
    { Ascii(Vertices + "element face 1\nproperty int a\n", Places + "1\n"), "vertex_indices" },
    { Ascii(Vertices + "element face 1\nproperty list uchar float vertex_indices\n", Places + "3 0 1 2\n"),
      "vertex_indices" },
    { Ascii("element vertex 4000000000\nproperty float x\nproperty float y\nproperty float z\n", Places), "announces" },
    { Ascii(Vertices, "0 0 0\n1 0 0\n1 1 0\n"), "announces" },
    // The file ends in the record that is bad.
    { Ascii(Vertices, "0.0 0 0\n1 0 0\n1 1 0\n0 1"), "row 4" },
    { Ascii(Vertices, "0 0 0\n1 0 0\n1 1 0\n0 a 0"), "\"a\"" },
    { Ascii(Vertices + Faces, Places + "-3 0 1 2"), "\"-3\"" },
    { Ascii(Vertices + Faces, Places + "200 0 1 2"), "impossible count 200" },
    { Ascii(Vertices + Faces, Places + "3 0 1"), "element face, row 1" },
    { Ascii(Vertices + Faces, Places + "3 0 1 1.5"), "1.5" },
    { Ascii(Vertices + Faces, Places + "3 0 1 2\n3 0 2 3\n"), "after the last element" } };
  for (const auto& test : cases)
  {
    const std::string error = ErrorOf(test.first);
    EXPECT_NE(error.find(test.second), std::string::npos) << test.first << "-> " << error;
  }
}

TEST(PlyReader, HugeCountsOfListsAreRefusedWithoutAllocation)
{
  for (const bool big : { false, true })
  {
    Body body(std::string("ply\nformat binary_") + (big ? "big" : "little") +
        "_endian 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
        "property list int int vertex_indices\nend_header\n",
      big);
    body.Put(0.0f).Put(0.0f).Put(0.0f);
    for (const std::int32_t count : { 0x7fffffff, -1, 2 })
    {
      Body whole = body;
      whole.Put(count).Put(std::int32_t(0));
      vtkNew<vtkPolyData> mesh;
      EXPECT_NE(Read(whole.Bytes, mesh).find("impossible count"), std::string::npos) << count;
    }
  }
}

// What is truncated is never taken for the whole, and what is changed does no harm.
TEST(PlyReader, CutAndChangedFilesAreSurvived)
{
  const std::string elements =
    "element vertex 4\nproperty float x\nproperty double y\nproperty float z\nproperty uchar red\nproperty uchar "
    "green\nproperty uchar blue\nelement extra 1\nproperty list short uint junk\nelement face 2\nproperty list "
    "uchar int vertex_indices\nproperty list uchar float texcoord\nproperty short part\nelement tristrips 1\n"
    "property list int int vertex_indices\n";
  Body little("ply\nformat binary_little_endian 1.0\n" + elements + "end_header\n");
  Body big("ply\nformat binary_big_endian 1.0\n" + elements + "end_header\n", true);
  for (Body* body : { &little, &big })
  {
    for (int i = 0; i < 4; ++i)
    {
      body->Put(static_cast<float>(i))
        .Put(2.0 * i)
        .Put(1.0f)
        .Put(std::uint8_t(1))
        .Put(std::uint8_t(2))
        .Put(std::uint8_t(3));
    }
    body->Put(std::int16_t(2)).Put(std::uint32_t(1)).Put(std::uint32_t(2));
    for (int face = 0; face < 2; ++face)
    {
      body->Put(std::uint8_t(3)).Put(std::int32_t(face)).Put(std::int32_t(face + 1)).Put(std::int32_t(face + 2));
      body->Put(std::uint8_t(6));
      for (int i = 0; i < 6; ++i)
      {
        body->Put(0.1f * static_cast<float>(i + face));
      }
      body->Put(std::int16_t(face));
    }
    body->Put(std::int32_t(4)).Put(std::int32_t(0)).Put(std::int32_t(1)).Put(std::int32_t(2)).Put(std::int32_t(3));
  }
  const std::string text = Ascii(elements,
    "0 0 1 1 2 3\n1 2 1 1 2 3\n2 4 1 1 2 3\n3 6 1 1 2 3\n2 1 2\n3 0 1 2 6 0 0 1 0 1 1 0\n3 1 2 3 6 0 0 1 0 1 1 1\n4 0 "
    "1 2 3\n");
  MTTestMeshes::Random random(4);
  for (const Bytes& good : { little.Bytes, big.Bytes, Bytes(text.begin(), text.end()) })
  {
    vtkNew<vtkPolyData> mesh;
    ASSERT_EQ(Read(good, mesh), "");
    const bool isText = good[11] == 'a';
    for (std::size_t length = 0; length + (isText ? 2 : 0) < good.size(); ++length)
    {
      EXPECT_NE(Read(Bytes(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(length)), mesh), "") << length;
    }
    std::size_t refused = 0;
    constexpr int attempts = 20000;
    for (int i = 0; i < attempts; ++i)
    {
      Bytes bytes = good;
      for (std::size_t j = 0; j <= random.Below(3); ++j)
      {
        bytes[random.Below(bytes.size())] = static_cast<unsigned char>(random.Below(256));
      }
      refused += !Read(bytes, mesh).empty();
      for (vtkIdType cell = 0; cell < mesh->GetNumberOfPolys(); ++cell)
      {
        for (const vtkIdType corner : CellOf(mesh->GetPolys(), cell))
        {
          ASSERT_LT(corner, mesh->GetNumberOfPoints());
        }
      }
    }
    std::cout << (isText ? "text" : "binary") << ": " << refused << " of " << attempts << " refused\n";
  }
}
