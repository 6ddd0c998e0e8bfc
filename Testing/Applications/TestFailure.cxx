// SPDX-License-Identifier: BSD-3-Clause
// What can go wrong around bmt build: it is killed, disks are full or gone, inputs change. Nothing is damaged, and what
// is left can be gone on with.
#include "MTRunBmt.h"

#include "vtkMTFileSpoolStore.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <random>

#include <sys/mount.h>
#include <unistd.h>

namespace
{
namespace fs = std::filesystem;

// A file system in memory of a size of its own, for those who may mount one.
class TmpFs
{
public:
  TmpFs(const fs::path& folder, const std::string& options, unsigned long flags = 0)
    : Folder(folder)
  {
    fs::create_directories(folder);
    this->IsMounted = ::mount("tmpfs", folder.c_str(), "tmpfs", flags, options.c_str()) == 0;
  }
  ~TmpFs()
  {
    if (this->IsMounted)
    {
      ::umount2(this->Folder.c_str(), MNT_DETACH);
    }
  }
  TmpFs(const TmpFs&) = delete;
  void operator=(const TmpFs&) = delete;

  bool IsMounted = false;

private:
  const fs::path Folder;
};
}

class Failure : public MTBmtTest
{
protected:
  std::vector<std::string> BuildCall(const std::vector<std::string>& more, const std::string& output = "out.bmt") const
  {
    std::vector<std::string> call{ "build", this->Path("sphere.ply"), "-o", this->Path(output), "--patch-triangles",
      "200" };
    call.insert(call.end(), more.begin(), more.end());
    return call;
  }

  // With files in the folder temp.
  std::vector<std::string> ToDisk(const std::vector<std::string>& more = {}) const
  {
    std::vector<std::string> options{ "--temp", this->Path("temp") };
    options.insert(options.end(), more.begin(), more.end());
    return this->BuildCall(options);
  }

  fs::path GetWork() const { return this->Folder / "temp" / "out.bmt.build"; }
  bool HasCheckpoint() const { return vtkMTFileSpoolStore::HasState(this->GetWork().string()); }

  void ExpectResumed(const std::string& expected, const std::string& what) const
  {
    const MTRun run = this->Bmt(this->ToDisk({ "--resume" }));
    EXPECT_EQ(run.Exit, 0) << what << ": " << run.Err;
    EXPECT_TRUE(this->ReadFile("out.bmt") == expected) << what;
    EXPECT_TRUE(fs::is_empty(this->Folder / "temp")) << what;
  }

  std::string MakeExpected(int triangles) const
  {
    this->MakeSphere(triangles);
    this->BmtJson(this->BuildCall({}, "expected.bmt"));
    fs::create_directories(this->Folder / "temp");
    return this->ReadFile("expected.bmt");
  }
};

TEST_F(Failure, KilledAtAnyMomentItGoesOnToTheSameBytes)
{
  const std::string expected = this->MakeExpected(40960);
  const char* wanted = std::getenv("MT_KILL_POINTS");
  const int points = wanted ? std::atoi(wanted) : 20;
  const double whole = 1e3 * this->BmtJson(this->ToDisk())["seconds"].get<double>();
  std::mt19937 random(4);
  int killed = 0;
  int resumed = 0;
  for (int i = 0; i < points; ++i)
  {
    fs::remove(this->Folder / "out.bmt");
    MTRunOptions options;
    options.Signal = SIGKILL;
    options.InterruptAfterMilliseconds = static_cast<int>(whole * (random() % 1100) / 1000.0);
    const MTRun run = this->Bmt(this->ToDisk(), options);
    killed += run.Exit == 1000 + SIGKILL ? 1 : 0;
    EXPECT_TRUE(run.Exit == 0 || run.Exit == 1000 + SIGKILL) << run.Err;
    resumed += this->HasCheckpoint() ? 1 : 0;
    // And once more while it goes on.
    options.InterruptAfterMilliseconds /= 2;
    std::vector<std::string> resume = this->ToDisk({ "--resume" });
    this->Bmt(resume, options);
    this->ExpectResumed(expected, "killed after " + std::to_string(2 * options.InterruptAfterMilliseconds) + " ms");
  }
  std::printf("%d builds of %.0f ms, %d killed, %d of them with a checkpoint\n", points, whole, killed, resumed);
  EXPECT_GT(killed, 0);
  EXPECT_EQ(this->List(), (std::vector<std::string>{ "expected.bmt", "out.bmt", "sphere.ply", "temp" }));
}

TEST_F(Failure, FilesThatMayNotGrowAreAnErrorAndTheBuildGoesOnLater)
{
  const std::string expected = this->MakeExpected(40960);
  for (const std::uint64_t limit : { 4u << 10, 32u << 10, 64u << 10, 128u << 10, 256u << 10, 384u << 10, 448u << 10 })
  {
    MTRunOptions options;
    options.LargestFile = limit;
    const MTRun run = this->Bmt(this->ToDisk(), options);
    EXPECT_EQ(run.Exit, 1) << limit;
    EXPECT_NE(run.Err.find("File too large"), std::string::npos) << run.Err;
    EXPECT_FALSE(fs::exists(this->Folder / "out.bmt"));
    EXPECT_TRUE(this->HasCheckpoint() || fs::is_empty(this->Folder / "temp")) << "something useless was left";
    EXPECT_EQ(this->HasCheckpoint(), run.Err.find("--resume") != std::string::npos) << run.Err;
    std::printf("%8llu bytes: %s", static_cast<unsigned long long>(limit), run.Err.c_str());
    this->ExpectResumed(expected, "after files of " + std::to_string(limit) + " bytes");
    fs::remove(this->Folder / "out.bmt");
  }
}

TEST_F(Failure, FullDiskIsAnErrorAndTheBuildGoesOnWhenThereIsRoom)
{
  const std::string expected = this->MakeExpected(81920);
  const TmpFs disk(this->Folder / "temp", "size=20m");
  if (!disk.IsMounted)
  {
    GTEST_SKIP() << "no file system can be mounted here";
  }
  // What fills the disk as soon as there is a checkpoint.
  MTRunOptions options;
  options.InterruptWhen = [this]
  {
    if (this->HasCheckpoint() && !fs::exists(this->Folder / "temp" / "hog"))
    {
      std::ofstream hog(this->Folder / "temp" / "hog");
      hog << std::string(std::size_t(20) << 20, 'x');
    }
    return false;
  };
  const MTRun run = this->Bmt(this->ToDisk({ "--threads", "1" }), options);
  EXPECT_EQ(run.Exit, 1);
  EXPECT_NE(run.Err.find("No space left"), std::string::npos) << run.Err;
  EXPECT_NE(run.Err.find("--resume"), std::string::npos) << run.Err;
  fs::remove(this->Folder / "temp" / "hog");
  this->ExpectResumed(expected, "after a full disk");
  // Too small from the beginning; and no room for the output alone.
  {
    const TmpFs small(this->Folder / "temp", "size=1m");
    const MTRun refused = this->Bmt(this->ToDisk());
    EXPECT_EQ(refused.Exit, 1);
    EXPECT_NE(refused.Err.find("may take"), std::string::npos) << refused.Err;
    EXPECT_TRUE(fs::is_empty(this->Folder / "temp"));
  }
  const TmpFs small(this->Folder / "small", "size=300k");
  std::vector<std::string> call = this->ToDisk();
  call[3] = this->Path("small/out.bmt");
  const MTRun noRoom = this->Bmt(call);
  EXPECT_EQ(noRoom.Exit, 1);
  EXPECT_NE(noRoom.Err.find("No space left"), std::string::npos) << noRoom.Err;
  EXPECT_TRUE(fs::is_empty(this->Folder / "small"));
  ASSERT_EQ(::mount("tmpfs", this->Path("small").c_str(), "tmpfs", MS_REMOUNT, "size=20m"), 0);
  call.emplace_back("--resume");
  EXPECT_EQ(this->Bmt(call).Exit, 0);
  EXPECT_TRUE(this->ReadFile("small/out.bmt") == expected);
}

TEST_F(Failure, ReadOnlyOutputFolderIsRefusedBeforeTheWorkBegins)
{
  this->MakeSphere(5120);
  const TmpFs disk(this->Folder / "fixed", "size=64m", MS_RDONLY);
  if (!disk.IsMounted)
  {
    GTEST_SKIP() << "no file system can be mounted here";
  }
  const MTRun output = this->Bmt(this->BuildCall({}, "fixed/out.bmt"));
  EXPECT_EQ(output.Exit, 1);
  EXPECT_NE(output.Err.find("cannot be written to"), std::string::npos) << output.Err;
  const MTRun temporary = this->Bmt(this->BuildCall({ "--temp", this->Path("fixed") }));
  EXPECT_EQ(temporary.Exit, 1);
  EXPECT_NE(temporary.Err.find("Read-only file system"), std::string::npos) << temporary.Err;
  EXPECT_EQ(this->List(), (std::vector<std::string>{ "fixed", "sphere.ply" }));
}

TEST_F(Failure, TemporaryFolderThatVanishesIsAClearError)
{
  const std::string expected = this->MakeExpected(81920);
  MTRunOptions options;
  options.InterruptWhen = [this]
  {
    std::error_code code;
    if (this->HasCheckpoint())
    {
      fs::remove_all(this->Folder / "temp", code);
    }
    return false;
  };
  const MTRun run = this->Bmt(this->ToDisk({ "--threads", "1" }), options);
  EXPECT_EQ(run.Exit, 1);
  EXPECT_NE(run.Err.find("No such file or directory"), std::string::npos) << run.Err;
  EXPECT_EQ(run.Err.find("--resume"), std::string::npos) << "there is nothing to resume: " << run.Err;
  EXPECT_FALSE(fs::exists(this->Folder / "out.bmt"));
  fs::create_directories(this->Folder / "temp");
  this->ExpectResumed(expected, "after the temporary folder was removed");
}

TEST_F(Failure, InputThatChangesOrEndsEarlyIsAnError)
{
  const std::string expected = this->MakeExpected(327680);
  const std::string input = this->ReadFile("sphere.ply");
  for (const bool cuts : { false, true })
  {
    bool isDone = false;
    MTRunOptions options;
    options.InterruptWhen = [&]
    {
      if (!isDone && fs::exists(this->GetWork()))
      {
        isDone = true;
        const fs::path path = this->Folder / "sphere.ply";
        cuts ? fs::resize_file(path, input.size() / 2) : fs::last_write_time(path, fs::file_time_type::clock::now());
      }
      return false;
    };
    const MTRun run = this->Bmt(this->ToDisk({ "--threads", "1" }), options);
    EXPECT_EQ(run.Exit, 1);
    EXPECT_NE(run.Err.find("has changed while it was read"), std::string::npos) << run.Err;
    EXPECT_NE(run.Err.find("sphere.ply"), std::string::npos) << run.Err;
    EXPECT_TRUE(fs::is_empty(this->Folder / "temp"));
    this->WriteFile("sphere.ply", input);
  }
  this->WriteFile("sphere.ply", input.substr(0, input.size() - 1));
  const MTRun cut = this->Bmt(this->ToDisk());
  EXPECT_EQ(cut.Exit, 1);
  EXPECT_NE(cut.Err.find("sphere.ply"), std::string::npos) << cut.Err;
  EXPECT_EQ(this->List(), (std::vector<std::string>{ "expected.bmt", "sphere.ply", "temp" }));
}

TEST_F(Failure, ResumeOfWhatIsDoneSucceedsAndOfOtherSettingsBuilds)
{
  const std::string expected = this->MakeExpected(20480);
  EXPECT_FALSE(this->BmtJson(this->ToDisk({ "--resume" })).contains("was_finished")); // there was nothing
  const auto time = fs::last_write_time(this->Folder / "out.bmt");
  const nlohmann::json again = this->BmtJson(this->ToDisk({ "--resume" }));
  EXPECT_TRUE(again.contains("was_finished"));
  EXPECT_EQ(again["triangles"], 20480);
  EXPECT_EQ(fs::last_write_time(this->Folder / "out.bmt"), time);
  EXPECT_TRUE(this->ReadFile("out.bmt") == expected);
  // Where and how the same was to be built does not matter.
  EXPECT_TRUE(this->BmtJson(this->BuildCall({ "--resume", "--threads", "1" })).contains("was_finished"));
  for (const std::vector<std::string>& other :
    { { "--no-normals" }, { "--certify-normals" }, std::vector<std::string>{ "--feature-angle", "1" } })
  {
    std::vector<std::string> call = { "--resume" };
    call.insert(call.end(), other.begin(), other.end());
    EXPECT_FALSE(this->BmtJson(this->ToDisk(call)).contains("was_finished")) << other[0];
    EXPECT_FALSE(this->ReadFile("out.bmt") == expected) << other[0];
  }
  // A file of that name which is no model, or another input.
  this->WriteFile("out.bmt", "something else");
  EXPECT_FALSE(this->BmtJson(this->ToDisk({ "--resume" })).contains("was_finished"));
  this->MakeSphere(5120);
  EXPECT_EQ(this->BmtJson(this->ToDisk({ "--resume" }))["triangles"], 5120);
}

TEST_F(Failure, InterruptionEndsTheProgramSoonAndLeavesWhatCanBeResumed)
{
  const std::string expected = this->MakeExpected(327680);
  const double whole = this->BmtJson(this->ToDisk())["seconds"].get<double>();
  for (const double share : { 0.0, 0.05, 0.15, 0.3, 0.5, 0.7, 0.9 })
  {
    fs::remove(this->Folder / "out.bmt");
    std::chrono::steady_clock::time_point sent;
    const auto start = std::chrono::steady_clock::now();
    MTRunOptions options;
    options.InterruptWhen = [&]
    {
      sent = std::chrono::steady_clock::now();
      return sent - start > std::chrono::duration<double>(0.05 + share * whole);
    };
    const MTRun run = this->Bmt(this->ToDisk(), options);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - sent).count();
    std::printf("interrupted at %3.0f %%: ended after %.3f s, %s a checkpoint\n", 100.0 * share, seconds,
      this->HasCheckpoint() ? "with" : "without");
    EXPECT_TRUE(run.Exit == 130 || run.Exit == 0 || run.Exit == 1000 + SIGINT) << run.Exit << run.Err;
    EXPECT_EQ(this->HasCheckpoint(), run.Err.find("--resume") != std::string::npos) << run.Err;
    EXPECT_TRUE(this->HasCheckpoint() || fs::is_empty(this->Folder / "temp")) << "something useless was left";
    this->ExpectResumed(expected, "interrupted");
  }
  EXPECT_EQ(this->List(), (std::vector<std::string>{ "expected.bmt", "out.bmt", "sphere.ply", "temp" }));
}
