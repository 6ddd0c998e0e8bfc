// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file bmtWorkspace.h
 * @brief where and with how much memory a model is built: the options --memory, --temp and --resume
 *
 * The memory limit is that of the whole process. What the process holds when building begins, its input included where
 * that is not streamed, is taken off it; the rest is the builder's. What fits in memory is built there; everything else
 * in a folder of its own, OUTPUT.build in the folder of --temp or of the output, which is gone when the output is
 * written, and which --resume goes on from when something has gone wrong.
 */
#ifndef bmtWorkspace_h
#define bmtWorkspace_h

#include "bmtCommon.h"

#include "vtkMTScratchStore.h"

#include <memory>

class vtkMTFileSpoolStore;
class vtkMTSpoolStore;
class vtkMTTriangleStream;
class vtkMultiTriangulationBuilder;

struct bmtWorkspaceOptions
{
  std::string Memory; ///< a size; empty: a quarter of the machine's
  std::string Temp;   ///< a folder; empty: the output's
  bool Resume = false;
};

void bmtAddWorkspaceOptions(CLI::App& command, bmtWorkspaceOptions& options);

/// Bytes of "512MiB", "1.5G", "2000000"; throws bmtError when it is none.
std::uint64_t bmtParseSize(const std::string& text);

/// Bytes of memory of the machine, or of the group that the process is confined to; and what it held at most.
std::uint64_t bmtGetMachineMemory();
std::uint64_t bmtGetPeakMemory();

class bmtWorkspace
{
public:
  bmtWorkspace(const bmtWorkspaceOptions& options, const std::string& output);
  ~bmtWorkspace();

  /// Sets the builder's limit and store. Throws bmtError when the limit or the disk is too small, or when there is an
  /// earlier build that was not resumed.
  void Prepare(const vtkMTTriangleStream& input, vtkMultiTriangulationBuilder* builder);

  /// For a sink that can be resumed; null when everything is in memory.
  vtkMTSpoolStore* GetStore() const;
  /// For what is sorted while the input is opened.
  vtkMTSpoolStore& GetScratch() const { return *this->Scratch; }
  std::uint64_t GetLimit() const { return this->Limit; }

  /// Whether there is a build to go on with.
  bool HasCheckpoint() const;
  /// Removes it: it is finished.
  void RemoveCheckpoint();
  /// What to say after a build that failed: how to go on, if one can.
  std::string GetAdvice(bool canResume) const;
  /// When the program is to end in the middle of the work: removes what cannot be resumed, and says what is left.
  std::string Leave() const;
  void Describe(bmtJson& result) const;

private:
  void OpenFolder();
  void CheckDisk(std::uint64_t spools) const;

  const bmtWorkspaceOptions Options;
  const std::string Output;
  std::string Folder;
  std::uint64_t Limit = 0;
  std::uint64_t Estimate = 0;
  std::unique_ptr<vtkMTScratchStore> Scratch;
  std::shared_ptr<vtkMTFileSpoolStore> Files;
  std::shared_ptr<vtkMTSpoolStore> Memory;
};

#endif
