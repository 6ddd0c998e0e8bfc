// SPDX-License-Identifier: BSD-3-Clause
// Terrain of GeoTIFF: where samples lie, and tiles that meet, overlap or are apart. Only where GDAL is built in.
#include "MTIOTest.h"

#include "vtkMTGdalLibrary.h"
#include "vtkMTTerrain.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataConnectivityFilter.h"

#include <gdal.h>
#include <ogr_srs_api.h>

#include <map>

using namespace MTIOTest;

namespace
{
// 5 x 4 samples; the last row has a void.
struct GeoTiff
{
  const char* System = "EPSG:32610";
  double West = 0.0; // of the first sample
  double North = 0.0;
  double StepX = 30.0; // to the next sample in a row, and to the next row
  double StepY = -30.0;
  bool IsPoint = false;
  bool HasVoid = true;
  float Base = 0.0f;
  const char* Unit = nullptr;

  void Write(const std::string& path) const
  {
    GDALAllRegister();
    GDALDatasetH file = GDALCreate(GDALGetDriverByName("GTiff"), path.c_str(), 5, 4, 1, GDT_Float32, nullptr);
    double transform[6] = { this->West - 0.5 * this->StepX, this->StepX, 0.0, this->North - 0.5 * this->StepY, 0.0,
      this->StepY };
    GDALSetMetadataItem(file, "AREA_OR_POINT", this->IsPoint ? "Point" : "Area", nullptr);
    GDALSetGeoTransform(file, transform);
    OGRSpatialReferenceH reference = OSRNewSpatialReference(nullptr);
    ASSERT_EQ(OSRSetFromUserInput(reference, this->System), OGRERR_NONE);
    GDALSetSpatialRef(file, reference);
    OSRDestroySpatialReference(reference);
    float heights[20];
    for (int i = 0; i < 20; ++i)
    {
      heights[i] = i == 19 && this->HasVoid
        ? -3.4e38f
        : this->Base + 100.0f * static_cast<float>(i / 5) + static_cast<float>(i % 5);
    }
    GDALRasterBandH band = GDALGetRasterBand(file, 1);
    GDALSetRasterNoDataValue(band, -3.4e38); // no double of the samples' single precision
    GDALSetRasterUnitType(band, this->Unit ? this->Unit : "");
    ASSERT_EQ(GDALRasterIO(band, GF_Write, 0, 0, 5, 4, heights, 5, 4, GDT_Float32, 0, 0), CE_None);
    GDALClose(file);
  }
};

void WriteGeoTiff(const std::string& path, const char* system, double west, double north, double step)
{
  GeoTiff{ system, west, north, step, -step }.Write(path);
}
}

TEST(TerrainOfGeoTiff, GeoTiffLiesWhereItSays)
{
  const Folder folder;
  WriteGeoTiff(folder / "utm.tif", "EPSG:32610", 600000.0, 5000000.0, 30.0);
  vtkMTTerrain terrain;
  std::string error;
  ASSERT_TRUE(terrain.AddTile(folder / "utm.tif", error)) << error;
  vtkNew<vtkPolyData> mesh;
  ASSERT_TRUE(terrain.Make(mesh, error)) << error;
  EXPECT_EQ(mesh->GetNumberOfPoints(), 19);
  EXPECT_EQ(mesh->GetNumberOfPolys(), 2 * 4 * 3 - 1);
  double bounds[6];
  mesh->GetBounds(bounds);
  EXPECT_EQ(bounds[0], 600000.0);
  EXPECT_EQ(bounds[1], 600120.0);
  EXPECT_EQ(bounds[2], 5000000.0 - 90.0);
  EXPECT_EQ(bounds[3], 5000000.0);
  double north[3];
  mesh->GetPoint(mesh->GetNumberOfPoints() - 5, north);
  EXPECT_EQ(north[2], 0.0) << "the first row of the file is in the north";

  WriteGeoTiff(folder / "degrees.tif", "EPSG:4326", 10.0, 45.0, 0.001);
  vtkMTTerrain geographic;
  geographic.Degrees = true;
  ASSERT_TRUE(geographic.AddTile(folder / "degrees.tif", error)) << error;
  EXPECT_FALSE(geographic.AddTile(folder / "utm.tif", error)) << "another system";
  ASSERT_TRUE(geographic.Make(mesh, error)) << error;
  mesh->GetBounds(bounds);
  EXPECT_NEAR(bounds[0], 10.0, 1e-9);
  EXPECT_NEAR(bounds[3], 45.0, 1e-9);

  EXPECT_EQ(terrain.GetFrame().Crs, "EPSG:32610");
  EXPECT_EQ(terrain.GetFrame().Units, "m");
  EXPECT_EQ(geographic.GetFrame().Crs, "EPSG:4326");

  WriteFile(folder / "noise.tif", std::string(300, 'x'));
  EXPECT_FALSE(geographic.AddTile(folder / "noise.tif", error));
  EXPECT_NE(error.find("noise.tif"), std::string::npos) << error;
}

namespace
{
// Of the terrain of these tiles.
struct Figures
{
  vtkIdType Points = 0;
  vtkIdType Triangles = 0;
  vtkIdType Components = 0;
  double Bounds[6] = { 0, 0, 0, 0, 0, 0 };
  std::map<std::string, std::int64_t> Report;
  vtkMTWorldFrame Frame;
};

Figures Join(const std::vector<std::string>& paths, bool degrees = false)
{
  Figures figures;
  vtkMTTerrain terrain;
  terrain.Degrees = degrees;
  std::string error;
  for (const std::string& path : paths)
  {
    EXPECT_TRUE(terrain.AddTile(path, error)) << error;
  }
  vtkNew<vtkPolyData> mesh;
  EXPECT_TRUE(terrain.Make(mesh, error)) << error;
  vtkNew<vtkPolyDataConnectivityFilter> parts;
  parts->SetInputData(mesh);
  parts->SetExtractionModeToAllRegions();
  parts->Update();
  figures.Points = mesh->GetNumberOfPoints();
  figures.Triangles = mesh->GetNumberOfPolys();
  figures.Components = parts->GetNumberOfExtractedRegions();
  mesh->GetBounds(figures.Bounds);
  figures.Report = terrain.GetReport();
  figures.Frame = terrain.GetFrame();
  return figures;
}
}

TEST(TerrainOfGeoTiff, TilesOfAreasThatMeetWithoutSharingSamplesAreJoined)
{
  const Folder folder;
  GeoTiff tile;
  tile.HasVoid = false;
  tile.Write(folder / "a.tif"); // columns 0 to 4, rows 0 to -3, in steps
  tile.West = 150.0;
  tile.Write(folder / "b.tif");
  tile.North = -120.0;
  tile.Write(folder / "d.tif"); // beyond the corner
  tile.West = 0.0;
  tile.Write(folder / "c.tif");
  const Figures two = Join({ folder / "b.tif", folder / "a.tif" });
  EXPECT_EQ(two.Points, 40);
  EXPECT_EQ(two.Triangles, 2 * 9 * 3);
  EXPECT_EQ(two.Components, 1);
  EXPECT_EQ(two.Report.at("terrain_gap_samples"), 0);
  const Figures four = Join({ folder / "a.tif", folder / "b.tif", folder / "c.tif", folder / "d.tif" });
  EXPECT_EQ(four.Triangles, 2 * 9 * 7);
  EXPECT_EQ(four.Components, 1);
  // Without the fourth the corner's square has three samples that tiles have: no triangle at its place.
  EXPECT_EQ(Join({ folder / "a.tif", folder / "b.tif", folder / "c.tif" }).Triangles, 2 * 9 * 7 - 2 * 5 * 4);
}

TEST(TerrainOfGeoTiff, WhereTilesOverlapOrAreApartIsCounted)
{
  const Folder folder;
  GeoTiff tile;
  tile.HasVoid = false;
  tile.Write(folder / "a.tif");
  tile.West = 90.0; // the columns 3 and 4 are in both, with other heights
  tile.Write(folder / "overlap.tif");
  tile.West = 210.0; // two columns between them
  tile.Write(folder / "apart.tif");
  tile.West = 0.0;
  tile.North = -150.0; // one row
  tile.Write(folder / "below.tif");
  const Figures overlap = Join({ folder / "a.tif", folder / "overlap.tif" });
  EXPECT_EQ(overlap.Points, 8 * 4);
  EXPECT_EQ(overlap.Triangles, 2 * 7 * 3);
  EXPECT_EQ(overlap.Report.at("terrain_disagreeing_samples"), 8);
  EXPECT_EQ(overlap.Report.at("terrain_gap_samples"), 0);
  const Figures apart = Join({ folder / "a.tif", folder / "apart.tif" });
  EXPECT_EQ(apart.Triangles, 2 * 2 * 4 * 3);
  EXPECT_EQ(apart.Components, 2);
  EXPECT_EQ(apart.Report.at("terrain_gap_samples"), 2 * 4);
  EXPECT_EQ(Join({ folder / "a.tif", folder / "below.tif" }).Report.at("terrain_gap_samples"), 5);
  // Beside and below at once: what is between no two tiles of a row or a column is no gap.
  EXPECT_EQ(
    Join({ folder / "a.tif", folder / "apart.tif", folder / "below.tif" }).Report.at("terrain_gap_samples"), 2 * 4 + 5);
}

TEST(TerrainOfGeoTiff, PointsAndAreasPutTheirSamplesWhereTheFileSays)
{
  const Folder folder;
  GeoTiff tile;
  tile.HasVoid = false;
  tile.West = 600000.0;
  tile.North = 5000000.0;
  tile.Write(folder / "area.tif");
  tile.IsPoint = true;
  tile.Write(folder / "point.tif");
  // From the south and from the east, the same places.
  tile.StepY = 30.0;
  tile.North = 5000000.0 - 90.0;
  tile.Write(folder / "south.tif");
  tile.StepX = -30.0;
  tile.West = 600120.0;
  tile.Write(folder / "east.tif");
  for (const char* name : { "area.tif", "point.tif", "south.tif", "east.tif" })
  {
    const Figures figures = Join({ folder / name });
    EXPECT_EQ(figures.Triangles, 2 * 4 * 3) << name;
    EXPECT_EQ(figures.Bounds[0], 600000.0) << name;
    EXPECT_EQ(figures.Bounds[1], 600120.0) << name;
    EXPECT_EQ(figures.Bounds[2], 5000000.0 - 90.0) << name;
    EXPECT_EQ(figures.Bounds[3], 5000000.0) << name;
  }
  // Points that tiles share at their border, and heights in feet.
  tile = GeoTiff{ "EPSG:4326", 10.0, 45.0, 0.25, -0.25, true, false };
  tile.Write(folder / "left.tif");
  tile.West = 11.0;
  tile.Write(folder / "right.tif");
  const Figures shared = Join({ folder / "left.tif", folder / "right.tif" }, true);
  EXPECT_EQ(shared.Points, 9 * 4);
  EXPECT_EQ(shared.Components, 1);
  tile.Unit = "ft";
  tile.Write(folder / "feet.tif");
  EXPECT_NEAR(Join({ folder / "feet.tif" }).Bounds[5], 304.0 * 0.3048, 1e-4);
}

TEST(TerrainOfGeoTiff, TilesOfTwoZonesAreRefused)
{
  const Folder folder;
  GeoTiff tile;
  tile.Write(folder / "zone10.tif");
  tile.System = "EPSG:32611";
  tile.West = 150.0;
  tile.Write(folder / "zone11.tif");
  vtkMTTerrain terrain;
  std::string error;
  ASSERT_TRUE(terrain.AddTile(folder / "zone10.tif", error)) << error;
  EXPECT_FALSE(terrain.AddTile(folder / "zone11.tif", error));
  EXPECT_NE(error.find("another reference system"), std::string::npos) << error;
}

TEST(TerrainOfGeoTiff, TheTilesOfTheReportsAreOneSurface)
{
  const std::string folder = GetDataFolder() + "/../reports";
  if (!std::filesystem::exists(folder + "/t_left.tif"))
  {
    GTEST_SKIP() << "the folder of reports is not there";
  }
  const Figures figures = Join({ folder + "/t_left.tif", folder + "/t_right.tif" });
  EXPECT_EQ(figures.Triangles, 4582);
  EXPECT_EQ(figures.Components, 1);
  EXPECT_EQ(figures.Frame.Crs.find("+proj=eqc +lat_ts=45.98"), 0u) << figures.Frame.Crs;
}

TEST(TerrainOfGeoTiff, ALibraryThatIsNotThereIsAnErrorThatSaysWhatToDo)
{
  vtkMTGdalLibrary library;
  std::string error;
  EXPECT_FALSE(library.Load("libgdal-that-is-not-there.so", error));
  EXPECT_NE(error.find("libgdal-that-is-not-there.so"), std::string::npos) << error;
  EXPECT_NE(error.find("install it"), std::string::npos) << error;
  EXPECT_FALSE(library.Load("libz.so.1", error)) << "a library without its functions";
  EXPECT_NE(error.find("has no function"), std::string::npos) << error;
  EXPECT_TRUE(vtkMTGdalLibrary::Get(error)) << error;
}
