// SPDX-License-Identifier: BSD-3-Clause
// Tiles of terrain: joined, with their voids and their places.
#include "MTIOTest.h"

#include "vtkMTTerrain.h"

#include "vtkNew.h"
#include "vtkPolyData.h"

#include <cmath>
#include <cstdio>

using namespace MTIOTest;

namespace
{
class Terrain : public testing::Test
{
protected:
  void SetUp() override
  {
    this->Folder = std::filesystem::path(MT_TEST_OUTPUT_DIRECTORY) / "Terrain" /
      testing::UnitTest::GetInstance()->current_test_info()->name();
    std::filesystem::remove_all(this->Folder);
    std::filesystem::create_directories(this->Folder);
  }
  void TearDown() override { std::filesystem::remove_all(this->Folder); }
  std::string Path(const std::string& name) const { return (this->Folder / name).string(); }

  // 11 x 11 samples; the height is a function of the place, or a void.
  void WriteSrtm(const std::string& name, int west, int south, int voidRow = -1, int voidColumn = -1) const
  {
    Bytes bytes;
    for (int row = 0; row < 11; ++row)
    {
      for (int column = 0; column < 11; ++column)
      {
        const int height = row == voidRow && column == voidColumn
          ? -32768
          : 100 * west + 10 * column + 7 * (10 * south + 10 - row) - 500;
        bytes.push_back(static_cast<unsigned char>(static_cast<std::uint16_t>(height) >> 8));
        bytes.push_back(static_cast<unsigned char>(static_cast<std::uint16_t>(height) & 0xff));
      }
    }
    WriteFile(this->Path(name), bytes);
  }

  std::filesystem::path Folder;
};

// A USGS DEM of 3 profiles of 3, 4 and 3 samples, 30 m apart, as in a turned quadrangle.
std::string MakeDem()
{
  const auto put = [](std::string& text, std::size_t at, const std::string& value)
  { text.replace(at, value.size(), value); };
  const auto real = [](double value)
  {
    char digits[32];
    std::snprintf(digits, sizeof(digits), "%24.15E", value);
    std::string text(digits);
    text[text.find('E')] = 'D';
    return text;
  };
  std::string head(1024, ' ');
  put(head, 528, "     2     2");
  const double corners[4][2] = { { 600000, 90 }, { 600000, 150 }, { 600060, 180 }, { 600060, 60 } };
  for (std::size_t i = 0; i < 4; ++i)
  {
    put(head, 546 + 48 * i, real(corners[i][0]) + real(corners[i][1]));
  }
  put(head, 816, "0.300000E+020.300000E+020.100000E+01     1     3");
  std::string text = head;
  const int first[3] = { 90, 60, 90 };
  const int counts[3] = { 3, 4, 3 };
  for (int profile = 0; profile < 3; ++profile)
  {
    std::string record(1024, ' ');
    char start[32];
    std::snprintf(start, sizeof(start), "%6d%6d%6d%6d", 1, profile + 1, counts[profile], 1);
    put(record, 0, start + real(600000 + 30 * profile) + real(first[profile]) + real(0.0));
    for (int i = 0; i < counts[profile]; ++i)
    {
      std::snprintf(start, sizeof(start), "%6d", profile == 1 && i == 3 ? -32767 : 100 + 10 * profile + i);
      put(record, 144 + 6 * static_cast<std::size_t>(i), start);
    }
    text += record;
  }
  return text;
}
}

TEST_F(Terrain, SamplesThatTilesShareAreOnePoint)
{
  this->WriteSrtm("N10E020.hgt", 20, 10);
  this->WriteSrtm("N10E021.hgt", 21, 10);
  this->WriteSrtm("N11E021.hgt", 21, 11);
  vtkMTTerrain terrain;
  std::string error;
  for (const char* name : { "N11E021.hgt", "N10E020.hgt", "N10E021.hgt" })
  {
    ASSERT_TRUE(terrain.AddTile(this->Path(name), error)) << error;
  }
  vtkNew<vtkPolyData> mesh;
  ASSERT_TRUE(terrain.Make(mesh, error)) << error;
  EXPECT_EQ(mesh->GetNumberOfPoints(), 3 * 121 - 11 - 11);
  EXPECT_EQ(mesh->GetNumberOfPolys(), 3 * 200);
  EXPECT_EQ(terrain.GetReport().at("terrain_disagreeing_samples"), 0);
  EXPECT_EQ(terrain.GetReport().at("terrain_voids"), 0);
  double bounds[6];
  mesh->GetBounds(bounds);
  const double degree = 6371008.8 * M_PI / 180.0;
  EXPECT_NEAR(bounds[3], degree, 1e-6) << "the middle is at 0";
  EXPECT_NEAR(bounds[2], -degree, 1e-6);
  EXPECT_NEAR(bounds[1], degree * std::cos(11.0 * M_PI / 180.0), 1e-6);

  terrain.Degrees = true;
  terrain.VerticalScale = 2.0;
  ASSERT_TRUE(terrain.Make(mesh, error)) << error;
  double scaled[6];
  mesh->GetBounds(scaled);
  EXPECT_DOUBLE_EQ(scaled[0], 20.0);
  EXPECT_DOUBLE_EQ(scaled[1], 22.0);
  EXPECT_DOUBLE_EQ(scaled[2], 10.0);
  EXPECT_DOUBLE_EQ(scaled[3], 12.0);
  EXPECT_DOUBLE_EQ(scaled[5], 2.0 * bounds[5]);
}

TEST_F(Terrain, VoidsAreHolesAndAreCounted)
{
  this->WriteSrtm("S01W001.hgt", -1, -1, 5, 5);
  vtkMTTerrain terrain;
  std::string error;
  ASSERT_TRUE(terrain.AddTile(this->Path("S01W001.hgt"), error)) << error;
  vtkNew<vtkPolyData> mesh;
  ASSERT_TRUE(terrain.Make(mesh, error)) << error;
  EXPECT_EQ(terrain.GetReport().at("terrain_voids"), 1);
  EXPECT_EQ(mesh->GetNumberOfPoints(), 120);
  EXPECT_EQ(mesh->GetNumberOfPolys(), 200 - 4);
}

TEST_F(Terrain, ProfilesOfADemBeginWhereTheySay)
{
  WriteFile(this->Path("quad.dem"), MakeDem());
  vtkMTTerrain terrain;
  std::string error;
  ASSERT_TRUE(terrain.AddTile(this->Path("quad.dem"), error)) << error;
  vtkNew<vtkPolyData> mesh;
  ASSERT_TRUE(terrain.Make(mesh, error)) << error;
  // Rows at 60, 90, 120, 150 and 180 m: of 15 samples 3 + 3 + 3 are there, the fourth of profile 2 is a void.
  EXPECT_EQ(mesh->GetNumberOfPoints(), 9);
  EXPECT_EQ(terrain.GetReport().at("terrain_voids"), 6);
  double bounds[6];
  mesh->GetBounds(bounds);
  EXPECT_EQ(bounds[0], 600000.0);
  EXPECT_EQ(bounds[1], 600060.0);
  EXPECT_EQ(bounds[2], 60.0);
  EXPECT_EQ(bounds[3], 150.0);
  EXPECT_EQ(bounds[4], 100.0);
  EXPECT_EQ(bounds[5], 122.0);
}

TEST_F(Terrain, ADamagedTileIsAnErrorThatNamesIt)
{
  const std::string dem = MakeDem();
  vtkMTTerrain terrain;
  std::string error;
  for (std::size_t size : { std::size_t(0), std::size_t(500), std::size_t(1024), std::size_t(1100), dem.size() - 900 })
  {
    WriteFile(this->Path("cut.dem"), dem.substr(0, size));
    EXPECT_FALSE(terrain.AddTile(this->Path("cut.dem"), error)) << size;
    EXPECT_NE(error.find("cut.dem"), std::string::npos) << error;
  }
  // Any byte of the header and of the first profile, set to something else: a terrain or an error.
  for (std::size_t at = 528; at < 1300; ++at)
  {
    std::string damaged = dem;
    damaged[at] = "9-X "[at % 4];
    WriteFile(this->Path("damaged.dem"), damaged);
    vtkMTTerrain one;
    vtkNew<vtkPolyData> mesh;
    if (one.AddTile(this->Path("damaged.dem"), error))
    {
      one.Make(mesh, error);
    }
  }
  this->WriteSrtm("nowhere.hgt", 0, 0);
  EXPECT_FALSE(terrain.AddTile(this->Path("nowhere.hgt"), error));
  EXPECT_NE(error.find("rename it"), std::string::npos) << error;
  WriteFile(this->Path("N01E001.hgt"), std::string(77, 'x'));
  EXPECT_FALSE(terrain.AddTile(this->Path("N01E001.hgt"), error));
  EXPECT_FALSE(terrain.AddTile(this->Path("N02E002.hgt"), error)) << "no such file";
  WriteFile(this->Path("N03E003.hgt.gz"), std::string("\x1f\x8b\x08\0\0\0\0\0\0\3abc", 13));
  EXPECT_FALSE(terrain.AddTile(this->Path("N03E003.hgt.gz"), error)) << "a damaged gzip stream";
  vtkNew<vtkPolyData> mesh;
  EXPECT_FALSE(terrain.Make(mesh, error)) << "no tiles";
}

TEST_F(Terrain, TilesOfAnotherGridAreRefused)
{
  this->WriteSrtm("N10E020.hgt", 20, 10);
  WriteFile(this->Path("N10E021.hgt"), Bytes(2 * 21 * 21, 0));
  vtkMTTerrain terrain;
  std::string error;
  ASSERT_TRUE(terrain.AddTile(this->Path("N10E020.hgt"), error)) << error;
  EXPECT_FALSE(terrain.AddTile(this->Path("N10E021.hgt"), error));
  EXPECT_NE(error.find("N10E020.hgt"), std::string::npos) << error;
}

TEST_F(Terrain, TilesOnBothSidesOfThe180thMeridianAreNeighbours)
{
  this->WriteSrtm("S18E179.hgt", 179, -18);
  this->WriteSrtm("S18W180.hgt", -180, -18);
  for (const bool isEastFirst : { false, true })
  {
    vtkMTTerrain terrain;
    terrain.Degrees = true;
    std::string error;
    ASSERT_TRUE(terrain.AddTile(this->Path(isEastFirst ? "S18E179.hgt" : "S18W180.hgt"), error)) << error;
    ASSERT_TRUE(terrain.AddTile(this->Path(isEastFirst ? "S18W180.hgt" : "S18E179.hgt"), error)) << error;
    vtkNew<vtkPolyData> mesh;
    ASSERT_TRUE(terrain.Make(mesh, error)) << error;
    EXPECT_EQ(mesh->GetNumberOfPoints(), 21 * 11);
    double bounds[6];
    mesh->GetBounds(bounds);
    EXPECT_NEAR(bounds[0], 179.0, 1e-9);
    EXPECT_NEAR(bounds[1], 181.0, 1e-9);
    EXPECT_EQ(terrain.GetReport().at("terrain_gap_samples"), 0);
  }
}
