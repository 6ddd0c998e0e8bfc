// SPDX-License-Identifier: BSD-3-Clause
// A file that is streamed gives the triangle stream that the whole file gives.
#include "MTIOTest.h"
#include "MTTestMeshes.h"
#include "vtkMTFractalSphere.h"
#include "vtkMTMemorySpoolStore.h"
#include "vtkMTMeshMerge.h"
#include "vtkMTMeshReader.h"
#include "vtkMTMeshStream.h"
#include "vtkMTMeshWriter.h"
#include "vtkMTPolyDataStream.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSTLWriter.h"
#include "vtkXMLPolyDataWriter.h"

#include <gtest/gtest.h>

#include <cstring>

namespace
{
using namespace MTIOTest;

// Everything that a stream says, whatever its blocks are.
struct Content
{
  std::vector<std::array<double, 3>> Points;
  std::vector<std::array<std::uint64_t, 3>> Triangles;
  std::vector<std::int64_t> CellIds;
  std::vector<vtkMTColumn> PointColumns;
  std::vector<vtkMTColumn> CellColumns;
};

void Append(std::vector<vtkMTColumn>& to, const std::vector<vtkMTColumn>& from)
{
  to.resize(from.size());
  for (std::size_t i = 0; i < from.size(); ++i)
  {
    to[i].insert(to[i].end(), from[i].begin(), from[i].end());
  }
}

Content ReadAll(vtkMTTriangleStream& stream)
{
  Content content;
  EXPECT_TRUE(stream.Rewind()) << stream.GetError();
  vtkMTTriangleStream::PointBlock points;
  while (stream.NextPoints(points) && !points.Points.empty())
  {
    content.Points.insert(content.Points.end(), points.Points.begin(), points.Points.end());
    Append(content.PointColumns, points.Columns);
  }
  vtkMTTriangleStream::TriangleBlock triangles;
  while (stream.NextTriangles(triangles) && !triangles.Triangles.empty())
  {
    content.Triangles.insert(content.Triangles.end(), triangles.Triangles.begin(), triangles.Triangles.end());
    content.CellIds.insert(content.CellIds.end(), triangles.CellIds.begin(), triangles.CellIds.end());
    Append(content.CellColumns, triangles.Columns);
  }
  EXPECT_EQ(stream.GetError(), "");
  EXPECT_EQ(content.Points.size(), stream.GetNumberOfPoints());
  EXPECT_EQ(content.Triangles.size(), stream.GetNumberOfTriangles());
  return content;
}

std::string ReadText(const std::string& path)
{
  const Bytes bytes = ReadFile(path);
  return std::string(bytes.begin(), bytes.end());
}

std::vector<std::string> GetFieldNames(vtkPolyData* mesh)
{
  std::vector<std::string> names;
  for (int i = 0; i < mesh->GetFieldData()->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = mesh->GetFieldData()->GetAbstractArray(i);
    names.emplace_back(array->GetName());
    for (vtkIdType v = 0; v < array->GetNumberOfValues(); ++v)
    {
      names.push_back(array->GetVariantValue(v).ToString());
    }
  }
  return names;
}

// report: what the reader of the whole counted, to which the triangle stream of the mesh adds.
void ExpectSame(vtkMTTriangleStream& streamed, vtkPolyData* mesh, const std::string& path,
  std::map<std::string, std::int64_t> report = {})
{
  vtkMTPolyDataStream whole(mesh);
  for (const auto& [reason, count] : whole.GetReport())
  {
    report[reason] += count;
  }
  EXPECT_EQ(streamed.GetArrays(), whole.GetArrays()) << path;
  EXPECT_EQ(streamed.GetReport(), report) << path;
  const Content expected = ReadAll(whole);
  for (int round = 0; round < 2; ++round)
  {
    const Content content = ReadAll(streamed);
    EXPECT_TRUE(content.Points == expected.Points) << path;
    EXPECT_TRUE(content.Triangles == expected.Triangles) << path;
    EXPECT_EQ(content.CellIds, expected.CellIds);
    EXPECT_TRUE(content.PointColumns == expected.PointColumns) << path;
    EXPECT_TRUE(content.CellColumns == expected.CellColumns) << path;
  }
}

// The sorts get as little memory as they take.
vtkMTMeshStream::Settings GetSettings(vtkMTSpoolStore& store)
{
  vtkMTMeshStream::Settings settings;
  settings.Store = &store;
  settings.Memory = 0;
  return settings;
}

void ExpectSameAsWhole(const std::string& path)
{
  std::string error;
  const vtkNew<vtkPolyData> mesh;
  std::map<std::string, std::int64_t> report;
  ASSERT_TRUE(vtkMTMeshReader::Read(path, mesh, error, &report)) << error;
  vtkMTMemorySpoolStore store;
  const vtkNew<vtkPolyData> names;
  const auto streamed = vtkMTMeshStream::Open(path, GetSettings(store), names);
  ASSERT_TRUE(streamed) << path;
  EXPECT_EQ(GetFieldNames(names), GetFieldNames(mesh)) << path;
  ExpectSame(*streamed, mesh, path, report);
}

// Null when they are not streamed.
std::unique_ptr<vtkMTTriangleStream> OpenAll(
  const std::vector<std::string>& paths, vtkMTSpoolStore& store, std::vector<std::uint64_t>& cells)
{
  std::vector<vtkSmartPointer<vtkPolyData>> names;
  for (std::size_t i = 0; i < paths.size(); ++i)
  {
    names.push_back(vtkSmartPointer<vtkPolyData>::New());
  }
  return vtkMTMeshStream::OpenAll(paths, GetSettings(store), names, cells);
}

void ExpectSameAsMerged(const std::vector<std::string>& paths)
{
  std::vector<vtkSmartPointer<vtkPolyData>> parts;
  std::string error;
  for (const std::string& path : paths)
  {
    parts.push_back(vtkSmartPointer<vtkPolyData>::New());
    ASSERT_TRUE(vtkMTMeshReader::Read(path, parts.back(), error)) << error;
  }
  const vtkNew<vtkPolyData> merged;
  std::map<std::string, std::int64_t> report;
  ASSERT_TRUE(vtkMTMeshMerge::Merge(parts, merged, report, error)) << error;
  vtkMTMemorySpoolStore store;
  std::vector<std::uint64_t> cells;
  const auto streamed = OpenAll(paths, store, cells);
  ASSERT_TRUE(streamed) << paths.front();
  ASSERT_EQ(cells.size(), parts.size());
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    EXPECT_EQ(cells[i], static_cast<std::uint64_t>(parts[i]->GetNumberOfCells()));
  }
  ExpectSame(*streamed, merged, paths.front());
}

// Text, with values before and after the corners.
std::string MakeText(int points, int faces, const char* format = "3 %d %d %d")
{
  std::string text = "ply\nformat ascii 1.0\ncomment by hand\nelement vertex " + std::to_string(points) +
    "\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\nproperty uchar green\nproperty uchar "
    "blue\nproperty double heat\nelement face " +
    std::to_string(faces) +
    "\nproperty int label\nproperty list uchar int vertex_indices\nproperty float area\nend_header\n";
  for (int i = 0; i < points; ++i)
  {
    text += std::to_string(i % 7) + ".25 " + std::to_string(i) + " -3e-2 " + std::to_string(i % 256) + " 7 255 " +
      std::to_string(i) + ".125\n";
  }
  for (int i = 0; i < faces; ++i)
  {
    char corners[100];
    std::snprintf(corners, sizeof(corners), format, i % points, (i + 1) % points, (7 * i + 3) % points);
    text += std::to_string(-i) + "  " + corners + " " + std::to_string(i) + ".5\n";
  }
  return text;
}
}

TEST(MeshStream, PlyAndStlGiveWhatTheWholeFileGives)
{
  const Folder folder;
  std::string error;
  vtkMTFractalSphere sphere(327680); // several blocks
  ASSERT_TRUE(vtkMTMeshWriter::WritePly(sphere, folder / "sphere.ply", error)) << error;
  ExpectSameAsWhole(folder / "sphere.ply");
  WriteFile(folder / "text.ply", MakeText(1000, 3000));
  ExpectSameAsWhole(folder / "text.ply");
  const vtkNew<vtkSTLWriter> writer;
  writer->SetFileTypeToBinary();
  writer->SetInputData(MTTestMeshes::FractalSphere(6));
  writer->SetFileName((folder / "sphere.stl").c_str());
  writer->Write();
  ExpectSameAsWhole(folder / "sphere.stl");
}

TEST(MeshStream, BinaryPlyOfBothByteOrdersWithValuesAroundTheCorners)
{
  const Folder folder;
  for (const bool isBig : { false, true })
  {
    Bytes bytes;
    const auto text = [&bytes](const std::string& line) { bytes.insert(bytes.end(), line.begin(), line.end()); };
    const auto number = [&](auto value)
    {
      unsigned char raw[sizeof(value)];
      std::memcpy(raw, &value, sizeof(value));
      isBig ? std::reverse(raw, raw + sizeof(value)) : void();
      bytes.insert(bytes.end(), raw, raw + sizeof(value));
    };
    text(std::string("ply\nformat ") + (isBig ? "binary_big_endian" : "binary_little_endian") +
      " 1.0\nelement vertex 100\nproperty double x\nproperty float y\nproperty short z\nproperty ushort id\n"
      "element face 50\nproperty uchar before\nproperty list ushort uint vertex_index\nproperty double after\n"
      "end_header\n");
    for (int i = 0; i < 100; ++i)
    {
      number(0.1 * i);
      number(static_cast<float>(i % 9));
      number(static_cast<std::int16_t>(-i));
      number(static_cast<std::uint16_t>(60000 + i));
    }
    for (int i = 0; i < 50; ++i)
    {
      number(static_cast<std::uint8_t>(i));
      number(static_cast<std::uint16_t>(3));
      for (int c = 0; c < 3; ++c)
      {
        number(static_cast<std::uint32_t>((i * 5 + 11 * c) % 100));
      }
      number(1.0 / (i + 1));
    }
    WriteFile(folder / "mesh.ply", bytes);
    ExpectSameAsWhole(folder / "mesh.ply");
    // Every file that is truncated is left to the reader, which says what is wrong.
    for (std::size_t size = 0; size < bytes.size(); size += 97)
    {
      WriteFile(folder / "cut.ply", Bytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)));
      EXPECT_FALSE(vtkMTMeshStream::Open(folder / "cut.ply")) << size;
    }
  }
}

TEST(MeshStream, PolygonsOfPlyBecomeTheTrianglesOfTheWholeFile)
{
  const Folder folder;
  WriteFile(folder / "quads.ply", MakeText(1000, 3000, "4 %d %d %d 5"));
  ExpectSameAsWhole(folder / "quads.ply");
  // Polygons of 0 to 9 corners, more than one block of them.
  std::string text = "ply\nformat ascii 1.0\ncomment TextureFile bark.png\nelement vertex 70000\nproperty float x\n"
                     "property float y\nproperty double z\nelement face 70000\nproperty list uchar int vertex_index\n"
                     "property int label\nend_header\n";
  for (int i = 0; i < 70000; ++i)
  {
    text += std::to_string(0.37 * (i % 211 * 79 % 211)) + " " + std::to_string(0.11 * (i % 307 * 41 % 307)) + " " +
      std::to_string(1e-3 * (i % 11)) + "\n";
  }
  for (int i = 0; i < 70000; ++i)
  {
    text += std::to_string(i % 10);
    for (int c = 0; c < i % 10; ++c)
    {
      text += " " + std::to_string((i * 31 + c * (i % 977)) % 70000);
    }
    text += " " + std::to_string(i) + "\n";
  }
  WriteFile(folder / "polygons.ply", text);
  ExpectSameAsWhole(folder / "polygons.ply");
}

TEST(MeshStream, TextOfStlGivesWhatTheWholeFileGives)
{
  const Folder folder;
  const vtkNew<vtkSTLWriter> writer;
  writer->SetFileTypeToASCII();
  writer->SetInputData(MTTestMeshes::FractalSphere(6));
  writer->SetFileName((folder / "sphere.stl").c_str());
  writer->Write();
  ExpectSameAsWhole(folder / "sphere.stl");
  const std::string text = ReadText(folder / "sphere.stl");
  WriteFile(folder / "cut.stl", text.substr(0, text.size() / 2));
  EXPECT_FALSE(vtkMTMeshStream::Open(folder / "cut.stl"));
}

namespace
{
// Points on a grid whose corners have coordinates and normals of their own here and there.
std::string MakeObj(int n, bool withTextures, bool withNormals, bool withColors, bool withMaterials)
{
  std::string text = withMaterials ? "mtllib some thing.mtl\nmtllib other.mtl\n" : "# plain\n";
  char line[200];
  for (int i = 0; i < n * n; ++i)
  {
    std::snprintf(line, sizeof(line), withColors ? "v %g %g %g 0.5 %g 1\n" : "v %g %g %g\n", 0.1 * (i % n),
      0.1 * (i / n), 0.01 * (i * 7919 % 13), (i % 5) / 5.0);
    text += line;
    std::snprintf(line, sizeof(line), "vt %g %g\nvn %d 0 1\n", (i % n) / 16.0, (i / n) / 16.0, i % 3);
    text += withTextures || withNormals ? line : "";
  }
  for (int i = 0; i + n + 1 < n * n; ++i)
  {
    if (i % n == n - 1)
    {
      continue;
    }
    text += withMaterials && i % 501 == 0 ? "usemtl m" + std::to_string(i % 7) + "\ng part\n" : "";
    const int corners[4] = { i, i + 1, i + n + 1, i + n };
    text += "f";
    for (int c = 0; c < (i % 4 == 0 ? 3 : 4); ++c)
    {
      const int point = corners[c] + 1;
      const int other = i % 17 == 0 ? (point * 31) % (n * n) + 1 : point;
      text += " " + std::to_string(i % 9 == 0 ? point - 1 - n * n : point);
      text += withTextures && i % 23 != 0 ? "/" + std::to_string(other) : (withNormals ? "/" : "");
      text += withNormals ? "/" + std::to_string(other) : "";
    }
    text += "\n";
    text += i % 1000 == 1 ? "l 1 2 3\n" : "";
  }
  return text;
}
}

TEST(MeshStream, ObjWithWedgesMaterialsAndPolygonsGivesWhatTheWholeFileGives)
{
  const Folder folder;
  for (int kind = 0; kind < 16; ++kind)
  {
    const int n = kind == 15 ? 270 : 60; // the largest has several blocks
    const std::string name = folder / ("grid-" + std::to_string(kind) + ".obj");
    WriteFile(name, MakeObj(n, (kind & 1) != 0, (kind & 2) != 0, (kind & 4) != 0, (kind & 8) != 0));
    ExpectSameAsWhole(name);
  }
  // Without a store or without names to tell it is not streamed; nor is a damaged one.
  vtkMTMemorySpoolStore store;
  vtkMTMeshStream::Settings settings;
  EXPECT_FALSE(vtkMTMeshStream::Open(folder / "grid-0.obj"));
  settings.Store = &store;
  EXPECT_TRUE(vtkMTMeshStream::Open(folder / "grid-0.obj", settings));
  EXPECT_FALSE(vtkMTMeshStream::Open(folder / "grid-15.obj", settings));
  settings.LeastSize = 1 << 30;
  EXPECT_FALSE(vtkMTMeshStream::Open(folder / "grid-0.obj", settings));
  settings.LeastSize = 0;
  WriteFile(folder / "range.obj", std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n"));
  WriteFile(folder / "none.obj", std::string("v 0 0 0\n"));
  EXPECT_FALSE(vtkMTMeshStream::Open(folder / "range.obj", settings));
  EXPECT_FALSE(vtkMTMeshStream::Open(folder / "none.obj", settings));
}

TEST(MeshStream, VtpOfEveryEncodingGivesWhatTheWholeFileGives)
{
  const Folder folder;
  const auto mesh = MTTestMeshes::FractalSphere(6); // two blocks of cells
  MTTestMeshes::AddArrays(mesh);
  vtkNew<vtkFloatArray> values;
  values->SetName("with components");
  values->SetNumberOfComponents(2);
  values->SetComponentName(0, "first");
  values->SetComponentName(1, "second");
  values->SetNumberOfTuples(mesh->GetNumberOfPoints());
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    values->SetTuple2(i, 0.1 * static_cast<double>(i), 1e-20 * static_cast<double>(i));
  }
  mesh->GetPointData()->AddArray(values);
  mesh->GetPointData()->SetActiveScalars("with components");
  // Some lines, a vertex and polygons, with a value for each.
  const auto mixed = vtkSmartPointer<vtkPolyData>::New();
  mixed->SetPoints(mesh->GetPoints());
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkCellArray> polys;
  vertices->InsertNextCell({ 7 });
  lines->InsertNextCell({ 1, 2, 3 });
  lines->InsertNextCell({ 5, 6 });
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("numbers");
  for (vtkIdType i = 0; i < 3; ++i)
  {
    ids->InsertNextValue(-i);
  }
  for (vtkIdType i = 0; i < 2000; ++i)
  {
    polys->InsertNextCell(3 + static_cast<int>(i % 5));
    for (vtkIdType c = 0; c < 3 + i % 5; ++c)
    {
      polys->InsertCellPoint((i * 17 + c * 29) % mixed->GetNumberOfPoints());
    }
    ids->InsertNextValue(i << 33);
  }
  mixed->SetVerts(vertices);
  mixed->SetLines(lines);
  mixed->SetPolys(polys);
  mixed->GetCellData()->AddArray(ids);
  for (int mode : { vtkXMLWriter::Ascii, vtkXMLWriter::Binary, vtkXMLWriter::Appended })
  {
    for (int compressor : { vtkXMLWriter::NONE, vtkXMLWriter::ZLIB, vtkXMLWriter::LZ4, vtkXMLWriter::LZMA })
    {
      const bool isUnused = mode == vtkXMLWriter::Ascii && compressor != vtkXMLWriter::NONE;
      const int encodings = isUnused ? 0 : (mode == vtkXMLWriter::Appended ? 2 : 1);
      for (int encoded = 0; encoded < encodings; ++encoded)
      {
        const std::string name = folder /
          ("sphere-" + std::to_string(mode) + "-" + std::to_string(compressor) + "-" + std::to_string(encoded) +
            ".vtp");
        const vtkNew<vtkXMLPolyDataWriter> writer;
        writer->SetDataMode(mode);
        writer->SetCompressorType(compressor);
        writer->SetEncodeAppendedData(encoded);
        writer->SetByteOrder(encoded ? vtkXMLWriter::BigEndian : vtkXMLWriter::LittleEndian);
        writer->SetHeaderType(encoded ? vtkXMLWriter::UInt64 : vtkXMLWriter::UInt32);
        writer->SetFileName(name.c_str());
        writer->SetInputData(mesh);
        ASSERT_TRUE(writer->Write());
        ExpectSameAsWhole(name);
        if (mode != vtkXMLWriter::Ascii) // cell values as text do not begin with those of polygons
        {
          writer->SetInputData(mixed);
          ASSERT_TRUE(writer->Write());
          ExpectSameAsWhole(name);
        }
        const std::string bytes = ReadText(name);
        WriteFile(name, bytes.substr(0, bytes.size() / 2));
        EXPECT_FALSE(vtkMTMeshStream::Open(name)) << name;
      }
    }
  }
}

TEST(MeshStream, SeveralFilesGiveWhatTheirMergedMeshGives)
{
  const Folder folder;
  std::string error;
  vtkMTFractalSphere sphere(81920); // two blocks
  ASSERT_TRUE(vtkMTMeshWriter::WritePly(sphere, folder / "sphere.ply", error)) << error;
  const vtkNew<vtkSTLWriter> writer;
  writer->SetFileTypeToBinary();
  writer->SetInputData(MTTestMeshes::FractalSphere(4));
  writer->SetFileName((folder / "small.stl").c_str());
  writer->Write();
  ExpectSameAsMerged({ folder / "sphere.ply", folder / "small.stl", folder / "sphere.ply" });
  // With arrays of points and cells, and polygons.
  WriteFile(folder / "a.ply", MakeText(1000, 3000));
  WriteFile(folder / "b.ply", MakeText(500, 70, "5 %d %d %d 4 5"));
  ExpectSameAsMerged({ folder / "a.ply", folder / "b.ply" });
}

TEST(MeshStream, FilesThatDoNotFitTogetherAreNotStreamed)
{
  const Folder folder;
  WriteFile(folder / "a.ply", MakeText(1000, 3000));
  WriteFile(folder / "none.ply", MakeText(100, 0));
  const std::string plain =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n";
  const std::string rest = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2";
  WriteFile(folder / "plain.ply", plain + "property list uchar int vertex_indices\nend_header\n" + rest + "\n");
  WriteFile(folder / "part.ply",
    plain + "property list uchar int vertex_indices\nproperty int PartId\nend_header\n" + rest + " 7\n");
  const std::vector<std::vector<std::string>> sets = { { folder / "a.ply", folder / "plain.ply" },
    { folder / "a.ply", folder / "none.ply" }, { folder / "part.ply", folder / "part.ply" },
    { folder / "plain.ply", folder / "missing.ply" } };
  for (const auto& paths : sets)
  {
    vtkMTMemorySpoolStore store;
    std::vector<std::uint64_t> cells;
    EXPECT_FALSE(OpenAll(paths, store, cells)) << paths.back();
  }
  ExpectSameAsMerged({ folder / "plain.ply", folder / "plain.ply" });
}

TEST(MeshStream, WhatNeedsTheWholeFileIsNotStreamed)
{
  const Folder folder;
  WriteFile(folder / "quads.ply", MakeText(100, 10, "4 %d %d %d 5")); // there is no room for temporary data
  WriteFile(folder / "none.ply", MakeText(100, 0));
  WriteFile(folder / "more.ply", MakeText(100, 10) + "1 2 3\n");
  WriteFile(folder / "text.stl", std::string("solid a\nendsolid a\n"));
  for (const char* name : { "quads.ply", "none.ply", "more.ply", "text.stl", "missing.ply" })
  {
    EXPECT_FALSE(vtkMTMeshStream::Open(folder / name)) << name;
  }
}

TEST(MeshStream, CornersThatDoNotExistAreStreamedToBeCounted)
{
  const Folder folder;
  WriteFile(folder / "range.ply", MakeText(100, 10, "3 %d %d 1%d000"));
  WriteFile(folder / "negative.ply", MakeText(100, 10, "3 %d %d -1%d"));
  ExpectSameAsWhole(folder / "range.ply");
  ExpectSameAsWhole(folder / "negative.ply");
}

TEST(MeshStream, FileThatChangesWhileItIsReadIsAnError)
{
  const Folder folder;
  const std::string text = MakeText(1000, 3000);
  WriteFile(folder / "mesh.ply", text);
  const auto stream = vtkMTMeshStream::Open(folder / "mesh.ply");
  ASSERT_TRUE(stream);
  WriteFile(folder / "mesh.ply", text.substr(0, text.size() / 2));
  vtkMTTriangleStream::PointBlock points;
  vtkMTTriangleStream::TriangleBlock triangles;
  bool good = stream->Rewind();
  while (good && (good = stream->NextPoints(points)) && !points.Points.empty())
  {
  }
  while (good && (good = stream->NextTriangles(triangles)) && !triangles.Triangles.empty())
  {
  }
  EXPECT_FALSE(good);
  EXPECT_NE(stream->GetError().find("mesh.ply"), std::string::npos) << stream->GetError();
}
