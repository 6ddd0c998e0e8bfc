// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTBuildWorkspace
 * @brief where and with how much memory a model is built
 *
 * The memory limit is that of the whole process. What the process holds when building begins, its input included where
 * that is not read block by block, is taken off it; the rest is the builder's. What fits in memory is built there;
 * everything else in a folder of its own, OUTPUT.build in the folder for temporary files or in the output's, which is
 * gone when the output is written, and from which a later build goes on when something has gone wrong.
 */
#ifndef vtkMTBuildWorkspace_h
#define vtkMTBuildWorkspace_h

#include "vtkMTBuildingModule.h" // For export macro
#include "vtkMTScratchStore.h"

#include <cstdint>
#include <memory>
#include <string>

class vtkMTFileSpoolStore;
class vtkMTSpoolStore;
class vtkMTTriangleStream;
class vtkMultiTriangulationBuilder;
struct vtkMTBuildError;

class VTKMTBUILDING_EXPORT vtkMTBuildWorkspace
{
public:
  struct Settings
  {
    std::string Output;
    std::string TemporaryFolder;   ///< empty: the output's
    std::uint64_t MemoryLimit = 0; ///< bytes; 0: a quarter of the machine's
    bool Resume = false;
  };

  explicit vtkMTBuildWorkspace(const Settings& settings);
  ~vtkMTBuildWorkspace();

  /// Checks the folder for temporary files, and removes what processes that were killed left of this output.
  bool Open(vtkMTBuildError& error);

  /// Sets the builder's limit, store and Resume. Fails when the limit or the disk is too small, or when there is an
  /// earlier build that was not finished and is not to be resumed.
  bool Prepare(const vtkMTTriangleStream& input, vtkMultiTriangulationBuilder* builder, vtkMTBuildError& error);
  /// What was removed by Prepare, for a warning; empty when nothing was.
  const std::string& GetWarning() const { return this->Warning; }

  /// For a sink that can be resumed; null when everything is in memory.
  vtkMTSpoolStore* GetStore() const;
  /// For what is sorted while the input is opened.
  vtkMTSpoolStore& GetScratch() const { return *this->Scratch; }
  /// Bytes.
  std::uint64_t GetLimit() const { return this->Limit; }

  /// Whether there is a build to go on with.
  bool HasCheckpoint() const;
  /// Removes it: the output is finished.
  bool RemoveCheckpoint(vtkMTBuildError& error);

  ///@{
  /// Bytes of temporary files: the most that there were at a time, and what was expected at most.
  std::uint64_t GetTemporaryBytes() const;
  std::uint64_t GetEstimate() const { return this->Estimate; }
  ///@}

  /// The folder of temporary files that belongs to an output.
  static std::string GetFolder(const std::string& output, const std::string& temporaryFolder);
  /// Bytes of memory of the machine, or of the group that the process is confined to.
  static std::uint64_t GetMachineMemory();

private:
  bool OpenFolder(vtkMTBuildError& error);
  bool CheckDisk(std::uint64_t spools, vtkMTBuildError& error) const;

  const Settings Given;
  const std::string Folder;
  const std::uint64_t Limit;
  std::uint64_t Estimate = 0;
  bool HasLargePages = false; // of the heap; set back in the end
  std::string Warning;
  std::unique_ptr<vtkMTScratchStore> Scratch; // never null
  std::shared_ptr<vtkMTFileSpoolStore> Files;
};

#endif
