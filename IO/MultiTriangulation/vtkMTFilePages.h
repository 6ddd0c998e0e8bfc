// SPDX-License-Identifier: BSD-3-Clause
// Bytes of the blocks of a Multi-Triangulation file, read page by page and verified. Not installed.
#ifndef vtkMTFilePages_h
#define vtkMTFilePages_h

#include "vtkMTFileBlocks.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

class vtkMTByteSource;

class vtkMTFilePages
{
public:
  /// head: the first bytes of the file, which need not be read again.
  vtkMTFilePages(const vtkMTByteSource& source, const vtkMTFileBlocks& blocks, std::vector<unsigned char> head);

  /// Any range within the blocks. Pages in which one block ends and another begins are read once.
  bool Read(std::uint64_t offset, std::size_t count, unsigned char* destination, std::string& error);

  /// The end of the page in which the byte before `offset` lies, so that whole pages are read.
  std::uint64_t GetPageEnd(std::uint64_t offset) const;

  /// Bytes that have been asked of the source, those of head included.
  std::uint64_t GetBytesRead() const { return this->BytesRead; }

private:
  std::uint64_t GetOffset(std::uint64_t page) const;
  bool Fetch(std::uint64_t first, std::uint64_t end, std::string& error);

  const vtkMTByteSource& Source;
  const vtkMTFileBlocks& Blocks;
  std::vector<unsigned char> Head;
  std::vector<unsigned char> Buffer;                          // what Fetch has brought
  std::set<std::uint64_t> Shared;                             // pages of several blocks
  std::map<std::uint64_t, std::vector<unsigned char>> Kept;   // of those, what has been read
  std::uint64_t BytesRead = 0;
};

#endif
