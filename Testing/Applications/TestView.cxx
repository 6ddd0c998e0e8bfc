// SPDX-License-Identifier: BSD-3-Clause
// `bmt view`: several models, meshes that are built in the background, camera paths, screenshots. Under a virtual
// display.
#include "MTRunBmt.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"

#include <iostream>
#include <set>

namespace
{
class View : public MTBmtTest
{
protected:
  void SetUp() override
  {
    MTBmtTest::SetUp();
    std::filesystem::create_directory(this->Path("temporary"));
    setenv("TMPDIR", this->Path("temporary").c_str(), 1);
  }
  void TearDown() override
  {
    unsetenv("TMPDIR");
    EXPECT_TRUE(std::filesystem::is_empty(this->Path("temporary"))) << "temporary files go with the command";
    MTBmtTest::TearDown();
  }

  nlohmann::json Look(const std::vector<std::string>& arguments) const
  {
    std::vector<std::string> call = { "view", "--off-screen", "--size", "300x200" };
    call.insert(call.end(), arguments.begin(), arguments.end());
    return this->BmtJson(call);
  }

  MTRun Fail(const std::vector<std::string>& arguments) const
  {
    std::vector<std::string> call = { "view", "--off-screen" };
    call.insert(call.end(), arguments.begin(), arguments.end());
    MTRun run = this->Bmt(call);
    EXPECT_NE(run.Exit, 0);
    return run;
  }

  // A quarter turn in a second.
  void WritePath(const std::string& name) const
  {
    this->WriteFile(name,
      "time,px,py,pz,fx,fy,fz,ux,uy,uz,view_angle,parallel_scale\n"
      "0,0,0,-6,0,0,0,0,1,0,30,0\n1,6,0,0,0,0,0,0,1,0,30,0\n");
  }

  std::size_t CountColors(const std::string& name) const
  {
    vtkNew<vtkPNGReader> reader;
    reader->SetFileName(this->Path(name).c_str());
    reader->Update();
    vtkImageData* image = reader->GetOutput();
    std::set<std::array<int, 3>> colors;
    for (int y = 0; y < image->GetDimensions()[1]; ++y)
    {
      for (int x = 0; x < image->GetDimensions()[0]; ++x)
      {
        const auto* pixel = static_cast<const unsigned char*>(image->GetScalarPointer(x, y, 0));
        colors.insert({ pixel[0], pixel[1], pixel[2] });
      }
    }
    return colors.size();
  }
};
}

TEST_F(View, ModelsAndMeshesAreInOneScene)
{
  this->MakeModel(20480);
  const nlohmann::json one = this->Look({ this->Path("sphere.bmt") });
  const nlohmann::json two = this->Look({ this->Path("sphere.bmt"), this->Path("sphere.ply") });
  std::cout << one.dump() << "\n" << two.dump() << "\n";
  EXPECT_EQ(one["files"].size(), 1u);
  EXPECT_EQ(two["files"].size(), 2u);
  EXPECT_GT(two["triangles"].get<int>(), one["triangles"].get<int>());
  EXPECT_TRUE(two["converged"]);
  EXPECT_LE(two["pixel_error"].get<double>(), 1.0);
}

TEST_F(View, APreviewOfAMeshIsSeenBeforeItsModel)
{
  this->MakeSphere(81920);
  const nlohmann::json json = this->Look(
    { this->Path("sphere.ply"), "-o", this->Path("kept.bmt"), "--keys", "g", "--screenshots", this->Path("seen") });
  EXPECT_GT(this->CountColors("seen-0001.png"), 30u) << "a shaded sphere";
  EXPECT_GT(json["triangles"].get<int>(), 0) << "the figures are those of the model";
  EXPECT_EQ(this->Bmt({ "verify", this->Path("kept.bmt"), "--input", this->Path("sphere.ply") }).Exit, 0);
  const auto time = std::filesystem::last_write_time(this->Path("kept.bmt"));
  this->Look({ this->Path("sphere.ply"), "-o", this->Path("kept.bmt") });
  EXPECT_EQ(std::filesystem::last_write_time(this->Path("kept.bmt")), time) << "it was there already";
}

TEST_F(View, APathIsPlayedFrameByFrameIntoNewPictures)
{
  this->MakeModel(20480);
  this->WritePath("path.csv");
  this->WriteFile("film-0002.png", "mine");
  const std::vector<std::string> call = { this->Path("sphere.bmt"), "--play", this->Path("path.csv"), "--frame-rate",
    "4", "--frames", this->Path("film") };
  const nlohmann::json json = this->Look(call);
  EXPECT_EQ(json["frames"], 5);
  EXPECT_EQ(this->ReadFile("film-0002.png"), "mine");
  std::set<std::string> pictures;
  for (int i = 3; i <= 7; ++i)
  {
    const std::string name = "film-000" + std::to_string(i) + ".png";
    EXPECT_GT(this->CountColors(name), 30u) << name;
    pictures.insert(this->ReadFile(name));
  }
  EXPECT_EQ(pictures.size(), 5u) << "the camera moves";
  EXPECT_FALSE(std::filesystem::exists(this->Path("film-0008.png")));
}

TEST_F(View, KeysMakePathsPicturesAndColours)
{
  this->MakeModel(20480);
  this->Look({ this->Path("sphere.bmt"), "--keys", "vgaxazakcgbghg", "--screenshots", this->Path("shot"), "--paths",
    this->Path("path") });
  std::set<std::string> pictures;
  for (int i = 1; i <= 4; ++i)
  {
    pictures.insert(this->ReadFile("shot-000" + std::to_string(i) + ".png"));
  }
  EXPECT_EQ(pictures.size(), 4u) << "plain, an array with its bar, without, with the keys";
  EXPECT_EQ(
    this->Look({ this->Path("sphere.bmt"), "--play", this->Path("path-0001.csv"), "--frame-rate", "1" })["frames"], 5);
}

TEST_F(View, WhatIsWrongIsSaidAndNothingIsLeft)
{
  this->MakeModel(1280, 64);
  this->WriteFile("bad.ply", "ply\nformat ascii 1.0\nelement vertex");
  this->WriteFile("bad.csv", "time,px,py,pz,fx,fy,fz,ux,uy,uz,view_angle,parallel_scale\n0,0,0,x,0,0,0,0,1,0,30,0\n");
  const std::string model = this->Path("sphere.bmt");
  const auto expect = [this](const std::vector<std::string>& arguments, const std::string& text)
  { EXPECT_NE(this->Fail(arguments).Err.find(text), std::string::npos) << text << ": " << this->Fail(arguments).Err; };
  expect({ this->Path("none.ply") }, "none.ply: there is no such file");
  expect({ this->Path("bad.ply") }, "bad.ply");
  for (const std::string& name : { "empty.stl", "empty.bmt", "noise.obj", "noise.vtp", "noise.glb" })
  {
    this->WriteFile(name, name.rfind("empty", 0) == 0 ? "" : "\x01\x02 noise \xff\xfe");
    expect({ this->Path(name) }, name);
  }
  expect({ model, "-o", this->Path("out.bmt") }, "--output");
  expect({ model, "--play", this->Path("bad.csv") }, "bad.csv:2: column pz: 'x'");
  expect({ model, "--play", this->Path("none.csv") }, "none.csv");
  expect({ model, "--color-by", "nothing" }, "no such array; there are level, patch, error, Normals");
  expect(
    { this->Path("sphere.ply"), "--color-by", "nothing" }, "no such array; there are level, patch, error, Normals");
  expect({ model, "--frames", this->Path("film") }, "--play");
  this->WritePath("path.csv");
  expect({ model, "--play", this->Path("path.csv"), "--frames", this->Path("nowhere/film") }, "nowhere/film-0001.png");
  EXPECT_FALSE(std::filesystem::exists(this->Path("out.bmt")));
}

TEST_F(View, ControlCEndsABuildAndLeavesNothing)
{
  this->MakeSphere(1310720);
  for (const std::string output : { "", "kept.bmt" })
  {
    MTRunOptions options;
    options.InterruptWhen = [this] { return !std::filesystem::is_empty(this->Path("temporary")); };
    std::vector<std::string> call = { "view", this->Path("sphere.ply") };
    if (!output.empty())
    {
      call.insert(call.end(), { "-o", this->Path(output) });
    }
    const MTRun run = this->Bmt(call, options);
    EXPECT_EQ(run.Exit, 130) << run.Err;
    EXPECT_EQ(this->List(), (std::vector<std::string>{ "sphere.ply", "temporary" }));
    EXPECT_TRUE(std::filesystem::is_empty(this->Path("temporary")));
  }
}
