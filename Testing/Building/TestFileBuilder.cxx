// SPDX-License-Identifier: BSD-3-Clause
// vtkMultiTriangulationFileBuilder: the bytes, progress, abort, going on, errors.
#include "MTFileBuilderTest.h"

#include "vtkMTFileSource.h"
#include "vtkMTFileSpoolStore.h"
#include "vtkMTMeshReader.h"
#include "vtkMultiTriangulationBuilder.h"
#include "vtkMultiTriangulationWriter.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>

#include <unistd.h>

class FileBuilder : public MTFileBuilderTest
{
protected:
  // Of a build without temporary files.
  MTIOTest::Bytes MakeExpected() const
  {
    const vtkNew<vtkMultiTriangulationFileBuilder> builder;
    this->Configure(builder, "expected.bmt");
    EXPECT_EQ(builder->Write(), 1) << builder->GetErrorMessage();
    return MTIOTest::ReadFile(this->Folder / "expected.bmt");
  }

  std::string MakeTemporaryFolder() const
  {
    std::filesystem::create_directories(this->Folder / "temp");
    return this->Folder / "temp";
  }
};

TEST_F(FileBuilder, HoldsWhatTheFiltersMakeInCore)
{
  this->MakeSphere(20480);
  ASSERT_FALSE(this->MakeExpected().empty());
  const vtkNew<vtkPolyData> mesh;
  std::string error;
  ASSERT_TRUE(vtkMTMeshReader::Read(this->Folder / "sphere.ply", mesh, error)) << error;
  const vtkNew<vtkMultiTriangulationBuilder> builder;
  builder->SetInputData(mesh);
  builder->SetPatchTriangles(200);
  const vtkNew<vtkMultiTriangulationWriter> writer;
  writer->SetInputConnection(builder->GetOutputPort());
  writer->SetFileName((this->Folder / "chain.bmt").c_str());
  ASSERT_EQ(writer->Write(), 1);

  vtkMTFileSource file;
  vtkMTFileSource chain;
  ASSERT_TRUE(file.Open(this->Folder / "expected.bmt", error)) << error;
  ASSERT_TRUE(chain.Open(this->Folder / "chain.bmt", error)) << error;
  vtkMTGraph graph = file.GetGraph();
  EXPECT_EQ(graph.Settings.erase("build"), 1u); // by which a finished build is known again
  MTIOTest::ExpectEqual(graph, chain.GetGraph());
  ASSERT_EQ(graph.Arcs.size(), chain.GetGraph().Arcs.size());
  for (std::uint32_t arc = 0; arc < graph.Arcs.size(); ++arc)
  {
    vtkMTPatch patches[2];
    ASSERT_TRUE(file.ReadPatch(arc, nullptr, patches[0], error)) << error;
    ASSERT_TRUE(chain.ReadPatch(arc, nullptr, patches[1], error)) << error;
    EXPECT_TRUE(MTIOTest::AreEqual(patches[0], patches[1])) << "patch " << arc;
  }
  std::printf("%zu patches, all equal\n", graph.Arcs.size());
}

TEST_F(FileBuilder, BytesDoNotDependOnThreadsMemoryOrFolder)
{
  this->MakeSphere(81920);
  const MTIOTest::Bytes expected = this->MakeExpected();
  ASSERT_FALSE(expected.empty());
  for (const bool inFolder : { false, true })
  {
    const vtkNew<vtkMultiTriangulationFileBuilder> builder;
    this->Configure(builder);
    builder->SetNumberOfThreads(inFolder ? 3 : 1);
    builder->SetTemporaryFolder(inFolder ? this->MakeTemporaryFolder().c_str() : "");
    ASSERT_EQ(builder->Write(), 1) << builder->GetErrorMessage();
    EXPECT_TRUE(MTIOTest::ReadFile(this->Folder / "out.bmt") == expected) << inFolder;
  }
  EXPECT_TRUE(std::filesystem::is_empty(this->Folder / "temp"));
}

TEST_F(FileBuilder, ProgressRisesToOneAndSaysWhatIsDone)
{
  this->MakeSphere(20480);
  const vtkNew<vtkMultiTriangulationFileBuilder> builder;
  this->Configure(builder);
  Events events;
  Observe(builder, events);
  ASSERT_EQ(builder->Write(), 1) << builder->GetErrorMessage();
  EXPECT_TRUE(std::is_sorted(events.Fractions.begin(), events.Fractions.end()));
  ASSERT_FALSE(events.Fractions.empty());
  EXPECT_EQ(events.Fractions.front(), 0.0);
  EXPECT_EQ(events.Fractions.back(), 1.0);
  std::vector<std::string> texts = events.Texts;
  texts.erase(std::unique(texts.begin(), texts.end()), texts.end());
  std::printf("%zu progress events, %zu texts\n", events.Fractions.size(), texts.size());
  EXPECT_NE(std::find(texts.begin(), texts.end(), "opening the input"), texts.end());
  EXPECT_GT(texts.size(), 4u);
  EXPECT_TRUE(events.Errors.empty());
}

TEST_F(FileBuilder, AbortLeavesNothingBehind)
{
  this->MakeSphere(20480);
  for (const double share : { 0.0, 0.1, 0.5, 0.9 })
  {
    const vtkNew<vtkMultiTriangulationFileBuilder> builder;
    this->Configure(builder);
    Events events;
    events.AbortWhen = [&events, share] { return events.Fractions.back() >= share; };
    Observe(builder, events);
    EXPECT_EQ(builder->Write(), 0);
    EXPECT_EQ(builder->GetErrorCode(), vtkMultiTriangulationFileBuilder::AbortError);
    EXPECT_TRUE(events.Errors.empty()) << events.Errors.front();
    EXPECT_FALSE(builder->GetHasCheckpoint());
    EXPECT_LT(events.Fractions.back(), 1.0);
    EXPECT_EQ(this->Folder.List(), std::vector<std::string>{ "sphere.ply" }) << share;
    events.AbortWhen = [] { return false; };
    EXPECT_EQ(builder->Write(), 1) << builder->GetErrorMessage();
    std::filesystem::remove(this->Folder / "out.bmt");
  }
}

TEST_F(FileBuilder, GoesOnAfterAnAbortToTheSameBytes)
{
  this->MakeSphere(81920);
  const MTIOTest::Bytes expected = this->MakeExpected();
  const vtkNew<vtkMultiTriangulationFileBuilder> builder;
  this->Configure(builder);
  builder->SetTemporaryFolder(this->MakeTemporaryFolder().c_str());
  Events events;
  events.AbortWhen = [&builder] { return vtkMTFileSpoolStore::HasState(builder->GetWorkFolder()); };
  Observe(builder, events);
  EXPECT_EQ(builder->Write(), 0);
  EXPECT_EQ(builder->GetErrorCode(), vtkMultiTriangulationFileBuilder::AbortError);
  EXPECT_TRUE(builder->GetHasCheckpoint());
  EXPECT_FALSE(std::filesystem::exists(this->Folder / "out.bmt"));
  const double share = events.Fractions.back();

  // Neither forgotten nor mixed up.
  events.AbortWhen = [] { return false; };
  EXPECT_EQ(builder->Write(), 0);
  EXPECT_EQ(builder->GetErrorCode(), vtkMultiTriangulationFileBuilder::UnfinishedBuildError);
  builder->ResumeOn();
  builder->SetPatchTriangles(500);
  EXPECT_EQ(builder->Write(), 0);
  EXPECT_NE(builder->GetErrorMessage().find("other settings"), std::string::npos) << builder->GetErrorMessage();
  builder->SetPatchTriangles(200);
  events.Fractions.clear();
  builder->Update();
  EXPECT_EQ(builder->GetErrorCode(), vtkErrorCode::NoError) << builder->GetErrorMessage();
  EXPECT_TRUE(MTIOTest::ReadFile(this->Folder / "out.bmt") == expected);
  EXPECT_TRUE(std::filesystem::is_empty(this->Folder / "temp"));
  EXPECT_FALSE(builder->GetWasFinished());

  // And what is finished is known again.
  EXPECT_EQ(builder->Write(), 1);
  EXPECT_TRUE(builder->GetWasFinished());
  builder->ExactPointsOn();
  EXPECT_EQ(builder->Write(), 1) << builder->GetErrorMessage();
  EXPECT_FALSE(builder->GetWasFinished());
  std::printf("aborted at %.0f %%\n", 100.0 * share);
}

TEST_F(FileBuilder, UpdateBuildsWhenASettingHasChangedAndWriteAlways)
{
  this->MakeSphere(5120);
  const vtkNew<vtkMultiTriangulationFileBuilder> builder;
  this->Configure(builder);
  Events events;
  Observe(builder, events);
  const std::string output = this->Folder / "out.bmt";
  const auto updates = [&]
  {
    std::filesystem::remove(output);
    builder->Update();
    return std::filesystem::exists(output);
  };
  EXPECT_TRUE(updates());
  EXPECT_FALSE(updates()) << "nothing has changed";
  builder->SetPatchTriangles(100);
  EXPECT_TRUE(updates());
  builder->SetVerticalScale(2.0);
  EXPECT_TRUE(updates());
  builder->GetPartitionStrategy();
  EXPECT_FALSE(updates());
  builder->SetFileName((this->Folder / "later.ply").c_str());
  EXPECT_FALSE(updates());
  EXPECT_EQ(builder->GetErrorCode(), vtkErrorCode::FileNotFoundError);
  this->MakeSphere(1280, "later.ply");
  EXPECT_FALSE(updates()) << "no setting has changed";
  EXPECT_EQ(builder->Write(), 1) << builder->GetErrorMessage();
}

TEST_F(FileBuilder, ErrorsHaveCodesAndSayWhatToDo)
{
  this->MakeSphere(5120);
  MTIOTest::WriteFile(this->Folder / "noise.ply", std::string(1000, 'n'));
  const auto expect = [this](unsigned long code, const std::string& what,
                        const std::function<void(vtkMultiTriangulationFileBuilder*)>& set)
  {
    const vtkNew<vtkMultiTriangulationFileBuilder> builder;
    this->Configure(builder);
    set(builder);
    Events events;
    Observe(builder, events);
    EXPECT_EQ(builder->Write(), 0) << what;
    EXPECT_EQ(builder->GetErrorCode(), code) << builder->GetErrorMessage();
    EXPECT_NE(builder->GetErrorMessage().find(what), std::string::npos) << builder->GetErrorMessage();
    ASSERT_EQ(events.Errors.size(), 1u) << what;
    EXPECT_NE(events.Errors[0].find(builder->GetErrorMessage()), std::string::npos) << events.Errors[0];
    std::printf("%lu: %s\n", code, builder->GetErrorMessage().c_str());
  };
  using Builder = vtkMultiTriangulationFileBuilder;
  expect(vtkErrorCode::NoFileNameError, "AddFileName", [](Builder* b) { b->RemoveAllFileNames(); });
  expect(vtkErrorCode::NoFileNameError, "SetOutputFileName", [](Builder* b) { b->SetOutputFileName(""); });
  expect(vtkErrorCode::FileNotFoundError, "none.ply", [](Builder* b) { b->AddFileName("none.ply"); });
  expect(vtkErrorCode::CannotOpenFileError, "is a folder", [](Builder* b) { b->SetFileName("/"); });
  expect(vtkErrorCode::CannotOpenFileError, "make it first",
    [this](Builder* b) { b->SetOutputFileName((this->Folder / "nowhere/out.bmt").c_str()); });
  expect(vtkErrorCode::CannotOpenFileError, "make it first",
    [this](Builder* b) { b->SetTemporaryFolder((this->Folder / "nowhere").c_str()); });
  expect(vtkErrorCode::FileFormatError, "noise.ply",
    [this](Builder* b) { b->SetFileName((this->Folder / "noise.ply").c_str()); });
  expect(Builder::MemoryLimitError, "is the least that would do", [](Builder* b) { b->SetMemoryLimit(1 << 20); });
  expect(Builder::ArrayError, "\"Wrong\"", [](Builder* b) { b->AddArrayName("Wrong"); });
  expect(Builder::PrecisionError, "the least is", [](Builder* b) { b->SetPrecision(1e-30); });
  EXPECT_EQ(this->Folder.List(), (std::vector<std::string>{ "noise.ply", "sphere.ply" }));
}

TEST_F(FileBuilder, NumbersThatAreNoneAreRefused)
{
  const vtkNew<vtkMultiTriangulationFileBuilder> builder;
  Events events;
  Observe(builder, events);
  const vtkMTimeType before = builder->GetMTime();
  std::size_t refused = 0;
  for (const double value : { std::nan(""), std::numeric_limits<double>::infinity(), -std::nan("") })
  {
    builder->SetIsoValue(value);
    builder->SetVerticalScale(value);
    builder->SetPrecision(value);
    refused += 3;
  }
  builder->SetVerticalScale(0.0);
  builder->SetPrecision(-1.0);
  EXPECT_EQ(events.Errors.size(), refused + 2);
  EXPECT_EQ(builder->GetMTime(), before);
  EXPECT_FALSE(builder->HasIsoValue());
  EXPECT_EQ(builder->GetVerticalScale(), 1.0);
  EXPECT_EQ(builder->GetPrecision(), 0.0);
}

TEST_F(FileBuilder, AnEarlierOutputStaysUntilTheNewOneIsWhole)
{
  this->MakeSphere(20480);
  MTIOTest::WriteFile(this->Folder / "out.bmt", std::string("what was there before"));
  const MTIOTest::Bytes before = MTIOTest::ReadFile(this->Folder / "out.bmt");
  const vtkNew<vtkMultiTriangulationFileBuilder> builder;
  this->Configure(builder);
  Events events;
  events.AbortWhen = [&events] { return events.Fractions.back() > 0.8; };
  Observe(builder, events);
  EXPECT_EQ(builder->Write(), 0);
  EXPECT_TRUE(MTIOTest::ReadFile(this->Folder / "out.bmt") == before);
  events.AbortWhen = [] { return false; };
  EXPECT_EQ(builder->Write(), 1) << builder->GetErrorMessage();
  EXPECT_FALSE(MTIOTest::ReadFile(this->Folder / "out.bmt") == before);
}
