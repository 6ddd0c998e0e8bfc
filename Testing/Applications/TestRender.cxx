// SPDX-License-Identifier: BSD-3-Clause
// `bmt render` and `bmt view`: pictures, figures, and what happens without a display. Runs under a virtual display.
#include "MTRunBmt.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"
#include "vtkPNGWriter.h"

#include <array>
#include <cmath>
#include <iostream>
#include <set>
#include <sstream>

namespace
{
struct Picture
{
  int Width = 0;
  int Height = 0;
  double Covered = 0.0; // share of pixels that are not the corner's colour
  bool TouchesBorder = false;
  std::size_t Colors = 0;
};

Picture Look(const std::string& path)
{
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  Picture picture;
  picture.Width = image->GetDimensions()[0];
  picture.Height = image->GetDimensions()[1];
  std::set<std::array<int, 3>> colors;
  const auto at = [image](int x, int y)
  {
    const auto* pixel = static_cast<const unsigned char*>(image->GetScalarPointer(x, y, 0));
    return std::array<int, 3>{ pixel[0], pixel[1], pixel[2] };
  };
  const auto background = at(0, 0);
  std::size_t covered = 0;
  for (int y = 0; y < picture.Height; ++y)
  {
    for (int x = 0; x < picture.Width; ++x)
    {
      if (at(x, y) != background)
      {
        ++covered;
        colors.insert(at(x, y));
        picture.TouchesBorder |= x == 0 || y == 0 || x + 1 == picture.Width || y + 1 == picture.Height;
      }
    }
  }
  picture.Covered = static_cast<double>(covered) / (picture.Width * picture.Height);
  picture.Colors = colors.size();
  return picture;
}
}

using Render = MTBmtTest;

TEST_F(Render, TheDefaultCameraShowsTheWholeModel)
{
  this->MakeModel(20480);
  const nlohmann::json json =
    this->BmtJson({ "render", this->Path("sphere.bmt"), "-o", this->Path("picture.png"), "--size", "400x300" });
  for (const char* name : { "triangles", "patches", "pixel_error", "converged", "frame_ms", "cut_ms" })
  {
    EXPECT_TRUE(json.contains(name)) << name;
  }
  EXPECT_TRUE(json["converged"]);
  EXPECT_LE(json["pixel_error"].get<double>(), 1.0);
  const Picture picture = Look(this->Path("picture.png"));
  EXPECT_EQ(picture.Width, 400);
  EXPECT_EQ(picture.Height, 300);
  EXPECT_GT(picture.Covered, 0.1);
  EXPECT_FALSE(picture.TouchesBorder);
  std::cout << json.dump() << ", covered " << picture.Covered << "\n";
}

// A square pyramid, as text, with coordinates in units of scale.
std::string MakePyramid(double scale)
{
  std::ostringstream off;
  off.precision(17);
  off << "OFF\n5 6 0\n";
  for (const std::array<int, 3>& x :
    std::array<std::array<int, 3>, 5>{ { { -1, -1, 0 }, { 1, -1, 0 }, { 1, 1, 0 }, { -1, 1, 0 }, { 0, 0, 2 } } })
  {
    off << x[0] * scale << " " << x[1] * scale << " " << x[2] * scale << "\n";
  }
  off << "3 0 2 1\n3 0 3 2\n3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n";
  return off.str();
}

TEST_F(Render, WhatVtkCannotDrawIsRefusedWithTheReasonAndNotDrawnEmpty)
{
  for (const int exponent : { 0, 100, 120, -60, 127, 200, 500, 1000, -80, -500, -1000 })
  {
    this->WriteFile("scale.off", MakePyramid(std::ldexp(1.0, exponent)));
    ASSERT_EQ(this->Bmt({ "build", this->Path("scale.off"), "-o", this->Path("scale.bmt") }).Exit, 0) << exponent;
    const MTRun verify =
      this->Bmt({ "verify", this->Path("scale.bmt"), "--input", this->Path("scale.off"), "--samples", "1000" });
    EXPECT_EQ(verify.Exit, 0) << exponent << ": " << verify.Out;
    const MTRun run =
      this->Bmt({ "render", this->Path("scale.bmt"), "-o", this->Path("scale.png"), "--size", "100x100" });
    if (exponent > 120 || exponent < -60)
    {
      EXPECT_EQ(run.Exit, 1) << exponent;
      EXPECT_NE(run.Err.find("cannot be drawn"), std::string::npos) << exponent << ": " << run.Err;
      continue;
    }
    EXPECT_EQ(run.Exit, 0) << exponent;
    EXPECT_GT(Look(this->Path("scale.png")).Covered, 0.1) << exponent;
  }
}

TEST_F(Render, ASmallerPixelErrorDrawsMoreAndABudgetIsKept)
{
  this->MakeModel(20480, 200, { "--certify-normals" });
  const auto render = [this](const std::vector<std::string>& more)
  {
    std::vector<std::string> call = { "render", this->Path("sphere.bmt"), "-o", this->Path("picture.png"), "--size",
      "300x300" };
    call.insert(call.end(), more.begin(), more.end());
    return this->BmtJson(call);
  };
  const nlohmann::json coarse = render({ "--pixel-error", "20" });
  const nlohmann::json fine = render({ "--pixel-error", "0.5" });
  EXPECT_LT(coarse["triangles"].get<int>(), fine["triangles"].get<int>());
  EXPECT_LE(coarse["pixel_error"].get<double>(), 20.0);
  const nlohmann::json distance = render({ "--pixel-error", "2", "--metric", "distance" });
  const nlohmann::json normals = render({ "--pixel-error", "2", "--metric", "normals" });
  const nlohmann::json edges = render({ "--pixel-error", "2", "--metric", "edges" });
  std::cout << distance["triangles"] << ", " << normals["triangles"] << ", " << edges["triangles"] << " triangles\n";
  EXPECT_LT(distance["triangles"].get<int>(), normals["triangles"].get<int>());
  EXPECT_LT(normals["triangles"].get<int>(), edges["triangles"].get<int>());
  EXPECT_LE(normals["pixel_error"].get<double>(), 2.0) << "certified all the same";
  const nlohmann::json limited = render({ "--pixel-error", "0.5", "--budget", "5000" });
  EXPECT_LE(limited["triangles"].get<int>(), 5000);
  EXPECT_FALSE(limited["converged"].get<bool>());
  EXPECT_GT(limited["pixel_error"].get<double>(), 0.5);
}

TEST_F(Render, CamerasAndColoursDoWhatTheySay)
{
  this->MakeModel(20480);
  const auto render = [this](const std::string& name, const std::vector<std::string>& more)
  {
    std::vector<std::string> call = { "render", this->Path("sphere.bmt"), "-o", this->Path(name), "--size", "300x300" };
    call.insert(call.end(), more.begin(), more.end());
    return this->BmtJson(call);
  };
  render("far.png", { "--camera=0,0,-60,0,0,0,0,1,0" });
  render("near.png", { "--camera", "-3,0,0,0,0,0,0,1,0" });
  EXPECT_LT(Look(this->Path("far.png")).Covered, 0.1 * Look(this->Path("near.png")).Covered);
  EXPECT_GT(Look(this->Path("far.png")).Covered, 0.0);

  render("wide.png", { "--camera=0,0,-6,0,0,0,0,1,0", "--view-angle", "90" });
  render("narrow.png", { "--camera=0,0,-6,0,0,0,0,1,0", "--view-angle", "30" });
  EXPECT_LT(Look(this->Path("wide.png")).Covered, Look(this->Path("narrow.png")).Covered);

  std::set<std::string> pictures;
  for (const std::string what : { "level", "patch", "error", "Normals", "vtkMTInputCellIds" })
  {
    render("colour.png", { "--color-by", what });
    pictures.insert(this->ReadFile("colour.png"));
  }
  render("colour.png", {});
  pictures.insert(this->ReadFile("colour.png"));
  EXPECT_EQ(pictures.size(), 6u) << "six ways of colouring, six pictures";
  render("again.png", {});
  EXPECT_TRUE(this->ReadFile("again.png") == this->ReadFile("colour.png")) << "the same call gives the same picture";

  const MTRun unknown =
    this->Bmt({ "render", this->Path("sphere.bmt"), "-o", this->Path("no.png"), "--color-by", "nothing" });
  EXPECT_EQ(unknown.Exit, 1);
  EXPECT_NE(unknown.Err.find("Normals"), std::string::npos) << "the message says what there is: " << unknown.Err;
  const MTRun senseless =
    this->Bmt({ "render", this->Path("sphere.bmt"), "-o", this->Path("no.png"), "--camera=0,0,0,0,0,0,0,1,0" });
  EXPECT_EQ(senseless.Exit, 1) << senseless.Err;
  EXPECT_FALSE(std::filesystem::exists(this->Path("no.png")));
}

// A square in the plane z = 0 of four triangles: two materials, the left one with a texture, red below and green above.
TEST_F(Render, TexturesAreDrawnOnTheirMaterialsAndMissingOnesListed)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(8, 8, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int j = 0; j < 8; ++j)
  {
    for (int i = 0; i < 8; ++i)
    {
      auto* pixel = static_cast<unsigned char*>(image->GetScalarPointer(i, j, 0));
      pixel[0] = j < 4 ? 255 : 0;
      pixel[1] = j < 4 ? 0 : 255;
      pixel[2] = 0;
    }
  }
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(this->Path("two.png").c_str());
  writer->SetInputData(image);
  writer->Write();
  this->WriteFile("square.mtl",
    "newmtl leaf\nKd 1 1 1\nmap_Kd two.png\nnewmtl plain\nKd 1 1 1\n"
    "newmtl lost\nKd 1 1 1\nmap_Kd lost.jpg\n");
  this->WriteFile("lost.jpg", "\xff\xd8\xff\xe0 no picture");
  this->WriteFile("square.obj",
    "mtllib square.mtl\nv 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nv 3 0 0\nv 3 1 0\n"
    "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl leaf\nf 1/1 2/2 5/3\nf 1/1 5/3 4/4\n"
    "usemtl plain\nf 2/1 3/2 6/3\nf 2/1 6/3 5/4\nusemtl lost\nf 3/1 7/2 8/3\nf 3/1 8/3 6/4\n");
  this->BmtJson({ "build", this->Path("square.obj"), "-o", this->Path("square.bmt") });
  const nlohmann::json json = this->BmtJson({ "render", this->Path("square.bmt"), "-o", this->Path("picture.png"),
    "--size", "400x400", "--camera=1,0.5,4,1,0.5,0,0,1,0" });
  std::cout << json["texture_problems"].dump() << "\n";
  ASSERT_EQ(json["texture_problems"].size(), 1u);
  EXPECT_NE(json["texture_problems"][0].get<std::string>().find("lost.jpg"), std::string::npos);
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(this->Path("picture.png").c_str());
  reader->Update();
  const auto look = [&reader](double x, double y)
  {
    // Pixels of a unit in the plane: the whole height of 400 is 2 * 4 * tan(15 degrees).
    const double scale = 400.0 / (8.0 * std::tan(0.2617993877991494));
    const auto* pixel = static_cast<const unsigned char*>(reader->GetOutput()->GetScalarPointer(
      static_cast<int>(200.0 + scale * (x - 1.0)), static_cast<int>(200.0 + scale * (y - 0.5)), 0));
    return std::array<int, 3>{ pixel[0] > 150, pixel[1] > 150, pixel[2] > 150 };
  };
  EXPECT_EQ(look(0.5, 0.2), (std::array<int, 3>{ 1, 0, 0 }));
  EXPECT_EQ(look(0.5, 0.8), (std::array<int, 3>{ 0, 1, 0 }));
  EXPECT_EQ(look(1.5, 0.2), (std::array<int, 3>{ 1, 1, 1 }));
  EXPECT_EQ(look(1.5, 0.8), (std::array<int, 3>{ 1, 1, 1 }));
  // An image that the mesh does not name is on all of it, in place of those that it names.
  const std::vector<std::string> call = { "render", this->Path("square.bmt"), "-o", this->Path("picture.png"), "--size",
    "400x400", "--camera=1,0.5,4,1,0.5,0,0,1,0", "--texture", this->Path("two.png") };
  EXPECT_TRUE(this->BmtJson(call)["texture_problems"].empty());
  reader->Modified();
  reader->Update();
  for (const double x : { 0.5, 1.5 })
  {
    EXPECT_EQ(look(x, 0.2), (std::array<int, 3>{ 1, 0, 0 })) << x;
    EXPECT_EQ(look(x, 0.8), (std::array<int, 3>{ 0, 1, 0 })) << x;
  }
  const MTRun refused = this->Bmt(
    { "render", this->Path("square.bmt"), "-o", this->Path("other.png"), "--texture", this->Path("lost.jpg") });
  EXPECT_EQ(refused.Exit, 1);
  EXPECT_NE(refused.Err.find("lost.jpg: the image is damaged"), std::string::npos) << refused.Err;
}

TEST_F(Render, WithoutADisplayThereIsAMessageAndNoAbort)
{
  this->MakeModel(1280, 64);
  for (const std::string display : { "DISPLAY", "DISPLAY=", "DISPLAY=:4711" })
  {
    MTRunOptions options;
    options.Environment = { display };
    const MTRun render = this->Bmt({ "render", this->Path("sphere.bmt"), "-o", this->Path("picture.png") }, options);
    EXPECT_EQ(render.Exit, 1) << display << render.Err;
    EXPECT_NE(render.Err.find("xvfb-run"), std::string::npos) << render.Err;
    EXPECT_FALSE(std::filesystem::exists(this->Path("picture.png")));
    const MTRun view = this->Bmt({ "view", this->Path("sphere.bmt") }, options);
    EXPECT_EQ(view.Exit, 1) << display << view.Err;
    EXPECT_NE(view.Err.find("xvfb-run"), std::string::npos) << view.Err;
  }
}

TEST_F(Render, AWindowStaysOpenUntilControlC)
{
  this->MakeModel(1280, 64);
  MTRunOptions options;
  options.InterruptAfterMilliseconds = 3000;
  const MTRun run = this->Bmt({ "view", this->Path("sphere.bmt") }, options);
  EXPECT_EQ(run.Exit, 130) << run.Err;
  EXPECT_NE(run.Err.find("interrupted"), std::string::npos) << run.Err;
}
