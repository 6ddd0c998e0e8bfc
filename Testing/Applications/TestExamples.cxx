// SPDX-License-Identifier: BSD-3-Clause
// The example program that makes meshes of data: what it makes is read back and counted.
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPLYReader.h"
#include "vtkPolyData.h"
#include "vtkXMLImageDataWriter.h"
#include "vtkXMLPolyDataReader.h"

#include <gtest/gtest.h>

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace
{
constexpr int Size = 1201;

// A tile whose heights are a function of the place, so that neighbours agree on their border; gzipped.
void WriteTile(const std::string& path, int west, int south, const std::vector<std::pair<int, int>>& voids)
{
  std::vector<unsigned char> bytes;
  for (int row = 0; row < Size; ++row)
  {
    for (int column = 0; column < Size; ++column)
    {
      const double x = west + column / (Size - 1.0);
      const double y = south + 1.0 - row / (Size - 1.0);
      auto height = static_cast<std::int16_t>(std::lround(300.0 * std::sin(3.0 * x) * std::cos(2.0 * y)));
      for (const auto& [voidRow, voidColumn] : voids)
      {
        height = row == voidRow && column == voidColumn ? std::int16_t(-32768) : height;
      }
      bytes.push_back(static_cast<unsigned char>(static_cast<std::uint16_t>(height) >> 8));
      bytes.push_back(static_cast<unsigned char>(static_cast<std::uint16_t>(height) & 0xff));
    }
  }
  gzFile file = gzopen(path.c_str(), "wb1");
  ASSERT_EQ(gzwrite(file, bytes.data(), static_cast<unsigned>(bytes.size())), static_cast<int>(bytes.size()));
  gzclose(file);
}

int MakeMesh(const std::string& arguments)
{
  return std::system((std::string(MESHES_FROM_DATA) + " " + arguments + " > /dev/null 2>&1").c_str());
}

// Edges that have not exactly two triangles. (vtkFeatureEdges asks for 300 GB of memory at 6 million triangles.)
std::ptrdiff_t CountBorderEdges(vtkPolyData* mesh)
{
  std::vector<std::pair<vtkIdType, vtkIdType>> edges;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, corners);
    for (vtkIdType i = 0; i < 3; ++i)
    {
      edges.emplace_back(std::minmax(corners->GetId(i), corners->GetId((i + 1) % 3)));
    }
  }
  std::sort(edges.begin(), edges.end());
  std::ptrdiff_t count = 0;
  for (auto first = edges.begin(); first != edges.end();)
  {
    const auto last = std::upper_bound(first, edges.end(), *first);
    count += last - first == 2 ? 0 : 1;
    first = last;
  }
  return count;
}

class MeshesFromData : public testing::Test
{
protected:
  void SetUp() override
  {
    this->Folder = std::filesystem::path(MT_TEST_OUTPUT_DIRECTORY) / "MeshesFromData";
    this->Folder /= testing::UnitTest::GetInstance()->current_test_info()->name();
    std::filesystem::remove_all(this->Folder);
    std::filesystem::create_directories(this->Folder);
  }
  void TearDown() override { std::filesystem::remove_all(this->Folder); }
  std::string Path(const std::string& name) const { return (this->Folder / name).string(); }

  std::filesystem::path Folder;
};
}

TEST_F(MeshesFromData, NeighbouringTilesBecomeOneTerrainInMetres)
{
  WriteTile(this->Path("N45E006.hgt.gz"), 6, 45, {});
  WriteTile(this->Path("N45E007.hgt.gz"), 7, 45, {});
  ASSERT_EQ(MakeMesh("terrain " + this->Path("N45E007.hgt.gz") + " " + this->Path("N45E006.hgt.gz") + " -o " +
              this->Path("out.ply")),
    0);
  vtkNew<vtkPLYReader> reader;
  reader->SetFileName(this->Path("out.ply").c_str());
  reader->Update();
  vtkPolyData* mesh = reader->GetOutput();
  const vtkIdType columns = 2 * Size - 1;
  EXPECT_EQ(mesh->GetNumberOfPoints(), columns * Size) << "the common border is there once";
  EXPECT_EQ(mesh->GetNumberOfPolys(), 2 * (columns - 1) * (Size - 1));
  EXPECT_EQ(CountBorderEdges(mesh), 2 * (columns - 1 + Size - 1));
  double bounds[6];
  mesh->GetBounds(bounds);
  EXPECT_NEAR(bounds[3] - bounds[2], 111195.0, 1.0) << "one degree of latitude";
  EXPECT_NEAR(bounds[1] - bounds[0], 2.0 * 111195.0 * std::cos(45.5 * M_PI / 180.0), 2.0);
  EXPECT_LT(bounds[5], 301.0);
}

TEST_F(MeshesFromData, VoidsAreHoles)
{
  WriteTile(this->Path("S01W001.hgt.gz"), -1, -1, { { 600, 600 }, { 0, 0 } });
  ASSERT_EQ(MakeMesh("terrain " + this->Path("S01W001.hgt.gz") + " -o " + this->Path("out.ply")), 0);
  vtkNew<vtkPLYReader> reader;
  reader->SetFileName(this->Path("out.ply").c_str());
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), Size * Size - 2);
  // A void inside takes one triangle of each of its four squares, one in a corner one.
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPolys(), 2 * (Size - 1) * (Size - 1) - 5);
}

TEST_F(MeshesFromData, AnIsosurfaceInsideItsVolumeIsClosed)
{
  vtkNew<vtkImageData> volume;
  volume->SetDimensions(40, 40, 40);
  volume->AllocateScalars(VTK_FLOAT, 1);
  for (int z = 0; z < 40; ++z)
  {
    for (int y = 0; y < 40; ++y)
    {
      for (int x = 0; x < 40; ++x)
      {
        volume->SetScalarComponentFromDouble(x, y, z, 0, std::hypot(x - 19.3, y - 19.6, z - 20.2));
      }
    }
  }
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetInputData(volume);
  writer->SetFileName(this->Path("ball.vti").c_str());
  writer->Write();
  ASSERT_EQ(MakeMesh("isosurface " + this->Path("ball.vti") + " --value 15 -o " + this->Path("out.vtp")), 0);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(this->Path("out.vtp").c_str());
  reader->Update();
  EXPECT_GT(reader->GetOutput()->GetNumberOfPolys(), 3000);
  EXPECT_EQ(CountBorderEdges(reader->GetOutput()), 0);
  EXPECT_NEAR(reader->GetOutput()->GetLength(), 30.0 * std::sqrt(3.0), 0.5);
}

TEST_F(MeshesFromData, BadInputIsAnErrorAndLeavesNoOutput)
{
  WriteTile(this->Path("nowhere.hgt.gz"), 0, 0, {});
  EXPECT_NE(MakeMesh("terrain " + this->Path("nowhere.hgt.gz") + " -o " + this->Path("out.ply")), 0)
    << "no corner in the name";
  EXPECT_NE(MakeMesh("terrain " + this->Path("N00E000.hgt") + " -o " + this->Path("out.ply")), 0) << "no such file";
  EXPECT_NE(MakeMesh("isosurface " + this->Path("no.vti") + " --value 1 -o " + this->Path("out.ply")), 0);
  EXPECT_FALSE(std::filesystem::exists(this->Path("out.ply")));
}
