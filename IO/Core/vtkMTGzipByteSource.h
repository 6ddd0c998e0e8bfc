// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTGzipByteSource
 * @brief what a file compressed by gzip holds, as a byte source
 *
 * The file is read through once when it is opened, by which its size is known and its checksums have been compared.
 * After that, ranges in order are decompressed as they are asked for. Others begin at the last of at most 256 copies of
 * the decompressor's state, which lie at equal distances: about 10 MiB, however large the file is. Several members one
 * after the other are one sequence of bytes, as gzip has it.
 *
 * Threads: as vtkMTByteSource says; they wait for each other.
 */
#ifndef vtkMTGzipByteSource_h
#define vtkMTGzipByteSource_h

#include "vtkMTByteSource.h"
#include "vtkMTIOCoreModule.h" // For export macro

#include <memory>

class VTKMTIOCORE_EXPORT vtkMTGzipByteSource : public vtkMTByteSource
{
public:
  /// The file's bytes: what it holds, where it is compressed by gzip, or else as they are. Empty, with the reason in
  /// error, when it cannot be opened or is damaged.
  static std::unique_ptr<vtkMTByteSource> OpenFile(const std::string& path, std::string& error);
  /// The same of other bytes, which become this source's. Only what begins as gzip does can be opened.
  static std::unique_ptr<vtkMTGzipByteSource> Open(std::unique_ptr<vtkMTByteSource> compressed, std::string& error);
  ~vtkMTGzipByteSource() override;

  std::uint64_t GetSize() const override { return this->Size; }
  bool Read(std::uint64_t offset, std::size_t count, void* destination, std::string& error) const override;
  std::string GetName() const override { return this->Compressed->GetName(); }

  static bool IsGzip(const vtkMTByteSource& bytes);

private:
  class Decompressor;

  explicit vtkMTGzipByteSource(std::unique_ptr<vtkMTByteSource> compressed);
  vtkMTGzipByteSource(const vtkMTGzipByteSource&) = delete;
  void operator=(const vtkMTGzipByteSource&) = delete;

  std::unique_ptr<vtkMTByteSource> Compressed;
  std::unique_ptr<Decompressor> State; // never null
  std::uint64_t Size = 0;
};

#endif
