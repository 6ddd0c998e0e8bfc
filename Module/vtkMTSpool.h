// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTSpool
 * @brief a working store of bytes: it grows at its end and is read anywhere
 *
 * What a mesh larger than memory is kept in while a Multi-Triangulation is built (BMT section 6). All else is made of
 * it: records under keys (vtkMTRecordSpool), external sorting (vtkMTRecordSort), the patches that are not yet in the
 * file. Reads and writes are explicit: mapped pages would count as memory of the process.
 *
 * Threads: Append comes from one thread at a time, and not while others read; Read may come from several.
 */
#ifndef vtkMTSpool_h
#define vtkMTSpool_h

#include "vtkMTCoreModule.h" // For export macro

#include <cstddef>
#include <cstdint>
#include <string>

class VTKMTCORE_EXPORT vtkMTSpool
{
public:
  virtual ~vtkMTSpool() = default;

  ///@{
  /// False on failure, with a message in error, which is otherwise left as it is.
  virtual bool Append(const void* data, std::size_t size, std::string& error) = 0;
  virtual bool Read(std::uint64_t offset, std::size_t size, void* data, std::string& error) const = 0;
  ///@}
  /// Those bytes where they lie, until the spool is removed; null where they do not lie in memory, one behind the
  /// other.
  virtual const unsigned char* Find(std::uint64_t, std::size_t) const { return nullptr; }
  virtual std::uint64_t GetSize() const = 0;
  /// Whether its bytes lie in memory, so that reading a few of them anywhere costs little.
  virtual bool IsInMemory() const { return false; }
  /// Those bytes will not be read again: a spool in memory may give up what holds them. From one thread at a time.
  virtual void Forget(std::uint64_t, std::size_t) {}
};

#endif
