// SPDX-License-Identifier: BSD-3-Clause
// Bytes that are put into a spool one after the other and taken out in the same order. Not installed.
#ifndef vtkMTSpoolQueue_h
#define vtkMTSpoolQueue_h

#include "vtkMTIOCoreModule.h" // For export macro
#include "vtkMTSpoolStore.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

/// Through a buffer of 256 KiB. After Seal everything can be taken, after Rewind once more.
class VTKMTIOCORE_EXPORT vtkMTSpoolQueue
{
public:
  explicit vtkMTSpoolQueue(vtkMTSpoolStore& store)
    : Store(store)
  {
  }

  ///@{
  /// False on failure, with a message in error.
  bool Put(const void* data, std::size_t size, std::string& error);
  bool Seal(std::string& error);
  ///@}
  void Rewind();
  /// The next bytes, valid until the next call; null on failure and at the end, with a message in error.
  const unsigned char* Take(std::size_t size, std::string& error);
  std::uint64_t GetSize() const { return this->Size; }

private:
  bool Flush(std::string& error);

  vtkMTSpoolStore& Store;
  std::unique_ptr<vtkMTSpool> Spool; // null while all is in the buffer
  std::vector<unsigned char> Buffer;
  std::uint64_t Size = 0;
  std::uint64_t BufferEnd = 0; // in the spool, while reading
  std::size_t Place = 0;       // in the buffer, while reading
};

#endif
