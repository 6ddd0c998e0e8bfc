// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTFileByteSource
 * @brief a file as a byte source
 *
 * Positioned block reads, no memory map: pages of a map count as the process's own memory, and this toolkit keeps
 * limits. A file that is replaced by rename while it is open stays readable as it was.
 */
#ifndef vtkMTFileByteSource_h
#define vtkMTFileByteSource_h

#include "vtkMTByteSource.h"
#include "vtkMTIOCoreModule.h" // For export macro

#include <memory>

class VTKMTIOCORE_EXPORT vtkMTFileByteSource : public vtkMTByteSource
{
public:
  /// Empty, with the reason in error, when the file is missing, not readable or not a regular file.
  static std::unique_ptr<vtkMTFileByteSource> Open(const std::string& path, std::string& error);
  ~vtkMTFileByteSource() override;

  std::uint64_t GetSize() const override { return this->Size; }
  bool Read(std::uint64_t offset, std::size_t count, void* destination, std::string& error) const override;
  std::string GetName() const override { return this->Path; }

private:
  vtkMTFileByteSource(const std::string& path, int descriptor, std::uint64_t size);
  vtkMTFileByteSource(const vtkMTFileByteSource&) = delete;
  void operator=(const vtkMTFileByteSource&) = delete;

  std::string Path;
  int Descriptor;
  std::uint64_t Size;
};

#endif
