// SPDX-License-Identifier: BSD-3-Clause
// bmt build with spools on disk: the same bytes under any limit, after any failure and any interruption.
#include "MTFaultyStore.h"
#include "MTRunBmt.h"

#include "vtkMTFileSink.h"
#include "vtkMTFileSpoolStore.h"
#include "vtkMTFractalSphere.h"
#include "vtkMultiTriangulationBuilder.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPLYReader.h"
#include "vtkPolyData.h"
#include "vtkXMLPolyDataWriter.h"

#include <cmath>
#include <cstdio>
#include <memory>

#include <sys/resource.h>

namespace
{
constexpr double MiB = 1024.0 * 1024.0;
}

class OutOfCore : public MTBmtTest
{
protected:
  std::vector<std::string> BuildCall(const std::vector<std::string>& more, const std::string& output = "out.bmt") const
  {
    std::vector<std::string> call{ "build", this->Path("sphere.ply"), "-o", this->Path(output) };
    call.insert(call.end(), more.begin(), more.end());
    return call;
  }

  // With 30 values per triangle, in wide.vtp, which is read as a whole where it is compressed.
  void MakeWide(int triangles, bool isCompressed) const
  {
    this->MakeSphere(triangles);
    const vtkNew<vtkPLYReader> reader;
    reader->SetFileName(this->Path("sphere.ply").c_str());
    reader->Update();
    vtkPolyData* mesh = reader->GetOutput();
    const vtkNew<vtkDoubleArray> values;
    values->SetName("values");
    values->SetNumberOfComponents(30);
    values->SetNumberOfTuples(mesh->GetNumberOfCells());
    for (vtkIdType i = 0; i < values->GetNumberOfValues(); ++i)
    {
      values->SetValue(i, std::sin(0.1 * static_cast<double>(i)));
    }
    mesh->GetCellData()->AddArray(values);
    const vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetFileName(this->Path("wide.vtp").c_str());
    writer->SetInputData(mesh);
    writer->EncodeAppendedDataOff();
    if (!isCompressed)
    {
      writer->SetCompressorTypeToNone();
    }
    ASSERT_EQ(writer->Write(), 1);
  }

  // In MiB; what the refusal of too little memory says.
  double GetLeastLimit(
    const std::string& mesh, const std::string& memory = "64MiB", const MTRunOptions& options = {}) const
  {
    const MTRun run = this->Bmt(
      { "build", this->Path(mesh), "-o", this->Path("out.bmt"), "--threads", "4", "--memory", memory }, options);
    EXPECT_EQ(run.Exit, 1);
    const std::string before = "small for this input: ";
    const std::size_t begin = run.Err.find(before);
    EXPECT_NE(begin, std::string::npos) << run.Err;
    return begin == std::string::npos ? 0.0 : std::stod(run.Err.substr(begin + before.size()));
  }

  // In MiB, of the largest child until now, of which this is one with that limit.
  double GetPeakOfBuild(const std::string& mesh, double limit) const
  {
    const std::string memory = std::to_string(static_cast<int>(limit)) + "MiB";
    this->BmtJson({ "build", this->Path(mesh), "-o", this->Path("out.bmt"), "--threads", "4", "--memory", memory });
    rusage usage;
    getrusage(RUSAGE_CHILDREN, &usage);
    const double peak = static_cast<double>(usage.ru_maxrss) / 1024.0;
    std::printf("limit %.0f MiB, largest child %.1f MiB\n", limit, peak);
    return peak;
  }

  // In the store's folder, with small patches; the sink publishes name.
  bool Build(std::shared_ptr<vtkMTSpoolStore> store, bool resume, const std::string& name, std::string& error) const
  {
    vtkMTFractalSphere sphere(5120);
    vtkMTFileSink sink(this->Path(name), vtkMTFileSink::Fast, store.get());
    const vtkNew<vtkMultiTriangulationBuilder> builder;
    builder->SetPatchTriangles(100);
    builder->SetNumberOfThreads(2);
    builder->SetSpoolStore(store);
    builder->SetResume(resume);
    const bool built = builder->Build(sphere, sink);
    error = builder->GetErrorMessage();
    return built;
  }
};

TEST_F(OutOfCore, BytesDoNotDependOnLimitThreadsOrFolder)
{
  this->MakeSphere(81920);
  this->BmtJson(this->BuildCall({}, "core.bmt"));
  const std::string expected = this->ReadFile("core.bmt");
  std::filesystem::create_directories(this->Folder / "temp");
  const std::vector<std::vector<std::string>> ways = { { "--memory", "220MiB", "--threads", "3" },
    { "--memory", "220MiB", "--threads", "1" },
    { "--temp", this->Path("temp"), "--memory", "1GiB", "--threads", "2" } };
  for (const auto& way : ways)
  {
    const nlohmann::json json = this->BmtJson(this->BuildCall(way));
    EXPECT_TRUE(this->ReadFile("out.bmt") == expected) << way[1];
    EXPECT_TRUE(json["input_streamed"].get<bool>());
    std::printf("%s: %.1f MB of temporary files, %.1f MB estimated\n", way[1].c_str(),
      1e-6 * json["temporary_bytes"].get<double>(), 1e-6 * json["temporary_bytes_estimated"].get<double>());
    EXPECT_LE(json["temporary_bytes"].get<double>(), json["temporary_bytes_estimated"].get<double>());
  }
  EXPECT_TRUE(std::filesystem::is_empty(this->Folder / "temp"));
  EXPECT_EQ(this->List(), (std::vector<std::string>{ "core.bmt", "out.bmt", "sphere.ply", "temp" }));
}

TEST_F(OutOfCore, ProcessStaysWithinItsLimit)
{
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers keep memory that was freed";
#endif
  this->MakeSphere(327680);
  const double least = this->GetLeastLimit("sphere.ply");
  const double peak = this->GetPeakOfBuild("sphere.ply", least);
  EXPECT_LE(peak, least);
  EXPECT_GT(peak, 0.2 * least);
}

TEST_F(OutOfCore, ProcessStaysWithinItsLimitWithManyValuesPerTriangle)
{
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers keep memory that was freed";
#endif
  this->MakeWide(327680, false);
  const double least = this->GetLeastLimit("wide.vtp");
  EXPECT_LE(this->GetPeakOfBuild("wide.vtp", least), least);
}

// Its environment, and whether the loader resolves all symbols at once, change what the process holds before it builds.
TEST_F(OutOfCore, LeastLimitThatARefusalNamesIsAcceptedWhateverIsResident)
{
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers keep memory that was freed";
#endif
  MTRunOptions large;
  large.Environment = { "LD_BIND_NOW=1" };
  for (int i = 0; i < 15; ++i)
  {
    large.Environment.push_back("MT_FILLER_" + std::to_string(i) + "=" + std::string(100000, 'x'));
  }
  const MTRunOptions plain;
  this->MakeWide(81920, true);
  const std::pair<const MTRunOptions*, const MTRunOptions*> ways[] = { { &plain, &plain }, { &plain, &large },
    { &large, &plain } };
  for (const char* mesh : { "sphere.ply", "wide.vtp" })
  {
    for (const auto& [refused, accepted] : ways)
    {
      for (const char* tooLittle : { "1MiB", "100MiB" })
      {
        const auto least = static_cast<int>(this->GetLeastLimit(mesh, tooLittle, *refused));
        const MTRun run = this->Bmt({ "build", this->Path(mesh), "-o", this->Path("out.bmt"), "--threads", "4",
                                      "--memory", std::to_string(least) + " MiB", "--json" },
          *accepted);
        ASSERT_EQ(run.Exit, 0) << run.Err;
        const double peak = run.Json()["peak_memory_bytes"].get<double>() / MiB;
        std::printf("%s: %d MiB named, %.1f MiB used\n", mesh, least, peak);
        EXPECT_LE(peak, least);
      }
    }
  }
}

TEST_F(OutOfCore, ResumeAfterAnyFailedWriteGivesTheSameBytes)
{
  std::string error;
  const auto open = [&](const std::string& folder)
  {
    auto store = std::make_shared<vtkMTFileSpoolStore>();
    EXPECT_TRUE(store->OpenFolder(this->Path(folder), error)) << error;
    return store;
  };
  std::uint64_t writes = 0;
  {
    const auto files = open("work");
    const auto store = std::make_shared<MTFaultyStore>(*files);
    ASSERT_TRUE(this->Build(store, false, "expected.bmt", error)) << error;
    writes = store->GetNumberOfWrites();
  }
  const std::string expected = this->ReadFile("expected.bmt");
  ASSERT_FALSE(expected.empty());
  std::size_t resumed = 0;
  const std::uint64_t step = std::max<std::uint64_t>(1, writes / 25);
  for (std::uint64_t i = 0; i < writes; i += step)
  {
    {
      const auto files = open("work");
      const auto store = std::make_shared<MTFaultyStore>(*files);
      store->FailingWrite = i;
      EXPECT_FALSE(this->Build(store, false, "out.bmt", error));
      EXPECT_NE(error.find("planned failure"), std::string::npos) << error;
      EXPECT_FALSE(std::filesystem::exists(this->Folder / "out.bmt"));
    }
    const bool hasState = vtkMTFileSpoolStore::HasState(this->Path("work"));
    EXPECT_TRUE(hasState || !std::filesystem::exists(this->Folder / "work")) << "something useless was left";
    resumed += hasState ? 1 : 0;
    ASSERT_TRUE(this->Build(open("work"), true, "out.bmt", error)) << i << ": " << error;
    EXPECT_TRUE(this->ReadFile("out.bmt") == expected) << "after failed write " << i;
    std::filesystem::remove(this->Folder / "out.bmt");
  }
  std::printf("%llu writes; %zu builds went on from a checkpoint\n", static_cast<unsigned long long>(writes), resumed);
  EXPECT_GT(resumed, 5u);
  EXPECT_EQ(this->List(), std::vector<std::string>{ "expected.bmt" });
}

TEST_F(OutOfCore, InterruptedBuildSaysHowToGoOnAndDoes)
{
  this->MakeSphere(327680);
  this->BmtJson(this->BuildCall({}, "core.bmt"));
  MTRunOptions options;
  const std::filesystem::path temp = this->Folder / "temp";
  std::filesystem::create_directories(temp);
  options.InterruptWhen = [&temp]
  {
    std::error_code code;
    for (const auto& entry : std::filesystem::directory_iterator(temp, code))
    {
      if (vtkMTFileSpoolStore::HasState(entry.path().string()))
      {
        return true;
      }
    }
    return false;
  };
  const std::vector<std::string> way{ "--temp", this->Path("temp"), "--threads", "1" };
  const MTRun run = this->Bmt(this->BuildCall(way), options);
  ASSERT_EQ(run.Exit, 130) << run.Out << run.Err;
  EXPECT_FALSE(std::filesystem::exists(this->Folder / "out.bmt"));
  ASSERT_NE(run.Err.find("--resume"), std::string::npos) << run.Err;
  EXPECT_NE(run.Err.find(this->Path("temp")), std::string::npos) << run.Err;
  // Neither forgotten nor mixed up.
  const MTRun anew = this->Bmt(this->BuildCall(way));
  EXPECT_EQ(anew.Exit, 1);
  EXPECT_NE(anew.Err.find("unfinished build"), std::string::npos) << anew.Err;
  std::vector<std::string> other = way;
  other.insert(other.end(), { "--resume", "--patch-triangles", "500" });
  const MTRun otherSettings = this->Bmt(this->BuildCall(other));
  EXPECT_EQ(otherSettings.Exit, 1);
  EXPECT_NE(otherSettings.Err.find("other settings"), std::string::npos) << otherSettings.Err;
  std::vector<std::string> resume = way;
  resume.emplace_back("--resume");
  this->BmtJson(this->BuildCall(resume));
  EXPECT_TRUE(this->ReadFile("out.bmt") == this->ReadFile("core.bmt"));
  EXPECT_TRUE(std::filesystem::is_empty(this->Folder / "temp"));
  // With nothing left to go on from it just succeeds.
  this->MakeSphere(20480);
  this->BmtJson(this->BuildCall(resume));
}

TEST_F(OutOfCore, FoldersAndSizesThatMakeNoSenseAreClearErrors)
{
  this->MakeSphere(20480);
  const std::pair<std::vector<std::string>, const char*> calls[] = {
    { { "--temp", this->Path("none") }, "no such folder" }, { { "--memory", "much" }, "is no size" },
    { { "--memory", "-3GiB" }, "is no size" }, { { "--memory", "1MiB" }, "least that would do" }
  };
  for (const auto& [options, message] : calls)
  {
    const MTRun run = this->Bmt(this->BuildCall(options));
    EXPECT_EQ(run.Exit, 1) << message;
    EXPECT_NE(run.Err.find(message), std::string::npos) << run.Err;
  }
  EXPECT_EQ(this->List(), std::vector<std::string>{ "sphere.ply" });
}
