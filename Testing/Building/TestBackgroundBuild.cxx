// SPDX-License-Identifier: BSD-3-Clause
// Meshes that are built in the background: previews first, the models that the builder makes, and nothing left behind.
#include "MTFileBuilderTest.h"

#include "vtkMTBackgroundBuild.h"
#include "vtkMTChildProcess.h"

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <set>
#include <thread>

namespace
{
class BackgroundBuild : public MTFileBuilderTest
{
protected:
  void SetUp() override
  {
    std::filesystem::create_directory(this->Folder / "temporary");
    setenv("TMPDIR", (this->Folder / "temporary").c_str(), 1);
  }
  void TearDown() override { unsetenv("TMPDIR"); }

  vtkMTInputSettings Settings(const std::string& name) const
  {
    vtkMTInputSettings settings;
    settings.Paths = { this->Folder / name };
    return settings;
  }

  // All events until nothing runs any more, or until one of that kind.
  static std::vector<vtkMTBuildEvent> Wait(vtkMTBackgroundBuild& build, char kind = 0)
  {
    std::vector<vtkMTBuildEvent> events;
    bool isThere = false;
    while (build.IsRunning() && !isThere)
    {
      for (const vtkMTBuildEvent& event : build.Poll())
      {
        events.push_back(event);
        isThere = isThere || event.Kind == kind;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return events;
  }

  // What the builder makes of it, in a process of its own: a child cannot be started after a build's threads.
  MTIOTest::Bytes BuildInChild(const std::string& name) const
  {
    vtkMTChildProcess child;
    std::string error;
    const auto build = [&](const vtkMTChildProcess::Report&)
    {
      vtkNew<vtkMultiTriangulationFileBuilder> builder;
      builder->AddFileName((this->Folder / name).c_str());
      builder->SetOutputFileName((this->Folder / "out.bmt").c_str());
      return builder->Write() ? 0 : 1;
    };
    EXPECT_TRUE(child.Start(build, error)) << error;
    while (child.IsRunning())
    {
      child.TakeLines();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    EXPECT_EQ(child.GetExitCode(), 0);
    return MTIOTest::ReadFile(this->Folder / "out.bmt");
  }

  bool IsTemporaryFolderEmpty() const { return std::filesystem::is_empty(this->Folder / "temporary"); }
};
}

TEST_F(BackgroundBuild, GivesPreviewsFirstAndThenTheBuildersModels)
{
  this->MakeSphere(20480, "one.ply");
  this->MakeSphere(5120, "two.ply");
  std::string error;
  std::string kinds;
  std::vector<MTIOTest::Bytes> models;
  {
    vtkMTBackgroundBuild build;
    ASSERT_TRUE(
      build.Start({ this->Settings("one.ply"), this->Settings("none.ply"), this->Settings("two.ply") }, "", error))
      << error;
    for (const vtkMTBuildEvent& event : Wait(build))
    {
      kinds += event.Kind == vtkMTBuildEvent::Progress ? std::string()
                                                       : static_cast<char>(event.Kind) + std::to_string(event.Index);
      if (event.Kind == vtkMTBuildEvent::Preview)
      {
        EXPECT_EQ(event.Mesh->GetNumberOfPolys(), event.Index == 0 ? 20480 : 5120);
      }
      if (event.Kind == vtkMTBuildEvent::Model)
      {
        models.push_back(MTIOTest::ReadFile(event.Text));
      }
      if (event.Kind == vtkMTBuildEvent::Failure)
      {
        EXPECT_NE(event.Text.find("none.ply"), std::string::npos) << event.Text;
        EXPECT_NE(event.Code, 0ul);
      }
    }
    EXPECT_FALSE(this->IsTemporaryFolderEmpty()) << "models are kept as long as the object is there";
  }
  EXPECT_EQ(kinds, "v0v2m0f1m2");
  EXPECT_TRUE(this->IsTemporaryFolderEmpty());
  ASSERT_EQ(models.size(), 2u);
  EXPECT_TRUE(models[0] == this->BuildInChild("one.ply"));
}

TEST_F(BackgroundBuild, AModelThatIsThereIsTakenAsItIs)
{
  this->MakeSphere(20480, "one.ply");
  std::string error;
  std::set<std::filesystem::file_time_type> times;
  for (int i = 0; i < 2; ++i)
  {
    vtkMTBackgroundBuild build;
    ASSERT_TRUE(build.Start({ this->Settings("one.ply") }, this->Folder / "one.bmt", error)) << error;
    const std::vector<vtkMTBuildEvent> events = Wait(build);
    ASSERT_FALSE(events.empty());
    EXPECT_EQ(events.back().Kind, vtkMTBuildEvent::Model);
    EXPECT_EQ(events.back().Text, this->Folder / "one.bmt");
    times.insert(std::filesystem::last_write_time(this->Folder / "one.bmt"));
  }
  EXPECT_EQ(times.size(), 1u) << "written once";
  EXPECT_EQ(this->Folder.List(), (std::vector<std::string>{ "one.bmt", "one.ply", "temporary" }));
  EXPECT_TRUE(this->IsTemporaryFolderEmpty());
}

TEST_F(BackgroundBuild, EndsAtAnyTimeAndLeavesNothing)
{
  this->MakeSphere(327680, "one.ply");
  std::string error;
  for (const char kind : { vtkMTBuildEvent::Progress, vtkMTBuildEvent::Preview })
  {
    for (const std::string& output : { std::string(), this->Folder / "one.bmt" })
    {
      vtkMTBackgroundBuild build;
      ASSERT_TRUE(build.Start({ this->Settings("one.ply") }, output, error)) << error;
      EXPECT_FALSE(Wait(build, kind).empty());
      EXPECT_TRUE(build.IsRunning());
    }
    EXPECT_EQ(this->Folder.List(), (std::vector<std::string>{ "one.ply", "temporary" }));
    EXPECT_TRUE(this->IsTemporaryFolderEmpty());
  }
}

TEST_F(BackgroundBuild, WithoutMeshesThereIsNothingToDoAndWithoutAFolderAnError)
{
  std::string error;
  vtkMTBackgroundBuild none;
  EXPECT_TRUE(none.Start({}, "", error)) << error;
  EXPECT_FALSE(none.IsRunning());
  EXPECT_TRUE(none.Poll().empty());
  this->MakeSphere(1280, "one.ply");
  setenv("TMPDIR", (this->Folder / "one.ply").c_str(), 1);
  vtkMTBackgroundBuild build;
  bool isStarted = true;
  try
  {
    isStarted = build.Start({ this->Settings("one.ply") }, "", error);
  }
  catch (const std::exception& thrown)
  {
    ADD_FAILURE() << "nothing must be thrown: " << thrown.what();
  }
  EXPECT_FALSE(isStarted);
  EXPECT_NE(error.find("temporary folder"), std::string::npos) << error;
}
