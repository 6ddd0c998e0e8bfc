// SPDX-License-Identifier: BSD-3-Clause
// Mesh files as people have them: what is a little wrong is read and counted, colours and names are kept, and all of it
// is the same whether a file is read whole or streamed.
#include "MTIOTest.h"
#include "MTTestMeshes.h"

#include "vtkMTGzipByteSource.h"
#include "vtkMTMemoryByteSource.h"
#include "vtkMTMemorySpoolStore.h"
#include "vtkMTMeshReader.h"
#include "vtkMTMeshStream.h"
#include "vtkMTMeshWriter.h"
#include "vtkMTPolyDataStream.h"

#include "vtkCellData.h"
#include "vtkInformation.h"
#include "vtkLookupTable.h"
#include "vtkMassProperties.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTriangleFilter.h"
#include "vtkUnstructuredGrid.h"
#include "vtkUnstructuredGridWriter.h"
#include "vtkXMLMultiBlockDataWriter.h"
#include "vtkXMLUnstructuredGridWriter.h"

#include <cstring>
#include <functional>
#include <map>

#include <zlib.h>

using namespace MTIOTest;

namespace
{
using Counts = std::map<std::string, std::int64_t>;

// The corners of a unit cube and its twelve triangles, outwards.
constexpr int Corners[8][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 },
  { 1, 1, 1 }, { 0, 1, 1 } };
constexpr int Triangles[12][3] = { { 0, 2, 1 }, { 0, 3, 2 }, { 4, 5, 6 }, { 4, 6, 7 }, { 0, 1, 5 }, { 0, 5, 4 },
  { 1, 2, 6 }, { 1, 6, 5 }, { 2, 3, 7 }, { 2, 7, 6 }, { 3, 0, 4 }, { 3, 4, 7 } };

// The same through a stream: points, triangles, arrays and what is counted.
void ExpectStreamedAlike(const std::string& path, vtkPolyData* mesh, const Counts& counts)
{
  vtkMTMemorySpoolStore store;
  vtkMTMeshStream::Settings settings;
  settings.Store = &store;
  settings.Memory = 0;
  const vtkNew<vtkPolyData> names;
  const auto streamed = vtkMTMeshStream::Open(path, settings, names);
  ASSERT_TRUE(streamed) << path;
  vtkMTPolyDataStream whole(mesh);
  Counts expected = whole.GetReport();
  for (const auto& [reason, count] : counts)
  {
    expected[reason] += count;
  }
  EXPECT_EQ(streamed->GetReport(), expected) << path;
  ASSERT_EQ(streamed->GetArrays(), whole.GetArrays()) << path;
  vtkMTTriangleStream::PointBlock points[2];
  vtkMTTriangleStream::TriangleBlock triangles[2];
  ASSERT_TRUE(streamed->NextPoints(points[0]) && whole.NextPoints(points[1]));
  ASSERT_TRUE(streamed->NextTriangles(triangles[0]) && whole.NextTriangles(triangles[1]));
  ASSERT_EQ(points[0].Points.size(), points[1].Points.size());
  EXPECT_EQ(
    std::memcmp(points[0].Points.data(), points[1].Points.data(), points[0].Points.size() * sizeof(double[3])), 0);
  EXPECT_TRUE(points[0].Columns == points[1].Columns && triangles[0].Columns == triangles[1].Columns) << path;
  EXPECT_TRUE(triangles[0].Triangles == triangles[1].Triangles) << path;
}

// Reads whole, and compares with the stream where there is one (isStreamed).
Counts Read(const std::string& path, vtkPolyData* mesh, bool isStreamed = true)
{
  Counts counts;
  std::string error;
  EXPECT_TRUE(vtkMTMeshReader::Read(path, mesh, error, &counts)) << error;
  if (isStreamed && error.empty())
  {
    ExpectStreamedAlike(path, mesh, counts);
  }
  return counts;
}

std::string ErrorOf(const std::string& path)
{
  const vtkNew<vtkPolyData> mesh;
  std::string error;
  EXPECT_FALSE(vtkMTMeshReader::Read(path, mesh, error)) << path;
  return error;
}

double GetVolume(vtkPolyData* mesh)
{
  double sum = 0.0;
  vtkMTPolyDataStream stream(mesh);
  vtkMTTriangleStream::PointBlock points;
  vtkMTTriangleStream::TriangleBlock triangles;
  EXPECT_TRUE(stream.NextPoints(points) && stream.NextTriangles(triangles));
  for (const auto& t : triangles.Triangles)
  {
    const auto& a = points.Points[t[0]];
    const auto& b = points.Points[t[1]];
    const auto& c = points.Points[t[2]];
    sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return sum / 6.0;
}

// header: what comes after the first two lines and before the places; values: of a vertex, after its place.
std::string MakePly(
  const std::string& header, const std::string& properties,
  const std::function<std::string(int)>& values = [](int) { return ""; })
{
  std::string text = "ply\nformat ascii 1.0\n" + header +
    "element vertex 8\nproperty float x\nproperty float y\nproperty float z\n" + properties +
    "element face 12\nproperty list uchar int vertex_indices\nend_header\n";
  for (int i = 0; i < 8; ++i)
  {
    text += std::to_string(Corners[i][0]) + " " + std::to_string(Corners[i][1]) + " " + std::to_string(Corners[i][2]) +
      " " + values(i) + "\n";
  }
  for (const auto& t : Triangles)
  {
    text += "3 " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]) + "\n";
  }
  return text;
}

std::string MakeChannels(const std::string& type, const std::string& prefix = "", bool withAlpha = false)
{
  std::string text;
  for (const char* channel : { "red", "green", "blue", "alpha" })
  {
    text += withAlpha || std::strcmp(channel, "alpha") != 0 ? "property " + type + " " + prefix + channel + "\n" : "";
  }
  return text;
}

void ExpectColor(vtkDataArray* colors, vtkIdType i, const std::vector<double>& expected)
{
  ASSERT_NE(colors, nullptr);
  EXPECT_EQ(colors->GetDataType(), VTK_UNSIGNED_CHAR);
  ASSERT_EQ(colors->GetNumberOfComponents(), static_cast<int>(expected.size()));
  for (int c = 0; c < colors->GetNumberOfComponents(); ++c)
  {
    EXPECT_EQ(colors->GetComponent(i, c), expected[static_cast<std::size_t>(c)]) << "channel " << c;
  }
}

// Solids are triangles first ... last.
std::string MakeStl(const std::string& name, int first, int last)
{
  std::string text = "solid " + name + "\n";
  for (int t = first; t < last; ++t)
  {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const int corner : Triangles[t])
    {
      const int* x = Corners[corner];
      text += "vertex " + std::to_string(x[0]) + " " + std::to_string(x[1]) + " " + std::to_string(x[2]) + "\n";
    }
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid " + name + "\n";
}

Bytes MakeBinaryStl(const std::string& head, std::uint32_t count, const std::function<std::uint16_t(int)>& attribute)
{
  Bytes bytes(80, 0);
  std::copy(head.begin(), head.end(), bytes.begin());
  const auto put = [&bytes](const void* from, std::size_t size)
  {
    const auto* values = static_cast<const unsigned char*>(from);
    bytes.insert(bytes.end(), values, values + size);
  };
  put(&count, 4);
  for (int t = 0; t < 12; ++t)
  {
    float values[12] = {};
    for (int c = 0; c < 9; ++c)
    {
      values[3 + c] = static_cast<float>(Corners[Triangles[t][c / 3]][c % 3]);
    }
    put(values, sizeof(values));
    const std::uint16_t word = attribute(t);
    put(&word, 2);
  }
  return bytes;
}

std::string Replace(std::string text, const std::string& from, const std::string& to)
{
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
  {
    text.replace(at, from.size(), to);
  }
  return text;
}

void WriteGzip(const std::string& path, const Bytes& bytes)
{
  gzFile file = gzopen(path.c_str(), "wb");
  ASSERT_NE(file, nullptr);
  EXPECT_EQ(gzwrite(file, bytes.data(), static_cast<unsigned>(bytes.size())), static_cast<int>(bytes.size()));
  gzclose(file);
}
}

//------------------------------------------------------------------------------
// PLY
TEST(MeshQuirks, HeaderLinesWithoutKeywordAndByteOrderMarksAreSteppedOver)
{
  const Folder folder;
  const vtkNew<vtkPolyData> mesh;
  WriteFile(folder / "a.ply", MakePly("Created by a program\nobj_info one\ncomment two\n\n", ""));
  EXPECT_EQ(Read(folder / "a.ply", mesh), (Counts{ { "ignored_header_lines", 1 } }));
  EXPECT_DOUBLE_EQ(GetVolume(mesh), 1.0);
  WriteFile(folder / "b.ply", "\xEF\xBB\xBF" + MakePly("", ""));
  EXPECT_EQ(Read(folder / "b.ply", mesh), Counts());
  EXPECT_DOUBLE_EQ(GetVolume(mesh), 1.0);
}

TEST(MeshQuirks, ANewlineAfterAHeaderOfReturnsIsDataOfABinaryFile)
{
  const Folder folder;
  std::string text =
    "ply\rformat binary_little_endian 1.0\relement vertex 3\rproperty uchar id\rproperty float x\r"
    "property float y\rproperty float z\relement face 1\rproperty list uchar int vertex_indices\rend_header\r";
  for (int i = 0; i < 3; ++i)
  {
    const float place[3] = { i == 1 ? 1.0f : 0.0f, i == 2 ? 1.0f : 0.0f, 0.0f };
    text += "\n" + std::string(reinterpret_cast<const char*>(place), sizeof(place)); // the id is 10
  }
  text += std::string("\3\0\0\0\0\1\0\0\0\2\0\0\0", 13);
  WriteFile(folder / "a.ply", text);
  const vtkNew<vtkPolyData> mesh;
  EXPECT_EQ(Read(folder / "a.ply", mesh), Counts());
  EXPECT_EQ(mesh->GetPointData()->GetArray("id")->GetTuple1(0), 10.0);
}

TEST(MeshQuirks, ColorsOfPlyOfAnyNameAndTypeBecomeBytesThatAreDrawn)
{
  struct Case
  {
    std::string Properties;
    std::string Values; // of every vertex
    std::vector<double> Color;
    bool IsScaled = true;
  };
  const std::vector<Case> cases = { { MakeChannels("uchar", "diffuse_"), "255 128 0", { 255, 128, 0 }, false },
    { MakeChannels("uchar", "", true), "1 2 3 4", { 1, 2, 3, 4 }, false },
    { MakeChannels("float", "", true), "1 0.5 0 0.25", { 255, 128, 0, 64 } },
    { MakeChannels("double"), "255 128 0", { 255, 128, 0 } },
    { MakeChannels("ushort"), "65535 32768 0", { 255, 128, 0 } },
    { MakeChannels("short", "diffuse_"), "255 7 0", { 255, 7, 0 } },
    { MakeChannels("int"), "255 128 0", { 255, 128, 0 } }, { MakeChannels("char"), "-1 127 0", { 255, 127, 0 } },
    { "property uchar r\nproperty uchar g\nproperty uchar b\n", "9 8 7", { 9, 8, 7 }, false },
    { "property uchar Red\nproperty uchar Green\nproperty uchar Blue\n", "9 8 7", { 9, 8, 7 }, false },
    { MakeChannels("uchar") + "property float alpha\n", "9 8 7 0.5", { 9, 8, 7, 128 } } };
  const Folder folder;
  for (const Case& test : cases)
  {
    WriteFile(folder / "a.ply", MakePly("", test.Properties, [&](int) { return test.Values; }));
    const vtkNew<vtkPolyData> mesh;
    const Counts counts = Read(folder / "a.ply", mesh);
    EXPECT_EQ(counts, test.IsScaled ? (Counts{ { "colors_scaled_to_bytes", 8 } }) : Counts()) << test.Properties;
    ExpectColor(mesh->GetPointData()->GetScalars(), 3, test.Color);
    EXPECT_EQ(mesh->GetPointData()->GetNumberOfArrays(), 1) << test.Properties;
  }
}

TEST(MeshQuirks, ABadRecordOfPlyNeverRefusesTheFile)
{
  const Folder folder;
  const vtkNew<vtkPolyData> mesh;
  const std::string good = MakePly("", "property float heat\n", [](int i) { return std::to_string(i); });
  WriteFile(folder / "a.ply", Replace(good, "3 4 5 6\n", "3 4 5 77\n"));
  EXPECT_EQ(Read(folder / "a.ply", mesh), (Counts{ { "bad_records", 1 } }));
  EXPECT_EQ(vtkMTPolyDataStream(mesh).GetNumberOfTriangles(), 11u);
  EXPECT_EQ(vtkMTPolyDataStream(mesh).GetReport().at("degenerate_cells"), 1);
  WriteFile(folder / "a.ply", Replace(good, "3 4 5 6\n", "3 4 5\n"));
  EXPECT_EQ(Read(folder / "a.ply", mesh), (Counts{ { "bad_records", 1 } }));
  WriteFile(folder / "a.ply", Replace(good, "1 1 1 6\n", "1 1 x 6\n"));
  EXPECT_EQ(Read(folder / "a.ply", mesh), (Counts{ { "bad_records", 1 } }));
  EXPECT_TRUE(std::isnan(mesh->GetPoint(6)[2]));
  WriteFile(folder / "a.ply", Replace(good, "1 1 1 6\n", "1 1 1.#QNAN 6\n"));
  EXPECT_EQ(Read(folder / "a.ply", mesh), Counts());
  EXPECT_TRUE(std::isnan(mesh->GetPoint(6)[2]));
  WriteFile(folder / "a.ply", Replace(good, "1 1 1 6\n", "1 1 1 6 7 8\n"));
  EXPECT_EQ(Read(folder / "a.ply", mesh), (Counts{ { "rows_with_more_values", 1 } }));
  EXPECT_DOUBLE_EQ(GetVolume(mesh), 1.0);
  // Where nearly all are bad the file is none of this kind.
  EXPECT_NE(ErrorOf((WriteFile(folder / "b.ply", Replace(good, "\n3 ", "\n3 9")), folder / "b.ply")), "");
}

//------------------------------------------------------------------------------
// STL
TEST(MeshQuirks, SpellingsOfStlAreRead)
{
  const Folder folder;
  const vtkNew<vtkPolyData> mesh;
  const std::string good = MakeStl("cube", 0, 12);
  const std::vector<std::string> texts = { "\xEF\xBB\xBF" + good, Replace(good, "\n", "\r"),
    Replace(good, "\n", "\r\n"), Replace(good, "outer loop", "OUTER LOOP"), Replace(good, "endfacet\n", "") };
  for (const std::string& text : texts)
  {
    WriteFile(folder / "a.stl", text);
    EXPECT_EQ(Read(folder / "a.stl", mesh), Counts());
    EXPECT_DOUBLE_EQ(GetVolume(mesh), 1.0) << text.substr(0, 200);
    EXPECT_EQ(mesh->GetCellData()->GetNumberOfArrays(), 0);
  }
  WriteFile(folder / "a.stl", Replace(good, "end", "end "));
  EXPECT_EQ(Read(folder / "a.stl", mesh), (Counts{ { "split_keywords", 25 } })); // 12 loops and facets, and the solid
  EXPECT_DOUBLE_EQ(GetVolume(mesh), 1.0);
  WriteFile(folder / "a.stl", Replace(good, "solid cube\n", "solid cube\ncolour 1 2 3\n"));
  EXPECT_EQ(Read(folder / "a.stl", mesh).at("ignored_lines"), 2); // "endsolid cube" has it too
  WriteFile(folder / "a.stl",
    "solid a\nfacet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\nendloop\nendfacet\nfacet\n"
    "outer loop\nvertex 0 0 0\nvertex 1 0\nendloop\nendfacet\nendsolid\n");
  const Counts counts = Read(folder / "a.stl", mesh);
  EXPECT_EQ(counts.at("facets_of_more_corners"), 1);
  EXPECT_EQ(counts.at("bad_records"), 2);
  EXPECT_EQ(mesh->GetNumberOfPolys(), 2);
}

TEST(MeshQuirks, SolidsOfStlAreCellsWithNames)
{
  const Folder folder;
  const vtkNew<vtkPolyData> mesh;
  WriteFile(folder / "text.stl", MakeStl("inlet", 0, 5) + MakeStl("the walls", 5, 12));
  Bytes binary = MakeBinaryStl("inlet", 12, [](int) { return std::uint16_t(0); });
  const Bytes second = MakeBinaryStl("the walls", 12, [](int) { return std::uint16_t(0); });
  binary.insert(binary.end(), second.begin(), second.end());
  WriteFile(folder / "binary.stl", binary);
  for (const char* name : { "text.stl", "binary.stl" })
  {
    EXPECT_EQ(Read(folder / name, mesh), Counts());
    vtkDataArray* ids = mesh->GetCellData()->GetArray("SolidIds");
    ASSERT_NE(ids, nullptr) << name;
    const vtkIdType first = name[0] == 't' ? 5 : 12;
    EXPECT_EQ(ids->GetTuple1(first - 1), 0.0);
    EXPECT_EQ(ids->GetTuple1(first), 1.0);
    ASSERT_NE(ids->GetLookupTable(), nullptr);
    EXPECT_EQ(ids->GetLookupTable()->GetAnnotation(0), "inlet");
    EXPECT_EQ(ids->GetLookupTable()->GetAnnotation(1), "the walls");
  }
}

TEST(MeshQuirks, ColorsOfStlFollowBothDialects)
{
  const Folder folder;
  const vtkNew<vtkPolyData> mesh;
  // Red, then blue, then none.
  const auto visCam = [](int t) { return std::uint16_t(t == 0 ? 0xfc00 : t == 1 ? 0x801f : 0); };
  WriteFile(folder / "a.stl", MakeBinaryStl("", 12, visCam));
  EXPECT_EQ(Read(folder / "a.stl", mesh), (Counts{ { "facets_without_color", 10 } }));
  ExpectColor(mesh->GetCellData()->GetScalars(), 0, { 255, 0, 0 });
  ExpectColor(mesh->GetCellData()->GetScalars(), 1, { 0, 0, 255 });
  ExpectColor(mesh->GetCellData()->GetScalars(), 2, { 255, 255, 255 });
  const auto magics = [](int t) { return std::uint16_t(t == 0 ? 0x001f : t == 1 ? 0x7c00 : 0x8000); };
  WriteFile(folder / "a.stl", MakeBinaryStl(std::string("x COLOR=\x0a\x14\x1e\xff", 12), 12, magics));
  EXPECT_EQ(Read(folder / "a.stl", mesh), Counts());
  ExpectColor(mesh->GetCellData()->GetScalars(), 0, { 255, 0, 0 });
  ExpectColor(mesh->GetCellData()->GetScalars(), 1, { 0, 0, 255 });
  ExpectColor(mesh->GetCellData()->GetScalars(), 2, { 10, 20, 30 });
  WriteFile(folder / "a.stl", MakeBinaryStl("", 12, [](int t) { return std::uint16_t(t == 3 ? 7 : 0); }));
  EXPECT_EQ(Read(folder / "a.stl", mesh), (Counts{ { "ignored_attributes", 1 } }));
  EXPECT_EQ(mesh->GetCellData()->GetNumberOfArrays(), 0);
}

TEST(MeshQuirks, TheSizeOfABinaryStlCountsMoreThanASmallerCount)
{
  const Folder folder;
  const vtkNew<vtkPolyData> mesh;
  for (const std::uint32_t count : { 0u, 5u, 0xffffffffu })
  {
    WriteFile(folder / "a.stl", MakeBinaryStl("solid", count, [](int) { return std::uint16_t(0); }));
    EXPECT_EQ(Read(folder / "a.stl", mesh), (Counts{ { "wrong_triangle_count", 1 } })) << count;
    EXPECT_DOUBLE_EQ(GetVolume(mesh), 1.0);
  }
  Bytes bytes = MakeBinaryStl("", 12, [](int) { return std::uint16_t(0); });
  bytes.resize(bytes.size() + 123, 0);
  WriteFile(folder / "a.stl", bytes);
  EXPECT_EQ(Read(folder / "a.stl", mesh), (Counts{ { "trailing_bytes", 123 } }));
  WriteFile(folder / "a.stl", MakeBinaryStl("", 13, [](int) { return std::uint16_t(0); }));
  EXPECT_NE(ErrorOf(folder / "a.stl").find("announces 13 triangles, but there are 12"), std::string::npos);
}

//------------------------------------------------------------------------------
// OFF
TEST(MeshQuirks, OffIsReadWithItsColorsAndNormals)
{
  const Folder folder;
  const vtkNew<vtkPolyData> mesh;
  const auto write = [&](const std::string& head, const std::string& vertex, const std::string& face)
  {
    std::string text = head + "# a comment\n8 12 0\n";
    for (const auto& x : Corners)
    {
      text += std::to_string(x[0]) + " " + std::to_string(x[1]) + " " + std::to_string(x[2]) + vertex + "\n";
    }
    for (const auto& t : Triangles)
    {
      text += "3 " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]) + face + "\n\n";
    }
    WriteFile(folder / "a.off", text);
    return Read(folder / "a.off", mesh, false);
  };
  EXPECT_EQ(write("OFF\n", "", ""), Counts());
  EXPECT_DOUBLE_EQ(GetVolume(mesh), 1.0);
  EXPECT_EQ(write("\xEF\xBB\xBFOFF ", "", " 255 128 0"), Counts());
  ExpectColor(mesh->GetCellData()->GetScalars(), 11, { 255, 128, 0 });
  EXPECT_EQ(write("COFF\n", " 9 8 7 6", " 3"), Counts());
  ExpectColor(mesh->GetPointData()->GetScalars(), 7, { 9, 8, 7, 6 });
  EXPECT_EQ(mesh->GetCellData()->GetArray("ColorIndex")->GetTuple1(5), 3.0);
  EXPECT_EQ(write("STCNOFF\n", " 0 0 1 1.0 0.5 0.0 1.0 0.25 0.75", "").at("colors_scaled_to_bytes"), 8);
  ExpectColor(mesh->GetPointData()->GetScalars(), 7, { 255, 128, 0, 255 });
  EXPECT_EQ(mesh->GetPointData()->GetNormals()->GetComponent(4, 2), 1.0);
  EXPECT_EQ(mesh->GetPointData()->GetTCoords()->GetComponent(4, 1), 0.75);
  const std::string good =
    std::string(reinterpret_cast<const char*>(ReadFile(folder / "a.off").data()), ReadFile(folder / "a.off").size());
  WriteFile(folder / "a.off", Replace(good, "3 4 5 6\n", "3 4 5 66\n"));
  EXPECT_EQ(Read(folder / "a.off", mesh, false).at("bad_records"), 1);
  WriteFile(folder / "b.off", good.substr(0, good.size() / 2));
  EXPECT_NE(ErrorOf(folder / "b.off"), "");
  WriteFile(folder / "b.off", "OFF BINARY\n");
  EXPECT_NE(ErrorOf(folder / "b.off").find("binary"), std::string::npos);
  WriteFile(folder / "b.off", "OFF\n999999999999 999999999999 0\n0 0 0\n");
  EXPECT_NE(ErrorOf(folder / "b.off").find("truncated"), std::string::npos);
}

//------------------------------------------------------------------------------
// Compression
TEST(MeshQuirks, EveryMeshFormatIsReadThroughGzip)
{
  const Folder folder;
  const MTTestMeshes::Mesh mesh = MTTestMeshes::FractalSphere(3);
  std::string error;
  for (const char* name : { "a.ply", "a.stl", "a.obj", "a.vtp", "a.glb" })
  {
    ASSERT_TRUE(vtkMTMeshWriter::Write(folder / name, mesh, error)) << error;
    const std::string compressed = folder / (std::string(name) + ".gz");
    WriteGzip(compressed, ReadFile(folder / name));
    const vtkNew<vtkPolyData> plain;
    const vtkNew<vtkPolyData> read;
    ASSERT_TRUE(vtkMTMeshReader::Read(folder / name, plain, error)) << error;
    ASSERT_TRUE(vtkMTMeshReader::Read(compressed, read, error)) << error;
    EXPECT_EQ(read->GetNumberOfPoints(), plain->GetNumberOfPoints()) << name;
    EXPECT_EQ(read->GetNumberOfPolys(), plain->GetNumberOfPolys()) << name;
    if (std::strcmp(name, "a.vtp") != 0 && std::strcmp(name, "a.glb") != 0)
    {
      ExpectStreamedAlike(compressed, plain, Counts());
    }
    Bytes damaged = ReadFile(compressed);
    damaged.resize(damaged.size() / 2);
    WriteFile(compressed, damaged);
    EXPECT_NE(ErrorOf(compressed).find("truncated"), std::string::npos) << ErrorOf(compressed);
  }
}

TEST(MeshQuirks, RangesOfAGzipFileComeInAnyOrder)
{
  const Folder folder;
  Bytes bytes(40000000);
  MTTestMeshes::Random random(3);
  for (std::size_t i = 0; i < bytes.size(); ++i)
  {
    bytes[i] = static_cast<unsigned char>(i % 251 + i / 100000 % 7);
  }
  WriteGzip(folder / "a.gz", bytes);
  Bytes twice = ReadFile(folder / "a.gz"); // two members
  const std::size_t size = twice.size();
  twice.resize(2 * size);
  std::copy_n(twice.begin(), size, twice.begin() + static_cast<std::ptrdiff_t>(size));
  WriteFile(folder / "a.gz", twice);
  std::string error;
  const auto source = vtkMTGzipByteSource::OpenFile(folder / "a.gz", error);
  ASSERT_TRUE(source) << error;
  ASSERT_EQ(source->GetSize(), 2 * bytes.size());
  for (int i = 0; i < 20; ++i)
  {
    const std::size_t from = i == 0 ? bytes.size() - 50 : random.Below(2 * bytes.size() - 1000);
    Bytes got(100 + random.Below(900));
    ASSERT_TRUE(source->Read(from, got.size(), got.data(), error)) << error;
    for (std::size_t j = 0; j < got.size(); ++j)
    {
      ASSERT_EQ(got[j], bytes[(from + j) % bytes.size()]) << from;
    }
  }
  EXPECT_FALSE(source->Read(2 * bytes.size() - 1, 2, bytes.data(), error));
}

//------------------------------------------------------------------------------
// What else ParaView opens
namespace
{
vtkSmartPointer<vtkUnstructuredGrid> MakeGrid()
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  const vtkNew<vtkPoints> points;
  for (int i = 0; i < 12; ++i)
  {
    points->InsertNextPoint(i / 4, i % 4 == 1 || i % 4 == 2 ? 1 : 0, i % 4 > 1 ? 1 : 0);
  }
  grid->SetPoints(points);
  for (vtkIdType first : { 0, 4 })
  {
    const vtkIdType corners[8] = { first, first + 1, first + 2, first + 3, first + 4, first + 5, first + 6, first + 7 };
    grid->InsertNextCell(VTK_HEXAHEDRON, 8, corners);
  }
  return grid;
}
}

TEST(MeshQuirks, GridsGiveTheirSurfacesAndBlocksTheirNames)
{
  const Folder folder;
  const auto grid = MakeGrid();
  const vtkNew<vtkXMLUnstructuredGridWriter> xml;
  xml->SetInputData(grid);
  xml->SetFileName((folder / "a.vtu").c_str());
  ASSERT_EQ(xml->Write(), 1);
  for (const int type : { VTK_ASCII, VTK_BINARY })
  {
    const vtkNew<vtkUnstructuredGridWriter> legacy;
    legacy->SetInputData(grid);
    legacy->SetFileType(type);
    legacy->SetFileName((folder / (type == VTK_ASCII ? "text.vtk" : "binary.vtk")).c_str());
    ASSERT_EQ(legacy->Write(), 1);
  }
  WriteGzip(folder / "b.vtu.gz", ReadFile(folder / "a.vtu"));
  WriteGzip(folder / "b.vtk.gz", ReadFile(folder / "binary.vtk"));
  for (const char* name : { "a.vtu", "text.vtk", "binary.vtk", "b.vtu.gz", "b.vtk.gz" })
  {
    const vtkNew<vtkPolyData> mesh;
    EXPECT_EQ(Read(folder / name, mesh, false), (Counts{ { "surfaces_of_grids", 1 } })) << name;
    EXPECT_EQ(mesh->GetNumberOfPolys(), 10) << name; // not the face between the two
    EXPECT_NEAR(GetVolume(mesh), 2.0, 1e-12) << name;
  }
  const vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, grid);
  blocks->SetBlock(1, MTTestMeshes::Icosphere(1));
  blocks->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), "beam");
  blocks->GetMetaData(1u)->Set(vtkCompositeDataSet::NAME(), "ball");
  const vtkNew<vtkXMLMultiBlockDataWriter> writer;
  writer->SetInputData(blocks);
  writer->SetFileName((folder / "blocks.vtm").c_str());
  ASSERT_EQ(writer->Write(), 1);
  const vtkNew<vtkPolyData> mesh;
  Read(folder / "blocks.vtm", mesh, false);
  vtkDataArray* parts = mesh->GetCellData()->GetArray("PartId");
  ASSERT_NE(parts, nullptr);
  EXPECT_EQ(parts->GetTuple1(9), 0.0);
  EXPECT_EQ(parts->GetTuple1(10), 1.0);
  ASSERT_NE(parts->GetLookupTable(), nullptr);
  EXPECT_EQ(parts->GetLookupTable()->GetAnnotation(1), "ball");
}

TEST(MeshQuirks, GridsThatAreUnsoundAreRefused)
{
  const Folder folder;
  const std::string head = "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n"
                           "0 0 0 1 0 0 0 1 0 0 0 1\n";
  WriteFile(folder / "a.vtk", head + "CELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n10\n"); // a tetrahedron of three points
  EXPECT_NE(ErrorOf(folder / "a.vtk").find("points of a cell of its type"), std::string::npos);
  WriteFile(folder / "a.vtk", head + "CELLS 1 5\n4 0 1 2 9\nCELL_TYPES 1\n10\n");
  EXPECT_NE(ErrorOf(folder / "a.vtk").find("does not exist"), std::string::npos);
  WriteFile(folder / "a.vtk", head + "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n69\n");
  EXPECT_NE(ErrorOf(folder / "a.vtk").find("type 69"), std::string::npos);
  WriteFile(folder / "a.vtk", head + "CELLS 99999999999 99999999999\n4 0 1 2 3\nCELL_TYPES 1\n10\n");
  EXPECT_NE(ErrorOf(folder / "a.vtk").find("too short"), std::string::npos);
  for (const char* type : { "PolyData", "UnstructuredGrid" })
  {
    WriteFile(folder / "a.vtp",
      std::string("<?xml version=\"1.0\"?>\n<VTKFile type=\"") + type + "\" version=\"0.1\"><" + type +
        "><Piece NumberOfPoints=\"99999999999\" NumberOfPolys=\"0\" NumberOfCells=\"1\">"
        "</Piece></" +
        type + "></VTKFile>\n");
    EXPECT_NE(ErrorOf(folder / "a.vtp").find("size does not suffice"), std::string::npos) << type;
  }
}

TEST(MeshQuirks, WhatIsNotReadIsRefusedForTheReasonThatIsTrue)
{
  const Folder folder;
  const std::string text = MakePly("", "");
  std::string utf16 = "\xFF\xFE";
  for (const char c : text)
  {
    utf16 += c;
    utf16 += '\0';
  }
  for (const char* name : { "a.ply", "a.stl", "a.obj", "a.off", "a.vtp" })
  {
    WriteFile(folder / name, utf16);
    EXPECT_NE(ErrorOf(folder / name).find("UTF-16"), std::string::npos) << name;
    WriteFile(folder / name, utf16.substr(2));
    EXPECT_NE(ErrorOf(folder / name).find("UTF-16"), std::string::npos) << name;
  }
  for (const char* name : { "a.las", "a.laz", "a.xyz", "a.pcd", "a.e57" })
  {
    WriteFile(folder / name, "1 2 3\n");
    EXPECT_NE(ErrorOf(folder / name).find("not supported yet"), std::string::npos) << name;
  }
  WriteFile(folder / "cloud", "LASF and so on");
  EXPECT_NE(ErrorOf(folder / "cloud").find("not supported yet"), std::string::npos);
}
