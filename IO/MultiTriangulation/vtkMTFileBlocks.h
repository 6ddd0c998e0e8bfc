// SPDX-License-Identifier: BSD-3-Clause
// The header of a Multi-Triangulation file, its table of blocks and the checksums of its pages. Not installed.
#ifndef vtkMTFileBlocks_h
#define vtkMTFileBlocks_h

#include "vtkMTFileFormat.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

class vtkMTByteSource;

struct vtkMTFileBlocks
{
  vtkMTFileFormat::Header Header{};
  std::vector<vtkMTFileFormat::BlockRecord> Table;
  std::vector<std::uint64_t> PageChecksums;

  /// Whether a file that begins with these bytes is a Multi-Triangulation file, of whatever version.
  static bool HasMagic(const unsigned char* bytes, std::size_t count);

  /// The block of a type; of size 0 where there is none.
  vtkMTFileFormat::BlockRecord Get(vtkMTFileFormat::BlockType type) const;

  /**
   * Reads and checks header, table and checksums of pages: lengths, offsets, overlaps, blocks that must be known. head
   * becomes the first bytes of the file, which have been read for it: enough for the first page of most models.
   */
  bool Read(const vtkMTByteSource& bytes, std::vector<unsigned char>& head, std::string& error);

  /// Gives the blocks of the table, all but the first, their places after each other, and header and page block theirs.
  /// The table holds types, flags and sizes; the first one must be the page block.
  void Place();

  /// Fills in the beginning of a file of which everything else up to the sections is there: header, table, checksums.
  void Seal(std::uint64_t fileSize, std::vector<unsigned char>& bytes);

private:
  bool CheckHeader(const std::vector<unsigned char>& head, std::uint64_t size, std::string& error);
  bool CheckTable(std::string& error) const;
  bool ReadPageChecksums(const vtkMTByteSource& bytes, const std::vector<unsigned char>& head, std::string& error);
};

#endif
