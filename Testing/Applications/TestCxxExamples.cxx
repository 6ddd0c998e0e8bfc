// SPDX-License-Identifier: BSD-3-Clause
// The programs of Examples/Cxx, run as their users run them: what they draw, print and answer. Under a virtual display.
#include "MTRunBmt.h"

#include "vtkElevationFilter.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPLYReader.h"
#include "vtkPNGReader.h"
#include "vtkPolyData.h"
#include "vtkRTAnalyticSource.h"
#include "vtkTriangle.h"
#include "vtkXMLImageDataWriter.h"
#include "vtkXMLPolyDataWriter.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <iostream>
#include <map>
#include <regex>

#include <sys/wait.h>

namespace
{
using Pixel = std::array<int, 3>;
constexpr int Triangles = 20480;

struct Picture
{
  explicit Picture(const std::string& path)
  {
    vtkNew<vtkPNGReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    this->Image = reader->GetOutput();
    EXPECT_GT(this->Image->GetNumberOfPoints(), 1) << path;
  }
  Pixel At(int x, int y) const
  {
    const auto* pixel = static_cast<const unsigned char*>(this->Image->GetScalarPointer(x, y, 0));
    return { pixel[0], pixel[1], pixel[2] };
  }
  bool IsDrawn(const Pixel& pixel) const { return pixel != this->At(0, 0); }

  // The share of the pixels for which that holds.
  double Count(const std::function<bool(const Pixel&)>& holds) const
  {
    const int* size = this->Image->GetDimensions();
    std::int64_t count = 0;
    for (int y = 0; y < size[1]; ++y)
    {
      for (int x = 0; x < size[0]; ++x)
      {
        count += holds(this->At(x, y)) ? 1 : 0;
      }
    }
    return static_cast<double>(count) / static_cast<double>(this->Image->GetNumberOfPoints());
  }
  double GetCovered() const
  {
    const double covered = this->Count([this](const Pixel& pixel) { return this->IsDrawn(pixel); });
    std::cout << 100.0 * covered << " % drawn\n";
    return covered;
  }

  vtkSmartPointer<vtkImageData> Image;
};

// What a command prints on both outputs, and its exit code.
struct Process
{
  explicit Process(const std::string& command)
    : Pipe(popen((command + " 2>&1").c_str(), "r"))
  {
  }
  int Wait(std::string& text)
  {
    std::array<char, 4096> bytes;
    for (std::size_t size = 0; (size = fread(bytes.data(), 1, bytes.size(), this->Pipe)) > 0;)
    {
      text.append(bytes.data(), size);
    }
    const int status = pclose(this->Pipe);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 1000;
  }

  FILE* Pipe;
};

bool IsRed(const Pixel& pixel)
{
  return pixel[0] > 110 && pixel[1] < 60 && pixel[2] < 60;
}

bool IsBlue(const Pixel& pixel)
{
  return pixel[2] > 110 && pixel[0] < 60 && pixel[1] < 60;
}
}

class CxxExamples : public MTBmtTest
{
protected:
  static std::string Program(const std::string& name) { return std::string(CXX_EXAMPLES) + "/" + name; }

  // Arguments are words without spaces; FOLDER/ stands for the test's folder.
  std::string Command(const std::string& name, const std::string& arguments) const
  {
    return "'" + Program(name) + "' " + std::regex_replace(arguments, std::regex("FOLDER/"), this->Path(""));
  }
  std::string Run(const std::string& name, const std::string& arguments, int exit = 0) const
  {
    std::string text;
    EXPECT_EQ(Process(this->Command(name, arguments)).Wait(text), exit) << name << ": " << text;
    std::cout << text;
    return text;
  }

  // A model with a point array Elevation from -1 to 1.
  void MakeHeights() const
  {
    this->MakeSphere(Triangles);
    vtkNew<vtkPLYReader> reader;
    reader->SetFileName(this->Path("sphere.ply").c_str());
    vtkNew<vtkElevationFilter> heights;
    heights->SetInputConnection(reader->GetOutputPort());
    heights->SetLowPoint(-1.0, 0.0, 0.0);
    heights->SetHighPoint(1.0, 0.0, 0.0);
    heights->SetScalarRange(-1.0, 1.0);
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetInputConnection(heights->GetOutputPort());
    writer->SetFileName(this->Path("heights.vtp").c_str());
    writer->Write();
    this->BmtJson({ "build", this->Path("heights.vtp"), "-o", this->Path("heights.bmt"), "--patch-triangles", "200" });
  }

  void MakeVolume() const
  {
    vtkNew<vtkRTAnalyticSource> source;
    vtkNew<vtkXMLImageDataWriter> writer;
    writer->SetInputConnection(source->GetOutputPort());
    writer->SetFileName(this->Path("volume.vti").c_str());
    writer->Write();
  }

  // A tile that rises to the north, or else falls, near a meridian, and is void elsewhere, so that it is small.
  void MakeTile(const std::string& name, int firstColumn, bool rises) const
  {
    constexpr int size = 1201;
    std::string bytes;
    for (int row = 0; row < size; ++row)
    {
      for (int column = 0; column < size; ++column)
      {
        const bool known = row < 200 && column >= firstColumn && column < firstColumn + 201;
        const int height = known ? 20 * (rises ? 200 - row : row) : -32768;
        bytes += static_cast<char>((height >> 8) & 255);
        bytes += static_cast<char>(height & 255);
      }
    }
    this->WriteFile(name, bytes);
  }
};

TEST_F(CxxExamples, AMeshGoesToTheScreenInOnePipeline)
{
  this->MakeSphere(Triangles);
  EXPECT_EQ(this->Run("source_to_screen", "FOLDER/sphere.ply FOLDER/source.png"), "");
  const double covered = Picture(this->Path("source.png")).GetCovered();
  EXPECT_GT(covered, 0.1);
  EXPECT_LT(covered, 0.6);
}

TEST_F(CxxExamples, AFileIsOpenedAndDrawnWhole)
{
  this->MakeModel(Triangles);
  EXPECT_EQ(this->Run("open_file", "FOLDER/sphere.bmt FOLDER/open.png"), "");
  const double covered = Picture(this->Path("open.png")).GetCovered();
  EXPECT_GT(covered, 0.1);
  EXPECT_LT(covered, 0.6);
}

TEST_F(CxxExamples, TilesBecomeATerrainThatIsColouredByHeight)
{
  this->MakeTile("N45E005.hgt", 1000, true);
  this->MakeTile("N45E006.hgt", 0, false);
  this->Run("terrain", "FOLDER/terrain.bmt FOLDER/N45E005.hgt FOLDER/N45E006.hgt FOLDER/terrain.png");
  const Picture picture(this->Path("terrain.png"));
  EXPECT_GT(picture.GetCovered(), 0.05);
  EXPECT_GT(picture.Count([](const Pixel& p) { return p[1] > 1.5 * p[0] && p[1] > 1.5 * p[2]; }), 0.001)
    << "low: green";
  EXPECT_GT(picture.Count([](const Pixel& p) { return p[0] > 150 && p[1] > 150 && p[2] > 130; }), 0.001)
    << "high: white";
  EXPECT_NE(
    this->Run("terrain", "FOLDER/terrain.bmt FOLDER/nowhere.hgt FOLDER/x.png", 1).find("nowhere"), std::string::npos);
}

TEST_F(CxxExamples, AVolumeBecomesAnIsosurface)
{
  this->MakeVolume();
  this->Run("isosurface", "FOLDER/volume.vti 150 FOLDER/iso.bmt FOLDER/iso.png");
  EXPECT_GT(Picture(this->Path("iso.png")).GetCovered(), 0.1);
  EXPECT_NE(this->Run("isosurface", "FOLDER/nowhere.vti 150 FOLDER/iso.bmt FOLDER/x.png", 1).find("nowhere"),
    std::string::npos);
}

TEST_F(CxxExamples, AnArrayIsColouredOverItsRange)
{
  this->MakeHeights();
  this->Run("colour_by_array", "FOLDER/heights.bmt Elevation FOLDER/colours.png");
  const Picture picture(this->Path("colours.png"));
  EXPECT_GT(picture.Count(IsBlue), 0.002);
  EXPECT_GT(picture.Count(IsRed), 0.002);
  EXPECT_EQ(
    this->Run("colour_by_array", "FOLDER/heights.bmt Nothing FOLDER/x.png", 1), "the model has no array Nothing\n");
}

TEST_F(CxxExamples, APickGivesTheInputsTriangle)
{
  this->MakeModel(Triangles);
  const std::string hit = this->Run("pick", "FOLDER/sphere.bmt 400 300 FOLDER/pick.png");
  std::smatch words;
  ASSERT_TRUE(std::regex_match(hit, words, std::regex("triangle ([0-9]+) of the input at \\((.*), (.*), (.*)\\)\n")))
    << hit;
  vtkNew<vtkPLYReader> reader;
  reader->SetFileName(this->Path("sphere.ply").c_str());
  reader->Update();
  auto* triangle = vtkTriangle::SafeDownCast(reader->GetOutput()->GetCell(std::stoi(words[1])));
  ASSERT_NE(triangle, nullptr);
  const std::array<double, 3> place{ std::stod(words[2]), std::stod(words[3]), std::stod(words[4]) };
  std::array<double, 3> closest;
  std::array<double, 3> coordinates;
  std::array<double, 3> weights;
  int part = 0;
  double squared = 0.0;
  triangle->EvaluatePosition(place.data(), closest.data(), part, coordinates.data(), squared, weights.data());
  std::cout << std::sqrt(squared) << " from that triangle\n";
  EXPECT_LT(std::sqrt(squared), 0.02) << "about one edge of the mesh";
  EXPECT_GT(Picture(this->Path("pick.png")).Count(IsRed), 1e-4) << "the label";
  EXPECT_EQ(this->Run("pick", "FOLDER/sphere.bmt 2 2 FOLDER/x.png"), "nothing there\n");
}

TEST_F(CxxExamples, SeveralModelsStandInARow)
{
  this->MakeModel(Triangles);
  this->Run("several_models", "FOLDER/sphere.bmt FOLDER/sphere.bmt FOLDER/sphere.bmt FOLDER/several.png");
  const Picture picture(this->Path("several.png"));
  const int* size = picture.Image->GetDimensions();
  int changes = 0;
  bool drawn = false;
  for (int x = 0; x < size[0]; ++x)
  {
    bool now = false;
    for (int y = 0; y < size[1]; ++y)
    {
      now = now || picture.IsDrawn(picture.At(x, y));
    }
    changes += now != drawn ? 1 : 0;
    drawn = now;
  }
  EXPECT_EQ(changes, 6) << "three spheres, with room between them";
}

TEST_F(CxxExamples, ARegionIsFineAndTheRestCoarse)
{
  this->MakeModel(Triangles);
  const std::string said = this->Run("region_of_interest", "FOLDER/sphere.bmt FOLDER/region.png");
  std::smatch words;
  ASSERT_TRUE(std::regex_match(said, words, std::regex("([0-9]+) of 20480 triangles\n"))) << said;
  EXPECT_LT(std::stoi(words[1]), Triangles * 3 / 4);
  EXPECT_GT(std::stoi(words[1]), 1000);
  const Picture picture(this->Path("region.png"));
  EXPECT_GT(picture.Count([](const Pixel& p) { return p == Pixel{ 0, 0, 0 }; }), 0.005) << "edges";
}

TEST_F(CxxExamples, ASectionIsDrawnWhereTheModelIsClipped)
{
  this->MakeModel(Triangles);
  this->Run("section", "FOLDER/sphere.bmt FOLDER/section.png");
  const Picture picture(this->Path("section.png"));
  EXPECT_GT(picture.Count(IsRed), 0.001);
  EXPECT_GT(picture.Count([](const Pixel& p) { return p[0] > 60 && 8 * p[0] > 9 * p[1] && 5 * p[1] > 6 * p[2]; }), 0.02)
    << "the colour of the inside";
}

TEST_F(CxxExamples, ATurntableGivesFramesThatDiffer)
{
  this->MakeModel(Triangles);
  this->Run("turntable", "FOLDER/sphere.bmt FOLDER/film 3");
  std::map<std::string, Picture> frames;
  for (const auto& entry : std::filesystem::directory_iterator(this->Path("film")))
  {
    frames.emplace(entry.path().filename().string(), Picture(entry.path().string()));
  }
  ASSERT_EQ(frames.size(), 3U);
  ASSERT_EQ(frames.count("frame-000.png"), 1U);
  ASSERT_EQ(frames.count("frame-002.png"), 1U);
  const Picture& first = frames.at("frame-000.png");
  EXPECT_GT(first.GetCovered(), 0.1);
  int different = 0;
  for (int x = 0; x < first.Image->GetDimensions()[0]; ++x)
  {
    different += first.At(x, 240) != frames.at("frame-002.png").At(x, 240) ? 1 : 0;
  }
  EXPECT_GT(different, 50) << "pixels of the middle row";
}

TEST_F(CxxExamples, ATimeBudgetIsToldWithWhatWasDrawn)
{
  this->MakeModel(Triangles);
  const std::string said = this->Run("time_budget", "FOLDER/sphere.bmt 20 FOLDER/budget.png");
  EXPECT_TRUE(std::regex_match(said,
    std::regex("[0-9.e+]+ frames per second of 20 asked for\n"
               "[0-9]+ triangles in the last frame, within [0-9.e+-]+ pixels\n")))
    << said;
  EXPECT_GT(Picture(this->Path("budget.png")).GetCovered(), 0.1);
}

TEST_F(CxxExamples, WithoutAPictureTheyWaitInAWindow)
{
  this->MakeModel(Triangles);
  this->MakeHeights();
  this->MakeVolume();
  this->MakeTile("N45E005.hgt", 1000, true);
  const std::map<std::string, std::string> arguments = {
    { "colour_by_array", "FOLDER/heights.bmt Elevation" },
    { "isosurface", "FOLDER/volume.vti 150 FOLDER/iso.bmt" },
    { "open_file", "FOLDER/sphere.bmt" },
    { "pick", "FOLDER/sphere.bmt" },
    { "region_of_interest", "FOLDER/sphere.bmt" },
    { "section", "FOLDER/sphere.bmt" },
    { "several_models", "FOLDER/sphere.bmt FOLDER/heights.bmt" },
    { "source_to_screen", "FOLDER/sphere.ply" },
    { "terrain", "FOLDER/terrain.bmt FOLDER/N45E005.hgt" },
    { "time_budget", "FOLDER/sphere.bmt 20" },
  };
  std::map<std::string, Process> running;
  for (const auto& entry : std::filesystem::directory_iterator(MT_SOURCE_DIRECTORY "/Examples/Cxx"))
  {
    const std::string name = entry.path().stem().string();
    if (entry.path().extension() == ".cxx" && name != "turntable")
    {
      ASSERT_EQ(arguments.count(name), 1U) << name << " is not tested";
      running.emplace(name, Process("timeout 15 " + this->Command(name, arguments.at(name))));
    }
  }
  EXPECT_EQ(running.size(), arguments.size());
  for (auto& [name, process] : running)
  {
    std::string text;
    EXPECT_EQ(process.Wait(text), 124) << name << " has ended by itself: " << text;
    EXPECT_EQ(text, "") << name;
  }
}
