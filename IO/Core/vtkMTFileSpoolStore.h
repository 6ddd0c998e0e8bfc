// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTFileSpoolStore
 * @brief a store whose spools are files in a folder, with a checkpoint that survives the process
 *
 * Named spools are files NAME.spool in the folder; nameless ones are unlinked as soon as they are open. Commit syncs
 * what was written since the last one, then replaces the file "state", which holds the names of all spools, the given
 * bytes and a checksum (XXH3-64), by renaming: a crash leaves the old state or the new one. A file that the last state
 * needs is removed only after the next Commit. Reads and writes are pread and pwrite; errors of the disk are reported
 * with the file's name, the byte and the reason. A lock on the folder keeps a second process out.
 *
 * When the store goes away without a Commit ever having been made, so that nothing could be resumed, everything is
 * removed; otherwise it stays until Clear.
 */
#ifndef vtkMTFileSpoolStore_h
#define vtkMTFileSpoolStore_h

#include "vtkMTIOCoreModule.h" // For export macro
#include "vtkMTSpoolStore.h"

class VTKMTIOCORE_EXPORT vtkMTFileSpoolStore : public vtkMTSpoolStore
{
public:
  vtkMTFileSpoolStore();
  ~vtkMTFileSpoolStore() override;

  /// The folder is made when it does not exist; its parent must. False with a message in error.
  bool OpenFolder(const std::string& folder, std::string& error);
  const std::string& GetFolder() const;
  /// Whether the folder holds a state, or files without one. Neither needs the folder to be open.
  static bool HasState(const std::string& folder);
  static bool HasFiles(const std::string& folder);
  /// Removes what a build left that had no state yet, and the folder when nothing else is in it.
  static void RemoveFiles(const std::string& folder);
  /// A nameless spool in the folder of path, of no store. Null on failure, with a message in error.
  static std::unique_ptr<vtkMTSpool> CreateBeside(const std::string& path, std::string& error);

  std::unique_ptr<vtkMTSpool> Create(std::string& error) override;
  std::unique_ptr<vtkMTSpool> Create(const std::string& name, std::string& error) override;
  std::unique_ptr<vtkMTSpool> Open(const std::string& name, std::uint64_t size, std::string& error) override;
  void Remove(const std::string& name) override;
  bool IsLasting() const override { return true; }
  bool Commit(const std::vector<unsigned char>& state, std::string& error) override;
  bool Restore(std::vector<unsigned char>& state, std::string& error) override;
  /// Removes the folder too, when nothing else is in it.
  void Clear() override;
  std::uint64_t GetSize() const override;
  std::uint64_t GetLargestSize() const override;

private:
  struct Internals;
  std::unique_ptr<Internals> Implementation;
};

#endif
