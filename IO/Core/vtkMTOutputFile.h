// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTOutputFile
 * @brief a file that is published whole or not at all
 *
 * Open makes a new file with a temporary name in the folder of the wanted one; Write appends to it; Commit makes it
 * durable (fsync), gives it the wanted name (rename, which replaces an earlier file in one step) and makes the name
 * durable (fsync of the folder). Until Commit has succeeded an earlier file of that name is untouched; after a failure,
 * Abandon or destruction nothing of the new one remains. Where the wanted name is a symbolic link, the file that it
 * points to is replaced and the link stays. A name that is in use by something else than a regular file is refused.
 */
#ifndef vtkMTOutputFile_h
#define vtkMTOutputFile_h

#include "vtkMTIOCoreModule.h" // For export macro

#include <cstddef>
#include <cstdint>
#include <string>

class VTKMTIOCORE_EXPORT vtkMTOutputFile
{
public:
  vtkMTOutputFile();
  ~vtkMTOutputFile();

  bool Open(const std::string& path);
  bool Write(const void* data, std::size_t size);
  bool Commit();
  void Abandon();

  /// Removes what writers of this output left when their process was killed; with ownToo, also what this process is
  /// writing, before it ends.
  static void RemoveStrays(const std::string& path, bool ownToo = false);

  bool IsOpen() const { return this->Descriptor >= 0; }
  std::uint64_t GetBytesWritten() const { return this->Written; }
  const std::string& GetPath() const { return this->Path; }
  /// Where the bytes are until Commit, for writers that want a file name; such a writer must not rename or remove it.
  const std::string& GetTemporaryName() const { return this->Temporary; }
  /// Why the last call failed; names the wanted file.
  const std::string& GetError() const { return this->Error; }

private:
  vtkMTOutputFile(const vtkMTOutputFile&) = delete;
  void operator=(const vtkMTOutputFile&) = delete;
  bool Fail(const std::string& what);

  std::string Path;
  std::string Target; // Path with symbolic links resolved
  std::string Temporary;
  std::string Error;
  int Descriptor = -1;
  std::uint64_t Written = 0;
};

#endif
