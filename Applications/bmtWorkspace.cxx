// SPDX-License-Identifier: BSD-3-Clause
#include "bmtWorkspace.h"

#include "vtkMTFileSpoolStore.h"
#include "vtkMTMemoryPlan.h"
#include "vtkMTMemorySpoolStore.h"
#include "vtkMTOutputFile.h"
#include "vtkMTTriangleStream.h"
#include "vtkMTTrimHeap.h"
#include "vtkMultiTriangulationBuilder.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>

namespace
{
std::uint64_t ReadNumber(const char* path)
{
  std::ifstream file(path);
  std::uint64_t number = 0;
  return file >> number ? number : 0;
}
}

//------------------------------------------------------------------------------
// Sizes
std::uint64_t bmtParseSize(const std::string& text)
{
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  std::string unit(end);
  std::transform(unit.begin(), unit.end(), unit.begin(), [](unsigned char c) { return std::tolower(c); });
  const std::pair<const char*, double> units[] = { { "", 1.0 }, { "b", 1.0 }, { "k", 1024.0 }, { "kib", 1024.0 },
    { "kb", 1e3 }, { "m", 1048576.0 }, { "mib", 1048576.0 }, { "mb", 1e6 }, { "g", 1073741824.0 },
    { "gib", 1073741824.0 }, { "gb", 1e9 }, { "t", 1099511627776.0 }, { "tib", 1099511627776.0 }, { "tb", 1e12 } };
  for (const auto& [name, factor] : units)
  {
    const double bytes = number * factor;
    if (unit == name && end != text.c_str() && bytes >= 1.0 && bytes < 1e18)
    {
      return static_cast<std::uint64_t>(bytes);
    }
  }
  throw bmtError("\"" + text + "\" is no size; say 512MiB, 1.5GiB or a number of bytes");
}

std::uint64_t bmtGetMachineMemory()
{
  const auto pages = static_cast<std::uint64_t>(std::max(0L, sysconf(_SC_PHYS_PAGES)));
  const std::uint64_t machine = pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
  const std::uint64_t group = ReadNumber("/sys/fs/cgroup/memory.max"); // 0 where it says "max"
  return group > 0 ? std::min(machine, group) : machine;
}

std::uint64_t bmtGetPeakMemory()
{
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

namespace
{
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
}

void bmtAddWorkspaceOptions(CLI::App& command, bmtWorkspaceOptions& options)
{
  command.add_option("--memory", options.Memory,
    "Most memory that the process may hold, such as 512MiB or 2GiB; default: a quarter of the machine's. No influence "
    "on "
    "the file");
  command.add_option("--temp", options.Temp, "Folder for temporary files; default: that of the output");
  command.add_flag("--resume", options.Resume, "Go on with the build that was interrupted, if there is one");
}

//------------------------------------------------------------------------------
bmtWorkspace::bmtWorkspace(const bmtWorkspaceOptions& options, const std::string& output)
  : Options(options)
  , Output(output)
{
  const std::uint64_t machine = bmtGetMachineMemory();
  this->Limit = options.Memory.empty() ? machine / 4 : bmtParseSize(options.Memory);
  KeepSmallBlocks(this->Limit);
  namespace fs = std::filesystem;
  const fs::path name = fs::path(output).filename();
  const fs::path parent = options.Temp.empty() ? fs::path(output).parent_path() : fs::path(options.Temp);
  std::error_code code;
  if (!options.Temp.empty() && !fs::is_directory(parent, code))
  {
    throw bmtError(options.Temp + ": no such folder for temporary files; make it first");
  }
  const fs::path folder = parent.empty() ? fs::path(".") : parent;
  this->Folder = (folder / (name.string() + ".build")).string();
  this->Scratch = std::make_unique<vtkMTScratchStore>(folder.string());
  vtkMTOutputFile::RemoveStrays(output);
}

bmtWorkspace::~bmtWorkspace() = default;

vtkMTSpoolStore* bmtWorkspace::GetStore() const
{
  return this->Files.get();
}

void bmtWorkspace::Prepare(const vtkMTTriangleStream& input, vtkMultiTriangulationBuilder* builder)
{
  const bool hasState = this->HasCheckpoint();
  if (hasState && !this->Options.Resume)
  {
    throw bmtError(this->Folder + " holds an unfinished build of " + this->Output +
      ": go on with it by --resume, or delete that folder to begin anew");
  }
  // Nothing is planned by counts that a damaged file claims.
  constexpr std::uint64_t most = 4294967294;
  if (input.GetNumberOfPoints() > most || input.GetNumberOfTriangles() > most)
  {
    throw bmtError("the input has, or claims to have, " + std::to_string(input.GetNumberOfPoints()) + " points and " +
      std::to_string(input.GetNumberOfTriangles()) + " triangles; " + std::to_string(most) +
      " of either are supported");
  }
  malloc_trim(0); // what reading has freed would count
  const std::uint64_t resident = vtkMTTrimHeap::GetResidentSize();
  const vtkMTMemoryPlan plan = builder->MakeMemoryPlan(input);
  std::uint64_t limit = 0;
  std::string error;
  if (!plan.Divide(this->Limit, resident, limit, error))
  {
    throw bmtError(error);
  }
  builder->SetResume(this->Options.Resume);
  // Spools in memory, and sorts that need not spill.
  const bool fits = plan.IsWhole(this->Limit, resident) && !hasState && this->Options.Temp.empty();
  if (fits)
  {
    this->Memory = std::make_shared<vtkMTMemorySpoolStore>();
    builder->SetSpoolStore(this->Memory);
    builder->SetMemoryLimit(0);
    return;
  }
  this->Estimate = plan.GetSpoolSize();
  if (!hasState)
  {
    this->CheckDisk(plan.GetSpoolSize());
  }
  this->OpenFolder();
  builder->SetSpoolStore(this->Files);
  builder->SetMemoryLimit(static_cast<vtkTypeInt64>(limit));
}

void bmtWorkspace::CheckDisk(std::uint64_t spools) const
{
  std::error_code code;
  const std::filesystem::path parent = std::filesystem::path(this->Folder).parent_path();
  const auto space = std::filesystem::space(parent, code);
  if (!code && space.available < spools)
  {
    throw bmtError(parent.string() + " has " + vtkMTMemoryPlan::ToText(space.available) +
      " left, and building this mesh may take " + vtkMTMemoryPlan::ToText(spools) +
      " of temporary files; name another folder with --temp");
  }
}

void bmtWorkspace::OpenFolder()
{
  std::string error;
  if (vtkMTFileSpoolStore::HasFiles(this->Folder) && !vtkMTFileSpoolStore::HasState(this->Folder))
  {
    bmtWarn(this->Folder + ": temporary files of a build that had no checkpoint yet are removed");
  }
  this->Files = std::make_shared<vtkMTFileSpoolStore>();
  std::vector<unsigned char> state;
  if (!this->Files->OpenFolder(this->Folder, error) || !this->Files->Restore(state, error))
  {
    throw bmtError(error);
  }
}

bool bmtWorkspace::HasCheckpoint() const
{
  return vtkMTFileSpoolStore::HasState(this->Folder);
}

// Also what is left of one whose process was killed while it removed it.
void bmtWorkspace::RemoveCheckpoint()
{
  std::error_code code;
  if (std::filesystem::is_directory(this->Folder, code))
  {
    this->OpenFolder();
    this->Files->Clear();
    this->Files.reset();
  }
}

std::string bmtWorkspace::Leave() const
{
  vtkMTOutputFile::RemoveStrays(this->Output, true);
  const bool canResume = this->HasCheckpoint();
  if (!canResume && this->Files)
  {
    vtkMTFileSpoolStore::RemoveFiles(this->Folder);
  }
  return "interrupted; " + this->Output + " is as it was" + this->GetAdvice(canResume);
}

std::string bmtWorkspace::GetAdvice(bool canResume) const
{
  return canResume && this->HasCheckpoint()
    ? "; the same command with --resume goes on from the last checkpoint, in " + this->Folder
    : "";
}

void bmtWorkspace::Describe(bmtJson& result) const
{
  result["memory_limit_bytes"] = this->Limit;
  result["peak_memory_bytes"] = bmtGetPeakMemory();
  result["temporary_bytes"] = (this->Files ? this->Files->GetLargestSize() : 0) + this->Scratch->GetLargestSize();
  result["temporary_bytes_estimated"] = this->Estimate;
}
