// SPDX-License-Identifier: BSD-3-Clause
// Volumes of every format, and their isosurfaces.
#include "MTIOTest.h"

#include "vtkMTTriangleStream.h"
#include "vtkMTVolumeReader.h"

#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkMetaImageWriter.h"
#include "vtkNIFTIImageWriter.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStructuredPointsWriter.h"
#include "vtkXMLImageDataWriter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

using namespace MTIOTest;

namespace
{
constexpr int Size = 24;

vtkSmartPointer<vtkImageData> MakeBall()
{
  auto volume = vtkSmartPointer<vtkImageData>::New();
  volume->SetDimensions(Size, Size, Size);
  volume->AllocateScalars(VTK_FLOAT, 1);
  for (int z = 0; z < Size; ++z)
  {
    for (int y = 0; y < Size; ++y)
    {
      for (int x = 0; x < Size; ++x)
      {
        volume->SetScalarComponentFromDouble(x, y, z, 0, std::hypot(x - 11.3, y - 11.6, z - 11.2));
      }
    }
  }
  return volume;
}

template <typename Writer>
void WriteWith(const std::string& path)
{
  vtkNew<Writer> writer;
  writer->SetInputData(MakeBall());
  writer->SetFileName(path.c_str());
  writer->Write();
}

// The same samples by hand: a header in text, then the numbers.
void WriteNrrd(const std::string& path)
{
  Bytes bytes;
  const std::string head = "NRRD0004\ntype: float\ndimension: 3\nsizes: 24 24 24\nspacings: 1 1 1\nendian: little\n"
                           "encoding: raw\n\n";
  bytes.assign(head.begin(), head.end());
  const auto ball = MakeBall();
  const auto* values = static_cast<const unsigned char*>(ball->GetScalarPointer());
  bytes.insert(bytes.end(), values, values + Size * Size * Size * sizeof(float));
  WriteFile(path, bytes);
}
}

TEST(VolumeReader, EveryFormatGivesTheSameIsosurface)
{
  const std::filesystem::path folder = std::filesystem::path(MT_TEST_OUTPUT_DIRECTORY) / "Volumes";
  std::filesystem::create_directories(folder);
  WriteWith<vtkXMLImageDataWriter>((folder / "ball.vti").string());
  WriteWith<vtkStructuredPointsWriter>((folder / "ball.vtk").string());
  WriteWith<vtkMetaImageWriter>((folder / "ball.mhd").string());
  WriteWith<vtkMetaImageWriter>((folder / "ball.mha").string());
  WriteWith<vtkNIFTIImageWriter>((folder / "ball.nii.gz").string());
  WriteNrrd((folder / "ball.nrrd").string());
  for (const char* name : { "ball.vti", "ball.vtk", "ball.mhd", "ball.mha", "ball.nii.gz", "ball.nrrd" })
  {
    const std::string path = (folder / name).string();
    vtkNew<vtkPolyData> mesh;
    std::string error;
    EXPECT_TRUE(vtkMTVolumeReader::CanRead(path)) << name;
    ASSERT_TRUE(vtkMTVolumeReader::ReadIsosurface(path, 9.0, false, mesh, error)) << error;
    EXPECT_NEAR(mesh->GetLength(), 18.0 * std::sqrt(3.0), 0.3) << name;
    EXPECT_GT(mesh->GetNumberOfPolys(), 1000) << name;
    EXPECT_EQ(mesh->GetPointData()->GetNumberOfArrays(), 0) << name;
    ASSERT_TRUE(vtkMTVolumeReader::ReadIsosurface(path, 9.0, true, mesh, error)) << error;
    EXPECT_NE(mesh->GetPointData()->GetNormals(), nullptr) << name;
  }
  std::filesystem::remove_all(folder);
}

TEST(VolumeReader, WholeNumbersOfEveryTypeGiveTheIsosurfaceOfDoubles)
{
  const std::string path = std::string(MT_TEST_OUTPUT_DIRECTORY) + "/types.vti";
  const auto ball = MakeBall();
  // Each with values from one end of its type to the other, whose differences it cannot hold.
  const std::vector<std::pair<int, std::array<double, 2>>> types = { { VTK_UNSIGNED_CHAR, { 0, 255 } },
    { VTK_SHORT, { -32768, 32767 } }, { VTK_UNSIGNED_SHORT, { 0, 65535 } },
    { VTK_INT, { -2147483648.0, 2147483647.0 } }, { VTK_UNSIGNED_INT, { 0, 4294967295.0 } },
    { VTK_LONG_LONG, { -9e18, 9e18 } }, { VTK_UNSIGNED_LONG_LONG, { 0, 1.8e19 } } };
  for (const auto& [type, range] : types)
  {
    std::vector<std::array<double, 3>> points[2];
    for (const int asType : { type, VTK_DOUBLE })
    {
      vtkNew<vtkImageData> volume;
      volume->SetDimensions(Size, Size, Size);
      volume->AllocateScalars(asType, 1);
      vtkDataArray* const samples = volume->GetPointData()->GetScalars();
      for (vtkIdType i = 0; i < samples->GetNumberOfTuples(); ++i)
      {
        const double share = ball->GetPointData()->GetScalars()->GetComponent(i, 0) / 21.0;
        samples->SetComponent(i, 0, std::floor(range[0] + std::min(share, 1.0) * (range[1] - range[0])));
      }
      vtkNew<vtkXMLImageDataWriter> writer;
      writer->SetInputData(volume);
      writer->SetFileName(path.c_str());
      ASSERT_EQ(writer->Write(), 1);
      vtkNew<vtkPolyData> mesh;
      std::string error;
      ASSERT_TRUE(vtkMTVolumeReader::ReadIsosurface(path, 0.4 * range[0] + 0.6 * range[1], false, mesh, error))
        << error;
      for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
      {
        std::array<double, 3> p{};
        mesh->GetPoint(i, p.data());
        points[asType == VTK_DOUBLE].push_back(p);
      }
    }
    EXPECT_GT(points[1].size(), 1000u);
    ASSERT_EQ(points[0].size(), points[1].size()) << vtkImageScalarTypeNameMacro(type);
    double largest = 0.0;
    for (std::size_t i = 0; i < points[0].size(); ++i)
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        largest = std::max(largest, std::abs(points[0][i][c] - points[1][i][c]));
      }
    }
    std::printf(
      "%s: %zu points, largest difference %g samples\n", vtkImageScalarTypeNameMacro(type), points[0].size(), largest);
    EXPECT_LT(largest, 1e-5);
  }
  std::filesystem::remove(path);
}

TEST(VolumeReader, EmptySpaceThatLzmaPacksBelowAnOctetPerThousandSamplesIsNoDamage)
{
  constexpr int Length = 160;
  vtkNew<vtkImageData> volume;
  volume->SetDimensions(Length, Length, Length);
  volume->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  volume->GetPointData()->GetScalars()->Fill(0.0);
  volume->SetScalarComponentFromDouble(80, 80, 80, 0, 200.0);
  const std::string path = std::string(MT_TEST_OUTPUT_DIRECTORY) + "/almost_empty.vti";
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetCompressorTypeToLZMA();
  writer->SetBlockSize(1 << 22);
  writer->SetInputData(volume);
  writer->SetFileName(path.c_str());
  ASSERT_EQ(writer->Write(), 1);
  const double ratio =
    static_cast<double>(volume->GetNumberOfPoints()) / static_cast<double>(std::filesystem::file_size(path));
  std::printf("%.0f samples per byte\n", ratio);
  ASSERT_GT(ratio, 1100.0);
  vtkNew<vtkPolyData> mesh;
  std::string error;
  EXPECT_TRUE(vtkMTVolumeReader::ReadIsosurface(path, 100.0, false, mesh, error)) << error;
  EXPECT_EQ(mesh->GetNumberOfPolys(), 8);
  std::filesystem::remove(path);
}

namespace
{
using Corners = std::array<std::array<double, 3>, 3>;

std::vector<Corners> GetTriangles(vtkPolyData* mesh)
{
  std::vector<Corners> triangles(static_cast<std::size_t>(mesh->GetNumberOfPolys()));
  vtkNew<vtkIdList> points;
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    mesh->GetCellPoints(static_cast<vtkIdType>(t), points);
    for (int c = 0; c < 3; ++c)
    {
      mesh->GetPoint(points->GetId(c), triangles[t][c].data());
    }
  }
  return triangles;
}

std::vector<Corners> GetTriangles(vtkMTTriangleStream& stream)
{
  std::vector<std::array<double, 3>> points;
  vtkMTTriangleStream::PointBlock block;
  while (stream.NextPoints(block) && !block.Points.empty())
  {
    points.insert(points.end(), block.Points.begin(), block.Points.end());
  }
  EXPECT_EQ(points.size(), stream.GetNumberOfPoints());
  std::vector<Corners> triangles;
  vtkMTTriangleStream::TriangleBlock corners;
  while (stream.NextTriangles(corners) && !corners.Triangles.empty())
  {
    for (std::size_t t = 0; t < corners.Triangles.size(); ++t)
    {
      EXPECT_EQ(corners.CellIds[t], static_cast<std::int64_t>(triangles.size()));
      const auto& p = corners.Triangles[t];
      triangles.push_back({ points.at(p[0]), points.at(p[1]), points.at(p[2]) });
    }
  }
  EXPECT_EQ(triangles.size(), stream.GetNumberOfTriangles());
  return triangles;
}
}

TEST(VolumeReader, SlabsGiveTheTrianglesAndPointsOfTheWholeContour)
{
  const std::filesystem::path folder = std::filesystem::path(MT_TEST_OUTPUT_DIRECTORY) / "Slabs";
  std::filesystem::create_directories(folder);
  WriteWith<vtkXMLImageDataWriter>((folder / "ball.vti").string());
  WriteWith<vtkMetaImageWriter>((folder / "packed.mhd").string());
  WriteWith<vtkNIFTIImageWriter>((folder / "ball.nii.gz").string());
  WriteNrrd((folder / "ball.nrrd").string());
  for (const char* name : { "ball.mhd", "ball.mha" })
  {
    vtkNew<vtkMetaImageWriter> writer;
    writer->SetInputData(MakeBall());
    writer->SetCompression(false);
    writer->SetFileName((folder / name).string().c_str());
    writer->Write();
  }
  for (const char* name : { "ball.vti", "packed.mhd", "ball.mhd", "ball.mha", "ball.nii.gz", "ball.nrrd" })
  {
    const std::string path = (folder / name).string();
    vtkNew<vtkPolyData> whole;
    std::string error;
    ASSERT_TRUE(vtkMTVolumeReader::ReadIsosurface(path, 9.0, false, whole, error)) << error;
    for (const std::uint64_t slices : { 1, 5, 100 })
    {
      const auto stream = vtkMTVolumeReader::StreamIsosurface(path, 9.0, error, slices * Size * Size);
      ASSERT_NE(stream, nullptr) << error;
      EXPECT_EQ(stream->GetNumberOfPoints(), static_cast<std::uint64_t>(whole->GetNumberOfPoints())) << name;
      EXPECT_EQ(GetTriangles(*stream), GetTriangles(whole)) << name << ", slices " << slices;
      EXPECT_TRUE(stream->Rewind());
      EXPECT_EQ(GetTriangles(*stream), GetTriangles(whole)) << name << ", again";
    }
    EXPECT_EQ(vtkMTVolumeReader::StreamIsosurface(path, 900.0, error), nullptr);
    EXPECT_NE(error.find(name), std::string::npos) << error;
    EXPECT_NE(error.find("between"), std::string::npos) << error;
  }
  std::filesystem::remove_all(folder);
}

TEST(VolumeReader, WhatIsNoVolumeOrHasNoSuchSurfaceIsAnErrorThatNamesTheFile)
{
  const std::filesystem::path folder = std::filesystem::path(MT_TEST_OUTPUT_DIRECTORY) / "BadVolumes";
  std::filesystem::create_directories(folder);
  const std::string good = (folder / "ball.vti").string();
  WriteWith<vtkXMLImageDataWriter>(good);
  WriteFile((folder / "noise.mha").string(), std::string(500, 'x'));
  WriteFile((folder / "noise.nrrd").string(), std::string("NRRD0004\n") + std::string(500, 'x'));
  WriteFile((folder / "endless.nrrd").string(), std::string("NRRD0004\ntype: float\nsizes: 24 24 24"));
  WriteFile((folder / "alone.nhdr").string(),
    std::string("NRRD0004\ntype: float\ndimension: 3\nsizes: 24 24 24\nendian: little\nencoding: raw\n"
                "data file: nowhere.raw\n"));
  WriteFile((folder / "noise.nii").string(), std::string(500, 'x'));
  WriteFile((folder / "empty.vti").string(), std::string());
  WriteFile((folder / "huge.vtk").string(),
    std::string("# vtk DataFile Version 3.0\nv\nBINARY\nDATASET STRUCTURED_POINTS\nDIMENSIONS 9000 9000 9000\n"
                "ORIGIN 0 0 0\nSPACING 1 1 1\nPOINT_DATA 729000000000\nSCALARS s float\nLOOKUP_TABLE default\n"));
  vtkNew<vtkPolyData> mesh;
  std::string error;
  EXPECT_FALSE(vtkMTVolumeReader::ReadIsosurface(good, 900.0, false, mesh, error));
  EXPECT_NE(error.find("its values are between"), std::string::npos) << error;
  for (const char* name : { "noise.mha", "noise.nrrd", "endless.nrrd", "alone.nhdr", "noise.nii", "empty.vti",
         "huge.vtk", "missing.vti", "missing.mhd" })
  {
    error.clear();
    EXPECT_FALSE(vtkMTVolumeReader::ReadIsosurface((folder / name).string(), 1.0, false, mesh, error)) << name;
    EXPECT_NE(error.find(name), std::string::npos) << error;
    EXPECT_EQ(mesh->GetNumberOfPoints(), 0);
    std::printf("%s\n", error.substr(error.find(name)).c_str());
  }
  std::filesystem::remove_all(folder);
}
