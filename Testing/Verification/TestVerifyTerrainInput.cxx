// SPDX-License-Identifier: BSD-3-Clause
// The checker's own reading of terrain: samples of every form, their places, and tiles that are joined.
#include "MTVerifyFiles.h"
#include "MTVerifyTiff.h"

#include "vtkMTVerifyTerrainInput.h"

#include "vtkNew.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

using namespace MTVerifyFiles;

namespace
{
using Facts = vtkMTVerifyTerrainInput::Facts;
using Options = vtkMTVerifyTerrainInput::Options;

/// Whole heights of 0 to 100 of a hilly place; the same for every tile at the same place.
std::vector<double> MakeHeights(std::size_t columns, std::size_t rows, std::size_t left = 0, std::size_t top = 0)
{
  std::vector<double> heights;
  for (std::size_t i = 0; i < columns * rows; ++i)
  {
    const auto x = static_cast<double>(left + i % columns);
    const auto y = static_cast<double>(top + i / columns);
    heights.push_back(std::floor(50.0 + 49.0 * std::sin(0.9 * x) * std::cos(0.7 * y)));
  }
  return heights;
}

/// A tile of that place, whose first sample is the one at (left, top).
Tiff MakeTile(std::size_t columns, std::size_t rows, std::size_t left = 0, std::size_t top = 0)
{
  Tiff tiff;
  tiff.Columns = columns;
  tiff.Rows = rows;
  tiff.Heights = MakeHeights(columns, rows, left, top);
  tiff.Scale = { 10, 20, 0 };
  tiff.Tie = { 0, 0, 0, 1000.0 + 10.0 * static_cast<double>(left), 5000.0 - 20.0 * static_cast<double>(top), 0 };
  return tiff;
}

class VerifyTerrainInput : public FolderTest
{
protected:
  /// Reads the tiles; the surface stays until the next call.
  Facts Expect(const std::vector<std::string>& paths, const Options& options, vtkIdType triangles,
    const std::array<double, 4>& bounds)
  {
    SCOPED_TRACE(paths.front());
    Facts facts;
    std::string error;
    EXPECT_TRUE(vtkMTVerifyTerrainInput::Read(paths, options, this->Surface, facts, error)) << error;
    EXPECT_EQ(this->Surface->GetNumberOfCells(), triangles);
    for (int i = 0; i < 4; ++i)
    {
      EXPECT_NEAR(this->Surface->GetBounds()[i], bounds[static_cast<std::size_t>(i)], 1e-6) << i;
    }
    const double area = GetArea(this->Surface);
    EXPECT_LE(facts.AreaRange[0], area * (1 + 1e-12));
    EXPECT_GE(facts.AreaRange[1], area * (1 - 1e-12));
    return facts;
  }

  void ExpectRefused(const std::vector<std::string>& paths, bool isUnsupported)
  {
    SCOPED_TRACE(paths.empty() ? std::string("no tile") : paths.back());
    Facts facts;
    std::string error;
    EXPECT_FALSE(vtkMTVerifyTerrainInput::Read(paths, Options(), this->Surface, facts, error));
    EXPECT_EQ(facts.IsUnsupported, isUnsupported) << error;
    EXPECT_FALSE(error.empty());
    std::cout << error << "\n";
  }

  /// Twice the area of the triangles' shadows; clockwise ones count less than nothing.
  double GetShadow()
  {
    double shadow = 0.0;
    vtkNew<vtkIdList> corners;
    for (vtkIdType i = 0; i < this->Surface->GetNumberOfCells(); ++i)
    {
      double x[3][3];
      this->Surface->GetCellPoints(i, corners);
      for (int c = 0; c < 3; ++c)
      {
        this->Surface->GetPoint(corners->GetId(c), x[c]);
      }
      const double twice = (x[1][0] - x[0][0]) * (x[2][1] - x[0][1]) - (x[1][1] - x[0][1]) * (x[2][0] - x[0][0]);
      EXPECT_GT(twice, 0.0) << i;
      shadow += twice / 2;
    }
    return shadow;
  }

  vtkNew<vtkPolyData> Surface;
};
}

TEST_F(VerifyTerrainInput, EveryFormOfSamplesIsTheSame)
{
  int forms = 0;
  for (std::size_t type = 0; type < 10; ++type)
  {
    for (int form = 0; form < 8; ++form)
    {
      for (const int compression : { 1, 5, 8, 32773 })
      {
        for (int predictor = 1; predictor <= (compression == 5 || compression == 8 ? 3 : 1); ++predictor)
        {
          Tiff tiff = MakeTile(21, 17);
          tiff.Type = type;
          tiff.IsBigEndian = (form & 1) != 0;
          tiff.IsBigTiff = (form & 2) != 0;
          tiff.TileColumns = (form & 4) != 0 ? 16 : 0;
          tiff.TileRows = 16;
          tiff.Compression = compression;
          tiff.Predictor = predictor;
          if (predictor == 3 && type < 8)
          {
            continue;
          }
          const std::string name = std::to_string(type) + "_" + std::to_string(form) + "_" +
            std::to_string(compression) + "_" + std::to_string(predictor) + ".tif";
          const Facts facts =
            this->Expect({ this->Write(name, tiff.ToBytes()) }, Options(), 20 * 16 * 2, { 1005, 1205, 4670, 4990 });
          for (std::size_t i = 0; i < tiff.Heights.size(); ++i)
          {
            // Points come quad after quad; each is looked up by its place.
            double x[3];
            this->Surface->GetPoint(static_cast<vtkIdType>(i), x);
            const auto column = static_cast<std::size_t>(std::llround((x[0] - 1005) / 10));
            const auto row = static_cast<std::size_t>(std::llround((4990 - x[1]) / 20));
            ASSERT_EQ(x[2], tiff.Heights[row * 21 + column]) << name;
          }
          EXPECT_EQ(facts.Samples, 21 * 17);
          ++forms;
        }
      }
    }
  }
  std::cout << forms << " forms\n";
}

TEST_F(VerifyTerrainInput, LzwOfManyCodesIsTheSame)
{
  // More than 4094 texts, so that codes of all lengths and a full table occur.
  Tiff tiff = MakeTile(160, 120);
  for (std::size_t i = 0; i < tiff.Heights.size(); ++i)
  {
    tiff.Heights[i] += static_cast<double>(i * 7919 % 1009) / 16.0;
  }
  tiff.Compression = 5;
  const Facts facts =
    this->Expect({ this->Write("lzw.tif", tiff.ToBytes()) }, Options(), 159 * 119 * 2, { 1005, 2595, 2610, 4990 });
  tiff.Compression = 1;
  const Facts plain =
    this->Expect({ this->Write("plain.tif", tiff.ToBytes()) }, Options(), 159 * 119 * 2, { 1005, 2595, 2610, 4990 });
  EXPECT_EQ(facts.AreaRange, plain.AreaRange);
  EXPECT_EQ(facts.Range, plain.Range);
}

TEST_F(VerifyTerrainInput, PixelsAreAreasOrPoints)
{
  Tiff tiff = MakeTile(4, 3);
  // 4 x 3 pixels of 10 x 20 from (1000, 5000): the samples are their middles.
  const std::array<double, 4> middles = { 1005, 1035, 4950, 4990 };
  this->Expect({ this->Write("area.tif", tiff.ToBytes()) }, Options(), 12, middles);
  EXPECT_DOUBLE_EQ(this->GetShadow(), 30.0 * 40.0);
  tiff.RasterType = 0; // area is the default
  this->Expect({ this->Write("none.tif", tiff.ToBytes()) }, Options(), 12, middles);
  tiff.RasterType = 2;
  this->Expect({ this->Write("point.tif", tiff.ToBytes()) }, Options(), 12, { 1000, 1030, 4960, 5000 });
  // A tie point that is not the first pixel's corner: raster (2, 1) is at (1000, 5000).
  tiff.RasterType = 1;
  tiff.Tie = { 2, 1, 0, 1000, 5000, 0 };
  this->Expect({ this->Write("tie.tif", tiff.ToBytes()) }, Options(), 12, { 985, 1015, 4970, 5010 });
  // A quarter turn: columns run north, rows run east.
  tiff.Matrix = { 0, 20, 0, 1000, 10, 0, 0, 5000, 0, 0, 0, 0, 0, 0, 0, 1 };
  this->Expect({ this->Write("turned.tif", tiff.ToBytes()) }, Options(), 12, { 1010, 1050, 5005, 5035 });
  EXPECT_DOUBLE_EQ(this->GetShadow(), 30.0 * 40.0);
  // Rows from the south.
  tiff.Matrix = { 10, 0, 0, 1000, 0, 20, 0, 5000, 0, 0, 0, 0, 0, 0, 0, 1 };
  this->Expect({ this->Write("south.tif", tiff.ToBytes()) }, { 3.0, false }, 12, { 1005, 1035, 5010, 5050 });
  EXPECT_DOUBLE_EQ(this->GetShadow(), 30.0 * 40.0);
  EXPECT_EQ(this->Surface->GetBounds()[5], 3.0 * *std::max_element(tiff.Heights.begin(), tiff.Heights.end()));
}

TEST_F(VerifyTerrainInput, DegreesBecomeMetresAboutTheMiddle)
{
  Tiff tiff = MakeTile(3, 3);
  tiff.IsGeographic = true;
  tiff.RasterType = 2;
  tiff.Scale = { 0.5, 0.25, 0 };
  tiff.Tie = { 0, 0, 0, 10, 60.25, 0 };
  const std::string path = this->Write("degrees.tif", tiff.ToBytes());
  this->Expect({ path }, { 1.0, true }, 8, { 10, 11, 59.75, 60.25 });
  // A degree of latitude is 111195.0802 metres; at 60 degrees one of longitude is half of that.
  const double degree = 6371008.8 * 3.14159265358979323846 / 180.0;
  const Facts facts = this->Expect({ path }, Options(), 8, { -degree / 4, degree / 4, -degree / 4, degree / 4 });
  EXPECT_TRUE(facts.IsGeographic);
  EXPECT_DOUBLE_EQ(facts.Middle[0], 10.5);
  EXPECT_DOUBLE_EQ(facts.Middle[1], 60.0);
}

TEST_F(VerifyTerrainInput, TilesAreOneSurface)
{
  // Neighbours without a sample in common, sharing samples, and overlapping: all are the one tile of 12 x 9.
  const std::string whole = this->Write("whole.tif", MakeTile(12, 9).ToBytes());
  const std::array<double, 4> bounds = { 1005, 1115, 4830, 4990 };
  const Facts one = this->Expect({ whole }, Options(), 11 * 8 * 2, bounds);
  struct Pair
  {
    std::size_t Width, Left;
    std::int64_t Shared;
  };
  for (const Pair pair : { Pair{ 5, 5, 0 }, Pair{ 6, 5, 9 }, Pair{ 8, 5, 27 } })
  {
    const std::string name = std::to_string(pair.Width) + ".tif";
    const std::string left = this->Write("left" + name, MakeTile(pair.Width, 9).ToBytes());
    const std::string right = this->Write("right" + name, MakeTile(12 - pair.Left, 9, pair.Left).ToBytes());
    for (const auto& paths : { std::vector<std::string>{ left, right }, std::vector<std::string>{ right, left } })
    {
      const Facts facts = this->Expect(paths, Options(), 11 * 8 * 2, bounds);
      EXPECT_EQ(facts.SharedSamples, pair.Shared);
      EXPECT_EQ(facts.DisagreeingSamples, 0);
      EXPECT_EQ(CountComponents(this->Surface), 1U);
      EXPECT_EQ(facts.AreaRange, one.AreaRange);
    }
  }
  // Above each other, and one step of a gap more than neighbours have: two parts.
  const std::string low = this->Write("low.tif", MakeTile(12, 4, 0, 5).ToBytes());
  this->Expect({ this->Write("top.tif", MakeTile(12, 5).ToBytes()), low }, Options(), 11 * 8 * 2, bounds);
  this->Expect({ this->Write("high.tif", MakeTile(12, 4).ToBytes()), low }, Options(), 11 * 6 * 2, bounds);
  EXPECT_EQ(CountComponents(this->Surface), 2U);
}

TEST_F(VerifyTerrainInput, SharedSamplesThatDisagreeAreCountedAndTheFirstIsKept)
{
  Tiff left = MakeTile(5, 3);
  Tiff right = MakeTile(5, 3, 4);
  right.Heights[0] = 500.0;
  const std::string paths[2] = { this->Write("left.tif", left.ToBytes()), this->Write("right.tif", right.ToBytes()) };
  Facts facts = this->Expect({ paths[0], paths[1] }, Options(), 8 * 2 * 2, { 1005, 1085, 4950, 4990 });
  EXPECT_EQ(facts.SharedSamples, 3);
  EXPECT_EQ(facts.DisagreeingSamples, 1);
  EXPECT_LT(facts.Range[1], 500.0);
  facts = this->Expect({ paths[1], paths[0] }, Options(), 8 * 2 * 2, { 1005, 1085, 4950, 4990 });
  EXPECT_EQ(facts.Range[1], 500.0);
}

TEST_F(VerifyTerrainInput, VoidsAreHoles)
{
  Tiff tiff = MakeTile(4, 4);
  tiff.Heights.assign(16, 7.0);
  tiff.Heights[5] = -3.4028234663852886e+38; // a void within: four quads of 18 triangles keep one each
  tiff.NoData = "-3.4028235e+38";
  Facts facts = this->Expect({ this->Write("text.tif", tiff.ToBytes()) }, Options(), 14, { 1005, 1035, 4930, 4990 });
  EXPECT_EQ(facts.Voids, 1);
  EXPECT_EQ(facts.Range, (std::array<double, 2>{ { 7.0, 7.0 } }));
  EXPECT_DOUBLE_EQ(facts.AreaRange[0], 7 * 200.0);
  tiff.NoData.clear();
  tiff.Heights[5] = std::numeric_limits<double>::quiet_NaN();
  facts = this->Expect({ this->Write("nan.tif", tiff.ToBytes()) }, Options(), 14, { 1005, 1035, 4930, 4990 });
  EXPECT_EQ(facts.Voids, 1);
  // A void of one tile that another tile fills is none.
  const std::string full = this->Write("full.tif", MakeTile(4, 4).ToBytes());
  facts = this->Expect({ this->Folder + "/nan.tif", full }, Options(), 18, { 1005, 1035, 4930, 4990 });
  EXPECT_EQ(facts.Voids, 0);
}

TEST_F(VerifyTerrainInput, SrtmIsPlacedByItsName)
{
  // 3 x 3 samples; the second tile lies to the east and shares a column.
  std::vector<double> heights{ 1, 2, 3, 4, -32768, 6, 7, 8, 9 };
  const std::string west = this->Write("S01W002.hgt", Encode<std::int16_t>(heights, true));
  const std::string east =
    this->Write("s01w001.SRTM.hgt.gz", Compress(Encode<std::int16_t>({ 3, 3, 3, 6, 6, 6, 9, 9, 9 }, true), 31));
  Facts facts = this->Expect({ west }, { 1.0, true }, 4, { -2, -1, -1, 0 });
  EXPECT_EQ(facts.Voids, 1);
  EXPECT_EQ(facts.Range, (std::array<double, 2>{ { 1.0, 9.0 } }));
  facts = this->Expect({ west, east }, { 1.0, true }, 4 + 8, { -2, 0, -1, 0 });
  EXPECT_EQ(facts.SharedSamples, 3);
  EXPECT_EQ(facts.DisagreeingSamples, 0);
  EXPECT_EQ(CountComponents(this->Surface), 1U);
  this->ExpectRefused({ this->Write("N00E000.hgt", "12345") }, true);
  this->ExpectRefused({ this->Write("terrain.hgt", Encode<std::int16_t>(heights, true)) }, false);
}

TEST_F(VerifyTerrainInput, ProfilesOfADemMayBeRagged)
{
  // Fields at the places of USGS's header: reference 1 (UTM), units 2 (metres), resolution 30 x 30 x 0.5, 3 profiles.
  std::string file(1024, ' ');
  const auto set = [&](std::string& record, std::size_t at, const std::string& text)
  { record.replace(at, text.size(), text); };
  set(file, 156, "     1    10");
  set(file, 528, "     2     2     4");
  set(file, 816, "0.300000E+020.300000E+020.500000E+00     1     3");
  const double souths[3] = { 1000, 970, 1000 };
  const std::vector<int> values[3] = { { 10, 12 }, { 14, 16, 18 }, { 20, -32767 } };
  for (int i = 0; i < 3; ++i)
  {
    std::string record(1024, ' ');
    char text[160];
    std::snprintf(text, sizeof(text), "%6d%6d%6d%6d%24.15E%24.15E%24.15E", 1, i + 1, int(values[i].size()), 1,
      500000.0 + 30 * i, souths[i], 100.0);
    std::replace(text, text + sizeof(text), 'E', 'D');
    set(record, 0, text);
    for (std::size_t k = 0; k < values[i].size(); ++k)
    {
      std::snprintf(text, sizeof(text), "%6d", values[i][k]);
      set(record, 144 + 6 * k, text);
    }
    file += record;
  }
  // Rows at 1030, 1000 and 970; of the 9 places the profiles have 6: two and a half quads' triangles.
  const Facts facts = this->Expect({ this->Write("ragged.dem", file) }, Options(), 5, { 500000, 500060, 970, 1030 });
  EXPECT_EQ(facts.Samples, 6);
  EXPECT_EQ(facts.Voids, 3);
  EXPECT_EQ(facts.Range, (std::array<double, 2>{ { 105.0, 110.0 } }));
  this->ExpectRefused({ this->Write("short.dem", file.substr(0, 3000)) }, false);
}

TEST_F(VerifyTerrainInput, WhatIsNotReadHereIsNoDamage)
{
  const std::string base = this->Write("base.tif", MakeTile(4, 4).ToBytes());
  Tiff other = MakeTile(4, 4, 4);
  other.Tie[3] += 4.0; // 0.4 of a step
  this->ExpectRefused({ base, this->Write("off.tif", other.ToBytes()) }, true);
  other = MakeTile(4, 4, 4);
  other.Scale[0] = 11;
  this->ExpectRefused({ base, this->Write("step.tif", other.ToBytes()) }, true);
  other = MakeTile(4, 4, 100000);
  this->ExpectRefused({ base, this->Write("far.tif", other.ToBytes()) }, true);
  other = MakeTile(4, 4);
  other.Scale.clear();
  this->ExpectRefused({ this->Write("nowhere.tif", other.ToBytes()) }, true);
  other = MakeTile(4, 4);
  other.Compression = 50000; // zstd
  this->ExpectRefused({ this->Write("zstd.tif", other.ToBytes()) }, true);
}

TEST_F(VerifyTerrainInput, DamageIsAnError)
{
  const std::string bytes = MakeTile(4, 4).ToBytes();
  this->ExpectRefused({ this->Folder + "/missing.tif" }, false);
  this->ExpectRefused({ this->Write("words.tif", "not a TIFF file at all") }, false);
  this->ExpectRefused({ this->Write("short.tif", bytes.substr(0, 40)) }, false);
  Tiff packed = MakeTile(40, 40);
  for (const int compression : { 5, 8 })
  {
    packed.Compression = compression;
    std::string damaged = packed.ToBytes();
    damaged.replace(20, 40, 40, '\xff');
    this->ExpectRefused({ this->Write("damaged" + std::to_string(compression) + ".tif", damaged) }, false);
  }
  this->ExpectRefused({}, false);
}

TEST_F(VerifyTerrainInput, ReportsHaveTheirRightValues)
{
  const std::string folder = GetReports();
  if (folder.empty())
  {
    GTEST_SKIP() << "no ../shared/reports";
  }
  Facts facts;
  std::string error;
  ASSERT_TRUE(vtkMTVerifyTerrainInput::Read(
    { folder + "t_left.tif", folder + "t_right.tif" }, Options(), this->Surface, facts, error))
    << error;
  std::cout << this->Surface->GetNumberOfCells() << " triangles, " << CountComponents(this->Surface)
            << " component(s), " << facts.Dimensions[0] << " x " << facts.Dimensions[1] << " samples\n";
  EXPECT_EQ(this->Surface->GetNumberOfCells(), 4582);
  EXPECT_EQ(CountComponents(this->Surface), 1U);
}
