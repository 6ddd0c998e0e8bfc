// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTBuildWorkspace.h"

#include "vtkMTBuildError.h"
#include "vtkMTFileSpoolStore.h"
#include "vtkMTMemoryPlan.h"
#include "vtkMTMemorySpoolStore.h"
#include "vtkMTOutputFile.h"
#include "vtkMTPosix.h"
#include "vtkMTTriangleStream.h"
#include "vtkMTTrimHeap.h"
#include "vtkMultiTriangulationBuilder.h"
#include "vtkMultiTriangulationFileBuilder.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <vector>

#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>

namespace
{
constexpr int LargestBlock = 32 << 20; // that glibc takes from the heap

// What is freed is given back to the system, since the limit is measured from outside; but not blocks of the size that
// a region needs, or a fifth of the time goes into pages that come and go. Where there is room, larger ones stay too.
void KeepSmallBlocks(std::uint64_t limit)
{
  constexpr std::uint64_t least = 4 << 20;
  const auto kept = static_cast<int>(std::clamp<std::uint64_t>(limit / 32, least, 8 * least));
  mallopt(M_MMAP_THRESHOLD, kept);
  mallopt(M_TRIM_THRESHOLD, limit >= 64 * least ? 2 * kept : kept);
  mallopt(M_ARENA_MAX, 4);
}

// The most that glibc comes to by itself: what draws next may free and fetch as much for every frame.
void KeepLargeBlocks()
{
  mallopt(M_MMAP_THRESHOLD, LargestBlock);
  mallopt(M_TRIM_THRESHOLD, 2 * LargestBlock);
}

// A build in memory touches so many pages that making and finding small ones takes a twentieth of the time. The heap
// grows at once by what the build may take, none of which is held before it is touched, and is to be made of large
// pages. Only the heap of the main thread is; where the block does not come from it, nothing is done.
void UseLargePages(std::uint64_t bytes)
{
  constexpr std::uintptr_t page = 2 << 20;
  constexpr std::uint64_t most = std::numeric_limits<int>::max();
  mallopt(M_MMAP_THRESHOLD, LargestBlock);
  mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
  mallopt(M_TOP_PAD, static_cast<int>(std::min(bytes, most)));
  void* volatile block = std::malloc(LargestBlock / 2); // volatile, or the compiler leaves both calls out
  const std::uintptr_t begin = (reinterpret_cast<std::uintptr_t>(block) + page - 1) / page * page;
  const auto end = reinterpret_cast<std::uintptr_t>(sbrk(0));
  if (block && begin < end)
  {
    madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
  }
  std::free(block);
  mallopt(M_TOP_PAD, page);
}

std::filesystem::path GetParent(const std::string& output, const std::string& temporaryFolder)
{
  const std::filesystem::path parent =
    temporaryFolder.empty() ? std::filesystem::path(output).parent_path() : std::filesystem::path(temporaryFolder);
  return parent.empty() ? std::filesystem::path(".") : parent;
}
}

std::uint64_t vtkMTBuildWorkspace::GetMachineMemory()
{
  return vtkMTPosix::GetMachineMemory();
}

std::string vtkMTBuildWorkspace::GetFolder(const std::string& output, const std::string& temporaryFolder)
{
  const std::string name = std::filesystem::path(output).filename().string();
  return (GetParent(output, temporaryFolder) / (name + ".build")).string();
}

vtkMTBuildWorkspace::vtkMTBuildWorkspace(const Settings& settings)
  : Given(settings)
  , Folder(GetFolder(settings.Output, settings.TemporaryFolder))
  , Limit(settings.MemoryLimit > 0 ? settings.MemoryLimit : GetMachineMemory() / 4)
  , Scratch(std::make_unique<vtkMTScratchStore>(GetParent(settings.Output, settings.TemporaryFolder).string()))
{
}

vtkMTBuildWorkspace::~vtkMTBuildWorkspace()
{
  if (this->Given.MemoryLimit > 0 || this->HasLargePages)
  {
    KeepLargeBlocks();
  }
}

bool vtkMTBuildWorkspace::Open(vtkMTBuildError& error)
{
  std::error_code code;
  const std::string& folder = this->Given.TemporaryFolder;
  if (!folder.empty() && !std::filesystem::is_directory(folder, code))
  {
    return error.Fail(
      vtkErrorCode::CannotOpenFileError, folder + ": no such folder for temporary files; make it first");
  }
  if (this->Given.MemoryLimit > 0)
  {
    KeepSmallBlocks(this->Limit);
  }
  vtkMTOutputFile::RemoveStrays(this->Given.Output);
  return true;
}

vtkMTSpoolStore* vtkMTBuildWorkspace::GetStore() const
{
  return this->Files.get();
}

bool vtkMTBuildWorkspace::Prepare(
  const vtkMTTriangleStream& input, vtkMultiTriangulationBuilder* builder, vtkMTBuildError& error)
{
  const bool hasState = this->HasCheckpoint();
  if (hasState && !this->Given.Resume)
  {
    return error.Fail(vtkMultiTriangulationFileBuilder::UnfinishedBuildError,
      this->Folder + " holds an unfinished build of " + this->Given.Output +
        ": resume it, or delete that folder to begin anew");
  }
  // Nothing is planned by counts that a damaged file claims.
  constexpr std::uint64_t most = 4294967294;
  if (input.GetNumberOfPoints() > most || input.GetNumberOfTriangles() > most)
  {
    return error.Fail(vtkErrorCode::FileFormatError,
      "the input has, or claims to have, " + std::to_string(input.GetNumberOfPoints()) + " points and " +
        std::to_string(input.GetNumberOfTriangles()) + " triangles; " + std::to_string(most) +
        " of either are supported");
  }
  malloc_trim(0); // what reading has freed would count
  const std::uint64_t resident = vtkMTTrimHeap::GetResidentSize();
  const vtkMTMemoryPlan plan = builder->MakeMemoryPlan(input);
  std::uint64_t limit = 0;
  std::string reason;
  if (!plan.Divide(this->Limit, resident, limit, reason))
  {
    return error.Fail(vtkMultiTriangulationFileBuilder::MemoryLimitError, reason);
  }
  builder->SetResume(this->Given.Resume);
  // Spools in memory, and sorts that need not spill.
  if (plan.IsWhole(this->Limit, resident) && !hasState && this->Given.TemporaryFolder.empty())
  {
    builder->SetSpoolStore(std::make_shared<vtkMTMemorySpoolStore>());
    builder->SetMemoryLimit(0);
    if (plan.IsWhole(this->Limit / 2, resident)) // large pages may hold more than is used
    {
      UseLargePages(plan.GetSpoolSize());
      this->HasLargePages = true;
    }
    return true;
  }
  this->Estimate = plan.GetSpoolSize();
  if ((!hasState && !this->CheckDisk(plan.GetSpoolSize(), error)) || !this->OpenFolder(error))
  {
    return false;
  }
  builder->SetSpoolStore(this->Files);
  builder->SetMemoryLimit(static_cast<vtkTypeInt64>(limit));
  return true;
}

bool vtkMTBuildWorkspace::CheckDisk(std::uint64_t spools, vtkMTBuildError& error) const
{
  std::error_code code;
  const std::filesystem::path parent = std::filesystem::path(this->Folder).parent_path();
  const auto space = std::filesystem::space(parent, code);
  return code || space.available >= spools ||
    error.Fail(vtkErrorCode::OutOfDiskSpaceError,
      parent.string() + " has " + vtkMTMemoryPlan::ToText(space.available) + " left, and building this mesh may take " +
        vtkMTMemoryPlan::ToText(spools) + " of temporary files; name another folder for them");
}

bool vtkMTBuildWorkspace::OpenFolder(vtkMTBuildError& error)
{
  if (vtkMTFileSpoolStore::HasFiles(this->Folder) && !vtkMTFileSpoolStore::HasState(this->Folder))
  {
    this->Warning = this->Folder + ": temporary files of a build that had no checkpoint yet are removed";
  }
  this->Files = std::make_shared<vtkMTFileSpoolStore>();
  std::vector<unsigned char> state;
  std::string reason;
  return (this->Files->OpenFolder(this->Folder, reason) && this->Files->Restore(state, reason)) ||
    error.Fail(vtkErrorCode::CannotOpenFileError, reason);
}

bool vtkMTBuildWorkspace::HasCheckpoint() const
{
  return vtkMTFileSpoolStore::HasState(this->Folder);
}

// Also what is left of one whose process was killed while it removed it.
bool vtkMTBuildWorkspace::RemoveCheckpoint(vtkMTBuildError& error)
{
  std::error_code code;
  if (!std::filesystem::is_directory(this->Folder, code))
  {
    return true;
  }
  if (!this->OpenFolder(error))
  {
    return false;
  }
  this->Files->Clear();
  this->Files.reset();
  return true;
}

std::uint64_t vtkMTBuildWorkspace::GetTemporaryBytes() const
{
  return (this->Files ? this->Files->GetLargestSize() : 0) + this->Scratch->GetLargestSize();
}
