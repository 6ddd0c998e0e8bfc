// SPDX-License-Identifier: BSD-3-Clause
// A file that is streamed gives the triangle stream that the whole file gives.
#include "MTIOTest.h"
#include "MTTestMeshes.h"
#include "vtkMTFractalSphere.h"
#include "vtkMTMeshReader.h"
#include "vtkMTMeshStream.h"
#include "vtkMTMeshWriter.h"
#include "vtkMTPolyDataStream.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSTLWriter.h"

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

void ExpectSameAsWhole(const std::string& path)
{
  std::string error;
  const vtkNew<vtkPolyData> mesh;
  ASSERT_TRUE(vtkMTMeshReader::Read(path, mesh, error)) << error;
  vtkMTPolyDataStream whole(mesh);
  const auto streamed = vtkMTMeshStream::Open(path);
  ASSERT_TRUE(streamed) << path;
  EXPECT_EQ(streamed->GetArrays(), whole.GetArrays());
  const Content expected = ReadAll(whole);
  for (int round = 0; round < 2; ++round)
  {
    const Content content = ReadAll(*streamed);
    EXPECT_TRUE(content.Points == expected.Points) << path;
    EXPECT_TRUE(content.Triangles == expected.Triangles) << path;
    EXPECT_EQ(content.CellIds, expected.CellIds);
    EXPECT_TRUE(content.PointColumns == expected.PointColumns) << path;
    EXPECT_TRUE(content.CellColumns == expected.CellColumns) << path;
  }
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
  vtkMTFractalSphere sphere(327680); // several pieces
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
    // Every file that is cut off is left to the reader, which says what is wrong.
    for (std::size_t size = 0; size < bytes.size(); size += 97)
    {
      WriteFile(folder / "cut.ply", Bytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)));
      EXPECT_FALSE(vtkMTMeshStream::Open(folder / "cut.ply")) << size;
    }
  }
}

TEST(MeshStream, WhatNeedsTheWholeFileIsNotStreamed)
{
  const Folder folder;
  WriteFile(folder / "quads.ply", MakeText(100, 10, "4 %d %d %d 5"));
  WriteFile(folder / "range.ply", MakeText(100, 10, "3 %d %d 1%d000"));
  WriteFile(folder / "negative.ply", MakeText(100, 10, "3 %d %d -1%d"));
  WriteFile(folder / "none.ply", MakeText(100, 0));
  WriteFile(folder / "more.ply", MakeText(100, 10) + "1 2 3\n");
  WriteFile(folder / "text.stl", std::string("solid a\nendsolid a\n"));
  for (const char* name :
    { "quads.ply", "range.ply", "negative.ply", "none.ply", "more.ply", "text.stl", "missing.ply" })
  {
    EXPECT_FALSE(vtkMTMeshStream::Open(folder / name)) << name;
  }
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
