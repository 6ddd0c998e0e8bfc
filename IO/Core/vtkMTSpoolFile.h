// SPDX-License-Identifier: BSD-3-Clause
// A file that spools are kept in, and what all files of a store hold together. Not installed.
#ifndef vtkMTSpoolFile_h
#define vtkMTSpoolFile_h

#include "vtkMTIOCoreModule.h" // For export macro
#include "vtkMTSpool.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>

/// Bytes that the files of a store hold.
struct VTKMTIOCORE_EXPORT vtkMTSpoolAccount
{
  std::atomic<std::uint64_t> Size{ 0 };
  std::uint64_t Largest = 0;

  void Add(std::uint64_t size);
};

/// An open file that grows at its end; pread and pwrite, so that no position is shared.
class VTKMTIOCORE_EXPORT vtkMTSpoolFile
{
public:
  /// Takes the descriptor over.
  vtkMTSpoolFile(std::string name, int descriptor, std::shared_ptr<vtkMTSpoolAccount> account);
  ~vtkMTSpoolFile();
  vtkMTSpoolFile(const vtkMTSpoolFile&) = delete;
  void operator=(const vtkMTSpoolFile&) = delete;

  bool Append(const unsigned char* data, std::size_t size, std::string& error);
  bool Read(std::uint64_t offset, std::size_t size, unsigned char* to, std::string& error) const;
  /// Makes durable what was appended since the last time.
  bool Sync(std::string& error);
  /// Takes over what the file holds already.
  void SetSize(std::uint64_t size);
  std::uint64_t GetSize() const { return this->Size; }

  /// A nameless file whose bytes are gone with it; folder ends with a slash. Null on failure, with a message in error.
  static std::unique_ptr<vtkMTSpool> CreateNameless(
    const std::string& folder, const std::shared_ptr<vtkMTSpoolAccount>& account, std::string& error);
  /// "name: what: reason", the reason being errno's.
  static std::string Describe(const std::string& name, const std::string& what);

private:
  const std::string Name;
  const int Descriptor;
  std::shared_ptr<vtkMTSpoolAccount> Account;
  std::uint64_t Size = 0;
  bool IsDirty = true;
};

/// The spool of a file; several may be of one.
class VTKMTIOCORE_EXPORT vtkMTFileSpool : public vtkMTSpool
{
public:
  explicit vtkMTFileSpool(std::shared_ptr<vtkMTSpoolFile> file)
    : File(std::move(file))
  {
  }
  bool Append(const void* data, std::size_t size, std::string& error) override
  {
    return this->File->Append(static_cast<const unsigned char*>(data), size, error);
  }
  bool Read(std::uint64_t offset, std::size_t size, void* data, std::string& error) const override
  {
    return this->File->Read(offset, size, static_cast<unsigned char*>(data), error);
  }
  std::uint64_t GetSize() const override { return this->File->GetSize(); }

private:
  std::shared_ptr<vtkMTSpoolFile> File;
};

#endif
