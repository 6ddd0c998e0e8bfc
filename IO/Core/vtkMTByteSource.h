// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTByteSource
 * @brief bytes that can be read by range: a file, a block of memory, a server
 *
 * Everything that the toolkit reads, it reads through this class and by ranges alone, so that a server of byte ranges
 * can stand in for a file.
 *
 * Threads: all members may be called from any number of threads at once.
 */
#ifndef vtkMTByteSource_h
#define vtkMTByteSource_h

#include "vtkMTIOCoreModule.h" // For export macro

#include <cstddef>
#include <cstdint>
#include <string>

class VTKMTIOCORE_EXPORT vtkMTByteSource
{
public:
  virtual ~vtkMTByteSource();

  /// Bytes in all, fixed while the source lives.
  virtual std::uint64_t GetSize() const = 0;

  /**
   * Copies the bytes offset .. offset+count-1 to destination. False, with the reason in error, when not all of them can
   * be had; what destination then holds is undefined. A range that passes the end is an error, never a short read.
   */
  virtual bool Read(std::uint64_t offset, std::size_t count, void* destination, std::string& error) const = 0;

  /// For messages: a file name, "memory".
  virtual std::string GetName() const = 0;
};

#endif
