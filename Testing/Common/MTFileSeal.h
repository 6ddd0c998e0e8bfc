// SPDX-License-Identifier: BSD-3-Clause
// Finds its way in the bytes of a Multi-Triangulation file by the tables of Documentation/file-format.md alone, and
// makes checksums right again where bytes have been changed.
#ifndef MTFileSeal_h
#define MTFileSeal_h

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace MTFileSeal
{
enum BlockType : std::uint32_t
{
  Pages = 1,
  Metadata = 2,
  Nodes = 3,
  Arcs = 4,
  Entering = 5,
  Sections = 6,
  Measures = 7,
  Ranges = 8,
  Distances = 9
};

template <class Number>
Number Get(const unsigned char* data, std::size_t offset)
{
  Number value;
  std::memcpy(&value, data + offset, sizeof(value));
  return value;
}

template <class Number>
void Put(unsigned char* data, std::size_t offset, Number value)
{
  std::memcpy(data + offset, &value, sizeof(value));
}

/// Where a block's entry in the table is; 0 when there is none.
inline std::size_t FindEntry(const unsigned char* data, std::uint32_t type)
{
  const auto blocks = std::min<std::uint32_t>(Get<std::uint32_t>(data, 52), 9); // more would pass 288 bytes
  for (std::uint32_t i = 0; i < blocks; ++i)
  {
    if (Get<std::uint32_t>(data, 64 + 24 * std::size_t(i)) == type)
    {
      return 64 + 24 * std::size_t(i);
    }
  }
  return 0;
}

struct Block
{
  std::uint64_t Offset = 0;
  std::uint64_t Size = 0;
};

/// Of size 0 where there is none, or one that passes the end.
inline Block GetBlock(const unsigned char* data, std::size_t size, std::uint32_t type)
{
  const std::size_t entry = size >= 256 ? FindEntry(data, type) : 0;
  Block block;
  if (entry > 0)
  {
    block = { Get<std::uint64_t>(data, entry + 8), Get<std::uint64_t>(data, entry + 16) };
  }
  return block.Offset <= size && block.Size <= size - block.Offset ? block : Block();
}

inline std::uint64_t GetSectionOffset(const unsigned char* data)
{
  return Get<std::uint64_t>(data, 32);
}

/// Makes the checksums of pages and header right, as far as the header's offsets lie within the file.
inline void SealPages(unsigned char* data, std::size_t size)
{
  const auto headerSize = Get<std::uint32_t>(data, 12);
  if (size < 256 || headerSize < 256 || headerSize > size)
  {
    return;
  }
  const auto first = Get<std::uint64_t>(data, 24);
  const std::uint64_t end = GetSectionOffset(data);
  const bool fits = first >= headerSize && first <= end && end <= size;
  for (std::uint64_t page = first, to = headerSize; fits && page < end && to + 8 <= first; page += 65536, to += 8)
  {
    const std::uint64_t length = std::min<std::uint64_t>(65536, end - page);
    Put<std::uint64_t>(data, to, XXH3_64bits(data + page, length));
  }
  if (fits)
  {
    Put<std::uint64_t>(data, 40, XXH3_64bits(data + headerSize, first - headerSize));
  }
  Put<std::uint64_t>(data, headerSize - 8, XXH3_64bits(data, headerSize - 8));
}

/// Those of the sections, in the order in which patches and blobs lie: the blobs' records come first, their bytes last.
/// Needs to know how many blobs there are.
inline void SealSections(unsigned char* data, std::size_t size, std::uint64_t blobs)
{
  const Block table = GetBlock(data, size, Sections);
  const std::uint64_t count = table.Size / 16;
  std::uint64_t at = size >= 256 ? GetSectionOffset(data) : size;
  for (std::uint64_t i = 0; i < count && blobs <= count; ++i)
  {
    const std::uint64_t entry = table.Offset + 16 * (i + blobs < count ? i + blobs : i + blobs - count);
    const std::uint64_t padded = (std::uint64_t(Get<std::uint32_t>(data, entry + 8)) + 15) / 16 * 16;
    if (at > size || padded > size - at)
    {
      return;
    }
    Put<std::uint64_t>(data, entry, XXH3_64bits(data + at, padded));
    at += padded;
  }
}
}

#endif
