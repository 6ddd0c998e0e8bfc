// SPDX-License-Identifier: BSD-3-Clause
// Blocks of bytes made smaller by LZ4 or zstd. Not installed.
#ifndef vtkMTByteCodec_h
#define vtkMTByteCodec_h

#include "vtkMTFileFormat.h"

#include <cstddef>
#include <vector>

namespace vtkMTByteCodec
{
/// Appends the block to `stored`. False when the library fails, which takes more bytes than it can count.
bool Compress(
  vtkMTFileFormat::Codec codec, const unsigned char* data, std::size_t size, std::vector<unsigned char>& stored);

/**
 * Fills exactly `size` bytes at destination; false when the stored ones are anything else than a block of that size.
 *
 * Threads: may be called from any number of threads at once; zstd's tables are kept per thread.
 */
bool Decompress(vtkMTFileFormat::Codec codec, const unsigned char* stored, std::size_t storedSize,
  unsigned char* destination, std::size_t size);

/// Whether that many stored bytes may stand for so many: what is asked to be allocated must be justified by the file.
inline bool IsPlausible(std::uint64_t storedSize, std::uint64_t size)
{
  constexpr std::uint64_t mostPerByte = 1024;
  return size / mostPerByte <= storedSize;
}
}

#endif
